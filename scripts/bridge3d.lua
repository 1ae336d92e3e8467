-- The seven-span bridge in space under El Centro 1940 with three components; the left side of the valley has firmer
-- ground. Each span has two lines of girders, each bent two columns on soil springs. Bearings resist longitudinal,
-- lateral and vertical motion up to a limit. Seats end longitudinally and laterally.
-- Results and reasons for the data: docs/gallery/bridge3d.md. scripts/bridge.lua is the same bridge in the plane.
local trilith = require "trilith"
local ft, inch, kip, g, s, deg = trilith.units "ft inch kip g s deg"
local p = trilith.params {
  pga = { 0.8, unit = "g", "peak acceleration along the bridge; the other components have the same factor" },
  across = { 1, "share of the component across the bridge" },
  vertical = { 1, "share of the vertical component" },
  sign = { 1, "sign of the component along the bridge: 1 or -1" },
  skew = { 0, unit = "deg", "skew of bents, abutments and joints, anticlockwise from above" },
  gap = { 4, unit = "inch", "width of the joints" },
  mu = { 0.1, "friction coefficient of the seats" },
  limit = { 10, unit = "inch", "horizontal displacement at which a fixed bearing fails" },
  side = { 15, unit = "inch", "length of the seat next to the outer girder" },
  overlap = { 0.001, unit = "inch", "overlap of a girder and its seat under an 80 ft span: contact stiffness" },
  zeta = { 0.05, "damping ratio of contact" },
  soil = { 60e6, unit = "Pa", "shear modulus of the ground" },
  duration = { 30, unit = "s", "duration of the shaking" },
  safety = { 0.8, "share of the longest stable step" },
  out = { "out/bridge3d.h5", "results" },
}
local m = trilith.model { name = "seven-span bridge in space", dim = 3 }
m:material { name = "concrete", density = 2400 }

-- Contact: damping ratio zeta for the mass that a girder's seat carries.
local dead_load, seat, girder = 5.6*kip, 15*inch, 2*ft -- of a foot of deck; length of a seat, width of a girder
local reaction = 20*dead_load
local kn = reaction/(seat*girder*p.overlap)
local beta = 2*p.zeta/math.sqrt(kn*seat*girder*g/reaction)
local function coulomb(mu) return trilith.frictional { kn = kn, ks = kn/2, mu = mu, beta = beta } end
m:contact { between = { "*", "*" }, law = "none" } -- piers, abutments and the ground move together
m:contact { between = { "spans", "*" }, law = coulomb(0.6), name = "concrete on concrete" }
m:contact { between = { "spans", "supports" }, law = coulomb(p.mu), name = "expansion bearing" }

