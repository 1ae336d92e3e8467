-- Heat and water of bodies that crack: both are conserved, steady states before and after follow closed forms, and the
-- bits are the same for any number of threads.
local trilith = require "trilith"
local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.15g is not %.15g"):format(what or "", a, b))
end

local strength = 2e4
local function model(dim, keys, softens)
  local t = { name = "fields of cracks", dim = dim, thickness = dim == 2 and 1 or nil }
  for k, v in pairs(keys or {}) do t[k] = v end
  local m = trilith.model(t)
  m:material { name = "stone", density = 2400, E = 3e10, nu = 0 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e12, ks = 5e11, mu = 0.7, beta = 1e-6 } }
  local bond = { kn = 1e12, ks = 5e11, mu = 0.7, tension = strength, cohesion = 2*strength, beta = 1e-6 }
  if softens then bond.energy_tension, bond.energy_shear = 0.1, 0.4 end
  m:contact { between = { "wall", "wall" }, name = "plane",
    law = softens and trilith.cohesive(bond) or trilith.bonded(bond) }
  return m
end
-- In space the third axis is the height, and all depths are 1 m.
local function at(dim, x, z) return dim == 3 and { x, 0, z } or { x, z } end
local function middle(dim, x, z) return dim == 3 and { x, 0.5, z } or { x, z } end
local function block(m, x, z, width, height, keys)
  local t = { material = "stone", at = at(m.dim, x, z) }
  if m.dim == 3 then t.size = { width, 1, height } else t.width, t.height = width, height end
  for k, v in pairs(keys) do t[k] = v end
  return m:block(t)
end
local function meshed(dim, nx, nz) return { mesh = dim == 3 and { nx, 1, nz } or { nx, nz } } end

