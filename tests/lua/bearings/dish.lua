-- A pendulum bearing with rise = 1 stands on a dish: the slider rises by R - sqrt(R^2 - u^2), and its weight gives the
-- restoring force N tan(angle). In the plane and in space, by explicit and implicit steps.
local trilith = require "trilith"

local g, radius = 9.80665, 1

local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.9g for %.9g"):format(what or "", a, b))
end

-- A slab on one dish in the plane, on four in space; its feet do not rotate it.
local function slab(dim, mu, damping, coupled, speed)
  local m = trilith.model { name = "slab", dim = dim }
  m:material { name = "c", density = 2400 }
  m:contact { between = { "*", "*" }, law = "none" }
  local dish = trilith.pendulum { radius = radius, mu = mu, stiffness = 5e6, rise = 1 }
  local foot = trilith.linear { stiffness = 2e8, damping = damping }
  if dim == 2 then
    m:block { name = "ground", width = 8, height = 0.5, at = { -4, -0.5 }, material = "c", support = "fixed" }
    local s = m:block { name = "slab", width = 4, height = 0.5, at = { -2, 0.1 }, material = "c",
      support = { rotation = "fixed" }, floating = true, velocity = { speed or 0, 0 } }
    m:bearing { name = "d", between = { "ground", "slab" }, at = { 0, 0 }, along = dish, axial = foot }
    return m, s
  end
  m:block { name = "ground", size = { 8, 8, 0.5 }, at = { -4, -4, -0.5 }, material = "c", support = "fixed" }
  local s = m:block { name = "slab", size = { 4, 4, 0.5 }, at = { -2, -2, 0.1 }, material = "c", floating = true,
    support = { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" }, velocity = { speed or 0, 0, 0 } }
  for i, at in ipairs { { -1.5, -1.5, 0 }, { 1.5, -1.5, 0 }, { 1.5, 1.5, 0 }, { -1.5, 1.5, 0 } } do
    m:bearing { name = "d" .. i, between = { "ground", "slab" }, at = at, axial = foot,
      horizontal = coupled and dish or nil, along = not coupled and dish or nil, across = not coupled and dish or nil }
  end
  return m, s
end
local function up(dim, s) return dim == 2 and s.uy or s.uz end

-- Driven slowly by 0.25 m: the rise, and the force W tan(angle) + mu W.
for _, case in ipairs { { 2 }, { 3, true }, { 3, false } } do
  local dim, coupled = case[1], case[2]
  local m, s = slab(dim, 0.02, 1e5, coupled)
  m:consolidate { rest = { ratio = 1e-5 } }
  local before = up(dim, s)
  m:drive { body = "slab", x = trilith.ramp { by = 0.25, duration = 2 } }
  m:run { duration = 2.2 }
  near(up(dim, s) - before, radius - math.sqrt(radius^2 - 0.25^2), 2e-3, "rise")
  local weight = s.mass*g
  near(math.abs(s.reaction_x), weight*(0.25/math.sqrt(1 - 0.25^2) + 0.02), 1e-2, "force")
end

-- Released without friction the slab is a pendulum: its period grows with the amplitude, and its energy is conserved.
-- `swing`: the largest angle [rad].
local function period_of(swing)
  local sum, k = 0, math.sin(swing/2)
  for i = 0, 199 do -- 4 sqrt(R/g) K(k), by the middle rule
    local x = (i + 0.5)/200*math.pi/2
    sum = sum + 1/math.sqrt(1 - k^2*math.sin(x)^2)
  end
  return 4*math.sqrt(radius/g)*sum/200*math.pi/2
end
for _, case in ipairs { { 2, nil, "explicit" }, { 3, true, "explicit" }, { 2, nil, "implicit" } } do
  local dim, coupled, integrator = table.unpack(case)
  for _, swing in ipairs { 0.02, 0.6 } do
    -- started at the middle with the speed that reaches this angle
    local speed = math.sqrt(2*g*radius*(1 - math.cos(swing)))
    local m, s = slab(dim, 0, 0, coupled, speed)
    local start = s.x
    local energy, period = 0.5*s.mass*speed^2, period_of(swing)
    local largest, back, last = 0, nil, nil
    m:on_step(function()
      local u = s.x - start
      largest = math.max(largest, u)
      if last and last < 0 and u >= 0 then back = back or m.time end
      last = u
    end)
    local begun = m.time
    m:run { duration = 1.2*period, integrator = integrator, dt = integrator == "implicit" and 2e-3 or 5e-4 }
    near(largest, radius*math.sin(swing), 3e-3, "swing")
    near(back - begun, period, 4e-3, "period")
    assert(math.abs(m.energy.residual) < 5e-3*energy, ("%d %s: %g of %g"):format(dim, integrator, m.energy.residual,
      energy))
  end
end
