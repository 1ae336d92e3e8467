-- Meshes in space that crack along faces of their elements: messages, parts and their contents, same bits, ledger.
local trilith = require "trilith"

local function near(a, b, share) assert(math.abs(a - b) <= share*math.max(1e-30, math.abs(b)), a .. " is not " .. b) end
local function refused(pattern, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(pattern), tostring(message))
end

local strength = 3e6
local law = { kn = 1e13, ks = 5e12, mu = 0.5, tension = strength, cohesion = 2*strength, energy_tension = 50,
  energy_shear = 200 }
local function empty(threads)
  local m = trilith.model { name = "cracks", dim = 3, gravity = 0, threads = threads }
  m:material { name = "concrete", density = 2400, E = 3e10, nu = 0.2 }
  m:contact { between = { "*", "*" }, name = "plane", law = trilith.cohesive(law) }
  m:contact { between = { "*", "*" }, name = "dry",
    law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-5 } }
  return m
end
local function bar(m, keys)
  local t = { name = "bar", size = { 0.4, 0.1, 0.1 }, at = { 0, 0, 0 }, material = "concrete",
    body = { mesh = { 8, 2, 2 } }, floating = true, cracks = "mid", crack_law = "plane" }
  for k, v in pairs(keys or {}) do t[k] = v end
  return m:block(t)
end

-- wrong input: place, value, allowed values, remedy
refused("cracks: the mesh has one element, which has no inner face to crack along", bar, empty(), { body = "brick" })
refused("cracks: plane 1 through %(0.001, 0, 0%) with the normal %(1, 0, 0%) meets no inner face of the mesh", bar,
  empty(), { cracks = { { { 0.001, 0, 0 }, { 1, 0, 0 } } } })
refused("leaves one tetrahedron ahead of it, whose rotary inertia", bar, empty(),
  { body = { mesh = { 1, 1, 1 }, element = "tet4" }, cracks = { { { 0.2, 0, 0 }, { 2.5, 2, -10 } } } })
refused("cracks: all nodes of the body are held along an axis", bar, empty(), { support = "fixed" })
refused("cracks: crack_law is missing", bar, empty(), { crack_law = "" })
do
  local m = empty()
  bar(m, { crack_law = "dry" })
  refused("'dry' has no strength", function() m:run { duration = 1e-4 } end)
end

-- planes that do not crack leave all bits and all steps as they are
local function struck(cracks)
  local m = empty()
  m:block { name = "floor", size = { 4, 4, 0.2 }, at = { -2, -2, -0.2 }, material = "concrete", support = "fixed" }
  bar(m, { at = { 0, 0, 1e-4 }, velocity = { 0, 0, -0.2 }, cracks = cracks or false,
    crack_law = cracks and "plane" or nil })
  m:run { duration = 2e-3 }
  return m.hash, m.steps
end
local hash, steps = struck(nil)
for _, cracks in ipairs { "mid", "quarter" } do
  local own, own_steps = struck(cracks)
  assert(own == hash and own_steps == steps, tostring(cracks))
end

-- both ends are pulled by loads that grow beyond the strength: the bar parts in its middle, at once or with softening
local function torn(keys)
  local m = empty(keys.threads)
  if keys.brittle then
    m:contact { between = { "bar", "bar" }, name = "plane of bar", law = trilith.bonded { kn = law.kn, ks = law.ks,
      mu = 0.5, tension = strength, cohesion = 2*strength } }
  end
  local body = bar(m, { cracks = keys.cracks, body = keys.body, crack_law = keys.brittle and "plane of bar" or nil })
  local seen = {}
  m:on("unit.cracked", function(e) seen[#seen + 1] = e end)
  for _, side in ipairs { "left", "right" } do
    m:pressure { name = side, body = "bar", face = side, value = -1.2*strength, load_curve = { ramp = 4e-3 } }
  end
  local follow = m:history { name = "follow", body = "bar", what = "ux", every = 1e-4 }
  m:run { duration = 4.5e-3, integrator = keys.dt and "implicit" or nil, dt = keys.dt }
  return m, body, seen, follow
end
for _, keys in ipairs { { brittle = false }, { brittle = true },
  { brittle = false, body = { mesh = { 8, 2, 2 }, element = "tet4" } } } do
  local m, body, seen, follow = torn(keys)
  assert(#seen == 1, #seen)
  local e = seen[1]
  assert(e.body.name == "bar" and e.plane == 1 and e.mode == "tension" and e.severity == "damage")
  near(e.value, strength, 0.02)
  near(e.x, 0.2, 1e-3)
  local a, b = e.parts[1], e.parts[2]
  assert(a.name == "bar.a" and b.name == "bar.b" and a.kind == "mesh" and not body.present)
  near(a.mass + b.mass, 0.4*0.1*0.1*2400, 1e-12)
  assert(a.vx < 0 and b.vx > 0)
  near(-a.vx, b.vx, keys.body and 1e-2 or 1e-6)
  assert(#follow.values > 30 and follow.last == follow.last)
  assert(#m:bodies { group = "pieces of bar" } == 2)
  local spent = 0.01*(keys.brittle and 0 or law.energy_tension)
  assert(math.abs(m.residual) < 1e-2*m.energy.kinetic, m.residual)
  assert(math.abs(m.energy.contact_fracture - spent) < 0.02*0.01*law.energy_tension, m.energy.contact_fracture)
  refused("a body that has cracked does not return", m.put_back, m, "bar")
  if not keys.body then
    assert(torn({ brittle = keys.brittle, threads = 3 }).hash == m.hash)
  end
end

-- implicit steps spend the same fracture energy, less the elastic energy of the joint at its strength
do
  local spent = (law.energy_tension - strength^2/(2*law.kn))*0.01
  for _, dt in ipairs { 2e-5, 1e-5 } do
    local m, _, seen = torn { body = { mesh = { 4, 1, 1 } }, dt = dt }
    assert(#seen == 1 and seen[1].mode == "tension")
    near(m.energy.contact_fracture, spent, 0.01)
    assert(math.abs(m.residual) < 1e-3*m.energy.kinetic, m.residual)
  end
end

-- into two parts of one brick, which share a point load on the edge of the crack
do
  local parts = torn { body = { mesh = { 2, 1, 1 } } }
  assert(#parts:bodies { group = "pieces of bar" } == 2)
  local m = empty()
  local one = bar(m, { body = { mesh = { 2, 1, 1 } } })
  m:point_load { name = "on the cut", body = "bar", at = { 0.2, 0.05, 0.1 }, force = { 0, 0, -600 } }
  for _, side in ipairs { "left", "right" } do
    m:pressure { name = side, body = "bar", face = side, value = -1.2*strength, load_curve = { ramp = 4e-3 } }
  end
  m:run { duration = 4.5e-3 }
  assert(not one.present)
  local mass = 0.4*0.1*0.1*2400
  near((m:body "bar.a".vz + m:body "bar.b".vz)/2, -600/mass*m.time, 0.01) -- velocities are half a step behind
end

-- several planes: the parts keep the planes that cut them
local m, _, seen = torn { cracks = "quarter" }
assert(#seen >= 1 and m.hash == torn({ cracks = "quarter", threads = 2 }).hash)
