-- Meshes in space that crack while a stage runs: a bar that is pulled apart, and a beam that a stone breaks.
local trilith = require "trilith"
local p = trilith.params { out = { "out/cracks_mesh_space.h5", "results" },
  duration = { 3e-3, unit = "s", "of the stage" } }
local strength = 2e6
local m = trilith.model { name = "cracks of meshes in space", dim = 3 }
m:material { name = "concrete", density = 2400, E = 3e10, nu = 0.2 }
m:contact { between = { "concrete", "concrete" }, name = "plane", law = trilith.cohesive { kn = 1e13, ks = 5e12,
  mu = 0.5, tension = strength, cohesion = 2*strength, energy_tension = 50, energy_shear = 200 } }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.5, beta = 1e-5 } }
for i, x in ipairs { 0, 0.7 } do
  m:block { name = "pad " .. i, size = { 0.1, 0.1, 0.1 }, at = { x, 0, -0.1 }, material = "concrete",
    support = "fixed", groups = { "pads" } }
end
m:block { name = "beam", size = { 0.8, 0.1, 0.1 }, at = { 0, 0, 0 }, material = "concrete",
  body = { mesh = { 16, 2, 2 } }, cracks = "quarter", crack_law = "plane" }
m:block { name = "stone", size = { 0.2, 0.1, 0.2 }, at = { 0.3, 0, 0.101 }, material = "concrete", floating = true,
  velocity = { 0, 0, -1.5 } }
m:block { name = "bar", size = { 0.4, 0.1, 0.1 }, at = { 0, 0, 2 }, material = "concrete",
  body = { mesh = { 8, 2, 2 } }, floating = true, cracks = "mid", crack_law = "plane" }
for _, side in ipairs { "left", "right" } do
  m:pressure { name = side, body = "bar", face = side, value = -1.2*strength, load_curve = { ramp = 1.5e-3 } }
end
m:results { file = p.out, frames = 1e-4, histories = 1e-5, energy = 1e-4 }
for _, body in ipairs { "beam", "bar" } do m:history { name = body, body = body, what = "z" } end
local state = m:keep { cracks = 0 }
m:on("unit.cracked", function() state.cracks = state.cracks + 1 end)
m:run { name = "breaking", duration = p.duration }
print("hash " .. m.hash, state.cracks)
