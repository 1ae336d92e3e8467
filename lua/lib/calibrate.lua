-- m:calibrate{...}: fits a stiffness to a measured frequency; trilith.rayleigh{...}: damping by mass and stiffness;
-- trilith.joint_stiffness{...}: stiffness of joints from the modulus of a wall.
local trilith, core = ...
local model_methods = core.members "model"

local what_is = core.what_is

local check_keys, positive = core.check_keys, core.positive

--- Two numbers above 0.
local function pair(owner, options, key, unit)
  local list = options[key]
  if type(list) ~= "table" or #list ~= 2 then
    core.fail(("%s: '%s' is %s, must be two numbers"):format(owner, key, list == nil and "missing" or what_is(list)))
  end
  for i = 1, 2 do positive(owner, ("%s[%d]"):format(key, i), list[i], unit) end
  return list[1], list[2]
end

--- Ratios r1 at f1 and r2 at f2 by mass_damping a and a stiffness part b: r = a/(4 pi f) + pi f b.
function trilith.rayleigh(options)
  check_keys("rayleigh", options, { "ratios", "frequencies" })
  local r1, r2 = pair("rayleigh", options, "ratios", "")
  local f1, f2 = pair("rayleigh", options, "frequencies", " Hz")
  if f1 == f2 then core.fail(("rayleigh: both frequencies are %g Hz, must be two"):format(f1)) end
  if f1 > f2 then r1, r2, f1, f2 = r2, r1, f2, f1 end
  local b = (r2*f2 - r1*f1)/(math.pi*(f2^2 - f1^2))
  local a = 4*math.pi*f1*f2*(r1*f2 - r2*f1)/(f2^2 - f1^2)
  if a < 0 or b < 0 then
    core.fail(("rayleigh: %g at %g Hz and %g at %g Hz need a %s part below 0; the ratios may differ by the ratio of "
      .. "the frequencies at most"):format(r1, f1, r2, f2, a < 0 and "mass" or "stiffness"))
  end
  return { mass_damping = a, beta = b }
end

--- Modulus at a stress from rows { stress, modulus }: between two rows, and beyond them, a power of the stress.
local function modulus_at(rows, stress)
  local owner, list = "joint_stiffness", {}
  for i, row in ipairs(rows) do
    if type(row) ~= "table" or #row ~= 2 then
      core.fail(("%s: row %d of 'wall_modulus' is %s, must be { stress, modulus }"):format(owner, i, what_is(row)))
    end
    list[i] = { positive(owner, ("wall_modulus[%d][1]"):format(i), row[1], " Pa"),
      positive(owner, ("wall_modulus[%d][2]"):format(i), row[2], " Pa") }
  end
  table.sort(list, function(a, b) return a[1] < b[1] end)
  for i = 2, #list do
    if list[i][1] == list[i - 1][1] then
      core.fail(("%s: two rows of 'wall_modulus' have the stress %g Pa, must differ"):format(owner, list[i][1]))
    end
  end
  if #list < 2 then core.fail(owner .. ": a table 'wall_modulus' needs at least two rows { stress, modulus }") end
  local i = 2
  while i < #list and list[i][1] < stress do i = i + 1 end
  local a, b = list[i - 1], list[i]
  local log = trilith.math.log
  return a[2]*trilith.math.exp(log(b[2]/a[2])*log(stress/a[1])/log(b[1]/a[1]))
end

--- Stiffness of the joints of a wall of units and joints in series: h/E_wall = h/E_unit + 1/kn, for one course h.
function trilith.joint_stiffness(options)
  local owner = "joint_stiffness"
  check_keys(owner, options, { "wall_modulus", "unit_modulus", "course_height", "stress", "shear_ratio" })
  local wall = options.wall_modulus
  if type(wall) == "table" then
    wall = modulus_at(wall, positive(owner, "stress", options.stress, " Pa"))
  elseif options.stress ~= nil then
    core.fail(owner .. ": 'stress' needs rows { stress, modulus } as 'wall_modulus'; one modulus holds at any stress")
  end
  wall = positive(owner, "wall_modulus", wall, " Pa")
  local height = positive(owner, "course_height", options.course_height, " m")
  local unit = options.unit_modulus == nil and math.huge or positive(owner, "unit_modulus", options.unit_modulus, " Pa")
  if unit <= wall then
    core.fail(("%s: 'unit_modulus' is %g Pa, must be above the modulus of the wall, %g Pa, because joints make a wall "
      .. "softer than its units"):format(owner, unit, wall))
  end
  local kn = 1/(height*(1/wall - 1/unit))
  local ratio = options.shear_ratio == nil and 0.4 or positive(owner, "shear_ratio", options.shear_ratio, "")
  return { kn = kn, ks = ratio*kn, wall_modulus = wall }
end

local stiffness_keys = { "kn", "ks" }

