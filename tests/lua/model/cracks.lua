-- Rigid bodies that crack at planes: keys and messages, names of parts, contents of the parts, same bits.
local trilith = require "trilith"

local function near(a, b, share) assert(math.abs(a - b) <= share*math.max(1e-30, math.abs(b)), a .. " is not " .. b) end
local function refused(pattern, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(pattern), tostring(message))
end

local law = { kn = 1e11, ks = 5e10, mu = 0.6, tension = 1e5, cohesion = 1e6 }
local function empty(options)
  options = options or {}
  local m = trilith.model { name = "cracks", thickness = 0.1, gravity = options.gravity or 0,
    threads = options.threads }
  m:material { name = "stone", density = 2400, E = 1e10 }
  m:contact { between = { "*", "*" }, name = "plane", law = trilith.bonded(law) }
  m:contact { between = { "*", "*" }, name = "dry",
    law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-5 } }
  return m
end
local outline = { { 0, 0 }, { 1, 0 }, { 1, 0.1 }, { 0, 0.1 } }
local function block(m, keys)
  local t = { name = "rod", outline = outline, material = "stone", floating = true, cracks = "mid",
    crack_law = "plane" }
  for k, v in pairs(keys or {}) do t[k] = v end
  for _, k in ipairs(keys and keys.without or {}) do t[k] = nil end
  t.without = nil
  return m:body(t)
end

-- wrong input: place, value, allowed values, remedy
refused("cracks: the mesh has one element, which has no inner edge to crack along", block, empty(), { body = "quad" })
refused("cracks: crack_law is missing, the name of a contact law with tension and cohesion", block, empty(),
  { without = { "crack_law" } })
refused("'crack_law' is given without 'cracks'", block, empty(), { without = { "cracks" } })
refused("cracks: the body is held", block, empty(), { support = "fixed" })
refused("cracks: inertia is given", block, empty(), { inertia = 1 })
refused("'cracks' is 'middle', must be \"mid\", \"quarter\", \"diagonals\"", block, empty(), { cracks = "middle" })
refused("must be 1 to 100 planes", block, empty(), { cracks = 0 })
do
  local m = empty { gravity = 9.80665 }
  refused("added_mass: body 'rod' has crack planes, and the added mass of water is not known at its sections",
    m.added_mass, m, { body = block(m), side = "left", level = 1, bed = 0 })
end
refused("'cracks' is true, must be \"mid\"", block, empty(), { cracks = true })
refused("plane 1 through %(3, 0%) with the normal %(1, 0%) does not divide the body in two; the body is between",
  block, empty(), { cracks = { { point = { 3, 0 }, normal = { 1, 0 } } } })
refused("plane 1: 'normal' is missing", block, empty(), { cracks = { { point = { 3, 0 } } } })
refused("the normal of plane 1 has no length", block, empty(), { cracks = { { { 0.5, 0 }, { 0, 0 } } } })
for name, pattern in pairs { plan = "there is no contact law 'plan'; did you mean 'plane'",
  dry = "'dry' has no strength" } do
  local m = empty()
  block(m, { crack_law = name })
  refused(pattern, function() m:run { duration = 0.01 } end)
