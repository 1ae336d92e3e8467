-- A block of stone falls onto a fixed base and bounces until it rests.
local trilith = require "trilith"
local p = trilith.params {
  height = { 0.2, unit = "m", "height of fall" },
  zeta = { 0.1, "damping ratio of the contact" } }
local m = trilith.model { name = "first block", thickness = 1 }

m:material { name = "stone", density = 2400 }
m:block { name = "base", width = 1.6, height = 0.1, at = { -0.8, -0.1 }, material = "stone", support = "fixed" }
local block = m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, p.height }, material = "stone",
                        floating = true }

local kn = 6e9                                         -- stress over overlap of two faces [Pa/m]
local frequency = math.sqrt(kn*0.5*1 / block.mass)     -- of the block on its face, 0.5 m by 1 m [rad/s]
m:contact { between = { "stone", "stone" },
            law = trilith.frictional { kn = kn, ks = kn/2, mu = 0.6, beta = 2*p.zeta/frequency } }

m:history { name = "height", unit = "m", of = function() return block.y - 0.15 end }
m:results { file = "out/first_block.h5", frames = 0.01, histories = 0.002 }
local speeds = {}
m:on("impact", function(e) speeds[#speeds + 1] = e.value end)
m:run { duration = 5, rest = true, dt = 5e-6 }

local z, s = p.zeta, math.sqrt(1 - p.zeta^2)           -- restitution of a spring and a damper that only push
local formula = math.exp(-z/s*(math.pi - math.atan(2*z*s, 1 - 2*z^2)))
print(("impact at %.3f m/s; restitution %.3f, formula %.3f"):format(speeds[1], speeds[2]/speeds[1], formula))
return { restitution = speeds[2]/speeds[1], formula = formula }
