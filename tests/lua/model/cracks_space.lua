-- Rigid bodies in space that crack at planes: keys and messages, names, loads and links of the parts, same bits.
local trilith = require "trilith"

local function near(a, b, share) assert(math.abs(a - b) <= share*math.max(1e-30, math.abs(b)), a .. " is not " .. b) end
local function refused(pattern, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(pattern), tostring(message))
end

local law = { kn = 1e11, ks = 5e10, mu = 0.6, tension = 1e5, cohesion = 1e6 }
local function empty(options)
  options = options or {}
  local m = trilith.model { name = "cracks", dim = 3, gravity = options.gravity or 0, threads = options.threads }
  m:material { name = "stone", density = 2400, E = 1e10 }
  local own = {}
  for k, v in pairs(law) do own[k] = v end
  own.tension = options.tension or law.tension
  m:contact { between = { "*", "*" }, name = "plane", law = trilith.bonded(own) }
  m:contact { between = { "*", "*" }, name = "dry",
    law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-5 } }
  return m
end
local function rod(m, keys)
  local t = { name = "rod", size = { 1, 0.1, 0.1 }, at = { 0, 0, 0 }, material = "stone", floating = true,
    cracks = "mid", crack_law = "plane" }
  for k, v in pairs(keys or {}) do t[k] = v end
  for _, k in ipairs(keys and keys.without or {}) do t[k] = nil end
  t.without = nil
  return m:block(t)
end

-- wrong input: place, value, allowed values, remedy
refused("cracks: the mesh has one element, which has no inner face to crack along", rod, empty(), { body = "brick" })
refused("cracks: crack_law is missing", rod, empty(), { without = { "crack_law" } })
refused("'crack_law' is given without 'cracks'", rod, empty(), { without = { "cracks" } })
refused("cracks: the body is held", rod, empty(), { support = "fixed" })
refused("cracks: inertia is given", rod, empty(), { inertia = 1 })
refused("'cracks' is 'diagonals', must be \"mid\", \"quarter\", a number of planes", rod, empty(),
  { cracks = "diagonals" })
refused("plane 1 through %(3, 0, 0%) with the normal %(1, 0, 0%) does not divide the body in two", rod, empty(),
  { cracks = { { point = { 3, 0, 0 }, normal = { 1, 0, 0 } } } })
refused("the normal of plane 1 has no length", rod, empty(), { cracks = { { { 0.5, 0, 0 }, { 0, 0, 0 } } } })
refused("plane 1: .*must be { point = {x, y, z}, normal", rod, empty(), { cracks = { { { 0.5, 0 }, { 1, 0 } } } })
do
  local m = empty()
  local cube = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 1, 0 }, { 1, 0, 1 }, { 0, 1, 1 },
    { 1, 1, 1 } }
  local beside = {}
  for i, p in ipairs(cube) do beside[i] = { p[1] + 1, p[2], p[3] } end
  refused("the body has 2 pieces, and planes are for bodies of one convex piece", m.body, m, { name = "two",
    pieces = { { hull = cube }, { hull = beside } }, material = "stone", floating = true, cracks = "mid",
    crack_law = "plane" })
end

-- no planes: no change of a bit; planes that do not crack: none either
local function fall(cracks)
  local m = empty { gravity = 9.81, tension = 1e8 }
  m:block { name = "floor", size = { 4, 4, 0.2 }, at = { -2, -2, -0.2 }, material = "stone", support = "fixed" }
  local t = { name = "rod", size = { 1, 0.2, 0.1 }, at = { 0, 0, 0.001 }, material = "stone", floating = true,
    spin = { 0, 0.05, 0 }, cracks = cracks, crack_law = cracks and "plane" or nil }
  m:block(t)
  m:pressure { body = "rod", face = "top", value = 100 }
  m:run { duration = 0.02 }
  return m.hash, m.steps
end
local hash, steps = fall(nil)
for _, cracks in ipairs { "mid", "quarter", 5, { { { 0.3, 0, 0 }, { 1, 1, 1 } } } } do
  local own, own_steps = fall(cracks)
  assert(own == hash and own_steps == steps)
end

