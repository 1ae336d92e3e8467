-- A rigid bar whose plane softens: the crack begins at the stress of the section, and spends its fracture energy.
local trilith = require "trilith"

local tension, energy = 3e6, 100

-- A bar between a fixed and a driven block, bonded to both by strong joints; all are rigid.
local function bar(p)
  local m = trilith.model { name = "bar", thickness = 0.1, gravity = 0 }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, name = "glue",
    law = trilith.bonded { kn = p.glue, ks = p.glue/2, mu = 0.5, tension = 1e9, cohesion = 1e9, beta = 2e-5 } }
  m:contact { between = { "bar", "bar" }, name = "plane", law = trilith.cohesive { kn = p.kn, ks = p.kn/2, mu = 0.5,
    tension = tension, cohesion = 2*tension, energy_tension = energy, energy_shear = 4*energy, beta = 2e-6 } }
  m:block { name = "left", width = 0.1, height = 0.1, at = { -0.1, 0 }, material = "concrete", support = "fixed" }
  m:block { name = "right", width = 0.1, height = 0.1, at = { 0.5, 0 }, material = "concrete", support = "fixed" }
  m:block { name = "bar", width = 0.5, height = 0.1, at = { 0, 0 }, material = "concrete", cracks = "mid",
    crack_law = "plane" }
  return m
end

local function pulled(p)
  local m = bar(p)
  m:drive { body = "right", x = trilith.ramp { by = 1e-4, duration = 1 } }
  local left, right = m:body "left", m:body "right"
  local most, jump, work, before, u, cracked = 0, 0, 0, 0, 0, false
  m:on("unit.cracked", function() cracked = true end)
  local steps = 0
  m:run { duration = 1, until_true = function()
    local force, at = math.abs(left.reaction_x), right.ux
    most, work = math.max(most, force), work + (math.abs(right.reaction_x) + before)/2*(at - u)
    if cracked and steps < 20 then steps, jump = steps + 1, math.max(jump, math.abs(force - most)) end
    before, u = math.abs(right.reaction_x), at
    return false
  end }
  local area = 0.1*0.1
  return { ["largest pull"] = most, ["work of the pull"] = work, ["pull at the end"] = math.abs(left.reaction_x),
    ["jump of the pull at the crack"] = jump/(tension*area),
    ["residual of the energy balance"] = m.residual/(energy*area) }
end

return {
  title = "Fracture energy of a plane",
  source = "Hillerborg (1976), cohesive crack with linear softening; Papoulia, Sam and Vavasis (2003) for its start " ..
    "at the stress of the section",
  formula = [[P = f_t A, \qquad W = \left(G_f - \frac{f_t^2}{2 k_n}\right) A]],
  text = "A rigid bar is pulled apart slowly by two strong joints. Before it cracks it has no stiffness, no joint. " ..
    "The joint of its halves begins at the stress of the section: the pull does not jump. The rigid bar has no " ..
    "elastic energy to give, so the work lacks the elastic energy of the joint at its peak.",
  cases = { {
    name = "softening_plane", title = "a bar of 0.1 m by 0.1 m that is pulled apart",
    parameters = { { "kn", 2e12, "Pa/m" }, { "glue", 2e12, "Pa/m" } },
    checks = { { "largest pull", unit = "N", exact = tension*0.01, tolerance = 0.005 },
      { "work of the pull", unit = "J", exact = (energy - tension^2/(2*2e12))*0.01, tolerance = 0.005 },
      { "pull at the end", unit = "N", exact = 0, within = 30 },
      { "jump of the pull at the crack", unit = "of the strength", exact = 0, within = 0.02 },
      { "residual of the energy balance", unit = "of the fracture energy", exact = 0, within = 0.01 } },
    run = pulled,
  } },
}
