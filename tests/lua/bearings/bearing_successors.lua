-- A bearing with a successor law that counts displacements from the switch (`becomes_from`): in the plane and in space,
-- by explicit and implicit steps and statics, when changed, after a rewind, and in readings.
local trilith = require "trilith"

local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed*math.abs(expected), ("%.9g instead of %.9g"):format(value, expected))
end

-- A block of 2,000 kg with 100 J on a spring of 10 kN/m, which stores 50 J at its limit; its successor is a spring of 1
-- MN/m.
local function handed_on(dim, from, speed)
  local m = trilith.model { name = "handed on", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 1000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5 } }
  local flat = dim == 2
  local function stone(name, x, more)
    more.name, more.material, more.mass = name, "stone", 2000
    if flat then more.width, more.height, more.at = 1, 1, { x, 0 }
    else more.size, more.at = { 1, 1, 1 }, { x, 0, 0 } end
    return m:block(more)
  end
  stone("base", 0, { support = "fixed" })
  local block = stone("block", 2, { floating = true,
    velocity = flat and { speed or 0.1^0.5, 0 } or { speed or 0.1^0.5, 0, 0 } })
  local function link(name, stiffness, more)
    more.name, more.between, more.along = name, { "base", "block" }, trilith.linear { stiffness = stiffness }
    more.from, more.to = flat and { 1, 0.5 } or { 1, 0.5, 0.5 }, flat and { 2, 0.5 } or { 2, 0.5, 0.5 }
    return m:bearing(more)
  end
  local first = link("first", 1e4, { limit = { along = 0.1 }, becomes = "second", becomes_from = from })
  return m, first, link("second", 1e6, { waiting = true, limit = { along = 0.05 } }), block
end

for _, dim in ipairs { 2, 3 } do
  for _, integrator in ipairs { "explicit", "implicit" } do
    for _, from in ipairs { "here", "start", { along = "here" } } do
      local m, first, second = handed_on(dim, from)
      local farthest, most = 0, 0
      m:on_step(function()
        farthest = math.max(farthest, second.displacement_along)
        if second.status == "intact" then most = math.max(most, second.share) end
      end)
      if from == "start" then
        -- The successor's limit is exceeded from its first instant on.
        m:run { duration = 0.4, dt = 5e-4, integrator = integrator }
        assert(first.status == "changed" and second.status == "failed", second.status)
        assert(math.abs(m.energy.residual) < 1e-9*5000, m.energy.residual)
      else
        m:run { duration = 0.6, dt = 5e-4, integrator = integrator }
        assert(first.status == "changed" and second.status == "intact", second.status)
        local energy = m.energy
        near(energy.bearing_failure, 50, 5e-3)
        assert(math.abs(energy.residual) < 1e-9*100, energy.residual)
        near(farthest, 0.11, 2e-3)
        -- The successor's limit counts from the switch as well; the displacement reading counts from the bearing's
        -- placement.
        near(most, 0.01/0.05, 1e-2)
      end
      m:close()
    end
  end
end

-- After a rewind into the time of the successor, and of the first law, the run gives the same displacements.
for _, dim in ipairs { 2, 3 } do
  local m, first, second = handed_on(dim, "here")
  m:checkpoints { every = 0.05 }
  m:run { duration = 0.6, dt = 5e-4 }
  local hash = m.hash
  for _, time in ipairs { 0.45, 0.2 } do
    m:rewind { to = time }
    assert(second.status == (time > 0.3 and "intact" or "waiting"), second.status)
    m:continue()
    assert(m.hash == hash and first.status == "changed")
  end
  m:close()
end

-- Under a load of 2 kN, which the first law could carry at 0.2 m, statics finds the equilibrium of the successor, which
-- counts from the switch.
for _, dim in ipairs { 2, 3 } do
  local m, first, second, block = handed_on(dim, "here", 0)
  m:fix(block, dim == 2 and "yr" or "yz")
  m:point_load { body = block, force = dim == 2 and { 2e3, 0 } or { 2e3, 0, 0 } }
  local report = m:consolidate { integrator = "static" }
  assert(report.rests and first.status == "changed" and second.status == "intact", report.reason)
  near(second.force_along, 2e3, 1e-5)
  near(second.share, 2e-3/0.05, 1e-5)
  assert(second.displacement_along > 0.1)
  assert(m.energy.bearing_failure > 49)
  m:close()
end

-- `becomes_from` is set later, for one direction or for all, and removed together with the successor.
do
  local m, first = handed_on(2, nil)
  m:run { duration = 0.01, dt = 5e-4 }
  m:change { bearing = "first", becomes = false }
  local ok, message = pcall(function() m:change { bearing = "first", becomes_from = { along = "here" } } end)
  assert(not ok and tostring(message):find("'becomes_from' is \"here\", but it becomes no bearing", 1, true), message)
  m:change { bearing = "first", becomes = "second", becomes_from = "start" }
  m:change { bearing = "first", becomes_from = { along = "here" } }
  m:run { duration = 0.6, dt = 5e-4 }
  near(m.energy.bearing_failure, 50, 5e-3)
  assert(first.status == "changed")
  m:close()
end