-- A wall of one cell on ground that has 10 degC, in air of 30 degC at its top. A short pull tears it in its middle, and
-- its weight closes the crack. Then it has two cells in series.
local function torn_wall(dim)
  local m, g, h = model(dim), 80, 25
  block(m, -1, -1, 3, 1, { name = "ground", support = "fixed" })
  block(m, 0, 0, 1, 2, { name = "wall", cracks = "mid", crack_law = "plane" })
  m:heat { body = "ground", conductivity = 2, heat_capacity = 900, temperature = 10 }
  m:heat { body = "wall", conductivity = 2, heat_capacity = 900, temperature = 15 }
  m:heat_exchange { name = "earth", body = "ground", side = "bottom", temperature = 10 }
  m:heat_exchange { name = "air", body = "wall", side = "top", temperature = 30, exchange = h }
  m:heat_contact { body = "wall", conductance = g }
  local history = m:history { name = "wall", body = "wall", what = "temperature" }
  local function season() m:process { duration = 4e8, step = 4e6, mechanics = false } end
  m:consolidate { integrator = "static" }
  season()
  near(m:temperature "wall", (g*10 + h*30)/(g + h), 1e-6, "one cell")
  local content, mean = m:heat_state().content, m:temperature "wall"
  local around = m:heat_state().surroundings
  local supplied, cracked = around.air.supplied + around.earth.supplied, 0
  m:on("unit.cracked", function() cracked = cracked + 1 end)
  -- The upper half is pulled with its weight and twice the strength of the plane.
  local pull = 2400*9.80665 + 2*strength
  m:point_load { name = "pull", body = "wall", at = middle(dim, 0.5, 2), force = at(dim, 0, 2*pull),
    load_curve = { { 0, 0 }, { 5e-3, 1 }, { 6e-3, 0 } } }
  m:run { duration = 0.2, safety = 0.05 }
  assert(cracked == 1, cracked)
  assert(m:heat_state().content == content or math.abs(m:heat_state().content/content - 1) < 1e-14, "heat is conserved")
  assert(m:temperature "wall.a" == mean and m:temperature "wall.b" == mean)
  near(history.values[#history.values], mean, 1e-14, "the mean of both parts")
  m:consolidate { integrator = "static" }
  season()
  local low, high = "wall.a", "wall.b"
  local function height(name) local b = m:body(name) return dim == 3 and b.z or b.y end
  if height(low) > height(high) then low, high = high, low end
  local flow = (30 - 10)/(2/g + 1/h)
  near(m:temperature(low), 10 + flow/g, 1e-5, "lower cell")
  near(m:temperature(high), 10 + 2*flow/g, 1e-5, "upper cell")
  near(history.values[#history.values], 10 + 1.5*flow/g, 1e-5, "mean")
  local s = m:heat_state()
  local given = s.surroundings.air.supplied + s.surroundings.earth.supplied - supplied
  -- Rounding of the heat that has flowed through.
  assert(math.abs(s.content - content - given) < 1e-12*s.surroundings.air.supplied, "heat of the surroundings")
  -- The upper half strikes the lower one.
  assert(math.abs(m.residual) < 5e-3*m.energy.load, m.residual/m.energy.load)
  return m.hash
end
for _, dim in ipairs { 2, 3 } do torn_wall(dim) end

-- The same temperatures, capacities and heat in the parts of a mesh that is torn apart; an open crack carries nothing.
local function torn_bar(dim, threads)
  local m = model(dim, { gravity = 0, threads = threads }, true)
  block(m, 0, 0, 4, 1, { name = "wall", floating = true, cracks = "mid", crack_law = "plane",
    body = meshed(dim, 8, 2) })
  m:heat { body = "wall", conductivity = 2, heat_capacity = 900, temperature = 20, expansion = 1e-9 }
  m:heat_exchange { name = "air", body = "wall", side = "top", temperature = 5, exchange = 25 }
  m:heat_contact { conductance = 50 }
  m:set_temperature { body = "wall", temperature = 20, gradient = 4 }
  m:process { duration = 36000, step = 3600, mechanics = false }
  for _, side in ipairs { "left", "right" } do
    m:pressure { name = side, body = "wall", face = side, value = -3*strength, load_curve = { ramp = 0.01 } }
  end
  local before = m:heat_state()
  local points, history = {}, m:history { name = "point", body = "wall", what = "temperature",
    point = at(dim, 0.5, 0.5) }
  for _, x in ipairs { 0.5, 1.5, 2.5, 3.5 } do points[x] = m:temperature("wall", at(dim, x, 0.5)) end
  m:run { duration = 0.02 }
  local after = m:heat_state()
  near(after.content, before.content, 1e-14, "heat of the mesh")
  local shared = dim == 3 and 6 or 3
  assert(after.cells == before.cells + shared, "nodes of the crack are doubled")
  for x, t in pairs(points) do
    near(m:temperature(x < 2 and "wall.a" or "wall.b", at(dim, x, 0.5)), t, 1e-13, "temperature of a point")
  end
  near(history.values[#history.values], points[0.5], 1e-13, "temperature of a point of the whole")
  assert(math.abs(m.residual) < 1e-3*m.energy.load, m.residual/m.energy.load)
  -- Air takes heat from both halves alike, through half of the surface each.
  m:process { duration = 36000, step = 3600, mechanics = false }
  near(m:temperature "wall.a", m:temperature "wall.b", 1e-10, "halves")
  near(m:heat_state().content - after.content,
    m:heat_state().surroundings.air.supplied - after.surroundings.air.supplied, 1e-9, "heat of the air")
  m:set_temperature { body = "wall.a", temperature = 40 }
  local other = m:temperature "wall.b"
  m:process { duration = 1, step = 1, mechanics = false }
  assert(math.abs(m:temperature "wall.b" - other) < 1e-2)
  return m.hash
end
for _, dim in ipairs { 2, 3 } do
  local hash = torn_bar(dim, 1)
  for threads = 2, dim == 2 and 4 or 2 do assert(torn_bar(dim, threads) == hash) end
end

-- A bar that is held at both ends and cools tears when E alpha dT reaches its strength, in the process, at that step.
do
  local m, rate = model(2, { gravity = 0 }, true), 1e-4
  block(m, 0, 0, 2, 1, { name = "wall", cracks = "mid", crack_law = "plane", body = meshed(2, 8, 1), hold = {
    { from = { 0, 0 }, to = { 0, 1 }, x = "fixed", y = "fixed" },
    { from = { 2, 0 }, to = { 2, 1 }, x = "fixed", y = "fixed" } } })
  m:heat { body = "wall", conductivity = 2, heat_capacity = 900, temperature = 20, expansion = 1e-5 }
  m:heat_exchange { body = "wall", side = "all", temperature = { { 0, 20 }, { 1e6, 20 - rate*1e6 } } }
  local clock
  m:on("unit.cracked", function() clock = m:heat_state().clock end)
  m:process { duration = 2000, step = 100 }
  local expected = strength/(3e10*1e-5*rate)
  assert(clock and clock >= expected - 100 and clock <= expected + 300, ("%s, not %g"):format(clock, expected))
  assert(m:heat_state().clock == 2000 and m:body "wall.a".present)
end
