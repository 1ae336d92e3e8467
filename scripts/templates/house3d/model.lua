-- A masonry house in space: four walls, a door, a window and a floor slab, shaken along both horizontal axes.
-- Set a parameter on the command line: trilith run model.lua pga=0.6 duration=3s
local trilith = require "trilith"

-- 1. Parameters.
local p = trilith.params {
  pga = { 0.5, unit = "g", "peak acceleration of the ground" },
  tension = { 1e4, unit = "Pa", "tensile strength of the mortar" },
  duration = { 2, unit = "s", "duration of the shaking" } }

-- 2. Materials and contact, in space: x and y are horizontal, z is upwards.
local m = trilith.model { name = "house", dim = 3 }
m:material { name = "stone", density = 2200 }
m:contact { between = { "*", "*" }, law = trilith.bonded {
  kn = 1e9, ks = 4e8,                               -- stiffness of a joint, stress per displacement [Pa/m]
  mu = 0.6, beta = 5e-5,                            -- friction after the bond is lost; damping
  tension = p.tension, cohesion = 1.5*p.tension } } -- strength of the bond [Pa]

-- 3. Geometry: each wall is a line in plan, at the middle of its thickness. Lengths are in whole units.
local house = m:building { name = "house", material = "stone", fixed = "base", unit_length = 0.6, unit_height = 0.3,
  walls = {
    { name = "south", from = { 0, 0 }, to = { 3.6, 0 },
      openings = { { storey = 1, from = 1.2, width = 0.9, height = 1.8 } } },
    { name = "north", from = { 0, 3 }, to = { 3.6, 3 },
      openings = { { storey = 1, from = 1.2, sill = 0.9, width = 0.9, height = 0.9 } } },
    { name = "west", from = { 0, 0 }, to = { 0, 3 } },
    { name = "east", from = { 3.6, 0 }, to = { 3.6, 3 } } },
  storeys = { { courses = 8, slab_height = 0.3 } }, base_height = 0.3, base_margin = 1 }

-- 4. Results.
m:results { file = "out/house3d.h5", frames = 0.02, histories = 0.01, energy = 0.02 }
for _, what in ipairs { "drift_x", "drift_y" } do m:history { name = what, storey = 1, what = what } end

-- 5. Weight first; the mortar is stress-free after it. Then the earthquake along x, y and z.
m:consolidate { rest = { ratio = 1e-4 }, fresh = true }
local broken = 0
m:on("bond.broken", function() broken = broken + 1 end)
local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
local ew = trilith.motion "elcentro_1940_rest_ew.csv":scale_as(ns)
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(ns)
m:shake { body = "house.base", x = ew, y = ns, z = up, duration = p.duration }

-- 6. Figures.
local storey, damage = m.storeys[1], house:damage_by_storey { apart = 1e-3, out_of_place = 5e-3 }[1]
print(("%d bodies; %d bonds broke; %d of %d joints apart by 1 mm"):format(#house, broken, damage.joints_apart,
  damage.joints))
print(("drift at the end: %.1f mm along x, %.1f mm along y"):format(1e3*storey.drift_x, 1e3*storey.drift_y))
return { broken = broken, collapsed = storey.drift > 0.5 }
