-- A grouted bolt across a joint that opens: stiffness, slip of the bond, pull-out, yield, rupture and prestress.
local trilith = require "trilith"

local diameter, modulus, bond, strength = 0.02, 210e9, 5e8, 3e6
local area = math.pi*diameter^2/4

local function joint(p, options)
  local dim = p.dim
  local m = trilith.model { name = "bolt", dim = dim, gravity = 0 }
  m:material { name = "rock", density = 2500, E = 30e9, nu = 0.2 }
  m:material { name = "steel", density = 7850, E = modulus, nu = 0.3 }
  m:contact { between = { "*", "*" }, law = options.law or "none" }
  local function block(name, x)
    if dim == 2 then
      return m:block { name = name, width = 1, height = 0.5, at = { x, -0.25 }, material = "rock", floating = true }
    end
    return m:block { name = name, size = { 1, 0.5, 0.5 }, at = { x, -0.25, -0.25 }, material = "rock", floating = true }
  end
  local a, b = block("a", -1), block("b", 0)
  local zero = dim == 3 and 0 or nil
  local bolt = m:bolt { name = "bolt", bodies = { a, b }, from = { -1, 0, zero }, to = { 1, 0, zero }, joints = { 1 },
    diameter = diameter, E = modulus, material = "steel", bond = bond, bond_strength = strength, spacing = 1/p.springs,
    yield = options.yield, rupture = options.rupture, prestress = options.prestress,
    prestress_ramp = options.prestress_ramp }
  m:fix(a)
  return m, a, b, bolt
end

local rows = { { 0.75398e-3, 67916 }, { 1.4350e-3, 113425 }, { 2.3817e-3, 154512 }, { 3.2903e-3, 182238 },
  { 3.9e-3, 188496 } }
local function pulled(p, options)
  local m, _, b, bolt = joint(p, options)
  m:fix(b, p.dim == 2 and "yr" or "yzr")
  m:drive { body = b, x = trilith.ramp { by = 4e-3, duration = 1 } }
  local force = m:history { name = "force", every = 1e-3, of = function() return bolt.force() end }
  local gap = m:history { name = "gap", every = 1e-3, of = function() return b.ux end }
  m:run { duration = 1.1, integrator = "implicit", dt = 2e-3 }
  local function at(u)
    for i = 2, #gap.values do
      local before, now = gap.values[i - 1], gap.values[i]
      if now >= u then
        return force.values[i - 1] + (force.values[i] - force.values[i - 1])*(u - before)/(now - before)
      end
    end
  end
  return m, at, force, bolt
end

local function grouted(p)
  local m, at = pulled(p, {})
  local out = { ["stiffness across the joint"] = at(1e-4)/1e-4 }
  for _, row in ipairs(rows) do out[("force at %.4g mm"):format(row[1]*1e3)] = at(row[1]) end
  out["residual of the energy balance"] = m.residual/m.energy.support
  return out
end

local function yields(p)
  local _, at, force, bolt = pulled(p, { yield = 500e6, rupture = 0.6e-3 })
  return { ["largest force"] = force.max, ["force at 1.435 mm"] = at(1.435e-3), ["force at 3.9 mm"] = at(3.9e-3),
    ["bar"] = bolt.bars[1].status }
end

-- Two blocks pressed together by a prestressed bolt, then pulled apart: the joint opens at the prestress.
local function prestressed(p)
  local m, _, b, bolt = joint(p, { prestress = 50e3, law = trilith.frictional { kn = 1e11, ks = 5e10, mu = 0.6 } })
  m:consolidate { integrator = "static" }
  bolt.lock()
  m:consolidate { integrator = "static" }
  local normal = 0
  for _, c in ipairs(m:contacts { between = { "a", "b" } }) do normal = normal + c.normal end
  local out = { ["thrust of the joint over the bolt force"] = normal/bolt.force(), ["bolt force"] = bolt.force() }
  local zero = p.dim == 3 and 0 or nil
  for _, share in ipairs { 0.9, 1.1 } do
    m:point_load { name = "pull", body = b, at = { 1, 0, zero }, force = { share*50e3, 0, zero } }
    m:consolidate { integrator = "static" }
    local open = 0
    for _, c in ipairs(m:contacts { between = { "a", "b" } }) do open = open + c.normal end
    out[("joint at %g of the prestress"):format(share)] = open > 0 and "closed" or "open"
    m:remove "pull"
  end
  return out
end

local function cases_of(dim)
  local place = dim == 2 and "plane" or "space"
  local checks = { { "stiffness across the joint", unit = "N/m", exact = 9.0076e7, tolerance = 0.01 } }
  for _, row in ipairs(rows) do
    checks[#checks + 1] = { ("force at %.4g mm"):format(row[1]*1e3), unit = "N", exact = row[2], tolerance = 0.01 }
  end
  checks[#checks + 1] = { "residual of the energy balance", unit = "of the work of the pull", exact = 0, within = 1e-6 }
  local parameters = { { "dim", dim }, { "springs", 40 } }
  return { name = "bolt_" .. place, title = "bolt across a joint, in " .. place, parameters = parameters,
    checks = checks, run = grouted },
  { name = "bolt_yield_" .. place, title = "bar of 500 MPa that breaks at 0.6 mm, in " .. place,
    parameters = parameters,
    checks = { { "largest force", unit = "N", exact = 500e6*area, tolerance = 0.01 },
      { "force at 1.435 mm", unit = "N", exact = 113425, tolerance = 0.01 },
      { "force at 3.9 mm", unit = "N", exact = 0, within = 1 }, { "bar", exact = "failed" } },
    run = yields },
  { name = "bolt_prestress_" .. place, title = "bolt with a prestress of 50 kN, in " .. place, parameters = parameters,
    checks = { { "thrust of the joint over the bolt force", exact = 1, tolerance = 1e-6 },
      { "bolt force", unit = "N", exact = 50e3, tolerance = 0.01 },
      { "joint at 0.9 of the prestress", exact = "closed" }, { "joint at 1.1 of the prestress", exact = "open" } },
    run = prestressed }
end

local cases = {}
for _, dim in ipairs { 2, 3 } do
  for _, case in ipairs { cases_of(dim) } do cases[#cases + 1] = case end
end

return {
  title = "Grouted bolts",
  source = "Bar on elastic springs whose force is limited: Farmer (1975), International Journal of Rock Mechanics 12",
  formula = [[K = \tfrac12 \sqrt{E A k}\,\tanh\!\left(l\sqrt{k/(E A)}\right), \qquad
P_\text{slip} = \frac{\pi d \tau}{\lambda}\tanh \lambda l, \qquad P_\text{out} = \pi d\, l\, \tau]],
  text = "A bar of 20 mm is grouted over 1 m on each side of a joint that opens. The bond slips from the joint " ..
    "inwards, and the bar comes out. With steel of 500 MPa it yields before and breaks. A prestressed bolt presses " ..
    "the joint; it opens when the pull exceeds the prestress.",
  cases = cases,
}
