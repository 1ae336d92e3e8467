-- Absorbing boundaries, bolts and creep: same bits for any number of threads, both sides of limits, wrong input.
local trilith = require "trilith"
local day = 86400

local function refused(words, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(words, 1, true), ("%s is not in: %s"):format(words, tostring(why)))
end
local function with(t, more)
  local out = {}
  for key, value in pairs(t) do out[key] = value end
  for key, value in pairs(more) do out[key] = value ~= "none" and value or nil end
  return out
end

-- A pulse crosses a column that ends in a half space of the density of the ground and `cs` as given.
local pulse = { { 0, 0 }, { 0.025, 0.1 }, { 0.05, 0 } }
local function soil_model(threads)
  local m = trilith.model { name = "soil", gravity = 0, threads = threads }
  m:material { name = "soil", density = 1800, E = 1.8e8, nu = 0.25, plane = "strain" }
  m:contact { between = { "*", "*" }, law = "none" }
  local soil = m:block { name = "soil", width = 1, height = 10, at = { 0, 0 }, material = "soil",
    body = { mesh = { 2, 20 } }, floating = true }
  return m, soil
end
local function left_after(cs, threads)
  local m, soil = soil_model(threads)
  m:absorbing_boundary { body = soil, edge = "bottom", density = 1800, cs = cs, cp = 2*cs, directions = "x",
    motion = pulse }
  m:fix(soil, "y")
  m:run { duration = 0.2 }
  -- The error of an explicit dashpot is of second order in the step.
  assert(math.abs(m.residual) < 1e-4*m.energy.load, "the energy balance does not close")
  return (m.energy.kinetic + m.energy.strain)/m.energy.load, m.hash
end
local left, bits = left_after(200)
assert(left < 1e-3, ("%g of the energy stays in the column"):format(left))
local _, bits_of_two = left_after(200, 2)
assert(bits == bits_of_two, "other bits with two threads")
assert(left_after(800) > 0.05 and left_after(50) > 0.05, "a half space of another stiffness reflects nothing")

-- A wave given by a ground motion: the surface moves twice as far as the wave.
do
  local m, soil = soil_model()
  local wave = trilith.motion { acceleration = { 0, 2, 0, -2, 0, 0 }, dt = 0.02, allow_drift = true }
  m:absorbing_boundary { body = soil, edge = "bottom", density = 1800, cs = 200, cp = 346, directions = "x",
    motion = { x = wave } }
  m:fix(soil, "y")
  m:run { duration = 0.3 }
  local _, _, far = wave:at(1)
  local moved = soil:point { 0, 10 }
  assert(far > 0 and math.abs(moved - 2*far) < 0.01*far, ("the surface moves by %g, the wave by %g"):format(moved, far))
  m:close()
end

-- Wrong input of boundaries.
local m, soil = soil_model()
local edge = { body = soil, edge = "bottom", density = 1800, cs = 200, cp = 346 }
local function boundary(more) return m.absorbing_boundary, m, with(edge, more) end
refused("'body' is missing, must be a body or its name", boundary { body = "none" })
refused("there is no 'botom' for the key 'edge'", boundary { edge = "botom" })
refused("'cp' is 200 m/s, must be above 1.155 cs", boundary { cp = 200 })
refused("'cs' is missing, must be a number above 0 m/s", boundary { cs = "none" })
refused("must be one or several of xy", boundary { directions = "z" })
refused("'from' is for models in space", boundary { from = { 0, 0 } })
refused("times must increase", boundary { motion = { { 0, 0 }, { 1, 1 }, { 1, 0 } } })
refused("a wave begins with 0 m/s", boundary { motion = { { 0, 1 }, { 1, 1 } } })
refused("must be a motion or a list of { time, velocity }", boundary { motion = { x = 3 } })
refused("'motion' is empty", boundary { motion = {} })
refused("unknown key 'w'", boundary { motion = { w = pulse } })
refused("'directions' has no dashpots along it", boundary { motion = { y = pulse }, directions = "x" })
refused("'free_field' is for upright edges", boundary { free_field = { base = 0, surface = 10, motion = pulse } })
refused("must be above the base at 5 m",
  boundary { edge = "left", free_field = { base = 5, surface = 5, motion = pulse } })
refused("outside the free field from 1 to 10 m",
  boundary { edge = "left", free_field = { base = 1, surface = 10, motion = pulse } })
local function beside(layers, more)
  return boundary { edge = "left", free_field = with({ base = 0, motion = pulse, layers = layers }, more or {}) }
