-- Natural frequencies of a wall and a cylinder with the mass of the water.
local trilith = require "trilith"
local pi = math.pi

-- A body that is free along x alone, on a spring to a fixed support.
local function oscillator(mass, stiffness)
  local m = trilith.model { name = "oscillator" }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.6 } }
  m:block { name = "support", width = 1, height = 1, at = { 4, 0 }, material = "concrete", support = "fixed" }
  m:block { name = "body", width = 2, height = 12, at = { 0, 0 }, mass = mass, material = "concrete",
    support = { y = "fixed", rotation = "fixed" }, floating = true }
  m:bearing { name = "spring", between = { "support", "body" }, from = { 4, 0.5 }, to = { 2, 0.5 },
    along = trilith.linear { stiffness = stiffness } }
  return m
end
local function frequency(mass, stiffness) return (stiffness/mass)^0.5/(2*pi) end

local function wall(p)
  local m = oscillator(80e3, p.stiffness)
  if p.form then m:added_mass { body = "body", side = "left", level = p.H, bed = 0, form = p.form } end
  return m
end
local function mode(p) return wall(p):modes { count = 1 }[1].frequency end

-- Frequency from the passages of a free vibration through 0.
local function vibrates(m, integrator, dt)
  local body, times, before = m:body "body", {}, nil
  local load = m:point_load { body = body, force = { 1e5, 0 }, at = { 1, 6 } }
  m:consolidate { integrator = "static" }
  local rest = body.ux
  m:remove(load)
  m:run { duration = 1.5, integrator = integrator, dt = dt, until_true = function(now)
    local u = body.ux
    if before and before < 0 and u >= 0 then times[#times + 1] = now.time - dt*u/(u - before) end
    before = u
    return false
  end }
  assert(rest > 0)
  return (#times - 1)/(times[#times] - times[1])
end

local H, k = 9, 2e8
local exact, parabola = 80e3 + 0.542755*1000*H^2, 80e3 + 7/12*1000*H^2
local function row(name, title, form, mass, run)
  return { name = name, title = title,
    parameters = { { "H", H, "m" }, { "stiffness", k, "N/m" }, form and { "form", form } or nil },
    checks = { { "frequency", unit = "Hz", exact = frequency(mass, k), tolerance = 0.002 } }, run = run }
end

return {
  title = "Added mass of water",
  source = "H. M. Westergaard, Water pressures on dams during earthquakes, Transactions ASCE 98, 1933",
  formula = [[M_\text{exact} = 0.542755\,\rho H^2, \qquad M_\text{parabola} = \frac{7}{12}\,\rho H^2, \qquad
M_\text{cylinder} = \rho \pi R^2 L, \qquad f = \frac{1}{2\pi}\sqrt{\frac{k}{m + M}}]],
  text = "A wall of 80 t per metre on a spring retains water of depth $H$. A cylinder of radius 1 m " ..
    "and length 10 m is " ..
    "deep under water.",
  cases = {
    row("water_wall_dry", "wall without water", nil, 80e3, mode),
    row("water_wall_exact", "wall, series of Westergaard", "exact", exact, mode),
    row("water_wall_parabola", "wall, parabola", "parabola", parabola, mode),
    row("water_wall_explicit", "wall, free vibration in explicit steps", "exact", exact,
      function(p) return vibrates(wall(p), "explicit", 2e-4) end),
    row("water_wall_implicit", "wall, free vibration in implicit steps", "exact", exact,
      function(p) return vibrates(wall(p), "implicit", 5e-4) end),
    { name = "water_cylinder", title = "cylinder", parameters = { { "R", 1, "m" }, { "L", 10, "m" } },
      checks = { { "frequency", unit = "Hz", exact = frequency(60e3 + 1000*pi*10, 5e7), tolerance = 0.002 } },
      run = function(p)
        local m = oscillator(60e3, 5e7)
        m:added_mass { body = "body", radius = p.R, level = p.L, bed = 0 }
        return m:modes { count = 1 }[1].frequency
      end },
  },
}
