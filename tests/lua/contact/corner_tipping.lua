-- A post on an elastic joint, under gravity tilted towards a corner of its foot. Leaning by th it stands on a triangle
-- with legs l at this corner, with the force kn l^3 sin(th)/(6 sqrt 2) at sqrt(2) l/4 from the corner. So gravity may
-- be tilted by at most atan(r/(h/2)) - th, r = b/sqrt(2) - sqrt(2) l/4, maximised over th. This is below the limit of
-- the rigid post by a share proportional to the cube root of 1/kn.
local trilith = require "trilith"

local g, b, h, density = 9.80665, 0.3, 0.8, 2300
local weight = density*b*b*h*g

local function most(kn)
  local best = 0
  for i = 1, 40000 do
    local th = i*5e-6
    local l = (6*math.sqrt(2)*weight/(kn*math.sin(th)))^(1/3)
    if l < b then best = math.max(best, math.atan(b/math.sqrt(2) - math.sqrt(2)*l/4, h/2) - th) end
  end
  return best
end

-- Whether the post stands, rotated about the vertical by `turn`, with gravity tilted by `tilt` towards its corner.
local function stands(kn, tilt, turn, integrator)
  local azimuth = math.pi/4 + turn
  local level = g*math.sin(tilt)
  local m = trilith.model { name = "post", dim = 3,
    gravity = { level*math.cos(azimuth), level*math.sin(azimuth), -g*math.cos(tilt) } }
  m:material { name = "stone", density = density }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 0.9, beta = 1e-4 } }
  m:block { name = "ground", size = { 4, 4, 1 }, at = { 0, 0, -0.5 }, anchor = "centre", support = "fixed",
    material = "stone" }
  local post = m:block { name = "post", size = { b, b, h }, at = { 0, 0, h/2 }, anchor = "centre", material = "stone",
    turn = { axis = { 0, 0, 1 }, angle = turn } }
  local stood, why
  if integrator == "static" then
    stood, why = pcall(m.consolidate, m, { integrator = "static", shares = 20 })
    assert(stood or tostring(why):find("did not come to rest", 1, true), why)
  else
    stood = m:consolidate { duration = 60, grow = 10, until_collapse = true }.ending == "rest"
  end
  assert(not stood or math.sqrt(post.ux^2 + post.uy^2) < 0.1*b)
  m:close()
  return stood
end

for _, case in ipairs { { 1e9, 0, "static" }, { 1e9, 0.4, "explicit" }, { 1e10, 0.4, "static" },
  { 1e10, 0, "explicit" } } do
  local kn, turn, integrator = table.unpack(case)
  local tilt = most(kn)
  assert(tilt < 0.97*math.atan(math.sqrt(2)*b/h), "joints that give cost some of the rigid post's tilt")
  assert(stands(kn, 0.99*tilt, turn, integrator) and not stands(kn, 1.01*tilt, turn, integrator),
    ("kn %g Pa/m, %s: limit %g"):format(kn, integrator, tilt))
end
