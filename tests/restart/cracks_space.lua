-- Bodies in space that crack while a stage runs, with mortar under their planes and a joint that softens.
local trilith = require "trilith"
local p = trilith.params { out = { "out/cracks_space.h5", "results" }, duration = { 1.5, unit = "s", "of the stage" } }
local m = trilith.model { name = "cracks in space", dim = 3 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "beams", "beams" }, name = "unit", law = trilith.cohesive { kn = 2e10, ks = 1e10, mu = 0.6,
  beta = 1e-5, tension = 4e4, cohesion = 2e5, energy_tension = 1, energy_shear = 20 } }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4 } }
m:contact { between = { "beams", "pads" }, law = trilith.bonded { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4,
  tension = 2e4, cohesion = 5e4 } }
m:block { name = "ground", size = { 8, 2, 0.2 }, at = { -4, -1, -0.2 }, material = "stone", support = "fixed" }
for i = 1, 2 do
  for _, x in ipairs { -0.55, 0.35 } do
    m:block { name = ("pad %d %g"):format(i, x), size = { 0.2, 0.3, 0.2 }, at = { 2*i - 3 + x, -0.15, 0 },
      material = "stone", groups = { "pads" } }
  end
  m:block { name = "beam " .. i, size = { 1.2, 0.3, 0.2 }, at = { 2*i - 3.6, -0.15, 0.2 }, material = "stone",
    groups = { "beams" }, cracks = 5, crack_law = "unit" }
end
m:results { file = p.out, frames = 0.05, histories = 0.01, energy = 0.05 }
for i = 1, 2 do m:history { name = "beam " .. i, body = "beam " .. i, what = "z" } end
m:consolidate { rest = { ratio = 1e-3 }, duration = 2 }
local state = m:keep { dropped = 0, cracks = 0 }
m:on("unit.cracked", function() state.cracks = state.cracks + 1 end)
m:every(0.4, function()
  if state.dropped == 3 then return end
  state.dropped = state.dropped + 1
  m:block { name = "drop " .. state.dropped, size = { 0.3, 0.25, 0.3 }, material = "stone", floating = true,
    at = { 2*(1 + (state.dropped - 1) % 2) - 3.15 + 0.05*math.random(), -0.1, 0.8 } }
end)
m:run { name = "dropping", duration = p.duration }
print("hash " .. m.hash, state.dropped, state.cracks)
