-- Steps of slow soft models are as long as the active forces allow, without a constant limit. Springs oscillate with
-- their period, motions and load curves are resolved while they act, and long steps return after them.
local trilith = require "trilith"

local function built(dim, period)
  local m = trilith.model { name = "slow", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 1000 }
  m:contact { between = { "*", "*" }, law = "none" }
  local plane = dim == 2
  local function block(name, height, options)
    options.name, options.material, options.at = name, "stone", plane and { 0, height } or { 0, 0, height }
    if plane then options.width, options.height = 1, 1 else options.size = { 1, 1, 1 } end
    return m:block(options)
  end
  local base = block("base", 0, { support = "fixed" })
  local held = plane and { y = "fixed", rotation = "fixed" } or
    { y = "fixed", z = "fixed", rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" }
  local mass = block("mass", 2, { support = held, floating = true, velocity = plane and { 1, 0 } or { 1, 0, 0 } })
  if period then
    local spring = trilith.linear { stiffness = mass.mass*(2*math.pi/period)^2 }
    m:bearing { name = "spring", between = { "base", "mass" }, at = plane and { 0.5, 1.5 } or { 0.5, 0.5, 1.5 },
                along = spring }
  end
  return m, mass, base
end

for _, dim in ipairs { 2, 3 } do
  -- Alone: no reason for short steps.
  local m = built(dim)
  assert(m:run { duration = 10 }.steps <= 250)
  m:close()
  -- On a spring: the mean period of many oscillations is right to 0.5 %, with far fewer steps than at 5 ms.
  for _, period in ipairs { 0.5, 2, 8 } do
    local mass
    m, mass = built(dim, period)
    local crossings, last, before, t0 = 0, 0, 0, 0
    m:on_step(function()
      local x = mass.ux
      if before < 0 and x >= 0 then crossings, last = crossings + 1, m.time - (m.time - t0)*x/(x - before) end
      before, t0 = x, m.time
    end)
    local report = m:run { duration = 10.5*period }
    local found = last/crossings
    assert(crossings == 10 and math.abs(found/period - 1) < 5e-3, ("period %g s: %g"):format(period, found))
    assert(report.steps < 10.5*period/0.005/1.3, report.steps)
    m:close()
  end
  -- A motion of 10 ms samples is resolved for as long as it acts.
  local base
  m, _, base = built(dim, 8)
  local acceleration = {}
  for i = 1, 201 do acceleration[i] = math.sin(2*math.pi*(i - 1)/100)*math.sin(math.pi*(i - 1)/200)^2 end
  m:drive { body = base, x = trilith.motion { acceleration = acceleration, dt = 0.01, allow_drift = true } }
  assert(m:run { duration = 1.9 }.longest_dt <= 0.005)
  m:run { duration = 0.5 }
  assert(m:run { duration = 5 }.longest_dt > 0.02)
  m:close()
end
