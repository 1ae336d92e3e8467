-- A rigid block that rocks on a rigid base, released from rest: time to the first impact, and the peak after it.
local trilith = require "trilith"
local g = 9.80665

-- Half diagonal R, angle of the diagonal and frequency parameter p of a block.
local function shape(p)
  local R = math.sqrt(p.width^2 + p.height^2)/2
  return R, trilith.math.atan(p.width, p.height), math.sqrt(3*g/(4*R))
end

-- Time from rest at the tilt q alpha to the tilt 0 by Runge's and Kutta's method.
local function quarter_period(p)
  local _, alpha, rate = shape(p)
  local tilt, speed, t, dt = p.q*alpha, 0, 0, 1e-4
  local function force(at) return -rate^2*trilith.math.sin(alpha - at) end
  while true do
    local k1, l1 = speed, force(tilt)
    local k2, l2 = speed + dt/2*l1, force(tilt + dt/2*k1)
    local k3, l3 = speed + dt/2*l2, force(tilt + dt/2*k2)
    local k4, l4 = speed + dt*l3, force(tilt + dt*k3)
    local next_tilt = tilt + dt/6*(k1 + 2*k2 + 2*k3 + k4)
    if next_tilt <= 0 then return t + dt*tilt/(tilt - next_tilt) end
    tilt, speed, t = next_tilt, speed + dt/6*(l1 + 2*l2 + 2*l3 + l4), t + dt
  end
end

-- A block that is tilted about its lower left corner; its tilt counts from there.
local function tilted(p, beta)
  local _, alpha = shape(p)
  local m = trilith.model { name = "rocking" }
  m:material { name = "stone", density = 1000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e12, ks = 5e11, mu = 2, beta = beta } }
  m:block { name = "base", width = 8, height = 1, at = { -4, -1 }, material = "stone", support = "fixed" }
  local block = m:block { name = "block", width = p.width, height = p.height, at = { 0, 0 }, angle = p.q*alpha,
    material = "stone", floating = true }
  return m, block, p.q*alpha
end

local function first_impact(p)
  local m, block, start = tilted(p, 7e-6)
  local before, found = start, nil
  m:run { duration = 2, integrator = p.integrator, dt = p.integrator and 1e-3 or nil, until_true = function()
    local tilt = start + block.rotation
    if tilt <= 0 then found = m.time - m.dt*tilt/(tilt - before) end
    before = tilt
    return found ~= nil
  end }
  return found
end

local cases = {}
for _, row in ipairs { { 0.4, 1.2, 0.25 }, { 0.4, 1.2, 0.5 }, { 0.4, 1.2, 0.75 }, { 0.4, 1.2, 0.9 }, { 0.5, 2, 0.25 },
  { 0.5, 2, 0.5 }, { 0.5, 2, 0.75 } } do
  local p = { width = row[1], height = row[2], q = row[3] }
  cases[#cases + 1] = {
    name = ("rocking_%.0fx%.0f_%.0f"):format(10*p.width, 10*p.height, 100*p.q),
    title = "released",
    parameters = { { "width", p.width, "m" }, { "height", p.height, "m" }, { "q", p.q } },
    checks = { { "first impact", unit = "s", exact = quarter_period(p), tolerance = 0.01 } },
    run = first_impact,
  }