--- "law.kn" for each contact law.
local function what_may_vary(model)
  local names = {}
  for _, law in ipairs(core.contact_laws(model)) do
    for _, key in ipairs(stiffness_keys) do
      local known, value = pcall(function() return law[key] end)
      if known and type(value) == "number" and value > 0 then
        names[#names + 1] = { name = law.name .. "." .. key, law = law.name, key = key, value = value }
      end
    end
  end
  return names
end

--- { law =, key =, value = } of each name; one of them determines the bounds.
local function read_varied(model, vary)
  local list = type(vary) == "string" and { vary } or vary
  if type(list) ~= "table" or #list == 0 then
    core.fail(("calibrate: 'vary' is %s, must be the name of a stiffness such as \"mortar.kn\", or a list of them")
      :format(vary == nil and "missing" or what_is(vary)))
  end
  local possible, names, varied = what_may_vary(model), {}, {}
  for _, row in ipairs(possible) do
    names[#names + 1] = row.name
  end
  for _, wanted in ipairs(list) do
    local found
    for _, row in ipairs(possible) do
      if row.name == wanted then found = row end
    end
    if not found then
      core.fail(("calibrate: there is no stiffness '%s'; it may vary %s"):format(tostring(wanted),
        #names > 0 and table.concat(names, ", ") or "nothing, as the model has no contact law"))
    end
    varied[#varied + 1] = found
  end
  return varied
end

--- Modal assurance criterion of two shapes over their common bodies: (a . b)^2 / (a . a) (b . b).
local function likeness(a, b)
  local ab, aa, bb = 0, 0, 0
  for body, s in pairs(a) do
    local t = b[body]
    if t then
      local sz, tz = s.z or 0, t.z or 0
      ab, aa, bb = ab + s.x*t.x + s.y*t.y + sz*tz, aa + s.x^2 + s.y^2 + sz^2, bb + t.x^2 + t.y^2 + tz^2
    end
  end
  return aa > 0 and bb > 0 and ab^2/(aa*bb) or 0
end

--- Frequency of the requested mode in the present model; with a shape, of the mode most similar to it.
local function frequency_now(model, options)
  local found = core.quiet_modes(model, math.max(options.mode, options.shape and 10 or 1))
  if not options.shape then
    if not found[options.mode] then
      core.fail(("calibrate: there are %d modes, none is number %d"):format(#found, options.mode))
    end
    return found[options.mode].frequency, options.mode
  end
  local best, most = 1, -1
  for i, mode in ipairs(found) do
    local like = likeness(options.shape, mode.shape)
    if like > most then best, most = i, like end
  end
  return found[best].frequency, best
end

local Search = {}
Search.__index = Search

--- Sets all varied numbers in their ratio, with `value` for the first, and finds the frequency.
function Search:try(value)
  for _, row in ipairs(self.varied) do
    core.set_law_number(self.model, row.law, row.key, row.value*value/self.varied[1].value)
  end
  if self.options.settle then
    local report = self.model:consolidate { integrator = "static", name = ("calibrate %d"):format(#self.tries + 1) }
    if not report.rests then core.fail("calibrate: no equilibrium was found on the way: " .. report.reason) end
  end
  local frequency, mode = frequency_now(self.model, self.options)
  self.tries[#self.tries + 1] = { value = value, frequency = frequency, mode = mode }
  return math.log(frequency/self.options.frequency)
end

function Search:restore()
  for _, row in ipairs(self.varied) do core.set_law_number(self.model, row.law, row.key, row.value) end
end

--- A stiffer joint must not have a lower frequency, otherwise the solution is not unique.
function Search:check_rising()
  local sorted = { table.unpack(self.tries) }
  table.sort(sorted, function(a, b) return a.value < b.value end)
  for i = 2, #sorted do
    local a, b = sorted[i - 1], sorted[i]
    if b.frequency < a.frequency*(1 - 1e-6) then
      core.fail(("calibrate: the frequency falls from %.5g to %.5g Hz while %s rises from %.4g Pa/m "
        .. "to %.4g Pa/m; give a mode by its number, or narrower bounds"):format(a.frequency, b.frequency,
        self.varied[1].name, a.value, b.value))
    end
  end
end

--- False position in the logarithms with the Illinois modification: the value at the retained end is halved (Dowell and
--- Jarratt, BIT 11, 1971).
function Search:find(low, high, tolerance)
  local a, b = math.log(low), math.log(high)
  local fa, fb = self:try(low), self:try(high)
  if fa > 0 or fb < 0 then
    local first, last = self.tries[1].frequency, self.tries[2].frequency
    core.fail(("calibrate: with %s from %.4g Pa/m to %.4g Pa/m the frequency is %.5g to %.5g Hz and never %.5g Hz; %s")
      :format(self.varied[1].name, low, high, first, last, self.options.frequency,
      fa > 0 and "it would have to be softer" or "it would have to be stiffer, or something else is too soft"))
  end
  local last = 0
  for _ = 1, 60 do
    local at = b - fb*(b - a)/(fb - fa)
    -- Near an end of a flat curve bisection converges faster.
    if not (at > a and at < b) or #self.tries > 12 and (b - a) > 0.5 then at = 0.5*(a + b) end
    local f = self:try(math.exp(at))
    self:check_rising()
    if math.abs(math.exp(f) - 1) <= tolerance then return math.exp(at) end
    if f < 0 then
      a, fa = at, f
      if last < 0 then fb = 0.5*fb end
    else
      b, fb = at, f
      if last > 0 then fa = 0.5*fa end
    end
    last = f
  end
  core.fail(("calibrate: no value gives %.6g Hz to %.1g; give a wider tolerance"):format(self.options.frequency,
    tolerance))
end

--- A line for each try; `name` and `unit` of its value.
function core.calibration_text(tries, name, unit)
  local head = ("%s [%s]"):format(name, unit)
  local wide = math.max(16, #head)
  local lines = { ("try   %" .. wide .. "s   frequency [Hz]   mode"):format(head) }
  for i, t in ipairs(tries) do
    lines[#lines + 1] = ("%3d   %" .. wide .. ".6g   %14.6g   %4d"):format(i, t.value, t.frequency, t.mode)
  end
  return table.concat(lines, "\n")
end

local calibrate_keys = { "frequency", "vary", "mode", "shape", "between", "tolerance", "settle" }
local keys_of_several = { "frequencies", "modes", "shapes", "scatter", "range" }

--- Refuses unknown keys, of which the message lists all, and keys that need `frequencies`.
local function check_single(options)
  local known = table.move(calibrate_keys, 1, #calibrate_keys, 1, {})
  check_keys("calibrate", options, table.move(keys_of_several, 1, #keys_of_several, #known + 1, known))
  for _, key in ipairs(keys_of_several) do
    if options[key] ~= nil then
      core.fail(("calibrate: '%s' is for a fit to several 'frequencies', which are not given"):format(key))
    end
  end
end

core.likeness = likeness

--- Groups of stiffnesses: each entry of `vary` is a name, or a list of names that keep their ratio.
function core.read_groups(model, vary)
  local groups, names, seen = {}, {}, {}
  if type(vary) ~= "table" or #vary == 0 then vary = { vary } end
  for j, entry in ipairs(#vary > 0 and vary or { false }) do
    groups[j] = read_varied(model, entry or nil)
    local texts = {}
    for _, row in ipairs(groups[j]) do
      if seen[row.name] then core.fail(("calibrate: '%s' occurs twice in 'vary'"):format(row.name)) end
      seen[row.name] = true
      texts[#texts + 1] = row.name
    end
    names[j] = table.concat(texts, " with ")
  end
  return groups, names
end

--- m:calibrate{ frequency =, vary = } -> { value, values, frequency, tries, text }; the model keeps the result. With
--- `frequencies`: lib/calibrate_fit.lua.
function model_methods.calibrate(model, options)
  if type(options) == "table" and options.frequencies ~= nil then
    if options.frequency ~= nil then
      core.fail "calibrate: 'frequency' and 'frequencies' are given, must be one of them"
    end
    return core.calibrate_several(model, options)
  end
  check_single(options)
  local wanted = { frequency = positive("calibrate", "frequency", options.frequency, " Hz"), mode = options.mode or 1,
    shape = options.shape, settle = options.settle }
  if math.type(wanted.mode) ~= "integer" or wanted.mode < 1 then
    core.fail(("calibrate: 'mode' is %s, must be a number from 1"):format(what_is(wanted.mode)))
  end
  if wanted.shape and (type(wanted.shape) ~= "table" or options.mode) then
    core.fail "calibrate: 'shape' is the shape of a mode from m:modes and replaces 'mode'"
  end
  local varied = read_varied(model, options.vary)
  local tolerance = positive("calibrate", "tolerance", options.tolerance or 1e-4, "")
  local low, high = 1e-3*varied[1].value, 1e3*varied[1].value
  if options.between then low, high = pair("calibrate", options, "between", " Pa/m") end
  if high <= low then core.fail(("calibrate: 'between' goes from %g Pa/m to %g Pa/m, must rise"):format(low, high)) end
  local search = setmetatable({ model = model, varied = varied, options = wanted, tries = {} }, Search)
  local ok, value = pcall(search.find, search, low, high, tolerance)
  if not ok then
    search:restore()
    error(value, 0)
  end
  local values = {}
  for _, row in ipairs(varied) do
    values[row.name] = row.value*value/varied[1].value
    model:change { law = row.law, [row.key] = values[row.name] }
  end
  local last = search.tries[#search.tries]
  return setmetatable({ value = value, values = values, frequency = last.frequency, mode = last.mode,
    tries = search.tries, text = core.calibration_text(search.tries, varied[1].name, "Pa/m") }, core.findings)
end
