-- A masonry wall of two storeys with a door and a window stands on a base that shakes.
-- Change a number in `params`, or set it on the command line: trilith run model.lua pga=0.6
local trilith = require "trilith"

-- 1. Parameters: each can be set on the command line and varied in a study.
local p = trilith.params {
  pga = { 0.6, unit = "g", "peak acceleration of the base" },
  tension = { 5e4, unit = "Pa", "tensile strength of the mortar" },
  duration = { 5, unit = "s", "duration of the shaking" } }

-- 2. Materials and contact. `thickness` is the length of the wall across the plane [m].
local m = trilith.model { name = "wall", thickness = 0.25 }
m:material { name = "brick", density = 1800 }
m:contact { between = { "*", "*" }, law = trilith.bonded {
  kn = 4e9, ks = 1.6e9,                             -- stiffness of a joint, stress per displacement [Pa/m]
  mu = 0.65, beta = 4e-5,                           -- friction after the bond is lost; damping
  tension = p.tension, cohesion = 1.5*p.tension } } -- strength of the bond [Pa]

-- 3. Geometry. Lengths are in whole units: 0.5 m x 0.25 m, ten courses a storey.
local wall = m:wall { name = "wall", length = 4, unit_length = 0.5, unit_height = 0.25, bond = "running",
  storeys = 2, storey_height = 2.5, slab_height = 0.25, base_height = 0.5, base_margin = 2,
  openings = { { storey = 1, x = 0.5, width = 1, height = 2 },
               { storey = 2, x = 2, sill = 0.75, width = 1, height = 1.25 } },
  lintel_bearing = 0.25, material = "brick", fixed = "base", body = "rigid",
  by_group = { slabs = { density = 10000 } } } -- a floor of 6 m width rests on each slab

-- 4. Results: pictures, histories and energy go to one file.
m:results { file = "out/wall.h5", frames = 0.02, histories = 0.01, energy = 0.02 }
for storey = 1, 2 do m:history { name = "drift " .. storey, storey = storey, what = "drift" } end
m:history { name = "base shear", what = "base_shear" }

-- 5. Weight first; the mortar is stress-free after it. Then the earthquake.
m:consolidate { duration = 5, fresh = true }
local broken = 0
m:on("bond.broken", function() broken = broken + 1 end)
local ground = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
m:shake { body = "wall.base", x = ground, duration = p.duration }

-- 6. Figures. The returned table becomes the row of this case in a study.
local damage = wall:damage_by_storey { apart = 1e-3, out_of_place = 5e-3 }
for storey, row in ipairs(damage) do
  print(("storey %d: %d of %d joints apart by 1 mm, %d of %d units out of place by 5 mm"):format(storey,
    row.joints_apart, row.joints, row.units_out_of_place, row.units))
end
local top = m:body "wall.s2.slab"
print(("%d bonds broken; the top slab has moved by %.1f mm"):format(broken, 1e3*math.abs(top.ux)))
return { broken = broken, collapsed = top.uy < -0.5 }
