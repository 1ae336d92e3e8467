-- A bar with one or several planes of which one is weaker: the number of planes does not change the energy of fracture.
local trilith = require "trilith"

local modulus, tension, energy, kn, length, area = 30e9, 3e6, 100, 1e13, 0.5, 0.01
local end_kn = 2e14 -- of the joints to the end plates, whose compliance is subtracted

local function bar(planes)
  local m = trilith.model { name = "bar", thickness = 0.1, gravity = 0 }
  m:material { name = "concrete", density = 2400, E = modulus, nu = 0 }
  local function law(share)
    return trilith.cohesive { kn = kn, ks = kn/2, mu = 0.5, tension = share*tension, cohesion = 2*tension,
      energy_tension = energy, energy_shear = 4*energy }
  end
  m:contact { between = { "*", "*" }, law = trilith.bonded { kn = end_kn, ks = end_kn/2, mu = 0.5, tension = 1e9,
    cohesion = 1e9 } }
  m:contact { between = { "bar", "bar" }, law = law(1) }
  local piece, n = length/(planes + 1), 8//(planes + 1)
  m:block { name = "left", width = 0.1, height = 0.1, at = { -0.1, 0 }, material = "concrete", support = "fixed" }
  for i = 0, planes do
    m:block { name = "p" .. i, width = piece, height = 0.1, at = { i*piece, 0 }, material = "concrete",
      groups = { "bar" }, body = { mesh = { n, 1 } }, floating = true }
  end
  local right = m:block { name = "right", width = 0.1, height = 0.1, at = { length, 0 }, material = "concrete",
    support = "fixed" }
  local weak = (planes + 1)//2
  m:contact { between = { "p" .. weak - 1, "p" .. weak }, law = law(0.99) }
  return m, right, weak
end

local function pulled(p)
  local m, right, weak = bar(p.planes)
  m:drive { body = right, x = trilith.ramp { by = 75e-6, duration = p.duration } }
  local left, most, stiffness = m:body "left", 0, nil
  m:run { duration = 1.05*p.duration, until_true = function()
    local force = math.abs(left.reaction_x)
    most = math.max(most, force)
    if not stiffness and right.ux > 20e-6 then
      stiffness = 1/(right.ux/force - 2/(end_kn*area))
    end
    return false
  end }
  local others = 0
  for _, joint in ipairs(m:joints()) do
    local p1, p2 = joint.a.name, joint.b.name
    local is_weak = p1 == "p" .. weak - 1 and p2 == "p" .. weak or p2 == "p" .. weak - 1 and p1 == "p" .. weak
    if p1:match "^p" and p2:match "^p" and not is_weak then others = math.max(others, math.abs(joint.opening)) end
  end
  return { ["stiffness"] = stiffness, ["largest pull"] = most, ["energy of fracture"] = m.energy.contact_fracture,
    ["opening of the other planes"] = others, ["residual of the energy balance"] = m.residual/(energy*area) }
end

local cases = {}
for _, planes in ipairs { 1, 3, 7 } do
  cases[#cases + 1] = { name = "planes_" .. planes, title = ("%d planes in a bar of 0.5 m"):format(planes),
    parameters = { { "planes", planes }, { "duration", 0.04, "s" } },
    checks = { { "stiffness", unit = "N/m", exact = area/(length/modulus + planes/kn), tolerance = 0.005 },
      { "largest pull", unit = "N", exact = 0.99*tension*area, tolerance = 0.01 },
      { "energy of fracture", unit = "J", exact = energy*area, tolerance = 0.02 },
      { "opening of the other planes", unit = "m", exact = 0, within = 1e-6 },
      { "residual of the energy balance", exact = 0, within = 0.02 } },
    run = pulled }
end

return {
  title = "Number of planes",
  source = "Equilibrium: the pull is the same in all planes, and the weakest alone softens",
  formula = [[K = \frac{A}{L/E + n/k_n}, \qquad W = G_f A]],
  text = "A bar of meshes with 1, 3 or 7 planes, of which one is weaker by 1 %. The planes make the bar softer. One " ..
    "of them opens, the others unload, and the energy of fracture is the same.",
  cases = cases,
}
