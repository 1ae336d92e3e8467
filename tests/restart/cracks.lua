-- Bodies that crack while a stage runs, and handlers that add others: units on two supports under falling stones.
local trilith = require "trilith"
local p = trilith.params { out = { "out/cracks.h5", "results" }, duration = { 4, unit = "s", "of the stage" } }
local m = trilith.model { name = "cracks", thickness = 0.2 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "beams", "beams" }, name = "unit", law = trilith.cohesive { kn = 2e10, ks = 1e10, mu = 0.6,
  beta = 1e-5, tension = 4e4, cohesion = 2e5, energy_tension = 1, energy_shear = 20 } }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4 } }
m:block { name = "ground", width = 8, height = 0.2, at = { -4, -0.2 }, material = "stone", support = "fixed" }
for i = 1, 3 do
  for _, x in ipairs { -0.55, 0.35 } do
    m:block { name = ("pad %d %g"):format(i, x), width = 0.2, height = 0.2, at = { 2*i - 4 + x, 0 },
      material = "stone" }
  end
  m:block { name = "beam " .. i, width = 1.2, height = 0.2, at = { 2*i - 4.6, 0.2 }, material = "stone",
    groups = { "beams" }, cracks = 5, crack_law = "unit" }
end
m:results { file = p.out, frames = 0.05, histories = 0.01, energy = 0.05 }
for i = 1, 3 do m:history { name = "beam " .. i, body = "beam " .. i, what = "y" } end
m:consolidate { rest = { ratio = 1e-4 } }
local state = m:keep { dropped = 0, cracks = 0 }
m:on("unit.cracked", function() state.cracks = state.cracks + 1 end)
m:every(0.6, function()
  if state.dropped == 6 then return end
  state.dropped = state.dropped + 1
  m:block { name = "drop " .. state.dropped, width = 0.3, height = 0.3, material = "stone", floating = true,
    at = { 2*(1 + (state.dropped - 1) % 3) - 4.15 + 0.05*math.random(), 1.2 } }
end)
m:run { name = "dropping", duration = p.duration }
print("hash " .. m.hash, state.dropped, state.cracks)