end
local loose, dense = { top = 4, density = 1800, cs = 150, cp = 260 }, { top = 10, density = 2000, cs = 300, cp = 520 }
refused("'layers' is a table, must be a list of layers from the lowest one upwards", beside {})
refused("layer 2: 'top' is 4 m, must be above 10 m, the top of the layer below", beside { dense, loose })
refused("layer 1: 'top' is 4 m, must be above 5 m, the base below", beside({ loose }, { base = 5 }))
refused("layer 1: 'cp' is missing", beside { { top = 10, density = 1800, cs = 150 } })
refused("layer 1: unknown key 'thickness'", beside { { thickness = 10, density = 1800, cs = 150 } })
refused("the uppermost layer ends at 10 m; leave it out", beside({ loose, dense }, { surface = 11 }))
refused("almost rigid; give a softer half_space",
  beside({ dense }, { half_space = { density = 1e8, cs = 800, cp = 1500 } }))
m:close()

-- A layer that is given in two parts is the same layer, at one side and in the motion of the ground.
local function surface_after(field)
  local g = trilith.model { name = "parts", gravity = 0 }
  g:material { name = "soil", density = 1800, E = 1.8e8, nu = 0.25, plane = "strain" }
  g:contact { between = { "*", "*" }, law = "none" }
  local layer = g:block { name = "soil", width = 4, height = 8, at = { 0, 0 }, material = "soil",
    body = { mesh = { 4, 8 } }, floating = true }
  local spec = { body = layer, density = 1800, cs = 200, cp = 346 }
  g:absorbing_boundary(with(spec, { edge = "bottom", motion = pulse }))
  for _, side in ipairs { "left", "right" } do g:absorbing_boundary(with(spec, { edge = side, free_field = field })) end
  g:run { duration = 0.2, dt = 1e-3, integrator = "implicit" }
  return (layer:point { 2, 8 })
end
-- A motion that goes on at its last velocity keeps the ground moving with twice that velocity.
do
  local lasting = { { 0, 0 }, { 0.025, 0.1 }, { 0.05, 0.1 } }
  local g = trilith.model { name = "lasting", gravity = 0 }
  g:material { name = "soil", density = 1800, E = 1.8e8, nu = 0.25, plane = "strain" }
  g:contact { between = { "*", "*" }, law = "none" }
  local layer = g:block { name = "soil", width = 4, height = 8, at = { 0, 0 }, material = "soil",
    body = { mesh = { 4, 8 } }, floating = true }
  local spec = { body = layer, density = 1800, cs = 200, cp = 346 }
  g:absorbing_boundary(with(spec, { edge = "bottom", motion = lasting }))
  local field = { base = 0, surface = 8, motion = lasting, half_space = { density = 2200, cs = 800, cp = 1500 } }
  for _, side in ipairs { "left", "right" } do g:absorbing_boundary(with(spec, { edge = side, free_field = field })) end
  g:run { duration = 2, dt = 1e-3, integrator = "implicit" }
  local before = layer:point { 2, 8 }
  g:run { duration = 0.1, dt = 1e-3, integrator = "implicit" }
  local velocity = ((layer:point { 2, 8 }) - before)/0.1
  assert(math.abs(velocity - 0.2) < 2e-3, ("the surface moves with %g m/s after the motion"):format(velocity))
  g:close()
end

local whole = surface_after { base = 0, surface = 8, motion = pulse }
local parts = surface_after { base = 0, motion = pulse, layers = {
  { top = 3, density = 1800, cs = 200, cp = 346 }, { top = 8, density = 1800, cs = 200, cp = 346 } } }
assert(math.abs(whole - 2) > 1e-4, "the surface has not moved")
assert(math.abs(parts - whole) < 1e-3*math.abs(whole - 2),
  ("a layer in two parts moves the ground to %.9g, not to %.9g"):format(parts, whole))

-- A bolt comes out when the bond slips along all of its shorter side.
local function bolted(options)
  local b = trilith.model { name = "bolted", gravity = 0 }
  b:material { name = "rock", density = 2500 }
  b:material { name = "steel", density = 7850, E = 210e9, nu = 0.3 }
  b:contact { between = { "*", "*" }, law = "none" }
  b:block { name = "a", width = 1, height = 0.5, at = { -1, -0.25 }, material = "rock", support = "fixed" }
  b:block { name = "b", width = 1, height = 0.5, at = { 0, -0.25 }, material = "rock",
    support = { y = "fixed", rotation = "fixed" }, floating = true }
  local spec = { name = "bolt", bodies = { "a", "b" }, from = { -0.5, 0 }, to = { 1, 0 }, joints = { 0.5 },
    diameter = 0.02, E = 210e9, material = "steel", bond = 5e8, bond_strength = 3e6, spacing = 0.1 }
  return b, with(spec, options or {})
