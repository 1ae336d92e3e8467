-- A wall of dry stones with a window is pushed sideways until it has lost half of its resistance.
-- Read the capacity, the failure mechanism, and the bilinear idealisation of the capacity curve.
local trilith = require "trilith"

local m = trilith.model { name = "dry wall", thickness = 0.5 } -- thickness of the wall [m]
m:material { name = "stone", density = 2200 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 2e9, ks = 8e8, mu = 0.6, beta = 5e-5 } }
local wall = m:wall { name = "wall", length = 4, unit_length = 0.8, unit_height = 0.4, courses = 6, bond = "running",
  openings = { { storey = 1, x = 1.6, sill = 0.8, width = 0.8, height = 0.8 } }, lintel_bearing = 0.4,
  base_height = 0.4, base_margin = 1, slab_height = 0.3, material = "stone", fixed = "base" }
local stones = wall - "wall.base"

m:results { file = "out/dry_wall_pushover.h5", frames = 0.05, histories = 0.01 }
m:history { name = "force", what = "push_force" }
m:history { name = "displacement", what = "push_displacement" }

m:consolidate {}
local push = m:pushover { body = stones, pattern = "mass", direction = "x", rate = 0.01,
  displacement = 0.3, drop = 0.5 }
local b = trilith.bilinear { curve = push, code = "ntc2018", mass = stones.mass }

print(("weight %.1f kN, peak %.1f kN at %.0f mm, ended by %s at %.0f mm"):format(stones.mass*9.80665/1e3,
  push.peak_force/1e3, 1e3*push.displacement_at_peak, push.limit, 1e3*push.displacement))
print(("bilinear: %.1f kN, ultimate displacement %.0f mm"):format(b.yield_force/1e3, 1e3*b.ultimate_displacement))
return { share = push.peak_force/(stones.mass*9.80665), ultimate = b.ultimate_displacement }
