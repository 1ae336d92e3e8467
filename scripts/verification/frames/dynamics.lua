-- Beams under moving forces and beams that are caught.
local trilith = require "trilith"

local cases = {}
for _, row in ipairs { { 39.27, 1.2576 }, { 78.54, 1.7054 } } do
  cases[#cases + 1] = {
    name = ("moving_force_%.0f"):format(row[1]), title = "force that crosses a simple beam",
    parameters = { { "speed", row[1], "m/s" }, { "length", 20, "m" }, { "EI", 5e9, "N m2" }, { "line_mass", 5000,
      "kg/m" } },
    checks = { { "largest deflection over static", exact = row[2], tolerance = 0.005 } },
    run = function(p)
      local n, force = 20, 1e5
      local m = trilith.model { name = "moving", gravity = 0 }
      m:material { name = "m", density = 2500, E = 5e10 }
      local body = m:beam { name = "beam", from = { 0, 0 }, to = { p.length, 0 }, material = "m", divisions = n,
        section = trilith.section { area = 2, inertia = 0.1, depth = 1 }, from_support = { x = "fixed", y = "fixed" },
        to_support = { y = "fixed" }, floating = true }
      local step = p.length/n/p.speed
      for i = 1, n - 1 do
        m:point_load { body = body, at = { i*p.length/n, 0 }, force = { 0, -force },
          load_curve = { { (i - 1)*step, 0 }, { i*step, 1 }, { (i + 1)*step, 0 } } }
      end
      local most = 0
      m:run { duration = p.length/p.speed, until_true = function()
        most = math.max(most, -select(2, body:point { p.length/2, 0 }))
        return false
      end }
      return most/(force*p.length^3/(48*p.EI))
    end,
  }
end

cases[#cases + 1] = {
  name = "caught_beam", title = "beam that falls flat at 1 m/s and is caught at its ends",
  parameters = { { "length", 8, "m" }, { "elements", 40 } },
  checks = { { "largest deflection", unit = "m", exact = 16.178e-3, tolerance = 0.02 },
    { "time of it", unit = "s", exact = 17.01e-3, tolerance = 0.02 } },
  run = function(p)
    local m = trilith.model { name = "caught", gravity = 0 }
    m:material { name = "m", density = 2400, E = 30e9 }
    local body = m:beam { name = "beam", from = { 0, 0 }, to = { p.length, 0 }, material = "m", divisions = p.elements,
      section = trilith.rectangle_section { width = 0.3, depth = 0.5 }, from_support = { x = "fixed", y = "fixed" },
      to_support = { y = "fixed" }, velocity = { 0, -1 }, floating = true }
    local most, at = 0, 0
    m:run { duration = 0.03, until_true = function()
      local down = -select(2, body:point { p.length/2, 0 })
      if down > most then most, at = down, m.time end
      return false
    end }
    return { ["largest deflection"] = most, ["time of it"] = at }
  end,
}

return {
  title = "Beams in motion",
  source = "Fryba (1999), Vibration of Solids and Structures under Moving Loads, chapter 1; for the beam that is " ..
    "caught the " ..
    "sum of the modes of a simple beam that starts with a uniform speed",
  formula = [[w(x, t) = \frac{2 P}{\mu L}\sum_n \frac{\sin\frac{n\pi x}{L}}{\omega_n^2 - \Omega_n^2}
\left(\sin\Omega_n t - \frac{\Omega_n}{\omega_n}\sin\omega_n t\right), \qquad \Omega_n = \frac{n\pi v}{L}]],
  cases = cases,
}
