-- Friction of a rectangle that slides and rotates, against the integral of Coulomb friction over its area, for several
-- side ratios and centres of rotation on a fixed floor.
local trilith = require "trilith"

local mu, density, thick = 0.5, 2000, 0.2

-- Shares of mu N: force along x and y, and couple over the mean distance, of an area that rotates about (cx, cy) [m].
local function integral(length, cx, cy)
  local n, fx, fy, couple, distance = 120, 0, 0, 0, 0
  for i = 1, n do
    for j = 1, n do
      local x, y = ((i - 0.5)/n - 0.5)*length, (j - 0.5)/n - 0.5
      local dx, dy = x - cx, y - cy
      local d = math.sqrt(dx*dx + dy*dy) + 1e-12
      fx, fy, couple = fx - dy/d, fy + dx/d, couple + (x*dx + y*dy)/d
      distance = distance + math.sqrt(x*x + y*y)
    end
  end
  return fx/n^2, fy/n^2, couple/distance, distance/n^2
end

-- The same shares measured on a block, driven slowly about the centre until friction is constant.
local function measured(length, cx, cy, distance)
  local m = trilith.model { name = "rectangle", dim = 3 }
  m:material { name = "s", density = density }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = mu, beta = 1e-3 } }
  m:block { name = "floor", size = { 12, 12, 0.5 }, at = { -6, -6, -0.5 }, material = "s", support = "fixed" }
  local held = { x = "fixed", y = "fixed", rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" }
  local b = m:block { name = "b", size = { length, 1, thick }, at = { -length/2, -0.5, 0 }, material = "s",
    support = held }
  m:run { duration = 0.2 }
  local turn = 1e-3/math.max(1, math.sqrt(cx*cx + cy*cy))
  local function ramp(by) return by ~= 0 and trilith.ramp { by = by, duration = 0.2 } or nil end
  m:drive { body = b, x = ramp(cy*turn), y = ramp(-cx*turn), rotation_z = ramp(turn) }
  m:run { duration = 0.1 }
  local r, limit = b:reactions()[1], mu*density*length*thick*9.80665
  local fx, fy, couple = r.fx/limit, r.fy/limit, r.mz/(limit*distance)
  m:close()
  return fx, fy, couple
end

local function is(what, got, expected, off)
  assert(math.abs(got - expected) < off, ("%s: %.4f for %.4f"):format(what, got, expected))
end

for _, length in ipairs { 1, 1.5, 2, 3, 5 } do
  for _, centre in ipairs { { 0, 0 }, { 1/6, 0 }, { 0.3, 0 }, { 0.5, 0 }, { 0, 0.3 }, { 0.2, 0.1 }, { 2, 1 } } do
    local cx, cy = centre[1]*length, centre[2]*length
    local x, y, t, distance = integral(length, cx, cy)
    local fx, fy, couple = measured(length, cx, cy, distance)
    local what = ("%g : 1 about (%g, %g)"):format(length, centre[1], centre[2])
    -- Friction power of a unit rotation about the centre: the limit along its rays, as both surfaces are convex.
    local power, expected = cy*fx - cx*fy + distance*couple, cy*x - cx*y + distance*t
    is(what .. ": power", power/expected, 1, 0.02)
    if cx == 0 and cy == 0 then is(what .. ": torsion", couple, 1, 0.012) end
    -- Error of the limit surface, and up to 1 % of the mean distance.
    local off = (cx == 0 or cy == 0) and 0.025 or 0.045
    is(what .. ": force across", fy, y, off)
    is(what .. ": force along", fx, x, off)
    is(what .. ": couple", couple, t, off)
    if power < 0 then error(what .. ": friction gives energy") end
  end
  local _, fy = measured(length, -1e4*length, 0, 1)
  is(("%g : 1 straight across"):format(length), math.abs(fy), 1, 1e-3)
end
