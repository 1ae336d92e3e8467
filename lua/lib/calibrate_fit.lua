-- Fit of several numbers to several measured frequencies by least squares of their logarithms: m:calibrate with
-- `frequencies` for stiffnesses of joints, trilith.calibrate{ build = } for any numbers of a script.
local trilith, core = ...

local check_keys, positive, what_is = core.check_keys, core.positive, core.what_is
local log, exp = trilith.math.log, trilith.math.exp

local Fit = {}
Fit.__index = Fit

--- A list of positive numbers.
local function positive_list(owner, key, list, unit)
  if type(list) ~= "table" or #list == 0 then
    core.fail(("%s: '%s' is %s, must be a list of numbers"):format(owner, key,
      list == nil and "missing" or what_is(list)))
  end
  for i, one in ipairs(list) do positive(owner, ("%s[%d]"):format(key, i), one, unit) end
  return list
end

local function check_shape(owner, i, shape)
  local size = 0
  if type(shape) == "table" then
    for _, s in pairs(shape) do
      if type(s) == "table" then size = size + (s.x or 0)^2 + (s.y or 0)^2 + (s.z or 0)^2 end
    end
  end
  if size == 0 then
    core.fail(("%s: 'shapes[%d]' is %s without displacements, must be as the shape of a mode from m:modes; a mode that "
      .. "only rotates has a number in 'modes'"):format(owner, i, what_is(shape)))
  end
end

