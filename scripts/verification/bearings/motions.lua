-- Bearings in motion: free swings on a friction pendulum, cables, loops along a circle in space.
local trilith = require "trilith"
local g, pi = 9.80665, math.pi

-- A mass that moves along x alone, joined to the ground by a law; `gravity` needs a law that carries it.
local function mass_on(options)
  local m = trilith.model { name = "bearing", gravity = options.gravity or 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "ground", width = 1, height = 1, at = { -0.5, -1 }, material = "steel", support = "fixed" }
  local body = m:block { name = "mass", width = 1, height = 1, at = { -0.5, 0 }, mass = options.mass,
    material = "steel",
    velocity = { options.speed or 0, 0 }, floating = true,
    support = { y = options.gravity and "free" or "fixed", rotation = "fixed" } }
  for i, law in ipairs(options.laws) do
    m:bearing { name = "law " .. i, between = { "ground", "mass" }, at = { 0, 0 }, along = law,
      axial = i == 1 and options.axial or nil }
  end
  return m, body
end

local cases = {}

cases[1] = {
  name = "pendulum_swings", title = "friction pendulum released at 0.22 m (R = 2 m, mu = 0.02)",
  parameters = { { "R", 2, "m" }, { "mu", 0.02 }, { "from", 0.22, "m" } },
  checks = { { "first turn", unit = "m", exact = -0.14, tolerance = 0.01 },
    { "second turn", unit = "m", exact = 0.06, tolerance = 0.01 },
    { "third turn", unit = "m", exact = 0.02, tolerance = 0.01 },
    { "half period", unit = "s", exact = pi*math.sqrt(2/g), tolerance = 0.01 } },
  run = function(p)
    local mass = 1e5
    local m, body = mass_on { mass = mass, gravity = g, axial = trilith.linear { stiffness = 1e10, damping = 1e7 },
      laws = { trilith.pendulum { radius = p.R, mu = p.mu, stiffness = 2e9 } } }
    m:consolidate { rest = { ratio = 1e-7 }, grow = 0.5 }
    m:drive { body = body, x = trilith.ramp { by = p.from, duration = 2 } }
    m:run { duration = 2.2, dt = 1e-4 }
    m:release { body = body, x = true, fade = 1e-4 }
    local turns, times, before = {}, {}, 0
    m:run { duration = 6, dt = 1e-4, until_true = function()
      if before*body.vx < 0 and math.abs(body.ux - (turns[#turns] or p.from)) > 0.01 then
        turns[#turns + 1], times[#times + 1] = body.ux, m.time
      end
      if math.abs(body.vx) > 1e-5 then before = body.vx end
      return false
    end }
    return { ["first turn"] = turns[1], ["second turn"] = turns[2], ["third turn"] = turns[3] or body.ux,
      ["half period"] = times[2] - times[1] }
  end,
}

cases[2] = {
  name = "slack_cable", title = "cable with a slack of 10 mm, 1 t at 0.5 m/s",
  parameters = { { "k", 1e6, "N/m" }, { "slack", 0.01, "m" }, { "speed", 0.5, "m/s" } },
  checks = { { "taut", unit = "s", exact = 0.02, tolerance = 0.002 },
    { "peak", unit = "m", exact = 0.025811, tolerance = 0.002 },
    { "largest force", unit = "N", exact = 15811.4, tolerance = 0.002 },
    { "slack again", unit = "s", exact = 0.119346, tolerance = 0.002 } },
  run = function(p)
    local m, body = mass_on { mass = 1000, speed = p.speed, laws = { trilith.cable { stiffness = p.k,
      slack = p.slack } } }
    local taut, slack, peak, force = nil, nil, 0, 0
    m:run { duration = 0.15, dt = 1e-5, until_true = function()
      local f = math.abs(m.bearings["law 1"].force_along)
      if f > 0 then taut, slack = taut or m.time, m.time end
      peak, force = math.max(peak, body.ux), math.max(force, f)
      return false
    end }
    return { taut = taut, peak = peak, ["largest force"] = force, ["slack again"] = slack }
  end,
}

cases[3] = {
  name = "opposed_cables", title = "two opposed cables with 5 kN of pretension, 1 t at 0.5 m/s",
  parameters = { { "k", 1e6, "N/m" }, { "pretension", 5e3, "N" }, { "speed", 0.5, "m/s" } },
  checks = { { "peak", unit = "m", exact = 0.0123205, tolerance = 0.002 },
    { "time of the peak", unit = "s", exact = 0.040577, tolerance = 0.002 },
    { "period", unit = "s", exact = 0.162309, tolerance = 0.002 },
    { "largest force", unit = "N", exact = 17320.5, tolerance = 0.002 } },
  run = function(p)
    local m, body = mass_on { mass = 1000, speed = p.speed, laws = {
      trilith.cable { stiffness = p.k, pretension = p.pretension, side = 1 },
      trilith.cable { stiffness = p.k, pretension = p.pretension, side = -1 } } }
    local peak, at, force, crossed, before = 0, 0, 0, nil, 0
    m:run { duration = 0.18, dt = 1e-5, until_true = function()
      local x = body.ux
      if x > peak and m.time < 0.1 then peak, at = x, m.time end
      if m.time > 0.1 and before < 0 and x >= 0 then crossed = crossed or m.time - m.dt*x/(x - before) end
      before = x
      force = math.max(force, math.abs(m.bearings["law 1"].force_along))
      return false
    end }
    return { peak = peak, ["time of the peak"] = at, period = crossed, ["largest force"] = force }
  end,
}

-- In space: a bearing whose upper block follows a circle of radius r, once in T, `turns` times.
local function circled(p, law, weight, axial)
  local m = trilith.model { name = "circle", dim = 3, gravity = weight and g or 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "below", size = { 1, 1, 1 }, at = { -0.5, -0.5, -1 }, material = "steel", support = "fixed" }
  local above = m:block { name = "above", size = { 1, 1, 1 }, at = { -0.5, -0.5, 0 }, mass = (weight or 1e4)/g,
    material = "steel", floating = true,
    support = { x = "fixed", y = "fixed", z = weight and "free" or "fixed", rotation_x = "fixed", rotation_y = "fixed",
      rotation_z = "fixed" } }
  m:bearing { name = "bearing", between = { "below", "above" }, at = { 0, 0, 0 }, horizontal = law, axial = axial }
  if weight then m:consolidate { rest = { ratio = 1e-7 }, grow = 0.5 } end
  -- A start along x with zero acceleration jump: r (1 - cos) moves from the origin, so the circle passes through it.
  m:drive { body = above, x = trilith.ramp { by = p.r, duration = 1 } }
  m:run { duration = 1, dt = 2e-4 }
  local w, dt, x, y = 2*pi/p.T, p.T/2000, {}, {}
  for i = 0, 2000*p.turns do
    local a = w*i*dt
    x[i + 1], y[i + 1] = -p.r*w^2*trilith.math.cos(a), -p.r*w^2*trilith.math.sin(a)
  end
  m:drive { body = above, x = trilith.motion { acceleration = x, dt = dt, allow_drift = true },
    y = trilith.motion { acceleration = y, dt = dt, v0 = p.r*w, allow_drift = true } }
  local bearing, begun, work, radial, across = m.bearings.bearing, m.time, 0, nil, nil
  local ux, uy, fx, fy
  m:run { duration = p.turns*p.T*0.99999, dt = p.T/8000, until_true = function()
    local t, x1, y1 = m.time - begun, bearing.displacement_along, bearing.displacement_across
    local f1, f2 = bearing.force_along, bearing.force_across
    if t > (p.turns - 1)*p.T and ux then work = work + (x1 - ux)*(f1 + fx)/2 + (y1 - uy)*(f2 + fy)/2 end
    ux, uy, fx, fy = x1, y1, f1, f2
    local size = math.sqrt(x1^2 + y1^2)
    radial, across = math.abs(f1*x1 + f2*y1)/size, math.abs(f1*y1 - f2*x1)/size
    return false
  end }
  return { ["radial force"] = radial, ["force against the motion"] = across, ["energy of a turn"] = math.abs(work) }
end

cases[4] = {
  name = "pendulum_circle", title = "friction pendulum led along a circle of 0.2 m",
  parameters = { { "R", 2, "m" }, { "mu", 0.05 }, { "r", 0.2, "m" }, { "T", 4, "s" }, { "turns", 2 } },
  checks = { { "radial force", unit = "N", exact = 1e5, tolerance = 0.005 },
    { "force against the motion", unit = "N", exact = 5e4, tolerance = 0.005 },
    { "energy of a turn", unit = "J", exact = 2*pi*0.2*5e4, tolerance = 0.005 } },
  run = function(p) return circled(p, trilith.pendulum { radius = p.R, mu = p.mu, stiffness = 5e8 }, 1e6,
    trilith.linear { stiffness = 1e10, damping = 1e7 }) end,
}
cases[5] = {
  name = "plastic_circle", title = "elastic and plastic bearing with a circular limit, led along a circle of 0.02 m",
  parameters = { { "k", 1e7, "N/m" }, { "Fy", 5e4, "N" }, { "r", 0.02, "m" }, { "T", 2, "s" }, { "turns", 5 } },
  checks = { { "radial force", unit = "N", exact = 12500, tolerance = 0.002 },
    { "force against the motion", unit = "N", exact = 48412, tolerance = 0.002 },
    { "energy of a turn", unit = "J", exact = 6083.67, tolerance = 0.002 } },
  run = function(p) return circled(p, trilith.elastic_plastic { stiffness = p.k, yield = p.Fy }) end,
}

return {
  title = "Bearings in motion",
  source = "Zayas, Low and Mahin (1987), UCB/EERC-87/01, for the friction pendulum; others derived: a mass on a " ..
    "spring " ..
    "that only pulls, and a force of constant size against the motion",
  formula = [[T = 2\pi\sqrt{\frac{R}{g}}, \qquad |u_{n+1}| = |u_n| - 2\mu R, \qquad
E_\text{circle} = 2\pi r \mu W, \qquad F_r = \frac{F_y^2}{k r}]],
  text = "A bearing that is led along a circle in space has one resultant force. Two laws of their own along x " ..
    "and y would " ..
    "dissipate more.",
  cases = cases,
}
