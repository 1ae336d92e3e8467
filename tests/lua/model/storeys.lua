-- Storeys of a building in space: drift, twist, base shear, damage, pushover by drift, and messages.
local trilith = require "trilith"

local function near(value, expected, share)
  assert(math.abs(value - expected) <= share*math.abs(expected), ("%.9g is not %.9g"):format(value, expected))
end
local function fails(f, text)
  local ok, message = pcall(f)
  assert(not ok and tostring(message):find(text, 1, true), message)
end

local g = 9.80665
local function house(law)
  local m = trilith.model { name = "house", dim = 3 }
  m:material { name = "stone", density = 2200 }
  m:contact { between = { "*", "*" }, law = law }
  local walls = m:building { name = "h", material = "stone", fixed = "base", unit_length = 0.4, unit_height = 0.2,
    walls = { { name = "front", from = { 0, 0.1 }, to = { 2.4, 0.1 } },
      { name = "back", from = { 0, 1.9 }, to = { 2.4, 1.9 } },
      { name = "left", from = { 0.1, 0.1 }, to = { 0.1, 1.9 } },
      { name = "right", from = { 2.3, 0.1 }, to = { 2.3, 1.9 } } },
    storeys = { { courses = 4, slab_height = 0.2 }, { courses = 3, slab_height = 0.2 } }, base_height = 0.3,
    base_margin = 1 }
  return m, walls
end

-- Heights from floor to floor. At rest under a level field of 0.1 g along x and 0.05 g along y the base carries both
-- components, and each storey drifts along them, the lower one by the shear of all mass above its joints.
do
  local m, walls = house(trilith.bonded { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4, tension = 1e6, cohesion = 1e6 })
  assert(#m.storeys == 2 and m.storeys[1].number == 1)
  near(m.storeys[1].height, 1.0, 1e-9)
  near(m.storeys[2].height, 0.8, 1e-9)
  m:consolidate { rest = { ratio = 1e-5 } }
  local ground = m:body "h.base"
  assert(m.base_shear < 1e-3*(walls - ground).mass*g)
  local before = { m.storeys[1].drift_x, m.storeys[1].drift_y }
  m:tilt { rate = 0.2, by = 0.1, towards = math.atan(0.5) }
  m:run { duration = 0.6, local_damping = 0.8 }
  local weight = (walls - ground).mass*g
  near(m.base_shear, weight*math.sin(0.1), 1e-2)
  near(m.base_shear_x, 2*m.base_shear_y, 1e-2)
  local low, high = m.storeys[1], m.storeys[2]
  assert(low.drift_x > before[1] and low.drift_y > before[2] and low.drift > high.drift and high.drift_x > 0)
  near(low.drift, math.sqrt(low.drift_x^2 + low.drift_y^2), 1e-12)
  near(low.drift_ratio, low.drift/low.height, 1e-12)
  near(m.top_drift_x, low.drift_x + high.drift_x, 1e-9)
  near(m.top_drift_y, low.drift_y + high.drift_y, 1e-9)
  near(m.top_drift, math.sqrt(m.top_drift_x^2 + m.top_drift_y^2), 1e-12)
  assert(math.abs(low.twist) < 1e-4 and low.damage == 0 and m.damage == 0)
  assert(m.largest_opening < 1e-3 and m.largest_opening > 0 and m.largest_slip < 1e-3)
  for _, row in ipairs(walls:damage_by_storey()) do
    assert(row.joints_apart == 0 and row.units_out_of_place == 0 and row.units > 20)
  end
  local joint = m:joints()[1]
  assert(joint.area > 0 and joint.storey >= 1 and joint.damage == 0 and joint.a and joint.b and joint.z)
  assert(tostring(low):find "storey 1")
  fails(function() m:pushover { body = "h.s2.floor", rate = 0.01, storey = 3, drift = 0.01 } end,
    "no storey 3; there are 2")
  fails(function() m:pushover { body = "h.s2.floor", direction = "z", rate = 0.01, storey = 1, drift = 0.01 } end,
    "an upright push has no drift")
end

-- A dry house pushed along -y at its upper floor, which slides: the pushover ends by the drift of its second storey
-- along -y.
do
  local m, walls = house(trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.5, beta = 1e-4 })
  m:consolidate { rest = { ratio = 1e-4 } }
  m:history { name = "drift", storey = 2, what = "drift_y" }
  local floor = m:body "h.s2.floor"
  local push = m:pushover { body = floor, direction = "-y", rate = 0.02, storey = 2, drift = 0.004,
    displacement = 0.01 }
  assert(push.limit == "drift", push.limit)
  near(push.drift, 0.004, 0.02)
  near(m.storeys[2].drift_y, -0.004, 0.05)
  -- At most the friction on the walls; less, because some of their stones move along.
  assert(push.force < 0.5*floor.mass*g and push.force > 0.8*0.5*floor.mass*g, push.force)
  assert(m.storeys[1].drift < 1e-3)
  local rows = walls:damage_by_storey { apart = 2e-3, out_of_place = 5e-3 }
  assert(rows[1].joints_apart == 0 and rows[2].joints_apart > 5 and rows[2].units_out_of_place == 0)
  fails(function() walls:damage_by_storey { apart = -1 } end, "'apart' is -1 m, must not be below 0")
