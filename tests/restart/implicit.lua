-- Quads and a frame by implicit steps, after an equilibrium found by statics.
local trilith = require "trilith"
local p = trilith.params { out = { "out/implicit.h5", "results" }, duration = { 3, unit = "s", "of the shaking" } }
local m = trilith.model { name = "implicit" }
m:material { name = "stone", density = 2400, E = 2e9, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4 } }
m:block { name = "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed",
          body = "rigid" }
for i = 1, 5 do
  m:block { name = "b" .. i, width = 0.6, height = 0.3, at = { -0.3, 0.3 * (i - 1) }, material = "stone",
            body = "quad" }
end
m:results { file = p.out, frames = 0.05, histories = 0.01, energy = 0.05 }
m:history { name = "top", body = m:body "b5", what = "ux" }
m:consolidate { integrator = "static" }
local wave = {}
for i = 1, 300 do wave[i] = 3 * trilith.math.sin(0.1 * i) end
wave[301] = 0
local motion = trilith.motion { acceleration = wave, dt = 0.01, allow_drift = true }
m:shake { body = "base", x = motion, duration = p.duration,
          integrator = "implicit", dt = 0.005 }
print("hash " .. m.hash)
