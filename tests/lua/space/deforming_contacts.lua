-- Deforming bodies that fall on a floor with edges, corners and tilted faces keep their energy: the contact force does
-- the work that the overlap stores. Rigid bodies do so too.
local trilith = require "trilith"

local function floor(m)
  m:material { name = "floor", density = 2000 }
  m:block { name = "floor", size = { 40, 40, 0.5 }, at = { -20, -20, -0.5 }, material = "floor", support = "fixed" }
end

--- Largest error of the energy of a block that falls with a tilt, as a share of the energy of the fall.
local function fall(body, E, angle, integrator)
  local m = trilith.model { name = "fall", dim = 3 }
  m:material { name = "stone", density = 2000, E = E, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5 } }
  floor(m)
  local b = m:block { name = "block", size = { 0.5, 0.5, 0.4 }, at = { -0.25, -0.25, 0.4 }, material = "stone",
                      floating = true, body = body, turn = { axis = { 1, 0.6, 0 }, angle = angle } }
  local energy, most, struck = b.mass*9.80665*0.4, 0, false
  m:on_step(function()
    most, struck = math.max(most, math.abs(m.residual)/energy), struck or m.energy.contact_elastic > 0
  end)
  m:run { duration = 0.6, dt = integrator == "explicit" and 4e-5 or nil, integrator = integrator }
  local sound = m.verdict.sound
  m:close()
  assert(struck and sound)
  return most
end

local show = os.getenv "TRILITH_SHOW"
for name, body in pairs { brick = "brick", mesh = { mesh = { 2, 2, 2 } }, rigid = "rigid" } do
  for _, E in ipairs { 2e8, 2e9 } do
    for _, angle in ipairs { 0.002, 0.02, 0.3 } do
      local most = fall(body, E, angle, "explicit")
      local where = ("%s, E %g Pa, tilt %g rad: %.3g of the energy"):format(name, E, angle, most)
      if show then print(where) else assert(most < (name == "rigid" and 2e-3 or 0.015), where) end
    end
  end
end

-- A brick rings, begins to tumble and lands on edges and corners.
local function ring(options)
  local m = trilith.model { name = "ring", dim = 3 }
  m:material { name = "stone", density = 2000, E = 2e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5 } }
  floor(m)
  local b = m:block { name = "b", size = { 0.5, 0.5, 0.4 }, at = { -0.25, -0.25, 0.2 }, material = "stone",
                      floating = true, body = "brick" }
  local energy, strain = b.mass*9.80665*0.2, 0
  m:on_step(function() strain = math.max(strain, m.energy.strain/energy) end)
  options.duration = 5
  m:run(options)
  local share = m.residual/energy
  m:close()
  return share, strain
end
local share, strain = ring {}
local where = ("ringing for 5 s: %.3g of the energy, strain energy up to %.3g"):format(share, strain)
if show then print(where) else assert(math.abs(share) < 0.01 and strain > 0.05, where) end

-- A ball that strikes a brick on the floor: both keep their energy.
local function ball(dt)
  local m = trilith.model { name = "ball", dim = 3, gravity = 0 }
  m:material { name = "stone", density = 2000, E = 2e8, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.3 } }
  m:block { name = "block", size = { 0.5, 0.5, 0.4 }, at = { -0.25, -0.25, 0 }, material = "stone", floating = true,
            body = "brick" }
  local b = m:sphere { name = "ball", radius = 0.15, at = { 0.05, 0.08, 0.6 }, material = "stone",
                       velocity = { 0.5, 0, -3 } }
  local energy, most = 0.5*b.mass*9.25, 0
  m:on_step(function() most = math.max(most, math.abs(m.residual)/energy) end)
  m:run { duration = 0.1, dt = dt }
  local speed = b.vz
  m:close()
  assert(speed > -2, speed)
  return most
end
local most = ball(2e-5)
if show then print("ball", most) else assert(most < 5e-3, most) end