end

-- A model without storeys has none, and the initial energy of bodies is not an error of the ledger.
do
  local m = trilith.model { name = "stone", dim = 3 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.5, beta = 1e-4 } }
  m:block { name = "ground", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
  local stone = m:block { name = "stone", size = { 0.2, 0.2, 0.2 }, at = { 0, 0, 1 }, material = "stone",
    floating = true, velocity = { 1, 0, 0 } }
  assert(#m.storeys == 0 and m.top_drift == 0 and m.damage == 0 and m.residual == 0)
  m:run { duration = 0.2 }
  assert(math.abs(m.residual) < 1e-6*m.energy.kinetic, m.residual)
  assert(m.energy.residual == m.residual)
  fails(function() m:pushover { body = stone, rate = 0.01, storey = 1, drift = 0.01 } end,
    "there are no storeys; leave 'storey' out")
  fails(function() m:bodies { name = "stone" }:damage_by_storey() end, "none of these 1 bodies is in a group")
end

-- Slabs on springs, without other parts of their storeys: heights count from the top of the base, as drifts do. Each
-- storey drifts by the level force of the mass above it over its spring stiffness, in the plane and along any azimuth.
for _, case in ipairs { { 2, 0 }, { 3, 0.6 }, { 3, 2.8 } } do
  local dim, azimuth = table.unpack(case)
  local tilt, stiffness, heights = 0.02, { 4e6, 3e6, 2e6 }, { 3.3, 3, 3 }
  local level, down = g*math.sin(tilt), -g*math.cos(tilt)
  local m = trilith.model { name = "slabs", dim = dim,
    gravity = dim == 2 and { level, down } or { level*math.cos(azimuth), level*math.sin(azimuth), down } }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = "none" }
  local upright = trilith.linear { stiffness = 1e9 }
  local function slab(name, z, height, spec)
    if dim == 2 then spec.width, spec.height, spec.at = 3, height, { -1.5, z }
    else spec.size, spec.at, spec.anchor = { 3, 2, height }, { 0, 0, z + height/2 }, "centre" end
    spec.name, spec.material = name, "stone"
    return m:block(spec)
  end
  slab("slab 0", -0.5, 0.5, { support = "fixed" })
  slab("pit", -4, 0.5, { support = "fixed" })
  local mass, top = 0, 0
  for i = 1, 3 do
    mass = mass + slab("slab " .. i, 3*i, 0.3, { groups = { "storey " .. i, "slabs" },
      support = dim == 2 and { rotation = "fixed" }
        or { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" } }).mass
    local at = dim == 2 and { 0, 3*i - 0.1 } or { 0, 0, 3*i - 0.1 }
    m:bearing { name = "spring " .. i, between = { "slab " .. i - 1, "slab " .. i }, from = at, to = at,
      angle = azimuth, along = trilith.linear { stiffness = stiffness[i] }, across = dim == 3 and upright or nil,
      axial = upright }
  end
  m:consolidate { integrator = "static" }
  for i = 1, 3 do
    local storey, drift = m.storeys[i], mass*(4 - i)/3*level/stiffness[i]
    near(storey.height, heights[i], 1e-12)
    near(storey.drift, drift, 1e-6)
    near(storey.drift_ratio, drift/heights[i], 1e-6)
    top = top + drift
  end
  near(m.top_drift, top, 1e-6)
  near(m.base_shear, mass*level, 1e-6)
  m:close()
end
