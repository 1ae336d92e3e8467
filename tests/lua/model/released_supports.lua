-- The force of a released support decreases to zero over `fade` with the share 1 - (6 s^5 - 15 s^4 + 10 s^3). The block
-- then falls at g fade/2, and with the acceleration g afterwards.
local trilith = require "trilith"
local g, dt = 9.80665, 1e-4

local function block(dim)
  local m = trilith.model { name = "released", dim = dim }
  m:material { name = "stone", density = 2500 }
  m:block { name = "block", width = dim == 2 and 1 or nil, height = dim == 2 and 0.5 or nil, material = "stone",
            size = dim == 3 and { 1, 0.6, 0.5 } or nil, at = dim == 2 and { 0, 0 } or { 0, 0, 0 }, support = "fixed" }
  m:run { duration = 0.01, dt = dt }
  return m, dim == 2 and "vy" or "vz"
end

for dim = 2, 3 do
  for _, fade in ipairs { 0.05, 0.2 } do
    local m, speed = block(dim)
    m:release { body = "block", x = true, y = true, z = dim == 3 or nil, fade = fade }
    for _, s in ipairs { 0.5, 1 } do
      m:run { duration = 0.5*fade, dt = dt }
      local fallen = -m:body("block")[speed]
      assert(math.abs(fallen - g*fade*(s^6 - 3*s^5 + 2.5*s^4)) < g*dt, ("%g after %g fade"):format(fallen, s))
    end
    m:run { duration = 0.05, dt = dt }
    assert(math.abs(-m:body("block")[speed] - g*(0.5*fade + 0.05)) < g*dt)
    m:close()
  end
end
