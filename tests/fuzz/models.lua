-- Base of random programs: sound models with one handle of each kind, and calls that may fail on their own. Created
-- before all models, so that it is finalized after them. A sandbox has no finalizers.
local is_closed = getmetatable "" == "locked"
local late = setmetatable({}, not is_closed and { __gc = function(o) for _, f in ipairs(o) do pcall(f) end end } or nil)
local trilith = require "trilith"
local fuzz = { trilith = trilith, late = late }

-- Calls f; prints whether it succeeded, because the next programs use the calls that did. A rejection is printed with
-- its position.
function fuzz.try(number, f)
  local good, given = pcall(f)
  if good then
    io.write("good ", number, "\n")
    return given
  end
  if type(given) == "string" then io.write(number, ": ", given, "\n") end
end

local function add_laws(m)
  m:material { name = "stone", density = 2400 }
  m:material { name = "soft", density = 2000, E = 1e8, nu = 0.2 }
  local law = trilith.frictional { name = "dry", kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-3 }
  m:contact { between = { "*", "*" }, law = law }
  return law
end

local function fibre_section()
  return trilith.fibre_section { shape = trilith.rectangle_section { width = 0.1, depth = 0.2 }, layers = 10,
    law = trilith.bilinear_steel { E = 2e11, yield = 250e6 } }
end

local function fill_space(m)
  local law = add_laws(m)
  local base = m:block { name = "base", size = { 6, 6, 0.5 }, at = { -3, -3, -0.5 }, material = "stone",
    support = "fixed" }
  local low = m:block { name = "low", size = { 1, 1, 0.5 }, at = { -0.5, -0.5, 0 }, material = "stone",
    groups = "pile" }
  local high = m:block { name = "high", size = { 1, 1, 0.5 }, at = { -0.5, -0.5, 0.5 }, material = "soft",
    groups = "pile",
    body = { mesh = { 2, 1, 1 } } }
  m:sphere { name = "ball", radius = 0.2, at = { 1.5, 1.5, 0.2 }, material = "stone", groups = "pile" }
  local spring = trilith.linear { stiffness = 1e6, damping = 1e3 }
  local bearing = m:bearing { name = "link", between = { "base", "low" }, at = { 0, 0, 0 }, along = spring,
    limit = { along = 0.05 } }
  local seat = m:seat { name = "rest", body = low, support = base, at_end = { -0.5, 0, 0 }, edge = { 3, 0, 0 },
    inward = { -1, 0, 0 } }
  local history = m:history { name = "top", body = high, what = "z" }
  return { model = m, body = low, mesh = high, base = base, set = m:bodies { group = "pile" }, bearing = bearing,
    none = m:bodies { name = "zz*" }, seat = seat, history = history, law = law, spring = spring,
    motion = trilith.ramp { by = 0.1, duration = 1 }, section = fibre_section() }
end

local function fill(m)
  local law = add_laws(m)
  local base = m:block { name = "base", width = 6, height = 0.5, at = { -3, -0.5 }, material = "stone",
    support = "fixed" }
  local low = m:block { name = "low", width = 1, height = 0.5, at = { -0.5, 0 }, material = "stone", groups = "pile" }
  local high = m:block { name = "high", width = 1, height = 0.5, at = { -0.5, 0.5 }, material = "soft", groups = "pile",
    body = { mesh = { 2, 1 } } }
  local spring = trilith.linear { stiffness = 1e6, damping = 1e3 }
  local bearing = m:bearing { name = "link", between = { "base", "low" }, at = { 0, 0 }, along = spring,
    limit = { along = 0.05 } }
  local seat = m:seat { name = "rest", body = low, support = base, at_end = { -0.5, 0 }, edge = { 3, 0 },
    inward = { -1, 0 } }
  local history = m:history { name = "top", body = high, what = "y" }
  return { model = m, body = low, mesh = high, base = base, set = m:bodies { group = "pile" }, bearing = bearing,
    none = m:bodies { name = "zz*" }, seat = seat, history = history, law = law, spring = spring,
    motion = trilith.ramp { by = 0.1, duration = 1 }, section = fibre_section() }
end

-- A model with its handles, in the plane or in space. Each of its stages ends after some steps, whatever duration is
-- requested.
function fuzz.make(name, dim)
  local m = trilith.model { name = name, dim = dim or 2 }
  local all, count = dim == 3 and fill_space(m) or fill(m), 0
  all.model:on_step(function(now) count = count + 1 if count % 100 == 0 then now:stop() end end)
  return all
end

-- Prints the number of the program if the model is built, so that it accepts no more parts.
function fuzz.tell_built(all, number)
  local takes = pcall(function() all.model:material { name = "later", density = 1000 } end)
  if not takes then io.write("built ", number, "\n") end
end

-- Reads all properties of x, and of the results.
function fuzz.read(x, deep)
  if type(x) ~= "userdata" and type(x) ~= "table" then return end
  for _, field in ipairs(fuzz.fields) do
    local good, value = pcall(function() return x[field] end)
    if good and not deep then fuzz.read(value, true) end
  end
  pcall(function() for k, v in pairs(x) do local _ = tostring(k) .. tostring(v) end end)
  pcall(function() return tostring(x) .. #x end)
  pcall(function() return x == fuzz.last end)
  fuzz.last = x
end

function fuzz.read_all(all)
  for _, x in pairs(all) do fuzz.read(x) end
end

-- Collects unreferenced objects and reuses their memory.
function fuzz.forget()
  collectgarbage()
  collectgarbage()
  for i = 1, 5 do fill(trilith.model { name = "f" .. i }) end
end

fuzz.endless = setmetatable({}, { __index = function(_, i) return i end, __len = function() return 1 << 40 end })

return fuzz
