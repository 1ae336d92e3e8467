-- The corner of a house in space: two interlocking walls of mortared stones, one with a window, shaken along the
-- diagonal of the plan. Read how many bonds break, and how many joints are apart.
local trilith = require "trilith"
local g = trilith.units "g"

local m = trilith.model { name = "house corner", dim = 3 }
m:material { name = "stone", density = 2200 }
m:contact { between = { "*", "*" }, law = trilith.bonded { kn = 1e9, ks = 4e8, mu = 0.6, beta = 5e-5,
  tension = 1e4, cohesion = 1.5e4 } }
local house = m:building { name = "house", material = "stone", fixed = "base", unit_length = 0.8, unit_height = 0.4,
  base_height = 0.4, base_margin = 1, storeys = { { courses = 6 } }, walls = {
    { name = "front", from = { 0, 0 }, to = { 3.2, 0 },
      openings = { { storey = 1, from = 1.2, sill = 0.8, width = 0.8, height = 0.8 } } },
    { name = "side", from = { 0, 0 }, to = { 0, 2.4 } } } }

m:results { file = "out/house_corner.h5", frames = 0.02, histories = 0.01 }
m:consolidate { rest = { ratio = 1e-4 }, fresh = true }
local broken = 0
m:on("bond.broken", function() broken = broken + 1 end)
local record = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = 0.5*g }
m:shake { body = "house.base", x = record, y = record, duration = 2.6 }

local damage = house:damage_by_storey { apart = 1e-3 }[1]
print(("%d stones, %d bonds broke, %d of %d joints apart by 1 mm"):format(#house, broken, damage.joints_apart,
  damage.joints))
return { broken = broken, joints = damage.joints }
