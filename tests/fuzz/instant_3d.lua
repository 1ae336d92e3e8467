-- A model in space with mortar and an implicit stage, paused within it.
local trilith = require "trilith"
local m = trilith.model { name = "instant", dim = 3 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, name = "mortar",
  law = trilith.cohesive { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4, tension = 1e5, cohesion = 1e5,
    energy_tension = 10, energy_shear = 20 } }
m:block { name = "base", size = { 2, 2, 0.2 }, at = { -1, -1, -0.2 }, material = "stone", support = "fixed" }
m:block { name = "b", size = { 0.4, 0.4, 0.4 }, at = { 0, 0, 0 }, material = "stone" }
m:point_load { body = "b", force = { 2e4, 0, 0 }, load_curve = { ramp = 0.2 } }
m:history { name = "x", body = m:body "b", what = "x" }
m:every(0.02, function() if m.time > 0.06 then error "pause here" end end)
m:run { duration = 0.2, integrator = "implicit" }