-- The valley: a shelf on the left, steps down to each bent on the right; { from x, level }, in ft.
local function ground(name, steps, to)
  local pieces = {}
  for i, step in ipairs(steps) do
    local x0, x1 = step[1]*ft, (steps[i + 1] or { to })[1]*ft
    local hull = {}
    for _, x in ipairs { x0, x1 } do
      for _, y in ipairs { -60*ft, 60*ft } do
        for _, z in ipairs { -90*ft, step[2]*ft } do hull[#hull + 1] = { x, y, z } end
      end
    end
    pieces[i] = { hull = hull }
  end
  m:body { name = name, material = "concrete", pieces = pieces, support = "fixed" }
end
ground("left ground", { { -60, -20 } }, 14.9)
ground("right ground", { { 17, -40 }, { 60, -50 }, { 130, -60 }, { 290, -50 }, { 360, -40 }, { 404, -20 } }, 490)

-- The bridge from left to right, in ft: spans by length and depth, supports by kind, height of bents and footings. A
-- fixed bearing is 2 in high, so its seat is lower: when it fails, the deck drops onto it. For a span of 80 ft it has
-- 60 kip/in lengthwise and sideways and 3000 kip/in vertically, shared by two girders; for others by weight.
local rows = { { 30, 2.5 }, { 60, 4 }, { 80, 5 }, { 80, 5 }, { 80, 5 }, { 60, 4 }, { 30, 2.5 } }
local stands = { { "fixed" }, { "expansion", 40, 20 }, { "fixed", 50, 24 }, { "expansion", 60, 24 },
                 { "fixed", 60, 24 }, { "expansion", 50, 24 }, { "fixed", 40, 20 }, { "expansion" } }
m:bearing_type { name = "expansion" }
local function type_for(length)
  local name, share = ("fixed %d ft"):format(length), length/80/2
  local function spring(k) return trilith.linear { stiffness = share*k*kip/inch } end
  return m:bearing_type { name = name, height = 2*inch, horizontal = spring(60), axial = spring(3000),
                          limit = { horizontal = p.limit }, becomes = "expansion bearing" }
end
local types, spans, supports = {}, {}, {}
for i, row in ipairs(rows) do
  local length, depth = row[1], row[2]
  types[length] = types[length] or type_for(length)
  local function at(stand) return stand[1] == "fixed" and types[length] or "expansion" end
  spans[i] = { length = length*ft + p.gap, depth = depth*ft, left = at(stands[i]), right = at(stands[i + 1]),
               diaphragm = { thickness = 1*ft, depth = (depth - 1.5)*ft } }
end
local half, line = 16*ft, 8*ft -- of the deck; of a girder line from the middle
for i, stand in ipairs(stands) do
  local height, width, outer = stand[2], stand[3], i == 1 and rows[1] or rows[#rows]
  supports[i] = height and { height = height*ft, footing_width = width*ft, weight = (9.6*(height - 4) + 460)*kip }
    or { height = 20*ft, back_wall_height = outer[2]*ft }
  supports[i].ground = i == 1 and "left ground" or "right ground"
end
-- Foundations are rigid discs of the footing's area on an elastic half space, with 10 % of critical for a swaying bent.
local foundation = { soil = p.soil, beta = 2*0.1/13 }
local bridge = m:bridge {
  gap = p.gap, seat = seat, breadth = 2*half, skew = p.skew, material = "concrete", spans = spans, supports = supports,
  girders = { count = 2, spacing = 2*line, breadth = girder },
  abutment = { width = 12*ft, foundation = foundation, groups = "supports" },
  pier = { breadth = 2*(line + 0.5*girder + p.side), cap_thickness = 4*ft, footing_thickness = 4*ft,
           footing_breadth = 2*half, columns = 2, column_spacing = 2*line, column_breadth = 4*ft,
           foundation = foundation, groups = "supports" },
  span = { slab = 1*ft, weight_per_length = dead_load/ft } }

m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
for _, what in ipairs { "displacement_along", "displacement_across" } do
  m:history { name = "S3.left.g2 " .. what, bearing = bridge.bearings.S3.left.g2, what = what }
end
m:consolidate { rest = { ratio = 1e-4 }, duration = 30*s }

local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
local along = ns:scale { factor = p.sign }
local across = trilith.motion "elcentro_1940_rest_ew.csv":scale_as(ns):scale { factor = p.across }
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(ns):scale { factor = p.vertical }
local function firm(motion) return motion:time_scale(0.8):delay(0.204*s) end

local begun = m.time
local function tell(e) print(("%6.2f s: %s"):format(e.time - begun, e.text)) end
m:on("bearing.failed", tell)
m:on("seat.lost", function(e) print(("%6.2f s: seat %s is lost"):format(e.time - begun, e.seat.name)) end)
local down = {} -- decks that have reached the ground
m:on("impact", function(e)
  for i, b in ipairs(e.bodies) do
    if b.name:match "^S%d$" and e.bodies[3 - i].name:match "ground" and not down[b.name] then
      down[b.name] = true
      tell(e)
    end
  end
end)
local report = m:shake {
  motions = { { body = "right ground", x = along, y = across, z = up },
              { body = "left ground", x = firm(along), y = firm(across), z = firm(up) } },
  duration = p.duration, safety = p.safety }

local base = m:body "right ground"
for _, b in ipairs(bridge.spans) do
  print(("%s has moved by %6.2f m along, %6.2f m across, %6.2f m up, and rotated by %4.1f deg about z"):format(b.name,
    b.ux - base.ux, b.uy - base.uy, b.uz - base.uz, b.rotation_z/deg))
end
print(("%s after %.2f s; the error of the energy balance is %.2g %% of the input"):format(report.ending,
  report.ended - report.begun, 100*math.abs(m.residual)/math.max(1, -m.energy.gravity + m.energy.support)))
