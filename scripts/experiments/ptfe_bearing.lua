-- PTFE on steel: friction against speed, Constantinou, Mokha and Reinhorn (1990).
local trilith = require "trilith"
local setting = ... or {}
local exp = trilith.math.exp

-- Assumptions: unfilled PTFE at 6.9 MPa.
local series = { mu_slow = 0.027, mu_fast = 0.119, rate = 23.6, normal = 1e5, stiffness = 1e8 }
local assumptions = {
  { "law", "mu = mu_fast - (mu_fast - mu_slow) exp(-r v)", "Constantinou, Mokha and Reinhorn 1990" },
  { "constants", "mu_slow 0.027, mu_fast 0.119, r = 23.6 s/m, at 6.9 MPa", "Constantinou, Mokha and Reinhorn 1990" },
  { "break-away", "none: the first slip takes the friction of its speed", "the law has no term for it" },
}

local function friction(v) return series.mu_fast - (series.mu_fast - series.mu_slow)*exp(-series.rate*math.abs(v)) end

-- A block on the bearing under N, which follows a motion; calls read(force, displacement) after each step.
local function slide(motion, duration, read)
  local m = trilith.model { name = "ptfe", gravity = 0 }
  m:material { name = "steel", density = 7850 }
  m:block { name = "table", width = 2, height = 0.2, at = { -1, -0.2 }, material = "steel", support = "fixed" }
  local plate = m:block { name = "plate", width = 0.4, height = 0.1, at = { -0.2, 0 }, material = "steel",
    support = { rotation = "fixed" } }
  m:contact { between = { "*", "*" }, law = "none" }
  local bearing = m:bearing { name = "ptfe", between = { "table", "plate" }, at = { 0, 0 },
    axial = trilith.linear { stiffness = 1e9, damping = 1e5 },
    along = trilith.friction { mu = series.mu_slow, mu_fast = series.mu_fast, rate = series.rate,
      stiffness = series.stiffness } }
  m:point_load { body = plate, force = { 0, -series.normal } }
  m:consolidate { rest = { ratio = 1e-6 } }
  if setting.file then m:results { file = setting.file } end
  motion.body = plate
  m:drive(motion)
  m:run { duration = duration, dt = setting.coarse and 1e-4 or 2e-5, until_true = function()
    read(bearing.force, plate.ux, m.time)
    return false
  end }
end

-- Friction at a steady speed, over 10 mm.
local function at_speed(v)
  local last
  local duration = 0.01/v
  slide({ x = trilith.motion { velocity = v, duration = duration } }, 0.9*duration,
    function(force) last = math.abs(force[1] or force.along) end)
  return last/series.normal
end

local loop = { x = {}, y = {} }

-- Area of the second loop of a sine of amplitude X and period T, over N.
local function loop_area(X, T)
  local values, dt = {}, T/400
  local omega = 2*math.pi/T
  for i = 0, 800 do values[i + 1] = -X*omega^2*trilith.math.sin(2*math.pi*i/400) end
  local area, before, begun
  slide({ x = trilith.motion { acceleration = values, dt = dt, v0 = X*omega, allow_drift = true } }, 2*T - dt,
    function(force, u, t)
      local f = force[1] or force.along
      begun = begun or t
      if before and t - begun > T - dt then area = (area or 0) + (f + before[1])/2*(u - before[2]) end
      if #loop.x == 0 or t - (loop.t or 0) > dt then
        loop.x[#loop.x + 1], loop.y[#loop.y + 1], loop.t = 1e3*u, f/series.normal, t
      end
      before = { f, u }
    end)
  return math.abs(area)/series.normal
end

-- Loop area by the law alone: integral of mu over the path.
local function area_of_law(X, T)
  local n, sum, omega = 20000, 0, 2*math.pi/T
  for i = 1, n do
    local v = X*omega*math.abs(trilith.math.cos(2*math.pi*(i - 0.5)/n))
    sum = sum + friction(v)*v*T/n
  end
  return sum
end

local cases = {}
for _, row in ipairs { { 1, 0.0291 }, { 10, 0.0463 }, { 50, 0.0907 }, { 250, 0.1187 } } do
  cases[#cases + 1] = {
    name = ("ptfe_%d"):format(row[1]), title = "steady sliding", parameters = { { "speed", row[1], "mm/s" } },
    checks = { { "friction", measured = row[2], between = { 0.99*row[2], 1.01*row[2] } } },
    run = function() return at_speed(row[1]*1e-3) end,
  }
end
local area = area_of_law(0.05, 2)
cases[#cases + 1] = {
  name = "ptfe_loop", title = "sine of 50 mm and 2 s",
  checks = { { "loop area over N", unit = "m", measured = area, between = { 0.99*area, 1.01*area } } },
  run = function() return loop_area(0.05, 2) end,
  plot = function()
    return { title = "PTFE bearing, sine of 50 mm and 2 s", x_label = "displacement", x_unit = "mm",
      y_label = "force over N", y_unit = "", { name = "model", x = loop.x, y = loop.y } }
  end,
}

return {
  title = "PTFE bearing: friction against speed",
  source = "Constantinou, Mokha and Reinhorn (1990), Journal of Structural Engineering 116(2)",
  text = "The measured values come from the published law at each speed, and the loop area from its integral.",
  formula = [[\mu(v) = \mu_\text{fast} - (\mu_\text{fast} - \mu_\text{slow})\, e^{-r |v|}]],
  assumptions = assumptions,
  cases = cases,
}
