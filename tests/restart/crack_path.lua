-- A load path by arc length through cracks, between two stages: bars that soften and snap back.
local trilith = require "trilith"
local p = trilith.params { out = { "out/crack_path.h5", "results" },
                           arc = { 2e-6, unit = "m", "first step of the path" },
                           samples = { 400, "points of the path" },
                           duration = { 2e-3, unit = "s", "of each stage in time" } }
local b, strength = 0.1, 3e6
local m = trilith.model { name = "path of cracks", thickness = b, gravity = 0 }
m:material { name = "concrete", density = 2400, E = 30e9, nu = 0.2 }
m:contact { between = { "*", "*" }, name = "plane", law = trilith.cohesive { kn = 1e13, ks = 5e12, mu = 0.5,
  tension = strength, cohesion = 2*strength, energy_tension = 100, energy_shear = 400 } }
m:contact { between = { "block", "bar" }, name = "glue", law = trilith.bonded { kn = 1e14, ks = 5e13, mu = 0.5,
  tension = 1e9, cohesion = 1e9 } }
m:block { name = "bar", width = 1, height = b, at = { 0, 0 }, material = "concrete", body = { mesh = { 12, 2 } },
  hold = { { from = { 0, 0 }, to = { 0, b }, x = "fixed", y = "fixed" } }, cracks = "mid", crack_law = "plane" }
m:block { name = "block", width = 0.1, height = b, at = { 1, 0 }, material = "concrete",
  support = { y = "fixed", rotation = "fixed" } }
m:results { file = p.out, frames = 1e-3, histories = 1e-4, energy = 1e-3 }
for _, body in ipairs { "bar", "block" } do m:history { name = body, body = body, what = "x" } end
local state = m:keep { cracks = 0 }
m:on("unit.cracked", function() state.cracks = state.cracks + 1 end)
m:run { name = "before", duration = p.duration }
local r = m:pushover { name = "path", body = "block", direction = "x", control = "arc", arc = p.arc,
  displacement = 1.5e-4, samples = p.samples, drop = 0.5 }
print(("path to %.9f m with %.6f N, time %.6f s"):format(r.displacement, r.force, m.time))
m:run { name = "after", duration = p.duration }
print("hash " .. m.hash, state.cracks)
return { cracks = state.cracks, time = m.time, energy = m.energy.contact_fracture }