--- Mode of each frequency: its number, in order if none is given, or its shape.
local function read_targets(owner, options)
  local fit = { owner = owner, wanted = positive_list(owner, "frequencies", options.frequencies, " Hz") }
  local count = #fit.wanted
  if options.modes ~= nil and options.shapes ~= nil then
    core.fail(owner .. ": 'modes' and 'shapes' are given, must be one of them")
  end
  for _, key in ipairs { "modes", "shapes" } do
    local list = options[key]
    if list ~= nil and (type(list) ~= "table" or #list ~= count) then
      core.fail(("%s: '%s' is %s, must be a list with one entry for each of the %d frequencies"):format(owner, key,
        type(list) == "table" and ("a list of %d"):format(#list) or what_is(list), count))
    end
  end
  local used = {}
  for i, number in ipairs(options.modes or {}) do
    if math.type(number) ~= "integer" or number < 1 or number > 1000 or used[number] then
      core.fail(("%s: 'modes[%d]' is %s, must be a whole number from 1 to 1000 that occurs once"):format(owner, i,
        what_is(number)))
    end
    used[number] = true
  end
  for i, shape in ipairs(options.shapes or {}) do check_shape(owner, i, shape) end
  fit.shapes, fit.numbers, fit.count = options.shapes, options.modes, 0
  if not fit.shapes and not fit.numbers then
    fit.numbers = {}
    for i = 1, count do fit.numbers[i] = i end
  end
  for _, number in ipairs(fit.numbers or {}) do fit.count = math.max(fit.count, number) end
  if fit.shapes then fit.count = count + 10 end
  fit.tolerance = positive(owner, "tolerance", options.tolerance or 1e-4, "")
  fit.scatter = positive(owner, "scatter", options.scatter or 0.01, "")
  fit.range = positive(owner, "range", options.range or 1000, "")
  return fit
end

--- Numbers of the modes that resemble the shapes most, each used once, and their likeness.
local function match_shapes(shapes, found)
  local pairs_of = {}
  for i, shape in ipairs(shapes) do
    for k, mode in ipairs(found) do
      pairs_of[#pairs_of + 1] = { i = i, k = k, like = core.likeness(shape, mode.shape) }
    end
  end
  table.sort(pairs_of, function(a, b)
    if a.like ~= b.like then return a.like > b.like end
    return a.i < b.i or a.i == b.i and a.k < b.k
  end)
  local numbers, like, taken = {}, {}, {}
  for _, one in ipairs(pairs_of) do
    if not numbers[one.i] and not taken[one.k] then
      numbers[one.i], like[one.i], taken[one.k] = one.k, one.like, true
    end
  end
  return numbers, like
end

--- Frequencies of the targets at the logarithms x of the factors, with the numbers of their modes and their likeness.
function Fit:frequencies(x)
  local found = self.modes_at(x, self.count)
  local numbers, like = self.numbers, {}
  if self.shapes then numbers, like = match_shapes(self.shapes, found) end
  local result = { numbers = {}, like = like }
  for i in ipairs(self.wanted) do
    local number = numbers[i]
    local mode = number and found[number]
    if not mode then
      core.fail(("%s: frequency %d needs mode %s, and there are %d modes"):format(self.owner, i, tostring(number or
        "of its shape"), #found))
    end
    if mode.square <= 0 then
      core.fail(("%s: mode %d does not oscillate, so that it has no frequency; bring the model to rest first, "
        .. "m:consolidate()"):format(self.owner, number))
    end
    result[i], result.numbers[i] = mode.frequency, number
  end
  return result
end

--- Logarithms of found over measured frequencies, the sum of their squares, and the frequencies.
function Fit:residual(x)
  local found, r, sum = self:frequencies(x), {}, 0
  for i, wanted in ipairs(self.wanted) do
    r[i] = log(found[i]/wanted)
    sum = sum + r[i]^2
  end
  return r, sum, found
end

--- Derivatives of the logarithms of the frequencies with respect to logarithms of the numbers, by central differences.
function Fit:sensitivity(x)
  local step, rows = 0.01, {}
  for i in ipairs(self.wanted) do rows[i] = {} end
  for j in ipairs(x) do
    local moved = { table.unpack(x) }
    moved[j] = x[j] + step
    local above = self:residual(moved)
    moved[j] = x[j] - step
    local below = self:residual(moved)
    for i in ipairs(rows) do rows[i][j] = (above[i] - below[i])/(2*step) end
  end
  return rows
end

--- J^T J.
local function normal_matrix(rows, n)
  local a = {}
  for j = 1, n do
    a[j] = {}
    for k = 1, n do
      a[j][k] = 0
      for _, row in ipairs(rows) do a[j][k] = a[j][k] + row[j]*row[k] end
    end
  end
  return a
end

--- Solves a x = b for a symmetric positive definite matrix by its factors L D L^T.
local function solve(a, b)
  local n, l, d, y = #b, {}, {}, {}
  for j = 1, n do
    l[j], d[j] = {}, a[j][j]
    for k = 1, j - 1 do
      local sum = a[j][k]
      for i = 1, k - 1 do sum = sum - l[j][i]*d[i]*l[k][i] end
      l[j][k] = sum/d[k]
      d[j] = d[j] - l[j][k]^2*d[k]
    end
  end
  for j = 1, n do
    y[j] = b[j]
    for k = 1, j - 1 do y[j] = y[j] - l[j][k]*y[k] end
  end
  for j = n, 1, -1 do
    y[j] = y[j]/d[j]
    for k = j + 1, n do y[j] = y[j] - l[k][j]*y[k] end
  end
  return y, d
end

--- Fails for a number that no frequency depends on, and for numbers that the frequencies cannot separate. Of these the
--- columns of the sensitivity are nearly dependent.
function Fit:check_separable(a)
  local n, scaled, zero = #a, {}, {}
  for j = 1, n do
    if a[j][j] < 1e-6 then
      core.fail(("%s: no frequency depends on %s: 1 %% of it moves them by less than 0.001 %%; leave it out, or "
        .. "measure a mode that it moves"):format(self.owner, self.names[j]))
    end
  end
  for j = 1, n do
    scaled[j], zero[j] = {}, 0
    for k = 1, n do scaled[j][k] = a[j][k]/math.sqrt(a[j][j]*a[k][k]) end
  end
  local _, d = solve(scaled, zero)
  for j = 2, n do
    if d[j] ~= d[j] or d[j] <= 1e-6 then
      core.fail(("%s: the frequencies cannot separate %s from %s: they move them in the same ratios; vary these "
        .. "together in one ratio, or measure a mode that moves them differently"):format(self.owner, self.names[j],
        table.concat(self.names, ", ", 1, j - 1)))
    end
  end
end

--- One step of Levenberg and Marquardt: the least damping that lowers the sum of squares. Nothing if none does.
function Fit:step(x, sum, a, gradient)
  while self.damping < 1e10 do
    local damped, minus = {}, {}
    for j = 1, #x do
      damped[j], minus[j] = { table.unpack(a[j]) }, -gradient[j]
      damped[j][j] = a[j][j]*(1 + self.damping)
    end
    local move, next_x, longest = solve(damped, minus), {}, 0
    for j = 1, #x do longest = math.max(longest, math.abs(move[j])) end
    local share = math.min(1, 1.5/math.max(longest, 1e-300)) -- no step beyond a factor of 4.5
    for j = 1, #x do next_x[j] = x[j] + share*move[j] end
    local r, next_sum, found = self:residual(next_x)
    if next_sum < sum then
      self.damping = math.max(1e-12, 0.1*self.damping)
      return next_x, r, next_sum, found
    end
    self.damping = 10*self.damping
  end
end

function Fit:check_range(x)
  for j, value in ipairs(x) do
    if math.abs(value) > log(self.range) then
      core.fail(("%s: %s would have to be %.4g times its start, beyond the factor %g; something else is too %s, or "
        .. "give a greater 'range'"):format(self.owner, self.names[j], exp(value), self.range,
        value > 0 and "soft" or "stiff"))
    end
  end
end

--- Least squares (Levenberg 1944, Marquardt 1963) from the start values.
function Fit:find()
  local x = {}
  for j in ipairs(self.names) do x[j] = 0 end
  local r, sum, found = self:residual(x)
  self.damping = 1e-3
  for round = 1, 40 do
    local rows = self:sensitivity(x)
    local a, gradient = normal_matrix(rows, #x), {}
    self:check_separable(a)
    for j = 1, #x do
      gradient[j] = 0
      for i, row in ipairs(rows) do gradient[j] = gradient[j] + row[j]*r[i] end
    end
    local full, longest = solve(a, gradient), 0
    for j = 1, #x do longest = math.max(longest, math.abs(full[j])) end
    local next_x, next_r, next_sum, next_found
    if longest > self.tolerance then next_x, next_r, next_sum, next_found = self:step(x, sum, a, gradient) end
    if not next_x then return { x = x, found = found, rows = rows, a = a, sum = sum, rounds = round } end
    x, r, sum, found = next_x, next_r, next_sum, next_found
    self:check_range(x)
  end
  core.fail(("%s: 40 rounds have not reached a least sum of squares; begin nearer to the result, or give modes by "
    .. "their shapes"):format(self.owner))
end

local function text_of(fit, result)
  local lines = { "frequency [Hz]   measured [Hz]   error [%]   mode   likeness" }
  for i, wanted in ipairs(fit.wanted) do
    local like = result.likeness[i]
    lines[#lines + 1] = ("%14.5g   %13.5g   %9.3g   %4d   %8s"):format(result.frequencies[i], wanted,
      100*(result.frequencies[i]/wanted - 1), result.modes[i], like and ("%.3f"):format(like) or "-")
  end
  for j, name in ipairs(fit.names) do
    lines[#lines + 1] = ("%s: %.5g times its start, within %.2g %% for frequencies within %.2g %%"):format(name,
      exp(result.x[j]), 100*result.deviations[j], 100*fit.scatter)
  end
  return table.concat(lines, "\n")
end

--- Runs a fit. Returns { factors, frequencies, modes, likeness, sensitivity, deviations, rms, rounds }.
function Fit:run()
  if #self.names > #self.wanted then
    core.fail(("%s: %d numbers vary and %d frequencies are given; give as many frequencies at least, or vary several "
      .. "numbers together"):format(self.owner, #self.names, #self.wanted))
  end
  local best = self:find()
  for i, like in pairs(best.found.like) do
    if like < 0.5 then
      core.fail(("%s: shape %d resembles no mode: the nearest, number %d, has a likeness of %.2f; 1 is the same shape, "
        .. "and at least 0.5 is needed"):format(self.owner, i, best.found.numbers[i], like))
    end
  end
  local result = { x = best.x, factors = {}, deviations = {}, frequencies = {}, modes = best.found.numbers,
    likeness = best.found.like, sensitivity = best.rows, rounds = best.rounds,
    rms = math.sqrt(best.sum/#self.wanted) }
  for i in ipairs(self.wanted) do result.frequencies[i] = best.found[i] end
  for j in ipairs(self.names) do
    local unit = {}
    for k in ipairs(self.names) do unit[k] = k == j and 1 or 0 end
    result.factors[j] = exp(best.x[j])
    result.deviations[j] = self.scatter*math.sqrt(solve(best.a, unit)[j])
  end
  result.text = text_of(self, result)
  result.x = nil
  return setmetatable(result, core.findings)
end

local model_keys = { "frequencies", "vary", "modes", "shapes", "tolerance", "scatter", "range", "settle" }

--- m:calibrate{ frequencies =, vary = }: the model keeps the result; after an error it has its numbers from before.
function core.calibrate_several(model, options)
  check_keys("calibrate", options, model_keys)
  local fit = setmetatable(read_targets("calibrate", options), Fit)
  local groups, names = core.read_groups(model, options.vary)
  local tries = 0
  fit.names = names
  local function set(x)
    for j, group in ipairs(groups) do
      for _, row in ipairs(group) do core.set_law_number(model, row.law, row.key, row.value*exp(x[j])) end
    end
  end
  function fit.modes_at(x, count)
    set(x)
    tries = tries + 1
    if options.settle then
      local report = model:consolidate { integrator = "static", name = ("calibrate %d"):format(tries) }
      if not report.rests then core.fail("calibrate: no equilibrium was found on the way: " .. report.reason) end
    end
    return core.quiet_modes(model, count)
  end
  local ok, result = pcall(fit.run, fit)
  local zero = {}
  for j in ipairs(groups) do zero[j] = 0 end
  set(zero)
  if not ok then error(result, 0) end
  result.values = {}
  for j, group in ipairs(groups) do
    for _, row in ipairs(group) do
      result.values[row.name] = row.value*result.factors[j]
      model:change { law = row.law, [row.key] = result.values[row.name] }
    end
  end
  return result
end

--- Start values by name, sorted by name.
local function read_start(vary)
  if type(vary) ~= "table" or next(vary) == nil then
    core.fail(("calibrate: 'vary' is %s, must be start values by name, such as { kn = 1e9, E = 3e9 }"):format(
      vary == nil and "missing" or what_is(vary)))
  end
  local names = {}
  for name, value in pairs(vary) do
    if type(name) ~= "string" then
      core.fail(("calibrate: 'vary' has the key %s, must be start values by name, such as { kn = 1e9 }"):format(
        what_is(name)))
    end
    positive("calibrate", "vary." .. name, value, "")
    names[#names + 1] = name
  end
  table.sort(names)
  return names
end

local build_keys = { "build", "frequencies", "vary", "modes", "shapes", "tolerance", "scatter", "range" }

--- trilith.calibrate{ build =, vary =, frequencies = }: builds one model for each trial.
function trilith.calibrate(options)
  check_keys("calibrate", options, build_keys)
  local build, start = options.build, options.vary
  if type(build) ~= "function" then
    core.fail(("calibrate: 'build' is %s, must be a function that returns a model at rest for a table of values")
      :format(build == nil and "missing" or what_is(build)))
  end
  local fit = setmetatable(read_targets("calibrate", options), Fit)
  fit.names = read_start(start)
  local function values_at(x)
    local values = {}
    for j, name in ipairs(fit.names) do values[name] = start[name]*exp(x[j]) end
    return values
  end
  function fit.modes_at(x, count)
    local model = build(values_at(x))
    if type(model) ~= "userdata" then
      core.fail(("calibrate: 'build' returned %s, must be a model at rest"):format(what_is(model)))
    end
    local ok, found = pcall(core.quiet_modes, model, count)
    model:close()
    if not ok then error(found, 0) end
    return found
  end
  local result = fit:run()
  local x = {}
  for j in ipairs(fit.names) do x[j] = log(result.factors[j]) end
  result.values = values_at(x)
  return result
end