end
local most = math.pi*0.02*0.5*3e6
for _, share in ipairs { 0.97, 1.03 } do
  local b, spec = bolted()
  local bolt = b:bolt(spec)
  b:point_load { body = "b", at = { 1, 0 }, force = { share*most, 0 } }
  local report = b:consolidate { integrator = "static", or_go_on = true }
  local holds = report.ending == "rest"
  assert(holds == (share < 1), ("pulled by %g of its capacity the bolt ends %s"):format(share, report.ending))
  if holds then assert(math.abs(bolt.force(1) - share*most) < 1e-6*most, "the bolt does not carry the load") end
  refused("there is no joint 2; the bolt has 1", bolt.force, 2)
  b:close()
end

-- Wrong input of bolts.
local function bolt(more)
  local b, spec = bolted(more)
  return b.bolt, b, spec
end
refused("'bodies' is missing, must be a list", bolt { bodies = "none" })
refused("'joints' has 0 distances for 2 bodies", bolt { joints = {} })
refused("joint 1 is at 2 m, must be above 0 m and below the length 1.5 m", bolt { joints = { 2 } })
refused("the same point", bolt { to = { -0.5, 0 } })
refused("'from' is missing, must be a point of 2 coordinates", bolt { from = "none" })
refused("'spacing' is 0.4 m, must be at most half of the shortest part, 0.25 m", bolt { spacing = 0.4 })
refused("more than 2000 springs", bolt { spacing = 1e-5 })
refused("'hardening' needs 'yield'", bolt { hardening = 0.1 })
refused("must be below the yield force", bolt { yield = 100e6, prestress = 50e3 })
refused("'bond' is -1, must be a number above 0 N/m per m", bolt { bond = -1 })
refused("unknown key 'bonds'", bolt { bonds = 1 })

-- A leaning column settles where W h (1 + factor) < k, and falls otherwise.
local function column()
  local t = trilith.model { name = "tower", gravity = 0 }
  t:material { name = "stone", density = 2500 }
  t:contact { between = { "*", "*" }, law = "none" }
  t:block { name = "base", width = 1, height = 0.2, at = { -0.5, -0.2 }, material = "stone", support = "fixed" }
  local tower = t:block { name = "tower", width = 0.5, height = 4, at = { -0.25, 0 }, material = "stone",
    floating = true }
  local stiff = trilith.linear { stiffness = 1e12 }
  t:bearing { name = "foot", between = { "base", "tower" }, at = { 0, 0 }, along = stiff, axial = stiff,
    turning = trilith.linear { stiffness = 3e5 } }
  t:point_load { body = tower, at = { 0, 2 }, force = { 0, -50e3 } }
  t:point_load { body = tower, moment = -100 }
  t:consolidate { integrator = "static" }
  return t, tower
end
for _, factor in ipairs { 1.6, 2.4 } do
  local t, tower = column()
  t:creep { bearing = "foot", direction = "turning", stiffness = 3e5, factor = factor, time = 10*day }
  local tilts = { tower.rotation }
  t:creep_process { duration = 20*day, step = 2*day, each = function() tilts[#tilts + 1] = tower.rotation end }
  assert(#tilts == 11)
  local first, last = math.abs(tilts[2] - tilts[1]), math.abs(tilts[11] - tilts[10])
  assert((last > first) == (factor > 2), ("the tilt grows by %g, then by %g rad"):format(first, last))
  assert(math.abs(t.residual) < 1e-9*math.abs(t.energy.load), "the energy balance does not close")
  t:close()
end

-- Wrong input of creep.
local t = column()
local row = { bearing = "foot", direction = "turning", stiffness = 3e5, factor = 2, time = 30*day }
refused("no bearing creeps; declare m:creep first", t.creep_process, t, { duration = 1, step = 1 })
refused("'factor' is missing", t.creep, t, with(row, { factor = "none" }))
refused("there is no 'twist' for the key 'direction'", t.creep, t, with(row, { direction = "twist" }))
refused("'bearing' is 3, must be a bearing or its name", t.creep, t, with(row, { bearing = 3 }))
t:creep(row)
refused("creeps in the direction turning already", t.creep, t, row)
local chain = { { factor = 1, time = day }, { factor = 0.5, time = 100*day } }
local chained = with(row, { bearing = "foot", direction = "along", factor = "none", time = "none" })
refused("'chain' and 'factor' or 'time' are given", t.creep, t, with(row, { chain = chain }))
refused("'chain' is a list of 0, must be a list of 1 to 20 elements", t.creep, t, with(chained, { chain = {} }))
refused("element 2 of 'chain': 'time' is missing", t.creep, t, with(chained, { chain = { chain[1], { factor = 1 } } }))
refused("element 1 of 'chain': 'factor' is -1", t.creep, t, with(chained, { chain = { { factor = -1, time = 1 } } }))
refused("more than 100000 steps", t.creep_process, t, { duration = 1e9, step = 1 })
refused("'each' is 3, must be a function", t.creep_process, t, { duration = day, step = day, each = 3 })
