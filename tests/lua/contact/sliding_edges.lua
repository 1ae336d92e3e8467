-- A body that slides on an edge or a corner without friction is not braked, and the rebound of an edge impact follows
-- the damping. Contacts of general shape are damped along the resultant of their springs alone
-- (docs/theory/contact.md).
local trilith = require "trilith"
local near = dofile "near_expected.lua"

local g <const> = 9.81

local function law_of(case)
  if case.power then return trilith.power { kn = case.kn, depth = 1e-5, ks = case.kn/2, mu = 0, beta = case.beta } end
  return trilith.frictional { kn = case.kn, ks = case.kn/2, mu = 0, beta = case.beta }
end

local function model_of(case)
  local m = trilith.model { name = "edge", dim = case.dim, gravity = g }
  m:material { name = "stone", density = 2000, E = 1e10, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = law_of(case) }
  return m
end

-- A body with fixed rotation slides on one of its edges along a level floor.
local function slides(case)
  local m, tilt, v = model_of(case), case.tilt or 0.3, case.speed or 2
  local height = 0.25*math.sin(tilt) + 0.15*math.cos(tilt)
  if case.dim == 3 then
    m:block { name = "floor", size = { 12, 2, 1 }, at = { -6, -1, -1 }, material = "stone", support = "fixed" }
    local fixed = { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" }
    if case.sides then
      local section = {}
      for i = 1, case.sides do
        local at = 2*math.pi*(i + 0.5)/case.sides
        section[i] = { 0.2*math.cos(at), 0.2*math.sin(at) }
      end
      m:prism { name = "a", section = section, thickness = 0.4, along = { 0, 1, 0 }, at = { 0, -0.2, 0.2 },
                material = "stone", velocity = { v, 0, 0 }, support = fixed }
    else
      m:block { name = "a", size = { 0.5, 0.4, 0.3 }, anchor = "centre", turn = { axis = { 0, 1, 0 }, angle = tilt },
                at = { 0, 0, height }, material = "stone", velocity = { v, 0, 0 }, support = fixed }
    end
  else
    m:block { name = "floor", width = 12, height = 1, at = { -6, -1 }, material = "stone", support = "fixed" }
    if case.sides then
      local outline = {}
      for i = 1, case.sides do
        local at = 2*math.pi*(i - 0.25)/case.sides + 0.01
        outline[i] = { 0.2*math.cos(at), 0.2*math.sin(at) + 0.2 }
      end
      m:polygon { name = "a", outline = outline, material = "stone", velocity = { v, 0 },
                  support = { rotation = "fixed" } }
    else
      m:block { name = "a", width = 0.5, height = 0.3, anchor = "centre", angle = -tilt, at = { 0, height },
                material = "stone", velocity = { v, 0 }, support = { rotation = "fixed" } }
    end
  end
  m:run { duration = 0.4, integrator = case.integrator }
  near(("%s: speed after .4 s"):format(case[1]), m:body "a".vx, v, 1e-7)
  local given_off = m.energy.contact_damping
  assert(given_off >= -1e-9, case[1])
  m:close()
end

slides { "a corner on a floor", dim = 2, kn = 1e9, beta = 1e-4 }
slides { "... stiff, strongly damped", dim = 2, kn = 1e10, beta = 1e-3 }
slides { "... in implicit steps", dim = 2, kn = 1e9, beta = 1e-4, integrator = "implicit" }
slides { "... nearly flat", dim = 2, kn = 1e9, beta = 1e-4, tilt = 0.02 }
slides { "... under a power law", dim = 2, kn = 1e9, beta = 1e-4, power = true }
slides { "a polygon of 12 corners", dim = 2, kn = 1e9, beta = 1e-4, sides = 12 }
slides { "an edge on a floor, in space", dim = 3, kn = 1e9, beta = 1e-4 }
slides { "... stiff, strongly damped", dim = 3, kn = 1e10, beta = 1e-3 }
slides { "... in implicit steps", dim = 3, kn = 1e9, beta = 1e-4, integrator = "implicit" }
slides { "... under a power law", dim = 3, kn = 1e9, beta = 1e-4, power = true }

-- A square on a corner, or a cube on an edge, is thrown against a floor and rebounds. At the penetration d the flanks
-- are d sqrt 2 long each, and the base is 2 d long and at most d / sqrt 2 deep. A stress that rises linearly from 0 to
-- s, damped by c, has the resultant (s + c)^2 / 2 s instead of s / 2 if s + c is above 0. The equation of motion is
-- integrated by the Runge-Kutta method.
local function rebound(kn, beta, mass, speed)
  local function force(d, rate)
    if d <= 0 then return 0 end
    local function left(s, c) return c >= 0 and s/2 + c or math.max(0, s + c)^2/(2*s) end
    local m = math.sqrt(0.5)
    local flanks, base = 2*d*math.sqrt(2)*m*left(d, beta*m*rate), 2*d*left(d*m, beta*rate)
    return 0.5*kn*(flanks + base)
  end
  local d, v, dt = 0, speed, 2e-7
  repeat
    local function a(x, u) return -force(x, u)/mass end
    local v1, a1 = v, a(d, v)
    local v2, a2 = v + dt/2*a1, a(d + dt/2*v1, v + dt/2*a1)
    local v3, a3 = v + dt/2*a2, a(d + dt/2*v2, v + dt/2*a2)
    local v4, a4 = v + dt*a3, a(d + dt*v3, v + dt*a3)
    d, v = d + dt/6*(v1 + 2*v2 + 2*v3 + v4), v + dt/6*(a1 + 2*a2 + 2*a3 + a4)
  until d <= 0
  return -v
end

for _, case in ipairs { { dim = 2, share = 1e-3 }, { dim = 3, share = 1e-2 } } do
  case.kn, case.beta = 1e9, 2e-4
  local m = trilith.model { name = "bounce", dim = case.dim, gravity = 0 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = law_of(case) }
  local half = 0.2*math.sqrt(2)
  if case.dim == 3 then
    m:block { name = "floor", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "a", size = { 0.4, 1, 0.4 }, anchor = "centre", turn = { axis = { 0, 1, 0 }, angle = math.pi/4 },
              at = { 0, 0, half + 1e-3 }, material = "stone", velocity = { 0, 0, -1 },
              support = { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" } }
  else
    m:block { name = "floor", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "a", width = 0.4, height = 0.4, anchor = "centre", angle = math.pi/4, at = { 0, half + 1e-3 },
              material = "stone", velocity = { 0, -1 }, support = { rotation = "fixed" } }
  end
  m:run { duration = 0.05, dt = 2e-6 }
  local a = m:body "a"
  near(("rebound from an edge, dim %d"):format(case.dim), case.dim == 3 and a.vz or a.vy,
    rebound(case.kn, case.beta, 320, 1), case.share)
  m:close()
end

-- A ladder slides down between a floor and a wall without friction: L w^2 = 3 g (sin th0 - sin th).
for _, beta in ipairs { 1e-4, 1e-3 } do
  local m = trilith.model { name = "ladder", dim = 2, gravity = g }
  m:material { name = "wood", density = 700 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0, beta = beta } }
  local length, thick, th0 = 3, 0.02, 1.2
  m:block { name = "floor", width = 8, height = 1, at = { 0, -1 }, material = "wood", support = "fixed" }
  m:block { name = "wall", width = 1, height = 8, at = { -1, 0 }, material = "wood", support = "fixed" }
  local c, s = math.cos(th0), math.sin(th0)
  local x, y = c*length + s*thick, s*length + c*thick
  m:block { name = "ladder", width = length, height = thick, anchor = "centre", angle = -th0, at = { x/2, y/2 },
            material = "wood" }
  local ladder = m:body "ladder"
  m:run { duration = 3, until_true = function() return ladder.rotation > 0.35 end }
  local th = th0 - ladder.rotation
  near(("spin of a ladder, beta %g"):format(beta),
    ladder.spin, math.sqrt(3*g/length*(math.sin(th0) - math.sin(th))), 0.02)
  local taken = m.energy.contact_damping/-m.energy.gravity
  assert(taken < 0.005, ("its contacts took %g of what fell"):format(taken))
  m:close()
end
