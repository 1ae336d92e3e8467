-- Meshes that crack along edges of their elements: a bar that is pulled apart, a beam that is bent, and spall.
local trilith = require "trilith"

local modulus, density, tension, energy = 30e9, 2400, 3e6, 100
local kn = 1e13

local function concrete(nu)
  local m = trilith.model { name = "mesh", thickness = 0.1, gravity = 0 }
  m:material { name = "concrete", density = density, E = modulus, nu = nu }
  m:contact { between = { "*", "*" }, name = "plane", law = trilith.cohesive { kn = kn, ks = kn/2, mu = 0.5,
    tension = tension, cohesion = 2*tension, energy_tension = energy, energy_shear = 4*energy } }
  return m
end

-- A bar of 0.5 m, held at its left end; a stiff joint bonds it to a block that moves.
local function pulled(p)
  local m = concrete(0)
  m:contact { between = { "*", "*" }, name = "glue", law = trilith.bonded { kn = 1e14, ks = 5e13, mu = 0.5,
    tension = 1e9, cohesion = 1e9 } }
  local block = m:block { name = "block", width = 0.1, height = 0.1, at = { 0.5, 0 }, material = "concrete",
    support = "fixed" }
  m:block { name = "bar", width = 0.5, height = 0.1, at = { 0, 0 }, material = "concrete", cracks = p.planes,
    crack_law = "plane", body = { mesh = { p.elements, p.elements//5 } },
    hold = { { from = { 0, 0 }, to = { 0, 0.1 }, x = "fixed", y = "fixed" } } }
  m:drive { body = block, x = trilith.ramp { by = 8e-5, duration = 0.05 } }
  local implicit = p.integrator == "implicit"
  local most, work, before, at, at_crack, jump, steps, after, since = 0, 0, 0, 0, nil, 0, 0, 0, nil
  m:on("unit.cracked", function() at_crack = at_crack or before end)
  m:run { integrator = p.integrator, dt = implicit and 2e-5 or nil, duration = 0.05,
    until_true = function()
      local force, u = block.reaction_x, block.ux
      most, work = math.max(most, force), work + (force + before)/2*(u - at)
      if at_crack and steps < (implicit and 1 or 20) then
        steps, jump = steps + 1, math.max(jump, math.abs(force - at_crack))
      end
      if m.time > 0.04 then after, since = after + (since and force*(m.time - since) or 0), m.time end
      before, at = force, u
      return false
    end }
  return { ["largest pull"] = most, ["work of the pull"] = work, ["mean pull after the crack"] = after/0.01,
    ["jump of the pull at the crack"] = jump/(tension*0.01), ["residual of the energy balance"] = m.residual }
end

local function bar_case(planes, elements, integrator)
  return { name = ("bar_%d_%d_%s"):format(planes, elements, integrator), title = "a bar of 0.5 m that is pulled apart",
    parameters = { { "planes", planes }, { "elements", elements }, { "integrator", integrator } },
    checks = { { "largest pull", unit = "N", exact = tension*0.01, tolerance = 0.005 },
      { "work of the pull", unit = "J", exact = (energy - tension^2/(2*kn))*0.01, tolerance = 0.005 },
      { "mean pull after the crack", unit = "N", exact = 0, within = 30 },
      { "jump of the pull at the crack", unit = "of the strength", exact = 0, within = 0.02 },
      { "residual of the energy balance", unit = "J", exact = 0, within = 0.01 } },
    run = pulled }
end

-- A beam in three-point bending. Its middle is held at the top; blocks below its ends move up.
local function bent(p)
  local m, d = concrete(0.2), p.depth
  local span = 4*d
  m:contact { between = { "block", "*" }, law = trilith.frictional { kn = 2e13, ks = 2e12, mu = 0, beta = 1e-6 } }
  local blocks = {}
  for i, x in ipairs { -0.02, span - 1e-3 } do
    blocks[i] = m:block { name = "block" .. i, width = 0.021, height = 0.02, at = { x, -0.02 },
      material = "concrete", support = "fixed", groups = { "block" } }
    m:drive { body = blocks[i], y = trilith.ramp { by = p.rise, duration = p.duration } }
  end
  m:block { name = "beam", width = span, height = d, at = { 0, 0 }, material = "concrete", cracks = "mid",
    crack_law = "plane", body = { mesh = { 4*p.rows, p.rows } },
    hold = { { from = { span/2, d }, to = { span/2, d }, x = "fixed", y = "fixed" } } }
  local most = 0
  m:run { duration = p.duration, until_true = function()
    most = math.max(most, math.abs(blocks[1].reaction_y + blocks[2].reaction_y))
    return false
  end }
  return { ["largest load"] = most, ["residual of the energy balance"] = m.residual }
end

local function beam_case(depth, rows, rise, peak)
  return { name = ("beam_%g_%d"):format(depth, rows),
    title = ("beam of %g m depth in three-point bending"):format(depth),
    parameters = { { "depth", depth, "m" }, { "rows", rows }, { "rise", rise, "m" }, { "duration", 0.04, "s" } },
    checks = { { "largest load", unit = "N", exact = peak, tolerance = 0.03 },
      { "residual of the energy balance", unit = "J", exact = 0, within = 0.01 } },
    run = bent }
end

return {
  title = "Meshes that crack along edges of their elements",
  source = "Hillerborg (1976), cohesive crack with linear softening; Camacho and Ortiz (1996), cracks along edges; " ..
    "peak loads of the beams by condensed finite elements with 80 to 160 elements over the depth",
  formula = [[P = f_t A, \qquad W = \left(G_f - \frac{f_t^2}{2 k_n}\right) A]],
  text = "A mesh has no joint before it cracks. Then it is divided along the edges of its elements next to the " ..
    "plane, and the new faces are bonded at the stress of the edges, so that the pull does not jump. The energy of " ..
    "a bar does not depend on the mesh. The peak of a beam depends on its size as the fracture energy requires.",
  cases = { bar_case(1, 10, "explicit"), bar_case(1, 20, "explicit"), bar_case(1, 10, "implicit"),
    beam_case(0.1, 8, 1.5e-4, 8539), beam_case(0.2, 8, 2e-4, 15147) },
}