end
cases[1].plot = function()
  local p = { width = 0.4, height = 1.2, q = 0.5 }
  local m, block, start = tilted(p, 1e-5)
  local t, tilt, next_time = {}, {}, 0
  m:run { duration = 3, until_true = function()
    if m.time >= next_time then
      t[#t + 1], tilt[#tilt + 1] = m.time, start + block.rotation
      next_time = next_time + 0.01
    end
    return false
  end }
  local T = quarter_period(p)
  return { title = "0.4 m x 1.2 m, q = 0.5", x_label = "time", x_unit = "s", y_label = "tilt", y_unit = "rad",
    { name = "computed", x = t, y = tilt },
    { name = "first impact, exact", kind = "points", x = { T }, y = { 0 } } }
end

-- A block on two narrow feet turns about their edges, as Housner has it: the angular momentum about the new edge stays.
local function next_peak(p)
  local _, alpha = shape(p)
  local m = trilith.model { name = "on feet" }
  m:material { name = "stone", density = 1000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e12, ks = 5e11, mu = 2, beta = 1e-4 } }
  m:block { name = "base", width = 8, height = 1, at = { -4, -1 }, material = "stone", support = "fixed" }
  local foot, lift, start = 0.05*p.width, 1e-3, p.q*alpha
  local c, s, outline = trilith.math.cos(start), trilith.math.sin(start), {}
  for i, corner in ipairs { { 0, 0 }, { foot, 0 }, { foot, lift }, { p.width - foot, lift }, { p.width - foot, 0 },
    { p.width, 0 }, { p.width, p.height }, { 0, p.height } } do
    outline[i] = { c*corner[1] - s*corner[2], s*corner[1] + c*corner[2] }
  end
  local mass = 1000*p.width*p.height
  local block = m:body { name = "block", outline = outline, mass = mass, inertia = mass*(p.width^2 + p.height^2)/12,
    material = "stone", floating = true }
  local peak = 0
  m:run { duration = 2.5*quarter_period(p), until_true = function()
    peak = math.max(peak, -(start + block.rotation))
    return false
  end }
  return peak/alpha
end

for _, row in ipairs { { 0.4, 1.2, 0.5, 0.3240 }, { 0.4, 1.2, 0.75, 0.4335 }, { 0.5, 2, 0.5, 0.3868 } } do
  cases[#cases + 1] = {
    name = ("rocking_decay_%.0fx%.0f_%.0f"):format(10*row[1], 10*row[2], 100*row[3]),
    title = "after the first impact, on two narrow feet",
    parameters = { { "width", row[1], "m" }, { "height", row[2], "m" }, { "q", row[3] } },
    checks = { { "next peak over alpha", exact = row[4], tolerance = 0.1 } },
    run = next_peak,
  }
end

local function constants(p)
  local m = trilith.model { name = "constants" }
  m:material { name = "stone", density = 2400 }
  local block = m:block { name = "block", width = p.width, height = p.height, at = { 0, 0 }, material = "stone" }
  local R = math.sqrt((block.x)^2 + (block.y)^2)
  local about_corner = block.inertia + block.mass*R^2
  return { p = math.sqrt(block.mass*g*R/about_corner), restitution = 1 - 2*block.mass*block.x^2/about_corner }
end
for _, row in ipairs { { 0.2, 0.6, 4.8227, 0.85 }, { 0.4, 1.2, 3.4102, 0.85 }, { 0.5, 2, 2.6712, 0.91176 } } do
  cases[#cases + 1] = {
    name = ("rocking_constants_%.0fx%.0f"):format(10*row[1], 10*row[2]),
    title = "mass and inertia of the shape",
    parameters = { { "width", row[1], "m" }, { "height", row[2], "m" } },
    checks = { { "p", unit = "1/s", exact = row[3], tolerance = 2e-5 },
      { "restitution", exact = row[4], tolerance = 2e-5 } },
    run = constants,
  }
end

return {
  title = "Rocking of a rigid block",
  source = "Housner (1963), The behavior of inverted pendulum structures during earthquakes, Bulletin of the " ..
    "Seismological Society of America 53(2), equations 2, 5 and 9, and the pendulum equation without linearisation",
  formula = [[\ddot\theta = -p^2 \sin(\alpha - \theta), \qquad p = \sqrt{\frac{3g}{4R}}, \qquad
e = 1 - \tfrac{3}{2}\sin^2\alpha]],
  text = "A block of half diagonal $R$, whose diagonal makes the angle $\\alpha$ with the upright, is released from " ..
    "rest at the tilt $q\\,\\alpha$. The exact time of the first impact comes from integrating the pendulum " ..
    "equation. " ..
    "A block on its whole base has a restitution of its own, as the stress of an impact is distributed over the " ..
    "base; " ..
    "two narrow feet make the block of Housner's theory.",
  cases = cases,
}
