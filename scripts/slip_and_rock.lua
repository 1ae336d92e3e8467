-- The effect of friction stiffness and of the shape of a foot on the result: the figures of docs/guide/numbers.md.
--
-- First a block slides back and forth under El Centro at 1.6 g, compared with Coulomb's law alone. Then blocks rock
-- on their whole base or on two feet, compared with Housner (1963). Half a minute.
local trilith = require "trilith"
local mu, g, density = 0.3, 9.80665, 2400
local duration = 12
local motion = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = 1.6*g }

--- Where a block without elasticity has slid to, and how far in all.
local function coulomb(dt)
  local v, u, path = 0, 0, 0
  for i = 1, math.floor(duration/dt + 0.5) do
    local a, before = motion:at((i - 0.5)*dt), v
    if v ~= 0 then
      v = v - dt*(a + (v > 0 and mu*g or -mu*g))
      if v*before < 0 then v = 0 end
    elseif math.abs(a) > mu*g then
      v = dt*((a > 0 and mu*g or -mu*g) - a)
    end
    u, path = u + 0.5*(before + v)*dt, path + 0.5*math.abs(before + v)*dt
  end
  return u, path
end

--- The same with contact that gives by `give` [m] before it slides.
local function slid(give)
  local width, height = 1, 0.5
  local ks = mu*density*g*height/give
  local beta = 2*0.1/math.sqrt(2*ks/(density*height))
  local m = trilith.model { name = "sliding block" }
  m:material { name = "stone", density = density }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 2*ks, ks = ks, mu = mu, beta = beta } }
  local ground = m:block { name = "ground", width = 6, height = 0.5, at = { -3, -0.5 }, material = "stone",
    support = "fixed" }
  local block = m:block { name = "block", width = width, height = height, at = { -0.5, 0 }, material = "stone" }
  m:consolidate { duration = 10 }
  local x0 = block.x - ground.x
  m:shake { body = ground, x = motion, duration = duration }
  return block.x - ground.x - x0
end

local exact, path = coulomb(1e-5)
print(("Coulomb's law alone: residual slip %.1f mm, path %.0f mm"):format(1e3*exact, 1e3*path))
local errors = {}
for i, give in ipairs { 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6 } do
  local u = slid(give)
  errors[i] = (u - exact)/exact
  print(("elastic displacement %6.3f mm: residual slip %.1f mm, error %+.1f %%"):format(1e3*give, 1e3*u, 100*errors[i]))
end

--- Share of its speed that a rocking block keeps at its first impacts, from the angles it swings to; `zeta` is the
--- damping for the block on its whole base.
local function kept(slenderness, feet, zeta)
  local h, b, kn = 1, slenderness, 2e10
  local m = trilith.model { name = "rocking block" }
  m:material { name = "stone", density = density }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = 0.5*kn, mu = 0.9,
    beta = 2*zeta/math.sqrt(kn*b/(density*b*h)) } }
  m:block { name = "ground", width = 4*b, height = 0.2, at = { -2*b, -0.2 }, material = "stone", support = "fixed" }
  local f, r = 0.02*b, 0.01*h -- a foot's width, and how far the base stands back between the two
  local outline = feet and { { 0, 0 }, { f, 0 }, { f, r }, { b - f, r }, { b - f, 0 }, { b, 0 }, { b, h }, { 0, h } }
    or { { 0, 0 }, { b, 0 }, { b, h }, { 0, h } }
  local corner = trilith.math.atan(b/h)
  local tilt = 0.3*corner
  local c, s = trilith.math.cos(tilt), trilith.math.sin(tilt)
  for i, p in ipairs(outline) do outline[i] = { p[1]*c - p[2]*s, p[1]*s + p[2]*c } end
  local block = m:polygon { name = "block", outline = outline, material = "stone", floating = true }
  local function lift(angle) return trilith.math.cos(corner - math.abs(angle)) - trilith.math.cos(corner) end
  local swings, before = { tilt }, 0
  m:on_step(function()
    local angle, spin = block.rotation + tilt, block.spin
    if before*spin < 0 and math.abs(angle) > 0.05*tilt then swings[#swings + 1] = angle end
    before = spin
    if #swings == 4 then m:stop() end
  end)
  m:run { duration = 4 }
  return math.sqrt(lift(swings[4])/lift(swings[3])), 1 - 1.5*trilith.math.sin(corner)^2
end

local rocking = {}
for _, slenderness in ipairs { 0.25, 0.33 } do
  for _, case in ipairs { { false, 0.3 }, { false, 1 }, { false, 4 }, { true, 0.3 }, { true, 1 }, { true, 4 } } do
    local e, housner = kept(slenderness, case[1], case[2])
    rocking[#rocking + 1] = { feet = case[1], zeta = case[2], kept = e, housner = housner }
    print(("width/height %.2f on %s, zeta = %g: restitution %.3f, Housner %.3f"):format(slenderness,
      case[1] and "feet" or "its whole base", case[2], e, housner))
  end
end

return { finest = math.abs(errors[#errors]), feet_off = math.abs(rocking[12].kept/rocking[12].housner - 1),
  base_off = rocking[9].kept/rocking[9].housner - 1 }
