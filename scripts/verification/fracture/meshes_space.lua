-- Meshes in space that crack along faces of their elements: a bar that is pulled apart, and a beam that is bent.
local trilith = require "trilith"

local modulus, density, tension, energy = 30e9, 2400, 3e6, 100
local kn = 1e13
local area = 0.1*0.1

local function concrete(nu)
  local m = trilith.model { name = "mesh", dim = 3, gravity = 0 }
  m:material { name = "concrete", density = density, E = modulus, nu = nu }
  m:contact { between = { "*", "*" }, name = "plane", law = trilith.cohesive { kn = kn, ks = kn/2, mu = 0.5,
    tension = tension, cohesion = 2*tension, energy_tension = energy, energy_shear = 4*energy } }
  return m
end

-- A bar of 0.5 m, held at its left end; a stiff joint bonds it to a block that moves.
local function pulled(p)
  local m = concrete(0)
  m:contact { between = { "block", "bar" }, name = "glue", law = trilith.bonded { kn = 1e14, ks = 5e13, mu = 0.5,
    tension = 1e9, cohesion = 1e9 } }
  local block = m:block { name = "block", size = { 0.1, 0.1, 0.1 }, at = { 0.5, 0, 0 }, material = "concrete",
    support = "fixed" }
  m:block { name = "bar", size = { 0.5, 0.1, 0.1 }, at = { 0, 0, 0 }, material = "concrete", cracks = p.planes,
    crack_law = "plane", body = { mesh = { p.divisions, 2, 2 }, element = p.element },
    hold = { { from = { 0, 0, 0 }, to = { 0, 0.1, 0.1 }, x = "fixed", y = "fixed", z = "fixed" } } }
  m:drive { body = block, x = trilith.ramp { by = 8e-5, duration = p.duration } }
  local implicit = p.integrator == "implicit"
  local most, work, before, at, at_crack, jump, steps, cracks = 0, 0, 0, 0, nil, 0, 0, 0
  m:on("unit.cracked", function() at_crack, cracks = at_crack or before, cracks + 1 end)
  m:run { integrator = p.integrator, dt = implicit and p.duration/2500 or nil, duration = p.duration,
    until_true = function()
      local force, u = block.reaction_x, block.ux
      most, work = math.max(most, force), work + (force + before)/2*(u - at)
      if at_crack and steps < (implicit and 1 or 20) then
        steps, jump = steps + 1, math.max(jump, math.abs(force - at_crack))
      end
      before, at = force, u
      return false
    end }
  return { ["largest pull"] = most, ["work of the pull"] = work, cracks = cracks,
    ["jump of the pull at the crack"] = jump/(tension*area), ["energy of fracture"] = m.energy.contact_fracture,
    ["residual of the energy balance"] = m.residual }
end

local function bar_case(element, planes, divisions, integrator)
  return { name = ("space_bar_%s_%d_%d_%s"):format(element, planes, divisions, integrator),
    title = "a bar of 0.5 m that is pulled apart",
    parameters = { { "element", element }, { "planes", planes }, { "divisions", divisions },
      { "integrator", integrator }, { "duration", 0.02, "s" } },
    checks = { { "largest pull", unit = "N", exact = tension*area, tolerance = 0.01 },
      { "work of the pull", unit = "J", exact = (energy - tension^2/(2*kn))*area, tolerance = 0.01 },
      { "energy of fracture", unit = "J", exact = (energy - tension^2/(2*kn))*area, tolerance = 0.01 },
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
    blocks[i] = m:block { name = "block" .. i, size = { 0.021, 0.1, 0.02 }, at = { x, 0, -0.02 },
      material = "concrete", support = "fixed", groups = { "block" } }
    m:drive { body = blocks[i], z = trilith.ramp { by = p.rise, duration = p.duration } }
  end
  m:block { name = "beam", size = { span, 0.1, d }, at = { 0, 0, 0 }, material = "concrete", cracks = "mid",
    crack_law = "plane", body = { mesh = { 4*p.rows, 1, p.rows } },
    hold = { { from = { span/2, 0, d }, to = { span/2, 0.1, d }, x = "fixed", y = "fixed", z = "fixed" } } }
  local most = 0
  m:run { duration = p.duration, until_true = function()
    most = math.max(most, math.abs(blocks[1].reaction_z + blocks[2].reaction_z))
    return false
  end }
  return { ["largest load"] = most, ["residual of the energy balance"] = m.residual }
end

return {
  title = "Meshes in space that crack along faces of their elements",
  source = "Hillerborg (1976), cohesive crack with linear softening; Camacho and Ortiz (1996), cracks along faces; " ..
    "peak load of the beam by condensed finite elements with 80 to 160 elements over the depth",
  formula = [[P = f_t A, \qquad W = \left(G_f - \frac{f_t^2}{2 k_n}\right) A]],
  text = "As in the plane, a mesh has no joint before it cracks. Bricks and tetrahedra of four and ten nodes part " ..
    "along the faces next to the plane, and each face begins at its stress.",
  cases = { bar_case("brick", 1, 10, "explicit"), bar_case("brick", 3, 20, "explicit"),
    bar_case("brick", 1, 10, "implicit"), bar_case("tet4", 1, 10, "explicit"), bar_case("tet10", 1, 10, "implicit"),
    { name = "space_beam", title = "beam of 0.1 m depth in three-point bending",
      parameters = { { "depth", 0.1, "m" }, { "rows", 8 }, { "rise", 1.5e-4, "m" }, { "duration", 0.04, "s" } },
      checks = { { "largest load", unit = "N", exact = 8539, tolerance = 0.03 },
        { "residual of the energy balance", unit = "J", exact = 0, within = 0.01 } },
      run = bent } },
}
