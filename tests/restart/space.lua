-- Blocks with mortar in space on a base that shakes, and one that comes later.
local trilith = require "trilith"
local p = trilith.params { out = { "out/space.h5", "results" }, duration = { 2, unit = "s", "of the shaking" } }
local m = trilith.model { name = "space", dim = 3 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, name = "mortar", law = trilith.bonded {
  kn = 1e9, ks = 4e8, mu = 0.6, beta = 2e-4, tension = 2e4, cohesion = 3e4 } }
m:block { name = "base", size = { 3, 3, 0.3 }, at = { -1.5, -1.5, -0.3 }, material = "stone", support = "fixed" }
for i = 1, 6 do
  m:block { name = "b" .. i, size = { 0.6, 0.3, 0.25 }, at = { -0.3 + 0.05 * (i % 2), -0.15, 0.25 * (i - 1) },
            material = "stone" }
end
m:results { file = p.out, frames = 0.05, histories = 0.01, energy = 0.05 }
m:history { name = "top", body = m:body "b6", what = "x" }
m:consolidate { rest = { ratio = 1e-4 }, fresh = true }
local wave = {}
for i = 1, 300 do wave[i] = 7 * trilith.math.sin(0.07 * i) end
wave[301] = 0
m:every(0.8, function()
  if #m:bodies { name = "late" } > 0 then return end
  m:block { name = "late", size = { 0.3, 0.3, 0.2 }, at = { 0.6, 0.6, 0.5 }, material = "stone", floating = true }
end)
local motion = trilith.motion { acceleration = wave, dt = 0.01, allow_drift = true }
m:shake { body = "base", x = motion, duration = p.duration }
print("hash " .. m.hash)
