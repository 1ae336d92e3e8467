-- A semicircular arch of thirty voussoirs on two abutments, under its own weight.
local trilith = require "trilith"
local g = trilith.units "g"
local p = trilith.params {
  thickness = { 0.15, unit = "m", "thickness of the ring; its mean radius is 1 m" },
  voussoirs = { 30, "number of voussoirs" },
  mu = { 10, "friction of the joints" } }
local m = trilith.model { name = "arch", thickness = 1 }

m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 4e12, ks = 2e12, mu = p.mu, beta = 5e-9 } }
m:arch { name = "arch", voussoirs = p.voussoirs, radius = 1, thickness = p.thickness, sub_edges = 2,
         abutments = true, material = "stone", fixed = "abutments" }
local ring = m:bodies { group = "voussoirs" }

m:results { file = "out/arch.h5", frames = 0.05 }
m:consolidate { duration = 2, rest = { speed = 1e-6 } }
local middle = m:thrust_line(ring)[p.voussoirs // 2]
print(("thrust at the crown: %.3f of the weight"):format(math.abs(middle.fx) / (ring.mass*g)))
m:run { name = "undamped", duration = 1 }
local moved = 0
for stone in ring do moved = math.max(moved, math.abs(stone.ux), math.abs(stone.uy)) end
print(moved < 0.01 and "stands" or "falls")
