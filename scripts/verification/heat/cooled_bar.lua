-- A bar between fixed ends that is cooled until a plane in its middle cracks: stable if short, with a snap if long.
local trilith = require "trilith"
local depth = 0.1

-- Two halves with a cohesive joint, held at their far ends.
local function bar(p)
  local m = trilith.model { name = "bar", gravity = 0, thickness = depth }
  m:material { name = "concrete", density = 2400, E = 30e9, nu = 0 }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = 1e13, ks = 1e13, mu = 0.6, tension = p.strength,
    cohesion = 2*p.strength, energy_tension = p.energy, energy_shear = 10*p.energy } }
  local halves = {}
  for i, x in ipairs { 0, p.length } do
    halves[i] = m:block { name = "half" .. i, width = p.length/2, height = depth, at = { (i - 1)*p.length/2, 0 },
      material = "concrete", body = { mesh = { p.elements, 1 } }, floating = true,
      hold = { { from = { x - 1e-3, -1 }, to = { x + 1e-3, 1 }, x = "fixed", y = "free" },
        { from = { x - 1e-3, -1e-3 }, to = { x + 1e-3, 1e-3 }, x = "fixed", y = "fixed" } } }
  end
  m:heat { body = halves, conductivity = 2, heat_capacity = 900, expansion = 1e-5 }
  local function cool(by) m:set_temperature { body = halves, temperature = -by } end
  return m, halves, cool
end
local function parameters(length, elements)
  return { { "length", length, "m" }, { "strength", 2.4e6, "Pa" }, { "energy", 80, "J/m2" }, { "elements", elements } }
end

local function short(p)
  local m, halves, cool = bar(p)
  local function stress_at(t)
    cool(t)
    m:consolidate { integrator = "static" }
    return halves[1].sxx/1e6
  end
  local out, t = {}, 7.9
  repeat t = t + 0.02; stress_at(t) until m.energy.contact_fracture > 0 or t > 9
  out["first crack"] = t - 0.01
  out["stress at 12.363 K"] = stress_at(12.363)
  out["stress at 16.55 K"], out["stress at 16.75 K"] = stress_at(16.55), stress_at(16.75)
  out["energy spent"] = m.energy.contact_fracture/depth^2
  return out
end

local function long(p)
  local m, halves, cool = bar(p)
  cool(8)
  m:consolidate { integrator = "static" }
  local before = halves[1].sxx/1e6
  cool(8.016)
  m:run { duration = 4e-3 }
  local e = m.energy
  return { ["stress at 8 K"] = before, ["energy spent"] = e.contact_fracture/depth^2,
    ["energy left as motion"] = (e.kinetic + e.strain + e.contact_elastic)/depth^2 }
end

return {
  title = "A cooled bar that cracks",
  source = "Balance of the elastic energy and of the energy of fracture",
  formula = [[\Delta T_c = \frac{f_t}{\alpha E}\left(1 + \frac{E}{k_n L}\right), \qquad
\frac{f_t^2}{2}\left(\frac{L}{E} + \frac{1}{k_n}\right) = G_f + T]],
  text = "A plane in the middle softens linearly. The short bar follows its softening as it is cooled further. The " ..
    "long one stores more energy than the crack takes, and snaps; the rest is left as motion $T$ of its halves.",
  cases = {
    { name = "cooled_short_bar", title = "0.4 m: stable", parameters = parameters(0.4, 2),
      checks = { { "first crack", unit = "K", exact = 8.06, tolerance = 0.01 },
        { "stress at 12.363 K", unit = "MPa", exact = 1.2, tolerance = 0.01 },
        { "stress at 16.55 K", unit = "MPa", exact = 2.4*(16.667 - 16.55)/(16.667 - 8.06), tolerance = 0.03 },
        { "stress at 16.75 K", unit = "MPa", exact = 0, within = 1e-9 },
        { "energy spent", unit = "J/m2", exact = 80, tolerance = 0.01 } }, run = short },
    { name = "cooled_long_bar", title = "2 m: snaps", parameters = parameters(2, 20),
      checks = { { "stress at 8 K", unit = "MPa", exact = 2.4*8/8.012, tolerance = 0.001 },
        { "energy spent", unit = "J/m2", exact = 80, tolerance = 0.01 },
        { "energy left as motion", unit = "J/m2", exact = 112.3, tolerance = 0.01 } }, run = long },
  },
}
