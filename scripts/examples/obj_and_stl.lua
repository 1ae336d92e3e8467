-- Stones from mesh files: a trilithon from an OBJ file in metres, and a boulder from an STL file in millimetres that
-- rolls against it. Read the volumes, which the program computes from the meshes, and which stone has moved.
local trilith = require "trilith"

local m = trilith.model { name = "trilithon", dim = 3 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5e9, ks = 2e9, mu = 0.6, beta = 1e-4 } }
local stones = m:solids { name = "stone", file = "meshes/trilithon.obj", material = "stone" }
local boulder = m:solids { name = "boulder", file = "meshes/boulder.stl", scale = 1e-3, material = "stone",
  velocity = { 8, 0, 0 } }[1]
m:level_ground { level = 0, material = "stone" }

m:results { file = "out/obj_and_stl.h5", frames = 0.02 }
m:run { duration = 3 }

for _, stone in ipairs(stones) do
  print(("%s: %.2f m3, moved by %.0f mm"):format(stone.name, stone.mass/2400,
    1e3*math.sqrt(stone.ux^2 + stone.uy^2 + stone.uz^2)))
end
print(("%s: %.4f m3"):format(boulder.name, boulder.mass/2400))
return { volume = stones[1].mass/2400, boulder = boulder.mass/2400 }
