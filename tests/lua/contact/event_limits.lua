-- Limits of events from both sides. Faces and corners that meet make an impact from the speed `impact_speed` on, with
-- the closing speed as value. A body is at rest once it has been slower than `still_speed` for `still_time`.
local trilith = require "trilith"
local limit = 0.2

local function meets(dim, share, tilt)
  local speed, met = share*limit, nil
  local m = trilith.model { name = "meeting", dim = dim, gravity = 0, impact_speed = limit }
  m:material { name = "stone", density = 2500 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0, beta = 0 } }
  if dim == 2 then
    m:block { name = "base", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", width = 1, height = 0.5, at = { -0.5, 0.01 }, angle = tilt, material = "stone",
              floating = true, velocity = { 0, -speed } }
  else
    m:block { name = "base", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", size = { 1, 1, 0.5 }, at = { -0.5, -0.5, 0.01 }, material = "stone", floating = true,
              velocity = { 0, 0, -speed } }
  end
  for _, kind in ipairs { "impact", "contact.made" } do
    m:on(kind, function(e)
      if not met then met = { kind = kind, value = e.value } end
    end)
  end
  m:run { duration = 0.4/speed, dt = 1e-4 }
  m:close()
  assert(met, "they do not meet")
  assert(math.abs(met.value - speed) < 0.02*speed, ("%g m/s instead of %g"):format(met.value, speed))
  return met.kind
end

for _, c in ipairs { { 2 }, { 2, 0.3 }, { 3 } } do
  assert(meets(c[1], 1.05, c[2]) == "impact")
  assert(meets(c[1], 0.95, c[2]) == "contact.made")
end

-- A block that slides to a stop is slower than `slow` from (v - slow)/(mu g) on.
for dim = 2, 3 do
  local still, slow, speed, mu, rested = 0.05, 0.1, 0.3, 0.5, nil
  local m = trilith.model { name = "still", dim = dim, still_time = still, still_speed = slow }
  m:material { name = "stone", density = 2500 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = mu, beta = 1e-4 } }
  if dim == 2 then
    m:block { name = "base", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", width = 1, height = 0.1, at = { -0.5, 0 }, material = "stone", velocity = { speed, 0 } }
  else
    m:block { name = "base", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", size = { 1, 1, 0.1 }, at = { -0.5, -0.5, 0 }, material = "stone",
              velocity = { speed, 0, 0 } }
  end
  m:on("body.rest", function(e) rested = rested or e.time end)
  m:run { duration = 0.2 }
  local expected = (speed - slow)/(mu*9.80665) + still
  assert(rested and math.abs(rested - expected) < 0.05*expected, rested)
  m:close()
end
