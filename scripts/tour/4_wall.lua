-- A dry wall of six courses stands on a table that tilts until the wall collapses.
local trilith = require "trilith"
local deg = trilith.units "deg"
local p = trilith.params {
  courses = { 6, "number of courses" },
  mu = { 0.65, "friction of the joints" },
  fast = { 28, unit = "deg", "tilt up to which the table rotates fast" } }
local m = trilith.model { name = "dry wall", thickness = 1 }

m:material { name = "stone", density = 2000 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 4e11, ks = 2e11, mu = p.mu, beta = 5e-6 } }
m:running_bond { name = "wall", columns = 5, courses = p.courses, unit_width = 0.4, unit_height = 0.175,
                 half_courses = "odd", base_height = 0.2, base_margin = 0.6, material = "stone", fixed = "base" }
m:results { file = "out/dry_wall.h5", frames = 0.05 }
m:consolidate { duration = 2, rest = { speed = 1e-6 } }

m:tilt { rate = 4*deg, by = p.fast }
m:run { name = "tilting fast", duration = p.fast/(4*deg) }

local slowly = false
m:every(0.002, function() if slowly and m.speed > 0.02 then m:stop() end end) -- a stone moves off
m:tilt { rate = 0.5*deg, by = 12*deg }
slowly = true
local slow = m:run { name = "tilting slowly", duration = 24 }
slowly = false
local angle = p.fast + 0.5*deg*(slow.ended - slow.begun)
print(("collapses at %.1f degrees, tangent %.3f"):format(angle/deg, math.tan(angle)))
m:run { name = "falling", duration = 0.8 }
