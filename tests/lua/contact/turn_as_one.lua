-- Bodies that rotate together do not slide against each other: a block held by friction on a rotating table, and blocks
-- in mortar that fly and spin, in the plane and in space. Plain leapfrog steps would make them slide by W^2 r dt / 2
-- per second.
local trilith = require "trilith"
local rate, r = 1.3, 1.5

--- A body on a table that rotates about z, at a share of its friction limit: change of its radius [m].
local function on_table(safety)
  local m = trilith.model { name = "table", dim = 3, overlap_allowed = 1e-2 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e7, ks = 1e7, mu = 0.6, beta = 1e-3 } }
  local top = m:block { name = "table", size = { 6, 6, 0.5 }, at = { -3, -3, -0.5 }, material = "stone",
                        support = "fixed" }
  local turning = { name = "rider", material = "stone", velocity = { 0, rate*r, 0 }, spin = { 0, 0, rate },
                    floating = true }
  turning.size, turning.at = { 0.1, 0.1, 0.02 }, { r - 0.05, -0.05, -3.92e-5 }
  local rider = m:block(turning)
  m:drive { body = top, rotation_z = trilith.motion { velocity = rate, duration = 5 } }
  m:run { duration = 0.1, safety = safety }
  local before = math.sqrt(rider.x^2 + rider.y^2)
  local report = m:run { duration = 0.3, safety = safety }
  local out, crept = math.sqrt(rider.x^2 + rider.y^2) - before, rate^2*r*report.longest_dt/2*0.3
  m:close()
  return out, crept
end

for _, safety in ipairs { 0.5, 0.25 } do
  local out, crept = on_table(safety)
  assert(math.abs(out) < 0.02*crept, ("the block on the table creeps by %g m, as steps would have it by %g"):format(
    out, crept))
end

--- Two blocks in mortar, offset sideways and upwards, that fly and spin about their common centre: the shear force
--- between them is the centripetal force of the second block, and does not grow with time.
local function flying(dim, W)
  local m = trilith.model { name = "flying", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.bonded { kn = 1e9, ks = 1e9, mu = 0.6, beta = 1e-5,
    tension = 1e6, cohesion = 1e6 } }
  local function block(name, x, y)
    local v = { -W*(y + 0.25), W*(x + 0.5) } -- velocity of the middle, about the origin
    if dim == 3 then
      return m:block { name = name, size = { 1, 0.5, 0.5 }, at = { x, y, 0 }, material = "stone", floating = true,
                       velocity = { v[1], v[2], 0 }, spin = { 0, 0, W } }
    end
    return m:block { name = name, width = 1, height = 0.5, at = { x, y }, material = "stone", floating = true,
                     velocity = v, spin = W }
  end
  local lower, upper = block("lower", -0.75, -0.5), block("upper", -0.25, 0)
  m:run { duration = 0.05 }
  local function apart() return math.sqrt((upper.x - lower.x)^2 + (upper.y - lower.y)^2) end
  local before, most, least = apart(), 0, math.huge
  m:on_step(function() most, least = math.max(most, apart()), math.min(least, apart()) end)
  local report = m:run { duration = 0.4 }
  local crept = W^2*0.5*report.longest_dt/2*0.4
  local friction = m.energy.contact_friction
  m:close()
  return most - before, before - least, crept, friction
end
for _, dim in ipairs { 2, 3 } do
  local out, back, crept, friction = flying(dim, 4)
  if os.getenv "TRILITH_SHOW" then print(dim, out, back, crept, friction) end
  assert(math.max(out, back) < 0.05*crept + 3e-6 and math.abs(friction) < 1e-3,
    ("dim %d: mortar that spins creeps by %g and %g m, steps by %g; %g J of friction"):format(dim, out, back, crept,
      friction))
end
