-- Water fills a joint and heats a dam in two processes, flows on while the dam is shaken, and friction heats the dam.
local trilith = require "trilith"
local p = trilith.params { out = { "out/seepage.h5", "results" }, steps = { 150, "steps of each process" } }
local m = trilith.model { name = "seepage" }
m:material { name = "concrete", density = 2400, E = 2e10, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = 0.3, beta = 1e-4 } }
m:block { name = "rock", width = 20, height = 2, at = { -6, -2 }, material = "concrete", support = "fixed" }
m:block { name = "dam", width = 8, height = 6, at = { 0, 0 }, material = "concrete" }
m:water { name = "lake", body = "dam", level = 5, side = "left" }
m:seepage { name = "joint", upper = "dam", lower = "rock", aperture = 3e-4, divisions = 16, from = "heel", to = "toe",
  filled = false, bulk_modulus = 2e8 }
m:seepage_head { node = "heel", water = "lake" }
m:seepage_head { node = "toe", head = 0 }
m:heat { body = "dam", conductivity = 2, heat_capacity = 900, temperature = 12 }
m:heat { body = "rock", conductivity = 2, heat_capacity = 900, temperature = 8 }
m:heat_contact { conductance = 20, friction = true }
m:results { file = p.out, frames = 0.05, histories = 0.01, energy = 0.05 }
m:history { name = "pressure", seepage = "joint", what = "pressure", at = 2 }
m:history { name = "inflow", seepage = "joint", what = "inflow" }
m:history { name = "temperature", body = "dam", what = "temperature" }
m:consolidate { integrator = "static" }
m:process { name = "filling", duration = 2*p.steps, step = 2 }
m:set_level { name = "lake", level = 4 }
m:process { name = "lowered", duration = 2*p.steps, step = 2 }
m:seepage_motion { flows = true }
local wave = {}
for i = 1, 100 do wave[i] = 5*trilith.math.sin(0.3*i) end
wave[101] = 0
m:shake { body = "rock", x = trilith.motion { acceleration = wave, dt = 0.01, allow_drift = true }, duration = 1 }
print("hash " .. m.hash, m:seepage_state("joint").volume, m:temperature "dam")
return { volume = m:seepage_state("joint").volume, temperature = m:temperature "dam", slip = m:body("dam").ux }
