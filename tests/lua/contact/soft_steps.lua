-- In a soft model the longest stable step is far longer than a record needs. A deck on a spring with a period of 2 s
-- under a base motion of 4 Hz with samples of 0.01 s agrees with small steps of its equation, and a limit is detected
-- in time.
local trilith = require "trilith"

local period, sample, count = 2, 0.01, 1000
local w = 2*math.pi/period
local acceleration = {}
for i = 1, count do acceleration[i] = 3*math.sin(8*math.pi*(i - 1)*sample)*math.sin(math.pi*(i - 1)/count) end

-- Largest relative displacement, and the first time at which it reaches `limit`: x'' + w^2 x = -a.
local function expected(limit)
  local steps, x, v, largest, at = 50, 0, 0, 0, nil
  local dt = sample/steps
  for i = 1, count - 1 do
    for k = 0, steps - 1 do
      local a = acceleration[i] + (acceleration[i + 1] - acceleration[i])*(k + 0.5)/steps
      v = v - dt*(w*w*x + a)
      x = x + dt*v
      largest = math.max(largest, math.abs(x))
      if not at and limit and math.abs(x) > limit then at = (i - 1)*sample + (k + 1)*dt end
    end
  end
  return largest, at
end

local function shaken(dim, limit)
  local m = trilith.model { name = "deck", dim = dim, gravity = 0 }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, law = "none" }
  local plane = dim == 2
  local function block(name, height, options)
    options.name, options.material, options.at = name, "concrete", plane and { 0, height } or { 0, 0, height }
    if plane then options.width, options.height = 4, 1 else options.size = { 4, 1, 1 } end
    return m:block(options)
  end
  local base = block("base", 0, { support = "fixed" })
  local deck = block("deck", 1.2, { floating = true })
  local spring = trilith.linear { stiffness = deck.mass*w*w }
  local laws = plane and { along = spring, axial = spring, turning = spring } or
    { along = spring, across = spring, axial = spring, turning_along = spring, turning_across = spring }
  laws.name, laws.between, laws.at = "spring", { "base", "deck" }, plane and { 2, 1.7 } or { 2, 0.5, 1.7 }
  if limit then laws.limit = { along = limit } end
  m:bearing(laws)
  local failed, largest = nil, 0
  m:on("bearing.failed", function(e) failed = e.time end)
  m:on_step(function() largest = math.max(largest, math.abs(deck.ux - base.ux)) end)
  m:shake { body = "base", x = trilith.motion { acceleration = acceleration, dt = sample, allow_drift = true } }
  m:close()
  return largest, failed
end

local right = expected()
local limit = 0.6*right
for _, dim in ipairs { 2, 3 } do
  local largest, none = shaken(dim)
  assert(not none and math.abs(largest/right - 1) < 5e-3, ("%d: %g m for %g"):format(dim, largest, right))
  local _, failed = shaken(dim, limit)
  local _, at = expected(limit)
  assert(failed and at and failed >= at - 1e-3 and failed < at + 0.01, ("%d: %s s for %s"):format(dim, failed, at))
end
