-- A load path between two stages: motions and load curves in progress wait for its second.
local trilith = require "trilith"
local p = trilith.params { out = { "out/load_path.h5", "results" }, blocks = { 6, "blocks of the stack" },
                           duration = { 12, unit = "s", "of each stage in time" } }
local m = trilith.model { name = "load path" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4 } }
m:block { name = "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
for i = 1, p.blocks do
  m:block { name = "b" .. i, width = 0.5, height = 0.25, at = { -0.25, 0.25 * (i - 1) }, material = "stone" }
end
m:results { file = p.out, frames = 0.05, histories = 0.01, energy = 0.05 }
m:consolidate { integrator = "static" }
local top = m:body("b" .. p.blocks)
m:point_load { name = "wind", body = top, force = { 20, 0 },
               load_curve = { { 0, 0 }, { 2, 1 }, { 2*p.duration + 1, -1 } } }
local wave = {}
for i = 1, 400 do wave[i] = 0.1 * trilith.math.sin(0.25 * i) end
wave[401] = 0
m:drive { body = "base", x = trilith.motion { acceleration = wave, dt = 0.05, allow_drift = true } }
m:history { name = "top", body = top, what = "x" }
m:run { name = "before", duration = p.duration }
m:consolidate { integrator = "static", name = "rest", within = 2 }
local r = m:pushover { name = "path", body = top, control = "arc", displacement = 2e-3, samples = 200 }
print(("path to %.9f m with %.6f N, time %.6f s"):format(r.displacement, r.force, m.time))
m:run { name = "after", duration = p.duration }
print("hash " .. m.hash)
return { top = top.x, time = m.time }
