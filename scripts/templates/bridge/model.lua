-- Three spans on two piers and two abutments shake along the bridge. Each span has a dowel at its left end.
-- Set a parameter on the command line: trilith run model.lua pga=0.8 seat=0.3m
local trilith = require "trilith"

-- 1. Parameters.
local p = trilith.params {
  pga = { 0.5, unit = "g", "peak acceleration of the ground" },
  seat = { 0.5, unit = "m", "length of the seats" },
  dowel = { 0.01, unit = "m", "displacement at which a dowel fails" },
  duration = { 10, unit = "s", "duration of the shaking" } }

-- 2. Materials and contact. `thickness` is the width of the bridge across the plane [m].
local m = trilith.model { name = "three spans", thickness = 10 }
local concrete = m:material { name = "concrete", density = 2400 }
local function coulomb(mu) return trilith.frictional { kn = 5e9, ks = 2.5e9, mu = mu, beta = 2e-3 } end
m:contact { between = { "*", "*" }, law = coulomb(0.1), name = "sliding" }
m:contact { between = { "*", "ground" }, law = coulomb(0.7), name = "footings" }

-- 3. Geometry: two tables, one of supports and one of spans (docs/guide/bridges.md).
m:ground { name = "ground", surface = { { -20, -8 }, { 95, -8 } }, base_level = -10, material = concrete,
           support = "fixed" }
local dowel = m:bearing_type { name = "dowel", along = trilith.linear { stiffness = 2e8 },
                               limit = { along = p.dowel }, becomes = "sliding" }
local slider = m:bearing_type { name = "slider" }
local bridge = m:bridge {
  gap = 0.1, seat = p.seat, material = concrete,
  abutment = { height = 8, width = 4, back_wall_height = 1.5 },
  pier = { height = 8, footing_width = 5, footing_thickness = 1 },
  span = { length = 25, depth = 1.5, weight_per_length = 1.5e5, left = dowel, right = slider },
  supports = { { name = "A0" }, { name = "P1" }, { name = "P2" }, { name = "A3" } },
  spans = { { name = "S1" }, { name = "S2" }, { name = "S3" } } }

-- 4. Results.
m:results { file = "out/bridge.h5", frames = 0.05, histories = 0.01, energy = 0.05 }
for _, span in ipairs(bridge.spans) do
  m:history { name = span.name .. ".ux", body = span, what = "ux" }
end
local lost = 0
m:on("seat.lost", function() lost = lost + 1 end)

-- 5. Weight, then the earthquake.
m:consolidate { rest = { ratio = 1e-4 } }
local quake = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
m:shake { body = "ground", x = quake, duration = p.duration }

-- 6. Figures.
local shortest = math.huge
for _, span in ipairs(bridge.spans) do
  local left = span.seats.right.length
  shortest = math.min(shortest, left)
  print(("%s: its dowel is %s; %.2f m of the right seat are left"):format(span.name, span.bearings.left.status, left))
end
print(("%d seats were lost"):format(lost))
return { shortest_seat = shortest, collapsed = lost > 0 }
