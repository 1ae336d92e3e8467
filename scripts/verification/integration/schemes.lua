-- The arithmetic of the implicit schemes on a mass of period 1 s: damping, period, and order of the error.
local trilith = require "trilith"
local pi = math.pi
local stiffness = 4*pi^2

local function mass_on_spring(options)
  local m = trilith.model { name = "scheme", gravity = 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "ground", width = 1, height = 1, at = { -1, 0 }, material = "steel", support = "fixed" }
  local body = m:block { name = "mass", width = 1, height = 1, at = { 0, 0 }, mass = 1, material = "steel",
    velocity = { options.speed or 0, 0 }, support = { y = "fixed", rotation = "fixed" }, floating = true,
    load = { options.force or 0, 0 } }
  m:bearing { name = "spring", between = { "ground", "mass" }, at = { 0, 0.5 },
    along = trilith.linear { stiffness = stiffness, damping = options.damping or 0 } }
  return m, body
end

local function history(p, options)
  local m, body = mass_on_spring(options)
  local x = {}
  m:run { duration = options.duration, dt = p.step, integrator = p.integrator or "implicit", alpha = p.alpha,
    spectral_radius = p.spectral_radius, accuracy = not p.integrator and 0 or nil, watch = false,
    until_true = function()
      x[#x + 1] = body.ux
      return false
    end }
  return x
end

-- x_(j+1) = a x_j - b x_(j-1) by least squares: spectral radius and period in steps of a free vibration.
local function vibration(x, from)
  local xx, xy, yy, zx, zy = 0, 0, 0, 0, 0
  for j = from, #x - 1 do
    xx, xy, yy = xx + x[j]^2, xy + x[j]*x[j - 1], yy + x[j - 1]^2
    zx, zy = zx + x[j + 1]*x[j], zy + x[j + 1]*x[j - 1]
  end
  local det = xx*yy - xy*xy
  local a, b = (zx*yy - zy*xy)/det, -(zy*xx - zx*xy)/det
  local radius = math.sqrt(b)
  return radius, 2*pi/math.acos(a/(2*radius))
end

local cases = {}
local function add(name, title, scheme, step, radius, longer, duration, from)
  local parameters = { { "step", step, "s" } }
  for key, value in pairs(scheme) do table.insert(parameters, 1, { key, value }) end
  local checks = { { "spectral radius", exact = radius, tolerance = radius == 1 and 1e-9 or 1e-5 } }
  if longer then checks[2] = { "elongation of the period", unit = "%", exact = longer, tolerance = 1e-3 } end
  cases[#cases + 1] = {
    name = name, title = title, parameters = parameters, checks = checks,
    run = function(p)
      local r, period = vibration(history(p, { speed = 1, duration = duration or 20 }), from or 10)
      return { ["spectral radius"] = r, ["elongation of the period"] = 100*(period*p.step - 1) }
    end,
  }
end

for _, h in ipairs { 0.02, 0.05, 0.1, 0.2 } do
  local w = 2*pi*h
  add(("newmark_%.0f"):format(100*h), "average acceleration", { alpha = 0 }, h, 1, 100*(w/2/math.atan(w/2) - 1), 100)
end
for _, row in ipairs { { -0.05, 0.05, .999948 }, { -0.05, 0.1, .999282, 3.611 }, { -0.05, 0.2, .993015 },
  { -0.1, 0.05, .999907 }, { -0.1, 0.1, .998728, 3.951 }, { -0.1, 0.2, .987832 }, { -0.3, 0.05, .999832 },
  { -0.3, 0.1, .997750, 4.657 }, { -0.3, 0.2, .979310 } } do
  add(("hht_%.0f_%.0f"):format(-100*row[1], 100*row[2]), "Hilber, Hughes and Taylor", { alpha = row[1] }, row[2],
    row[3],
    row[4])
end
for _, row in ipairs { { 0.9, .999990, .999872, 3.247 }, { 0.8, .999904, .998853, 3.383 }, { 0.5, .997733, .979178,
  4.672 },
  { 0, .969708, .853874, 12.321 } } do
  add(("generalised_alpha_%.0f_10"):format(100*row[1]), "generalised alpha", { spectral_radius = row[1] }, 0.1, row[2],
    row[4], 10)
  add(("generalised_alpha_%.0f_20"):format(100*row[1]), "generalised alpha", { spectral_radius = row[1] }, 0.2, row[3],
    nil,
    10, 25)
end

-- A suddenly applied force, from rest: the digits of the schemes, and the order of their error.
local suddenly = { force = stiffness, damping = 2*0.05*math.sqrt(stiffness), duration = 1 }
local function at_one_second(p)
  local x = history(p, suddenly)
  return x[#x]
end
for name, row in pairs { newmark = { 0, { .27140902, .26745978, .26910307, .26969391, .26985313 } },
  hht = { -0.1, { .28324395, .26810278, .26899266, .26963711, .26983565 } } } do
  local rows = {}
  for i, u in ipairs(row[2]) do
    rows[i] = { ("displacement at 1 s, step %g s"):format(0.1/2^(i - 1)), unit = "m", exact = u, within = 1e-7 }
  end
  cases[#cases + 1] = {
    name = "digits_" .. name, title = "a suddenly applied force: digits of the scheme",
    parameters = { { "alpha", row[1] }, { "ratio", 0.05 } },
    checks = rows,
    run = function(p)
      local found = {}
      for i, check in ipairs(rows) do found[check[1]] = at_one_second { alpha = p.alpha, step = 0.1/2^(i - 1) } end
      return found
    end,
  }
end
table.sort(cases, function(a, b) return a.name < b.name end)

local function study(name, title, scheme)
  cases[#cases + 1] = {
    name = "order_" .. name, title = "order of " .. title,
    convergence = { parameter = "step", unit = "s", values = { 0.02, 0.01, 0.005, 0.0025 }, order = 2, tolerance = 0.03,
      exact = 0.269907232, quantity = "displacement at 1 s", quantity_unit = "m" },
    run = function(p)
      local with = { step = p.step }
      for key, value in pairs(scheme) do with[key] = value end
      return at_one_second(with)
    end,
  }
end
study("newmark", "average acceleration", { alpha = 0 })
study("hht", "Hilber, Hughes and Taylor, alpha -0.05", { alpha = -0.05 })
study("generalised_alpha", "generalised alpha, spectral radius 0.8", { spectral_radius = 0.8 })

return {
  title = "Implicit time integration",
  source = "Newmark (1959), Journal of the Engineering Mechanics Division 85(3). Hilber, Hughes and Taylor (1977), " ..
    "Earthquake Engineering and Structural Dynamics 5, figures 1 and 2. Chung and Hulbert (1993), Journal of " ..
    "Applied Mechanics 60, equations 17 and 25",
  formula = [[\frac{T'}{T} = \frac{\omega h/2}{\arctan(\omega h/2)}, \qquad
u(t) = 1 - e^{-\xi\omega t}\left(\cos\omega_D t + \frac{\xi\omega}{\omega_D}\sin\omega_D t\right)]],
  text = "A mass of 1 kg with a period of 1 s. The spectral radius is the share of the amplitude that a step " ..
    "keeps, the " ..
    "elongation the error of the period. The displacement at 1 s under a suddenly applied force tends to " ..
    "0.26990723 m.",
  cases = cases,
}
