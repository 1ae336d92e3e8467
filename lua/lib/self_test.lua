-- Self-test of `trilith doctor`: a small collapse with something of each kind, whose motion is known to the bit
-- (tests/golden/hashes.txt, run "self-test"). A copy of this program with another result is not reliable.
--
-- It contains tumbling rigid blocks, an arch, an elastic and a yielding mesh, a quad, softening mortar, and a span on a
-- spring and a yielding bearing over moving ground. It does not use Lua's math, because the C library has variants of
-- its functions whose last bits differ.
local trilith = require "trilith"
local p = trilith.params { out = { "self_test.h5", "results" } }
local deg = trilith.units "deg"
local m = trilith.model { name = "self-test", thickness = 1 }

m:material { name = "stone", density = 2400 }
m:material { name = "brick", density = 2000, E = 2e8, nu = 0.2, beta = 1e-4 }
m:material { name = "clay", density = 2000,
  solid = trilith.mohr_coulomb { E = 2e8, nu = 0.3, cohesion = 3e4, friction_angle = 25*deg, dilation_angle = 5*deg } }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 2e-4 } }
m:contact { between = { "brick", "brick" }, law = trilith.cohesive { kn = 1e8, ks = 5e7, mu = 0.5, beta = 2e-4,
  cohesion = 2e3, tension = 1e3, energy_tension = 1, energy_shear = 2 } }
m:block { name = "ground", width = 40, height = 1, at = { -20, -1 }, material = "stone", support = "fixed" }

m:arch { name = "arch", voussoirs = 9, radius = 2, thickness = 0.25, abutments = false, material = "stone" }
for i, body in ipairs { "quad", { mesh = { 2, 2 } } } do
  local x, material = 3*i + 1, i == 1 and "brick" or "clay"
  m:block { name = material, width = 1, height = 1, at = { x, 0 }, material = material, body = body }
  m:block { name = "on " .. material, width = 0.8, height = 0.6, at = { x + 0.5, 1.5 }, anchor = "centre",
    angle = 0.3*i, material = "stone", spin = 0.7*i, floating = true }
end
for i = 0, 2 do
  m:block { name = "course " .. i, width = 0.6, height = 0.3, at = { 0.1*i - 5, 0.3*i }, material = "brick" }
end

local pier = m:block { name = "pier", width = 1, height = 3, at = { -8, 0 }, material = "stone" }
local bank = m:block { name = "bank", width = 1, height = 3, at = { -13, 0 }, material = "stone" }
local span = m:block { name = "span", width = 5, height = 0.5, at = { -12.5, 3 }, material = "stone" }
local spring = trilith.linear { stiffness = 1e7, damping = 1e5 }
local steel = trilith.elastic_plastic { stiffness = 1e7, yield = 2e4 }
m:bearing { name = "right", between = { pier, span }, at = { -7.75, 3 }, along = steel, axial = spring }
m:bearing { name = "left", between = { bank, span }, at = { -12.25, 3 }, along = spring, axial = spring,
  limit = { along = 5e-4 }, angle = 10*deg }

m:results { file = p.out, frames = 0.05 }
m:shake { body = "ground", x = trilith.ramp { by = 0.8, duration = 0.7 }, duration = 6 }
print("motion " .. m.hash)
