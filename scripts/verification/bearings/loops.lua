-- Bearings between two blocks that are moved along x, or along a circle in space: force and dissipated energy.
local trilith = require "trilith"
local pi = math.pi

-- A bearing whose second block follows `cycles` of X sin(2 pi t / T). Energy by the trapezoidal rule.
local function cycled(law, X, T, cycles, options)
  options = options or {}
  local m = trilith.model { name = "loop", gravity = options.gravity or 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "below", width = 1, height = 1, at = { -0.5, -1 }, material = "steel", support = "fixed" }
  local above = m:block { name = "above", width = 1, height = 1, at = { -0.5, 0 }, mass = options.mass or 1000,
    material = "steel", support = { x = "fixed", rotation = "fixed", y = options.mass and "free" or "fixed" },
    floating = true }
  m:bearing { name = "bearing", between = { "below", "above" }, at = { 0, 0 }, along = law, axial = options.axial }
  if options.mass then m:consolidate { rest = { ratio = 1e-7 }, grow = 1 } end
  local w, dt, samples = 2*pi/T, T/800, {}
  local n = math.floor(cycles*800 + 0.5)
  for i = 0, n do samples[i + 1] = -X*w^2*trilith.math.sin(w*i*dt) end
  m:drive { body = "above", x = trilith.motion { acceleration = samples, dt = dt, v0 = X*w, allow_drift = true } }
  local bearing, work, first, last, most = m.bearings.bearing, 0, 0, 0, 0
  local begun, u_before, f_before = m.time, 0, 0
  m:run { duration = cycles*T*0.9999, dt = T/4000, until_true = function()
    local u, f, t = bearing.displacement_along, bearing.force_along, m.time - begun
    local part = (u - u_before)*(f + f_before)/2
    work = work + part
    if t <= T then first = first + part end
    if t > (cycles - 1)*T then last, most = last + part, math.max(most, math.abs(f)) end
    u_before, f_before = u, f
    return false
  end }
  return { ["first loop"] = math.abs(first), ["last loop"] = math.abs(last), ["largest force"] = most,
    above = above }
end