end
-- no planes: no change of a bit; planes that do not crack: none either
local function fall(cracks)
  local m = empty { gravity = 9.81 }
  m:block { name = "floor", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
  block(m, { outline = { { 0, 0.01 }, { 1, 0.02 }, { 1, 0.12 }, { 0, 0.11 } }, cracks = cracks,
    crack_law = cracks and "plane" or nil, without = cracks and {} or { "cracks", "crack_law" } })
  m:run { duration = 0.02 }
  return m.hash, m.steps
end
local hash, steps = fall(nil)
for _, cracks in ipairs { "mid", "quarter", "diagonals", 5, { { { 0.3, 0 }, { 1, 1 } } } } do
  local own, own_steps = fall(cracks)
  assert(own == hash and own_steps == steps)
end

-- a rod that spins too fast: parts at the middle of three planes, then at the others
local function spun(options)
  local m = empty(options)
  local limit = math.sqrt(8*law.tension/2400)
  local rod = block(m, { cracks = "quarter", spin = options.share*limit, groups = { "rods" } })
  local seen = {}
  m:on("unit.cracked", function(e) seen[#seen + 1] = e end)
  local follow = m:history { name = "follow", body = "rod", what = "ux", every = 1e-3 }
  m:run { duration = 0.05 }
  return m, rod, seen, follow
end
local m, rod, seen, follow = spun { share = 1.01 }
assert(#seen == 1)
local e = seen[1]
assert(e.type == "unit.cracked" and e.severity == "damage" and e.body.name == "rod")
assert(e.plane == 2 and e.mode == "tension")
near(e.value, law.tension*1.01^2, 1e-3)
near(e.x, 0.5, 1e-2) -- at its edge, as the rod turns
assert(e.text:find "rod cracked in tension at 102 kPa on plane 2", e.text)
assert(e.parts[1].name == "rod.a" and e.parts[2].name == "rod.b" and e.cause == 0)
local a, b = m:body "rod.a", m:body "rod.b"
near(a.mass + b.mass, rod.mass, 1e-12)
assert(not rod.present and a.present)
assert(#m:bodies { group = "pieces of rod" } == 2 and #m:bodies { group = "rods" } == 2)
assert(a.material == "stone" and a.vy*b.vy < 0)
near(math.abs(a.vy - b.vy), math.abs(b.spin)*0.5, 0.05) -- both parts go on from the rigid motion
refused("cracked at .* into 'rod.a' and 'rod.b'", m.remove, m, "rod")
refused("a body that has cracked does not return", m.put_back, m, "rod")
assert(#follow.values > 40 and follow.last == follow.last) -- no NaN: its part carries it
near(rod.spin, a.spin, 1e-12)
for _, added in ipairs(m.events) do
  if added.type == "body.added" or added.type == "body.removed" then assert(added.cause == e.id) end
end
local two, _, all = spun { share = 2.1 } -- the halves are short enough for half the speed alone
assert(#all == 3 and two:body("rod.a.b").present and two:body("rod.b.a").present and not two:body("rod.a").present)
assert(all[2].plane + all[3].plane == 4 and all[2].cause > all[1].id)

-- the same bits with any number of threads
for threads = 2, 4 do assert(spun({ share = 2.1, threads = threads }).hash == two.hash) end

-- loads, bearings and seats go to the part that holds their point; the ledger stays closed
local function loaded()
  local own = empty()
  own:block { name = "ground", width = 4, height = 0.2, at = { -2, -1.2 }, material = "stone", support = "fixed" }
  block(own)
  local spring = trilith.linear { stiffness = 1e5, damping = 1e2 }
  for _, row in ipairs { { "west", 0.1 }, { "east", 0.9 } } do
    local x = row[2]
    own:bearing { name = row[1], between = { "ground", "rod" }, from = { x, -1 }, to = { x, 0 }, along = spring,
      axial = spring }
  end
  own:seat { name = "end", body = "rod", support = "ground", at_end = { 1, 0 }, edge = { 0.8, -1 } }
  own:point_load { name = "push", body = "rod", at = { 0.7, 0.1 }, force = { 0, -400 }, load_curve = { ramp = 0.1 } }
  own:pressure { name = "snow", body = "rod", face = "top", value = 500, load_curve = { ramp = 0.1 } }
  local cracks = 0
  own:on("unit.cracked", function() cracks = cracks + 1 end)
  own:run { duration = 0.2 }
  assert(cracks == 1)
  return own
end
local own = loaded()
assert(own.bearings.west.bodies[2].name == "rod.a" and own.bearings.east.bodies[2].name == "rod.b")
assert(math.abs(own.residual) < 2e-3*math.abs(own.energy.load), own.residual)
assert(math.abs(own.energy.contact_fracture) < 1e-3*math.abs(own.energy.load))
local force = { a = 0, b = 0 }
force.a, force.b = own.bearings.west.force.axial, own.bearings.east.force.axial
assert(force.a ~= 0 and force.b ~= 0)

-- a bed joint that spans the plane: its force and its friction are shared, no force jumps
local function on_bed(cracks)
  local bed = trilith.model { name = "bed", thickness = 0.1 }
  bed:material { name = "stone", density = 2400 }
  bed:contact { between = { "*", "*" }, name = "plane", law = trilith.bonded(law) }
  bed:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-4 } }
  bed:block { name = "floor", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
  block(bed, { cracks = cracks })
  bed:consolidate { duration = 5, rest = { ratio = 1e-5 } }
  bed:point_load { body = "rod", at = { 0.05, 0.05 }, force = { 100, 0 }, load_curve = { ramp = 0.02 } }
  bed:run { duration = 0.05 }
  return bed
end
-- the resultant over the floor does not change as the block cracks under a later force
local bed = on_bed { { { 0.3, 0 }, { 1, 0 } } }
local function floor_force()
  local x, y = 0, 0
  for _, c in ipairs(bed:contacts { between = { "floor", bed:bodies { name = "rod*" } } }) do
    x, y = x + c.force[1], y + c.force[2]
  end
  return x, y
end
local jump
bed:on("unit.cracked", function() jump = true end)
local x0, y0 = floor_force()
near(y0, 0.1*0.1*2400*9.80665, 1e-3)
near(x0, -100, 1e-2)
bed:point_load { body = "rod", at = { 0.65, 0.1 }, force = { 0, -3e4 }, load_curve = { ramp = 0.05 } }
local before, most = nil, 0
bed:run { duration = 0.06, until_true = function()
  local _, y = floor_force()
  if jump and before then most = math.abs(y - before) end
  before = y
  return jump
end }
assert(jump and most < 0.02*before, ("%s %s"):format(most, before))

-- units of a builder: parts that are fixed have no planes, and one plane crosses many units
local function wall(cracks)
  local w = trilith.model { name = "wall", thickness = 0.2 }
  w:material { name = "brick", density = 1800 }
  w:contact { between = { "brick", "brick" }, name = "unit", law = trilith.bonded(law) }
  w:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  w:wall { name = "w", length = 2, unit_length = 0.4, unit_height = 0.2, courses = 5, bond = "running",
    material = "brick", base_height = 0.4, fixed = "base", cracks = cracks, crack_law = "unit" }
  w:run { duration = 0.01 }
  return w
end
assert(wall("mid").hash == wall({ { { 1, 0 }, { 1, 0 } } }).hash)
