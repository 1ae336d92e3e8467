-- A body of elements hangs from a point far off its face, by springs along three axes. The stable step counts the tilt
-- of the face, so the energy balance closes for each length of the lever.
local trilith = require "trilith"

local stiffness, width, height = 1e7, 0.2, 1
for _, gap in ipairs { 0, 0.3, 1, 5, 15 } do
  local m = trilith.model { dim = 3 }
  m:material { name = "concrete", density = 2400, E = 3e10, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "base", size = { 1, 1, 0.2 }, at = { 0, 0, height + gap }, material = "concrete",
    support = "fixed" }
  local bob = m:block { name = "bob", size = { width, width, width }, at = { 0.4, 0.4, height - width },
    floating = true, material = "concrete", body = { mesh = { 2, 2, 2 } }, velocity = { 0.01, 0, 0 } }
  local spring = trilith.linear { stiffness = stiffness }
  m:bearing { name = "link", between = { "base", "bob" }, at = { 0.5, 0.5, height + gap }, arm = gap + 0.1,
    along = spring, across = spring, axial = spring }
  local report = m:run { duration = 2e-3 }
  local energy = m.energy
  assert(m.verdict.sound, ("lever of %g m: %s"):format(gap, report.reason))
  assert(math.abs(m.residual) < 1e-3*(energy.kinetic + energy.strain), ("lever of %g m: %g J"):format(gap, m.residual))
  -- The springs support the weight only after a while, so the body has fallen freely at most.
  assert(bob.uz < 0 and bob.uz > -9.80665*(2e-3)^2/2*1.01, bob.uz)
  m:close()
end
