-- A stone arch of voussoirs on two abutments carries a load at its quarter point that grows until the arch fails.
-- Set a parameter on the command line: trilith run model.lua thickness=0.3m
local trilith = require "trilith"

-- 1. Parameters.
local p = trilith.params {
  span = { 6, unit = "m", "clear span" },
  rise = { 2, unit = "m", "clear rise" },
  thickness = { 0.5, unit = "m", "thickness of the ring" },
  voussoirs = { 24, "number of voussoirs" } }

-- 2. Materials and contact: dry joints with friction. `thickness` of the model is the width of the arch [m].
local m = trilith.model { name = "arch", thickness = 1 }
m:material { name = "stone", density = 2200 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 4e10, ks = 2e10, mu = 0.7, beta = 2e-5 } }

-- 3. Geometry.
m:arch { name = "arch", voussoirs = p.voussoirs, span = p.span, rise = p.rise, thickness = p.thickness,
         material = "stone", fixed = "abutments" }
local ring = m:bodies { group = "voussoirs" }
local loaded = ring[p.voussoirs//4]

-- 4. Results.
m:results { file = "out/arch.h5", frames = 0.05, histories = 0.01, energy = 0.05 }
m:history { name = "load", what = "push_force" }
m:history { name = "displacement", what = "push_displacement" }

-- 5. Weight, then a push downwards at the quarter point until the force has fallen to half its peak.
m:consolidate { duration = 5 }
local push = m:pushover { body = loaded, direction = "-y", displacement = 0.05, drop = 0.5 }

-- 6. Figures.
print(("the arch weighs %.1f kN and carries %.1f kN at the quarter point"):format(
  1e-3*ring.mass*9.80665, 1e-3*push.peak_force))
print(("the push ended by %s at %.1f mm"):format(push.limit, 1e3*push.displacement))
return { peak = push.peak_force }
