-- The seven-span bridge in space: two lines of girders in each span, bents of two columns on springs of the ground,
-- bearings that hold lengthwise, sideways and vertically up to a limit, seats that end lengthwise and sideways; in
-- El Centro 1940 with its three components, the left side of the valley on firmer ground.
-- docs/gallery/bridge3d.md has what is found here, and why the numbers are as they are; scripts/bridge.lua is the
-- same bridge in the plane.
local trilith = require "trilith"
local ft, inch, kip, g, s, deg = trilith.units "ft inch kip g s deg"
local p = trilith.params {
  pga = { 0.8, unit = "g", "peak acceleration along the bridge; the other components have the same factor" },
  across = { 1, "share of the component across the bridge" },
  vertical = { 1, "share of the vertical component" },
  sign = { 1, "1: the motion along as the agency gives it, or -1" },
  skew = { 0, unit = "deg", "of bents, abutments and joints: to the right of the bridge they lie further on" },
  gap = { 4, unit = "inch", "joints" },
  mu = { 0.1, "friction of seats" },
  limit = { 10, unit = "inch", "horizontal displacement that ends a fixed bearing" },
  side = { 15, unit = "inch", "seat beside the outer girder" },
  overlap = { 0.005, unit = "inch", "of a girder and its seat under an 80 ft span; makes the stiffness of contact" },
  zeta = { 0.05, "damping of contact" },
  soil = { 60e6, unit = "Pa", "shear modulus of the ground" },
  duration = { 30, unit = "s", "of the shaking" },
  safety = { 0.8, "share of the longest stable step" },
  out = { "out/bridge3d.h5", "results" },
}
local m = trilith.model { name = "seven-span bridge in space", dim = 3 }
m:material { name = "concrete", density = 2400 }

-- Contact: damping zeta for what weighs on a girder's seat.
local dead_load, seat, girder = 5.6*kip, 15*inch, 2*ft -- of a foot of deck; length of a seat, width of a girder
local reaction = 20*dead_load
local kn = reaction/(seat*girder*p.overlap)
local beta = 2*p.zeta/math.sqrt(kn*seat*girder*g/reaction)
local function coulomb(mu) return trilith.frictional { kn = kn, ks = kn/2, mu = mu, beta = beta } end
m:contact { between = { "decks", "*" }, law = coulomb(0.6), name = "concrete on concrete" }
m:contact { between = { "decks", "supports" }, law = coulomb(p.mu), name = "expansion bearing" }