-- a rod that spins too fast: parts at the middle of three planes, then at the others
local function spun(options)
  local m = empty(options)
  local limit = math.sqrt(8*law.tension/2400)
  local body = rod(m, { cracks = "quarter", spin = { 0, 0, options.share*limit }, groups = { "rods" } })
  local seen = {}
  m:on("unit.cracked", function(e) seen[#seen + 1] = e end)
  local follow = m:history { name = "follow", body = "rod", what = "ux", every = 1e-3 }
  m:run { duration = 0.02 }
  return m, body, seen, follow
end
local m, body, seen, follow = spun { share = 1.01 }
assert(#seen == 1)
local e = seen[1]
assert(e.type == "unit.cracked" and e.plane == 2 and e.mode == "tension" and e.body.name == "rod")
near(e.value, law.tension*1.01^2, 1e-3)
near(e.x, 0.5, 0.06)
assert(e.parts[1].name == "rod.a" and e.parts[2].name == "rod.b")
local a, b = m:body "rod.a", m:body "rod.b"
near(a.mass + b.mass, body.mass, 1e-12)
assert(not body.present and a.present and #m:bodies { group = "pieces of rod" } == 2)
assert(a.vy*b.vy < 0)
refused("cracked at .* into 'rod.a' and 'rod.b'", m.remove, m, "rod")
refused("a body that has cracked does not return", m.put_back, m, "rod")
assert(follow.last == follow.last) -- no NaN: its part carries it
local x, y, z = body:point { 0.9, 0.05, 0.05 }
local px, py, pz = b:point { 0.9, 0.05, 0.05 }
assert(x == px and y == py and z == pz)
local two, _, all = spun { share = 2.1 }
assert(#all == 3 and two:body("rod.a.b").present and two:body("rod.b.a").present)
for threads = 2, 4, 2 do assert(spun({ share = 2.1, threads = threads }).hash == two.hash) end

-- loads, bearings and seats go to the part that holds their point; pressure is divided; the ledger stays closed
local own = empty()
own:block { name = "ground", size = { 4, 4, 0.2 }, at = { -2, -2, -1.2 }, material = "stone", support = "fixed" }
rod(own)
local spring = trilith.linear { stiffness = 1e5, damping = 1e2 }
for _, row in ipairs { { "west", 0.1 }, { "east", 0.9 } } do
  own:bearing { name = row[1], between = { "ground", "rod" }, from = { row[2], 0.05, -1 }, to = { row[2], 0.05, 0 },
    along = spring, across = spring, axial = spring, turning_along = trilith.linear { stiffness = 1e4, damping = 1e2 } }
end
own:point_load { name = "push", body = "rod", at = { 0.7, 0.05, 0.1 }, force = { 0, 0, -400 },
  load_curve = { ramp = 0.1 } }
own:pressure { name = "snow", body = "rod", face = "top", value = 5000, load_curve = { ramp = 0.1 } }
local cracks = 0
own:on("unit.cracked", function() cracks = cracks + 1 end)
own:run { duration = 0.2 }
assert(cracks == 1)
assert(own.bearings.west.bodies[2].name == "rod.a" and own.bearings.east.bodies[2].name == "rod.b")
assert(math.abs(own.residual) < 2e-3*math.abs(own.energy.load), own.residual)
assert(math.abs(own.energy.contact_fracture) < 1e-3*math.abs(own.energy.load))

-- a bed joint under the plane: force and friction are shared
local function on_bed(planes)
  local bed = empty { gravity = 9.81 }
  bed:block { name = "floor", size = { 4, 4, 0.2 }, at = { -2, -2, -0.2 }, material = "stone", support = "fixed" }
  rod(bed, { cracks = planes, without = planes and {} or { "cracks", "crack_law" } })
  bed:pressure { body = "rod", face = "top", value = 1e4 }
  bed:run { duration = 0.02 }
  return bed
end
local floor = on_bed("mid"):body "floor"
near(floor.reaction_z, on_bed(nil):body "floor".reaction_z, 1e-12)

-- statics: a body cracks in an equilibrium, and the next one follows; both halves stand on two pads each
local function beam(dim, softens)
  local s = trilith.model { name = "beam", dim = dim, thickness = dim == 2 and 0.1 or nil }
  s:material { name = "stone", density = 2400 }
  local strength = { kn = 1e11, ks = 5e10, mu = 0.6, tension = 2e4, cohesion = 2e5,
    energy_tension = softens and 400 or nil, energy_shear = softens and 400 or nil }
  s:contact { between = { "beam", "beam" }, name = "own",
    law = softens and trilith.cohesive(strength) or trilith.bonded(strength) }
  s:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6 } }
  local function block(name, left, low, width, height, more)
    local t = more or {}
    t.name, t.material = name, "stone"
    if dim == 3 then
      t.size, t.at = { width, 0.1, height }, { left, 0, low }
    else
      t.width, t.height, t.at = width, height, { left, low }
    end
    return s:block(t)
  end
  block("floor", -1, -0.2, 3, 0.2, { support = "fixed" })
  for i, left in ipairs { 0, 0.4, 0.5, 0.9 } do block("pad " .. i, left, 0, 0.1, 0.1) end
  block("beam", 0, 0.1, 1, 0.05, { cracks = "mid", crack_law = "own" })
  s:point_load { body = "beam", at = dim == 3 and { 0.5, 0.05, 0.15 } or { 0.5, 0.15 },
    force = dim == 3 and { 0, 0, -20 } or { 0, -20 } }
  local events = {}
  s:on("unit.cracked", function(event) events[#events + 1] = event end)
  local report = s:consolidate { integrator = "static" }
  return s, events, report
end
for _, dim in ipairs { 2, 3 } do
  for _, softens in ipairs { true, false } do
    local s, events = beam(dim, softens)
    assert(#events == 1 and events[1].mode == "tension")
    near(events[1].value, 3000*20, 1e-3)
    -- The parts are at rest, and the floor carries all of the weight and the load.
    local weight = 20
    for _, one in ipairs(s:bodies {}) do if one.name ~= "floor" then weight = weight + one.mass*9.80665 end end
    local up = s:body "floor"[dim == 3 and "reaction_z" or "reaction_y"]
    near(up - s:body "floor".mass*9.80665, weight, 1e-6)
    assert(s:body "beam.a".present and s:body "beam.b".speed == 0)
  end
end
