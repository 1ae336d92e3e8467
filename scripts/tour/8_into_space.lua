-- A dry wall on a table that tilts out of the wall's plane: alone, or held by return walls.
local trilith = require "trilith"
local deg = trilith.units "deg"
local p = trilith.params {
  returns = { 0, "length of the return walls, along y", unit = "m" },
  mu = { 0.65, "friction of the joints" },
  fast = { 6, unit = "deg", "tilt up to which the table rotates fast" } }
local m = trilith.model { name = "corner", dim = 3 }

m:material { name = "stone", density = 2000 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 4e10, ks = 2e10, mu = p.mu, beta = 2e-5 } }
local walls = { { name = "front", from = { 0, 0.1 }, to = { 2.4, 0.1 } } }
if p.returns > 0 then -- an end within the thickness of another wall: the walls interlock
  for i, x in ipairs { 0.1, 2.3 } do
    walls[i + 1] = { name = i == 1 and "left" or "right", from = { x, 0.1 }, to = { x, p.returns } }
  end
end
m:building { name = "house", walls = walls, storeys = { { courses = 8 } }, unit_length = 0.4, unit_height = 0.2,
             base_height = 0.2, base_margin = 0.6, material = "stone", fixed = "base" }
m:results { file = "out/corner.h5", frames = 0.05 }
m:consolidate { duration = 2, rest = { speed = 1e-6 } }

m:tilt { rate = 4*deg, by = p.fast, towards = -90*deg }
m:run { name = "tilting fast", duration = p.fast/(4*deg) }

local slowly = false
m:every(0.002, function() if slowly and m.speed > 0.05 then m:stop() end end) -- a stone moves off
m:tilt { rate = 0.5*deg, by = 20*deg, towards = -90*deg }
slowly = true
local slow = m:run { name = "tilting slowly", duration = 40 }
slowly = false
local angle = p.fast + 0.5*deg*(slow.ended - slow.begun)
print(("collapses at %.1f degrees, tangent %.3f"):format(angle/deg, math.tan(angle)))
m:run { name = "falling", duration = 0.8 }
