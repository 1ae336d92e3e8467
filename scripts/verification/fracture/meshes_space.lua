-- Meshes in space that crack along faces of their elements: a bar that is pulled apart.
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
  m:run { integrator = p.integrator, dt = implicit and 2e-5 or nil, duration = p.duration,
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

return {
  title = "Meshes in space that crack along faces of their elements",
  source = "Hillerborg (1976), cohesive crack with linear softening; Camacho and Ortiz (1996), cracks along faces",
  formula = [[P = f_t A, \qquad W = \left(G_f - \frac{f_t^2}{2 k_n}\right) A]],
  text = "As in the plane, a mesh has no joint before it cracks. The elements part along the faces next to the " ..
    "plane, and each face begins at its stress.",
  cases = { bar_case("brick", 1, 10, "explicit") },
}
