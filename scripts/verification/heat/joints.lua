-- A slab that curls off its base, and a plate that walks down a slope through cycles of temperature.
local trilith = require "trilith"
local g = 9.80665

local function curled(p)
  local m = trilith.model { name = "slab" }
  m:material { name = "concrete", density = 2400, E = 30e9 }
  m:material { name = "rock", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = p.kn, ks = p.kn, mu = 0.6 } }
  m:block { name = "base", width = 7, height = 1, at = { -3.5, -1 }, material = "rock", support = "fixed" }
  local slab = m:block { name = "slab", width = 6, height = 0.2, at = { -3, 0 }, material = "concrete",
    body = { mesh = { p.elements, 2 } } }
  m:heat { body = slab, conductivity = 1.5, heat_capacity = 900, expansion = 1e-5 }
  m:consolidate { integrator = "static" }
  local flat = select(2, slab:point { 3, 0 })
  m:set_temperature { body = slab, temperature = 0, gradient = -p.difference/0.2 }
  m:consolidate { integrator = "static" }
  return 1e3*(select(2, slab:point { 3, 0 }) - flat)
end

-- The plate lies along x; gravity has the direction that it has on the slope.
local function walk(p)
  local slope = p.slope*math.pi/180
  local m = trilith.model { name = "plate",
    gravity = { -g*trilith.math.sin(slope), -g*trilith.math.cos(slope) } }
  m:material { name = "plate", density = 2400, E = p.E }
  m:material { name = "rock", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e10, mu = 0.6 } }
  m:block { name = "base", width = 12, height = 1, at = { -6, -1 }, material = "rock", support = "fixed" }
  local plate = m:block { name = "plate", width = 10, height = 0.1, at = { -5, 0 }, material = "plate",
    body = { mesh = { p.elements, 1 } } }
  m:heat { body = plate, conductivity = 2, heat_capacity = 900, expansion = 1e-5 }
  m:heat_exchange { body = plate, side = "all",
    temperature = { { 0, 0 }, { 10, 20 }, { 19.99, 0 }, period = 20 } }
  m:consolidate { integrator = "static" }
  local places = {}
  for cycle = 1, p.cycles do
    m:process { duration = 20, step = p.step, within = 1 }
    places[cycle] = plate.x
  end
  return 1e3*(places[#places - 1] - places[#places])
end

return {
  title = "Joints and cycles of temperature",
  source = "Westergaard (1927) for curling; thermal ratcheting by the balance of a plate on a slope",
  formula = [[l = \sqrt{\frac{2 E I \kappa}{q}}, \qquad w = \frac{\kappa l^2}{4}, \qquad
\Delta u = \frac{L \tan\beta}{\mu}\left(\alpha \Delta T - \frac{\rho g L (\mu\cos\beta - \sin\beta)}{E}\right)]],
  text = "A slab whose top is colder lifts its ends off the base. A plate on a slope walks down by a step in each " ..
    "cycle, although friction would hold it at a constant temperature. The slip depends on its history, so the " ..
    "steps are a hundredth of the rise.",
  cases = {
    { name = "curled_slab", title = "slab with a cold top on a rigid base",
      parameters = { { "kn", 1e12, "Pa/m" }, { "difference", 10, "K" }, { "elements", 60 } },
      checks = { { "rise of the ends", unit = "mm", exact = 0.5311, tolerance = 0.01 } }, run = curled },
    { name = "walking_plate", title = "plate on a slope of 15 degrees, 20 K",
      parameters = { { "slope", 15 }, { "E", 30e9, "Pa" }, { "elements", 40 }, { "cycles", 2 }, { "step", 0.1 } },
      checks = { { "step in a cycle", unit = "mm", exact = 0.8819, tolerance = 0.03 } }, run = walk },
    { name = "walking_soft_plate", title = "the same, softer",
      parameters = { { "slope", 15 }, { "E", 3e9, "Pa" }, { "elements", 40 }, { "cycles", 2 }, { "step", 0.1 } },
      checks = { { "step in a cycle", unit = "mm", exact = 0.7808, tolerance = 0.03 } }, run = walk },
    { name = "level_plate", title = "the same plate on level ground",
      parameters = { { "slope", 0 }, { "E", 30e9, "Pa" }, { "elements", 40 }, { "cycles", 2 }, { "step", 0.1 } },
      checks = { { "step in a cycle", unit = "mm", exact = 0, within = 1e-3 } }, run = walk },
  },
}