local function checks(last, first, force, tolerance)
  local list = { { "last loop", unit = "J", exact = last, tolerance = tolerance } }
  if first then list[#list + 1] = { "first loop", unit = "J", exact = first, tolerance = tolerance } end
  if force then list[#list + 1] = { "largest force", unit = "N", exact = force, tolerance = tolerance } end
  return list
end

local cases = {
  {
    name = "bouc_wen_wide", title = "Bouc and Wen, exponent 1",
    parameters = { { "k", 1e6, "N/m" }, { "a", 0.1 }, { "uy", 0.01, "m" }, { "X", 0.1, "m" } },
    checks = checks(3150.00, 3060.02, 19000, 0.002),
    run = function() return cycled(trilith.bouc_wen { stiffness = 1e6, yield = 1e4, hardening = 0.1, exponent = 1 },
      0.1,
      2, 5) end,
  },
  {
    name = "bouc_wen_sharp", title = "Bouc and Wen, exponent 2",
    parameters = { { "k", 1e6, "N/m" }, { "a", 0.1 }, { "uy", 0.01, "m" }, { "X", 0.1, "m" } },
    checks = checks(3205.23, 3142.85, nil, 0.002),
    run = function() return cycled(trilith.bouc_wen { stiffness = 1e6, yield = 1e4, hardening = 0.1, exponent = 2 },
      0.1,
      2, 5) end,
  },
  {
    name = "bouc_wen_small", title = "Bouc and Wen, exponent 1, small cycle",
    parameters = { { "k", 1e6, "N/m" }, { "a", 0.1 }, { "uy", 0.01, "m" }, { "X", 0.02, "m" } },
    checks = checks(295.44, nil, 10572.7, 0.002),
    run = function() return cycled(trilith.bouc_wen { stiffness = 1e6, yield = 1e4, hardening = 0.1, exponent = 1 },
      0.02,
      2, 8) end,
  },
  {
    name = "bouc_wen_shape", title = "Bouc and Wen, slender loop (b = 0.9, c = 0.1)",
    parameters = { { "k", 2e7, "N/m" }, { "a", 0.05 }, { "uy", 0.005, "m" }, { "X", 0.05, "m" } },
    checks = checks(17037.0, 16562.1, 145000, 0.003),
    run = function() return cycled(trilith.bouc_wen { stiffness = 2e7, yield = 1e5, hardening = 0.05, exponent = 1,
      shape = 0.9 }, 0.05, 1, 5) end,
  },
  {
    name = "lead_rubber", title = "lead rubber bearing",
    parameters = { { "Q", 9e4, "N" }, { "K1", 1e7, "N/m" }, { "K2", 1e6, "N/m" }, { "D", 0.15, "m" } },
    checks = checks(50400, nil, 240000, 0.001),
    run = function() return cycled(trilith.lead_rubber { strength = 9e4, post_stiffness = 1e6, stiffness = 1e7 },
      0.15, 1,
      3) end,
  },
  {
    name = "viscous_linear", title = "linear damper",
    parameters = { { "c", 1e5, "N s/m" }, { "X", 0.05, "m" }, { "T", 1, "s" } },
    checks = checks(pi*1e5*2*pi*0.05^2, nil, 1e5*2*pi*0.05, 0.002),
    run = function() return cycled(trilith.viscous { force = 1e5 }, 0.05, 1, 3) end,
  },
  {
    name = "viscous_power", title = "damper of power 0.35",
    parameters = { { "c", 2e5, "N (s/m)^0.35" }, { "X", 0.05, "m" }, { "T", 1, "s" } },
    checks = checks(24188.4, nil, 133362, 0.002),
    run = function() return cycled(trilith.viscous { force = 2e5, exponent = 0.35 }, 0.05, 1, 3) end,
  },
  {
    name = "maxwell", title = "damper in series with a spring",
    parameters = { { "k", 1e6, "N/m" }, { "c", 1e5, "N s/m" }, { "X", 0.05, "m" }, { "T", 1, "s" } },
    checks = checks(3538.04, nil, 26600.9, 0.002),
    run = function() return cycled(trilith.maxwell { stiffness = 1e6, force = 1e5 }, 0.05, 1, 5) end,
  },
  {
    name = "slider", title = "friction slider under cycles of 5 mm",
    parameters = { { "N", 1e4, "N" }, { "mu", 0.5 }, { "k", 1e7, "N/m" }, { "X", 0.005, "m" } },
    checks = checks(90, nil, 5000, 0.001),
    run = function() return cycled(trilith.friction { mu = 0.5, stiffness = 1e7 }, 0.005, 1, 3,
      { mass = 1e4/9.80665, gravity = 9.80665, axial = trilith.linear { stiffness = 1e9, damping = 1e5 } }) end,
  },
  {
    name = "friction_pendulum", title = "friction pendulum",
    parameters = { { "R", 2, "m" }, { "mu", 0.05 }, { "W", 1e6, "N" }, { "D", 0.2, "m" } },
    checks = checks(40000, nil, 150000, 0.01),
    run = function() return cycled(trilith.pendulum { radius = 2, mu = 0.05, stiffness = 5e8 }, 0.2, 4, 3,
      { mass = 1e6/9.80665, gravity = 9.80665, axial = trilith.linear { stiffness = 1e10, damping = 1e7 } }) end,
  },
}
for _, case in ipairs(cases) do
  local run = case.run
  case.run = function(p)
    local found = run(p)
    found.above = nil
    return found
  end
end
cases[1].plot = function()
  local m = trilith.model { name = "loop", gravity = 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "below", width = 1, height = 1, at = { -0.5, -1 }, material = "steel", support = "fixed" }
  m:block { name = "above", width = 1, height = 1, at = { -0.5, 0 }, material = "steel", support = "fixed" }
  m:bearing { name = "bearing", between = { "below", "above" }, at = { 0, 0 },
    along = trilith.bouc_wen { stiffness = 1e6, yield = 1e4, hardening = 0.1, exponent = 1 } }
  local samples, w = {}, pi
  for i = 0, 1200 do samples[i + 1] = -0.1*w^2*trilith.math.sin(w*i*0.005) end
  m:drive { body = "above", x = trilith.motion { acceleration = samples, dt = 0.005, v0 = 0.1*w, allow_drift = true } }
  local u, f, next_time = {}, {}, 0
  m:run { duration = 4, dt = 1e-3, until_true = function()
    if m.time >= next_time then
      u[#u + 1], f[#f + 1] = m.bearings.bearing.displacement_along, m.bearings.bearing.force_along
      next_time = next_time + 0.02
    end
    return false
  end }
  return { title = "Loop of Bouc and Wen, exponent 1", x_label = "displacement", x_unit = "m", y_label = "force",
    y_unit = "N", { name = "computed", x = u, y = f },
    { name = "largest force, exact", kind = "points", x = { 0.1, -0.1 }, y = { 19000, -19000 } } }
end

return {
  title = "Hysteretic bearings and dampers under cycles",
  source = "Wen (1976), Journal of the Engineering Mechanics Division 102(2); Naeim and Kelly (1999), Design of " ..
    "Seismic " ..
    "Isolated Structures, chapters 2 and 4; Constantinou and Symans (1993) for dampers of a power of velocity",
  formula = [[E_\text{LRB} = 4 Q (D - D_y), \qquad
E_\text{FP} = 4 \mu W D, \qquad E_\text{viscous} = \pi c \omega X^2]],
  text = "One block follows a sine of amplitude $X$ against the other. The energy of a loop is the integral of the " ..
    "force over the displacement.",
  cases = cases,
}