-- Solids of boxes, sheared by the skew: { x0, x1, y0, y1, z0, z1 }, y and z in ft.
local shear = math.tan(p.skew)
local function solid(name, groups, weight, boxes)
  local pieces = {}
  for i, b in ipairs(boxes) do
    local hull = {}
    for _, x in ipairs { b[1], b[2] } do
      for _, y in ipairs { b[3]*ft, b[4]*ft } do
        for _, z in ipairs { b[5]*ft, b[6]*ft } do hull[#hull + 1] = { x - shear*y, y, z } end
      end
    end
    pieces[i] = { hull = hull }
  end
  return m:body { name = name, groups = groups, material = "concrete", weight = weight, pieces = pieces }
end
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

-- Foundations: a rigid disc of the footing's area on an elastic half space, and 10 % of critical for a swaying bent.
local soil_damping = 2*0.1/13
local function found(name, base, x, z, length, width)
  local radius, nu = math.sqrt(length*width/math.pi), 0.35
  local function spring(k) return trilith.linear { stiffness = k, damping = soil_damping*k } end
  local slide, sink = spring(8*p.soil*radius/(2 - nu)), spring(4*p.soil*radius/(1 - nu))
  local rock, twist = spring(8*p.soil*radius^3/(3*(1 - nu))), spring(16/3*p.soil*radius^3)
  m:bearing { name = name .. ".ground", between = { base, name }, at = { x, 0, z }, along = slide, across = slide,
              axial = sink, turning_along = rock, turning_across = rock, turning_axial = twist }
end

-- The bridge from left to right, in ft: spans by length and depth, supports by height (of bents) and kind. A fixed
-- bearing is 2 in high, so its seat is lower: when it fails, the deck drops onto it.
local spans = { { "S1", 30, 2.5 }, { "S2", 60, 4 }, { "S3", 80, 5 }, { "S4", 80, 5 }, { "S5", 80, 5 }, { "S6", 60, 4 },
                { "S7", 30, 2.5 } }
local supports = { { "A0", "fixed" }, { "P1", "expansion", 40, 20 }, { "P2", "fixed", 50, 24 },
                   { "P3", "expansion", 60, 24 }, { "P4", "fixed", 60, 24 }, { "P5", "expansion", 50, 24 },
                   { "P6", "fixed", 40, 20 }, { "A7", "expansion" } }
local line, half = 8, 16                    -- of girders and of the edge of the deck, from the middle [ft]
local cap = line + 0.5*girder/ft + p.side/ft -- half the length of a cap
local function top_of(support) return support[2] == "fixed" and -2*inch/ft or 0 end

-- Where joints are: the middle of the gap over each bent, the back wall's face at abutments.
local joint = { 0 }
for i, span in ipairs(spans) do joint[i + 1] = joint[i] + span[2]*ft + p.gap end
for i, support in ipairs(supports) do
  local name, x, top, base = support[1], joint[i], top_of(support), i == 1 and "left ground" or "right ground"
  local height, width = support[3], support[4]
  if height then -- a bent: footing, two columns, cap
    local bottom, reach = -height, seat + 0.5*p.gap
    solid(name, { "supports" }, (9.6*(height - 4) + 460)*kip, {
      { x - 0.5*width*ft, x + 0.5*width*ft, -half, half, bottom, bottom + 4 },
      { x - reach, x + reach, -line - 2, -line + 2, bottom + 4, top - 4 },
      { x - reach, x + reach, line - 2, line + 2, bottom + 4, top - 4 },
      { x - reach, x + reach, -cap, cap, top - 4, top } })
    found(name, base, x, bottom*ft, width*ft, 2*half*ft)
  else -- an abutment: a seat, and a back wall that the deck may hit
    local way, depth = i == 1 and 1 or -1, spans[i == 1 and 1 or #spans][3]
    local face, front = x - way*0.5*p.gap, x + way*(0.5*p.gap + seat)
    local back = front - way*12*ft
    solid(name, { "supports" }, nil, {
      { math.min(front, back), math.max(front, back), -half, half, -20, top },
      { math.min(face, back), math.max(face, back), -half, half, top, depth } })
    found(name, base, 0.5*(front + back), -20*ft, 12*ft, 2*half*ft)
  end
end

-- Decks: a slab of 1 ft on two girders, and a diaphragm at each end. On supports that are fixed a bearing under each
-- girder, for a span of 80 ft 60 kip/in lengthwise and sideways and 3000 kip/in vertically, for others by weight.
-- Each girder's end has two seats: how far it reaches over the edge lengthwise, and its middle over the edge sideways.
local function set_on(span, side, support, x, way)
  local share, top = span[2]/80/2, top_of(support)*ft
  local function spring(k) return trilith.linear { stiffness = share*k*kip/inch } end
  for _, row in ipairs { { "l", line }, { "r", -line } } do
    local name, y = ("%s.%s.%s"):format(span[1], side, row[1]), row[2]*ft
    local middle, out = x + way*0.5*seat - shear*y, y > 0 and 1 or -1
    if support[2] == "fixed" then
      m:bearing { name = name, between = { support[1], span[1] }, from = { middle, y, top }, to = { middle, y, 0 },
                  horizontal = spring(60), axial = spring(3000), limit = { horizontal = p.limit },
                  becomes = "expansion bearing" }
    end
    m:seat { name = name, body = span[1], support = support[1], at_end = { x - shear*y, y, 0 },
             edge = { x + way*seat - shear*y, y, top }, inward = { -way, -way*shear, 0 } }
    m:seat { name = name .. " sideways", body = span[1], support = support[1], at_end = { middle, y, 0 },
             edge = { middle, out*(support[3] and cap or half)*ft, top }, inward = { 0, -out, 0 } }
  end
end
for i, span in ipairs(spans) do
  local x0, x1, depth, slab = joint[i] + 0.5*p.gap, joint[i + 1] - 0.5*p.gap, span[3], 1
  local under = depth - slab
  solid(span[1], { "decks" }, span[2]*dead_load, {
    { x0, x1, -half, half, under, depth },
    { x0, x1, -line - 1, -line + 1, 0, under }, { x0, x1, line - 1, line + 1, 0, under },
    { x0, x0 + 1*ft, -line + 1, line - 1, 0.5, under }, { x1 - 1*ft, x1, -line + 1, line - 1, 0.5, under } })
  set_on(span, "left", supports[i], x0, 1)
  set_on(span, "right", supports[i + 1], x1, -1)
end

m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
for _, what in ipairs { "displacement_along", "displacement_across" } do
  m:history { name = "S3.left.l " .. what, bearing = "S3.left.l", what = what }
end
m:consolidate { ratio = 1e-4, duration = 30*s }

local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
local along = ns:scale { factor = p.sign }
local across = trilith.motion "elcentro_1940_rest_ew.csv":scale_as(ns):scale { factor = p.across }
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(ns):scale { factor = p.vertical }
local function firm(motion) return motion:time_scale(0.8):delay(0.204*s) end

local begun = m.time
local function tell(e) print(("%6.2f s: %s"):format(e.time - begun, e.text)) end
m:on("bearing.failed", tell)
m:on("seat.lost", function(e) print(("%6.2f s: seat %s is lost"):format(e.time - begun, e.seat.name)) end)
local down = {} -- decks that have come to the ground
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
for _, span in ipairs(spans) do
  local b = m:body(span[1])
  print(("%s has moved by %6.2f m along, %6.2f m across, %6.2f m up, and turned by %4.1f deg about z"):format(span[1],
    b.ux - base.ux, b.uy - base.uy, b.uz - base.uz, b.turn_z/deg))
end
print(("%s after %.2f s; the ledger is out by %.2g %% of what was put in"):format(report.ending,
  report.ended - report.begun, 100*math.abs(m.residual)/math.max(1, -m.energy.gravity + m.energy.support)))
