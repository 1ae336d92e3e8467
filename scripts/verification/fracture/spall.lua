-- Spall: a pulse of compression returns from the free end of a bar as tension, and a piece flies off.
local trilith = require "trilith"

local modulus, density, tension, speed = 30e9, 2400, 4e6, 2.35702
local wave = math.sqrt(modulus/density)
local pieces, length, kn = 30, 0.1, 7.5e12

-- One mesh with planes, which parts along edges of its elements.
local function blow_at_mesh(p)
  local m = trilith.model { name = "spall", thickness = 0.1, gravity = 0 }
  m:material { name = "concrete", density = density, E = modulus, nu = 0 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 0.5 } }
  m:contact { between = { "bar", "bar" }, name = "plane",
    law = trilith.bonded { kn = kn, ks = kn/2, mu = 0.5, tension = tension, cohesion = 10*tension } }
  m:block { name = "bar", width = length*pieces, height = 0.1, at = { 0, 0 }, material = "concrete",
    body = { mesh = { p.elements*pieces, 1 } }, floating = true, cracks = pieces - 1, crack_law = "plane" }
  local striker = m:block { name = "striker", width = 0.5, height = 0.1, at = { -0.5, 0 }, material = "concrete",
    body = { mesh = { 5*p.elements, 1 } }, floating = true, velocity = { speed, 0 } }
  m:fix(m:bodies {}, "y")
  local first, at
  m:on("unit.cracked", function(e)
    if not first then first, at = e.time, e.x end
  end)
  m:run { duration = 1.5e-3 }
  local momentum, mass = { 0, 0 }, { 0, 0 }
  for _, piece in ipairs(m:bodies { group = "pieces of bar" }) do
    if piece.present then
      local k = piece.x > at and 2 or 1
      momentum[k], mass[k] = momentum[k] + piece.mass*piece.vx, mass[k] + piece.mass
    end
  end
  return { ["distance of the first crack from the end"] = pieces*length - at, ["time of the first crack"] = first,
    ["speed of the piece"] = momentum[2]/mass[2], ["speed of the rest"] = momentum[1]/mass[1],
    ["speed of the striker"] = striker.vx,
    ["residual of the energy balance"] = m.residual/(0.5*density*0.5*0.01*speed^2) }
end

local function blow(p)
  local m = trilith.model { name = "spall", thickness = 0.1, gravity = 0 }
  m:material { name = "concrete", density = density, E = modulus, nu = 0 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 0.5 } }
  m:contact { between = { "bar", "bar" },
    law = trilith.bonded { kn = kn, ks = kn/2, mu = 0.5, tension = tension, cohesion = 10*tension } }
  local bar = {}
  for i = 1, pieces do
    bar[i] = m:block { name = "p" .. i, width = length, height = 0.1, at = { length*(i - 1), 0 }, material = "concrete",
      groups = { "bar" }, body = { mesh = { p.elements, 1 } }, floating = true }
  end
  local striker = m:block { name = "striker", width = 0.5, height = 0.1, at = { -0.5, 0 }, material = "concrete",
    body = { mesh = { 5*p.elements, 1 } }, floating = true, velocity = { speed, 0 } }
  m:fix(m:bodies {}, "y")
  local first, at
  m:on("bond.broken", function(e)
    if not first then first, at = e.time, e.x end
  end)
  m:run { duration = 1.5e-3 }
  local outer, rest = 0, 0
  for i, piece in ipairs(bar) do
    if i > 25 then outer = outer + piece.vx/5 else rest = rest + piece.vx/25 end
  end
  return { ["distance of the first crack from the end"] = pieces*length - at, ["time of the first crack"] = first,
    ["speed of the outer 0.5 m"] = outer, ["speed of the rest"] = rest, ["speed of the striker"] = striker.vx,
    ["residual of the energy balance"] = m.residual/(0.5*density*0.5*0.01*speed^2) }
end

return {
  title = "Spall of a bar",
  source = "One-dimensional waves: Kolsky (1953), Stress Waves in Solids, chapter 3",
  formula = [[\sigma = \tfrac12 \rho c v, \qquad l = c\, t_p/2, \qquad v_\text{piece} = v]],
  text = "A bar of 0.5 m strikes a bar of 3 m flat. The pulse of 10 MPa is 1 m long. It returns from the free end " ..
    "as tension, and the joint where this first exceeds 4 MPa is 0.5 m from the end. All momentum is in the piece " ..
    "that flies off. The bar has a brittle joint every 0.1 m; its pieces are meshes. The second bar is one mesh " ..
    "with brittle planes in these places.",
  cases = { { name = "spall", title = "bar of 3 m with joints of 4 MPa",
    parameters = { { "elements", 5 } },
    checks = { { "distance of the first crack from the end", unit = "m", exact = 0.5, within = 0.1001 },
      { "time of the first crack", unit = "s", exact = 3.5/wave, tolerance = 0.05 },
      { "speed of the outer 0.5 m", unit = "m/s", exact = speed, tolerance = 0.05 },
      { "speed of the rest", unit = "m/s", exact = 0, within = 0.05*speed },
      { "speed of the striker", unit = "m/s", exact = 0, within = 0.05*speed },
      { "residual of the energy balance", exact = 0, within = 0.01 } },
    run = blow },
    { name = "spall_mesh", title = "bar of 3 m as one mesh with planes of 4 MPa",
      parameters = { { "elements", 5 } },
      checks = { { "distance of the first crack from the end", unit = "m", exact = 0.5, within = 0.1001 },
        { "time of the first crack", unit = "s", exact = 3.5/wave, tolerance = 0.05 },
        { "speed of the piece", unit = "m/s", exact = speed, tolerance = 0.05 },
        { "speed of the rest", unit = "m/s", exact = 0, within = 0.05*speed },
        { "speed of the striker", unit = "m/s", exact = 0, within = 0.05*speed },
        { "residual of the energy balance", exact = 0, within = 0.01 } },
      run = blow_at_mesh } },
}
