-- A leaning block of one element turns about its edge as a rigid one, in the plane and in space. Their difference comes
-- from the strain of the element and vanishes as its modulus grows. The time
-- to the upright position follows the pendulum equation. It is longer by the toe of the joint, within which the pivot
-- lies.
local trilith = require "trilith"

local width, height, share = 0.5, 2, 0.4
local slope, g = math.atan(width/height), 9.80665
local lean, radius = share*slope, math.sqrt(width^2 + height^2)/2

-- Time from rest at `lean` until the centroid is 2 mm from its upright place, by the integral of 1/phi' with
-- J phi'' = -m g R sin(slope - phi).
local near_upright <const> = 2e-3
local function pendulum_time()
  local last = slope - math.asin((width/2 - near_upright)/radius)
  local square, n, sum = 2*g*radius/(4/3*radius^2), 20000, 0
  local most = math.sqrt(1 - last/lean) -- phi = lean (1 - u^2) removes the singularity at rest
  for i = 1, n do
    local u = (i - 0.5)/n*most
    local phi = lean*(1 - u^2)
    sum = sum + 2*lean*u*most/n
      / math.sqrt(square*(trilith.math.cos(slope - lean) - trilith.math.cos(slope - phi)))
  end
  return sum
end

local function rock(dim, form, kn, E)
  local m = trilith.model { name = "rock", dim = dim, threads = 1 }
  m:material { name = "stone", density = 2000, E = E, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 1, beta = 2e-6 } }
  local c, s = trilith.math.cos(lean), trilith.math.sin(lean)
  local function at(x, y) return { c*x + s*y, c*y - s*x } end
  local b
  if dim == 2 then
    m:block { name = "floor", width = 8, height = 0.5, at = { -4, -0.5 }, material = "stone", support = "fixed" }
    b = m:polygon { name = "b", outline = { at(-width, 0), at(0, 0), at(0, height), at(-width, height) },
                    material = "stone", body = form, floating = true }
  else
    m:block { name = "floor", size = { 8, 2, 0.5 }, at = { -4, -1, -0.5 }, material = "stone", support = "fixed" }
    b = m:block { name = "b", size = { width, 0.5, height }, at = { 0, 0, 0 }, material = "stone", body = form,
                  floating = true, turn = { axis = { 0, 1, 0 }, angle = -lean } }
  end
  local first, t = nil, 0
  local last
  m:on_step(function()
    local left = width/2 - math.abs(b.x)
    if not first and left <= near_upright and last then
      first = t + (m.time - t)*(last - near_upright)/(last - left)
    end
    last, t = left, m.time
  end)
  m:run { duration = 0.6 }
  m:close()
  return first
end

local expected = pendulum_time()
for _, dim in ipairs { 2, 3 } do
  local rigid, stiffer = rock(dim, "rigid", 1e11, 2e10), rock(dim, "rigid", 1e12, 2e10)
  local form = dim == 2 and "quad" or "brick"
  local soft, stiff = rock(dim, form, 1e11, 2e10), rock(dim, form, 1e11, 2e11)
  local function off(time) return math.abs(time/rigid - 1) end
  if os.getenv "TRILITH_SHOW" then print(dim, expected, rigid, stiffer, soft, stiff) end
  assert(off(soft) < 2e-4 and off(stiff) < 0.3*off(soft) + 1e-6, ("dim %d: %g, %g"):format(dim, off(soft), off(stiff)))
  -- The toe is proportional to the root of weight over stiffness, and the pivot lies within the edge by a part of it.
  local late, less = rigid/expected - 1, stiffer/expected - 1
  assert(less > 0 and late < 4e-3 and late/less > 2.5 and late/less < 3.5, ("dim %d: %g, %g"):format(dim, late, less))
end
