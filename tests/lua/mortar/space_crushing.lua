-- Crushing mortar in space: a block on a joint weaker than the impact load; the same by extrusion from the plane; and
-- after a rewind.
local trilith = require "trilith"
local function near(a, b, tolerance) assert(math.abs(a - b) <= tolerance, a .. " is not " .. b) end

local function mortar(compression)
  return trilith.cohesive { kn = 1e10, ks = 5e9, mu = 0.7, cohesion = 3e4, tension = 19150, energy_tension = 10,
    energy_shear = 50, compression = compression, crushing_depth = 5e-3 }
end

local m = trilith.model { name = "crushing", dim = 3 }
m:contact { between = { "*", "*" }, name = "mortar", law = mortar(2e5) }
m:block { name = "base", size = { 3, 3, 0.5 }, at = { -1, -1, -0.5 }, support = "fixed", mass = 1 }
local block = m:block { name = "block", size = { 1, 1, 0.5 }, at = { 0, 0, 0 }, mass = 1000, velocity = { 0, 0, -1 } }
local crushed = {}
m:on("joint.crushed", function(e) crushed[#crushed + 1] = e end)
m:history { name = "z", of = function() return block.z end, unit = "m" }
m:checkpoints { on = true, every = 0.02 }
m:run { duration = 0.1, dt = 1e-5 }
assert(#crushed == 1 and crushed[1].mode == "compression" and crushed[1].text:find "crushed in compression at 200 kN")
-- Kinetic energy over (strength minus weight), as in the plane.
near(m.energy.contact_fracture, 525, 10)
local taken, low, hash = m.energy.contact_fracture, block.z, m.hash

-- The same model of the plane by one call.
local flat = trilith.model { name = "flat", thickness = 1 }
flat:contact { between = { "*", "*" }, name = "mortar", law = mortar(2e5) }
flat:block { name = "base", width = 3, height = 0.5, at = { -1, -0.5 }, support = "fixed", mass = 1 }
flat:block { name = "block", width = 1, height = 0.5, at = { 0, 0 }, mass = 1000, velocity = { 0, -1 } }
local deep = flat:extruded()
deep:run { duration = 0.1, dt = 1e-5 }
near(deep.energy.contact_fracture, taken, 1)
near(deep:body "block".z, low, 1e-5)

-- Rewound to the middle and continued: the same bits; with an additional push the difference is reported.
m:rewind(0.05)
assert(m.time < 0.06 and m.energy.contact_fracture <= taken)
m:continue()
assert(m.hash == hash)
local same = m:compare()
assert(same.same and tostring(same):find "^identical at ", tostring(same))
m:rewind(0.05)
m:point_load { name = "push", body = "block", force = { 2e4, 0, 0 } }
m:continue()
local found = m:compare()
assert(not found.same and found.moved[1].body.name == "block" and found.moved[1].distance > 1e-6, tostring(found))
assert(found.moved[1].turn >= 0 and found.histories.z.difference > 0)
assert(tostring(found):find("bodies moved most", 1, true))
