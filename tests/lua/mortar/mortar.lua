-- Softening mortar: the law as a value, a joint pulled open by a load, its events with mode and force, notes.
local trilith = require "trilith"
local function near(a, b, tolerance) assert(math.abs(a - b) <= tolerance, a .. " is not " .. b) end
local function message(f) local ok, text = pcall(f); assert(not ok); return text end

local law = trilith.cohesive { kn = 1e8, ks = 5e7, mu = 0.7, cohesion = 3e4, tension = 19150, energy_tension = 10,
  energy_shear = 50 }
local m = trilith.model { name = "joint", thickness = 1, gravity = 0 }
m:contact { between = { "*", "*" }, law = law, name = "mortar" }
m:body { name = "base", outline = { { -1, -0.5 }, { 2, -0.5 }, { 2, 0 }, { -1, 0 } }, support = "fixed", mass = 1 }
m:body { name = "block", outline = { { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 0, 0.5 } }, mass = 1e5, velocity = { 0, 0.02 } }
local seen = {}
m:on("bond.cracked", function(e) seen[#seen + 1] = e end)
m:on("bond.broken", function(e) seen[#seen + 1] = e end)
m:run { duration = 0.2, dt = 1e-5 }
assert(#seen == 2 and seen[1].type == "bond.cracked" and seen[2].type == "bond.broken")
assert(seen[1].mode == "tension" and seen[1].text:find "cracked in tension at 19")
near(seen[1].value, 19150, 200)
-- 20 J of kinetic energy, 10 J of it dissipated by the mortar
near(m.energy.contact_fracture, 10, 0.05)
near(m.energy.kinetic, 10, 0.2)

assert(message(function()
  local n = trilith.model {}
  n:contact { between = { "*", "*" }, law = trilith.cohesive { kn = 1e8, ks = 5e7, mu = 0.7, cohesion = 3e4,
    tension = 19150, energy_tension = 1, energy_shear = 50 } }
end):find("energy_tension is 1 J/m2, must be above", 1, true))

-- Crushing mortar: a block on a joint weaker than the impact load.
local c = trilith.model { name = "crushing", thickness = 1 }
c:contact { between = { "*", "*" }, name = "mortar", law = trilith.cohesive { kn = 1e10, ks = 5e9, mu = 0.7,
  cohesion = 3e4, tension = 19150, energy_tension = 10, energy_shear = 50, compression = 2e5, crushing_depth = 5e-3 } }
c:body { name = "base", outline = { { -1, -0.5 }, { 2, -0.5 }, { 2, 0 }, { -1, 0 } }, support = "fixed", mass = 1 }
c:body { name = "block", outline = { { 0, 0 }, { 1, 0 }, { 1, 0.5 }, { 0, 0.5 } }, mass = 1000, velocity = { 0, -1 } }
local crushed = {}
c:on("joint.crushed", function(e) crushed[#crushed + 1] = e end)
c:run { duration = 0.1, dt = 1e-5 }
assert(#crushed == 1 and crushed[1].mode == "compression" and crushed[1].text:find "crushed in compression at 200 kN")
near(c.energy.contact_fracture, 525, 10)
