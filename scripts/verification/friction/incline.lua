-- A block on an inclined plane that sticks or slides.
local trilith = require "trilith"
local sin, cos = trilith.math.sin, trilith.math.cos
local deg = trilith.units "deg"
local g = 9.80665

-- The plane is level and gravity is turned instead. Distance that the block slides in `duration` seconds [m].
local function slid(p, duration)
  local angle = p.angle*deg
  local m = trilith.model { name = "incline", gravity = { g*sin(angle), -g*cos(angle) } }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = p.mu, beta = 1e-4 } }
  m:block { name = "plane", width = 20, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
  local block = m:block { name = "block", width = 1, height = 0.2, at = { 0, 0 }, material = "stone" }
  m:run { duration = duration }
  return block.ux
end

local cases = {}
for _, row in ipairs { { 30, 0.3 }, { 30, 0.5 }, { 40, 0.5 } } do
  local angle, mu = row[1], row[2]
  cases[#cases + 1] = {
    name = ("incline_slides_%.0f_%.0f"):format(angle, 100*mu),
    title = "slides",
    parameters = { { "angle", angle, "deg" }, { "mu", mu } },
    checks = { { "distance after 1 s", unit = "m", exact = g*(sin(angle*deg) - mu*cos(angle*deg))/2,
      tolerance = 0.005 } },
    run = function(p) return slid(p, 1) end,
  }
end
for _, row in ipairs { { 20, 0.5 }, { 30, 0.7 } } do
  cases[#cases + 1] = {
    name = ("incline_sticks_%.0f_%.0f"):format(row[1], 100*row[2]),
    title = "sticks",
    parameters = { { "angle", row[1], "deg" }, { "mu", row[2] } },
    checks = { { "creep from 1 s to 10 s", unit = "m", exact = 0, within = 1e-6 } },
    run = function(p) return slid(p, 10) - slid(p, 1) end,
  }
end

return {
  title = "Block on an incline",
  source = "Coulomb's law of friction",
  formula = [[a = g\,(\sin\theta - \mu\cos\theta)]],
  text = "A block rests on a plane of inclination $\\theta$. It slides with the constant acceleration $a$ where " ..
    "$\\mu < \\tan\\theta$, and does not creep where $\\mu > \\tan\\theta$.",
  cases = cases,
}
