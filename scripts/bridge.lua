-- Seven simple spans on six piers and two stub abutments under El Centro 1940, from dead load to final rest.
--
-- Physics: decks, piers, abutments and two ground blocks are rigid. A fixed bearing is a spring that fails at 10 in
-- of shear and becomes an expansion bearing: the deck slides on its seat of 15 in and falls where the seat ends. The
-- right ground follows the record, the left one the record with its time axis times 0.8, so that the two sides of
-- the valley move apart and together.
--
-- Expected at 0.8 g: spans 1, 3, 4 and 5 fall, the others stand. The first bearing fails 3.7 s after the start of
-- the record itself, and all bodies rest after 80.3 s. The energy residual stays below 1 % of the input (0.017 %).
-- At 0.6 g no bearing fails.
--
-- Source: R. Barbosa, "Discontinuous structural analysis", first example. It leaves data open;
-- docs/gallery/bridge.md lists the chosen values and the effect of other choices.
local trilith = require "trilith"
local ft, inch, kip, g, s = trilith.units "ft inch kip g s"
local p = trilith.params {
  pga = { 0.8, unit = "g", "peak horizontal acceleration" },
  sign = { 1, "sign of the record: 1 or -1" },
  gap = { 4, unit = "inch", "width of the joints" },
  mu = { 0.1, "friction coefficient of the seats" },
  zeta = { 0.15, "damping ratio of contact" },
  stiffness = { 1, "factor of the contact stiffness" },
  onset = { 0, unit = "s", "more time at rest before the record" },
  slider = { "contact", choices = { "contact", "constant", "speed" },
    "expansion bearings: contact with friction mu; or sliding bearings with friction mu, or with friction over speed" },
  base = { "bonded", choices = { "rocking", "bonded" }, "contact of the footings with the ground" },
  out = { "out/bridge.h5", "results" },
}
local width, seat = 32*ft, 15*inch -- of the deck; length of a seat
local dead_load = 5.6*kip          -- of a foot of deck
local reaction = 40*dead_load      -- of an 80 ft span on one seat
local still = 1e-5*inch/s          -- slower than this is at rest
local m = trilith.model { name = "seven-span bridge", thickness = width, still_speed = still }
local concrete = m:material { name = "concrete", density = 2400 }

-- Contact: 0.02 in of overlap under an 80 ft span; damping zeta for half such a span on its seat.
local kn = p.stiffness*reaction / (seat*width*0.02*inch)
local beta = 2*p.zeta / math.sqrt(kn*seat*width*g/reaction)
local function coulomb(mu)
  return trilith.frictional { kn = kn, ks = kn/2, mu = mu, beta = beta }
end
local bonded_to_ground = trilith.bonded {
  kn = kn, ks = kn/2, mu = 0.6, beta = beta, cohesion = 1e9, tension = 1e9 }
local bonded_bodies = p.base == "bonded" and "*" or "abutments"
m:contact { between = { "*", "*" }, law = coulomb(p.mu), name = "expansion bearing" }
m:contact { between = { "*", "ground" }, law = coulomb(0.6), name = "concrete on concrete" }
m:contact { between = { bonded_bodies, "ground" }, law = bonded_to_ground, name = "bond" }

-- The valley: level steps of ground, from x on at a level below the decks. The two blocks meet
-- between abutment 0 and pier 1.
local function step(x, level) return { from = x*ft, level = level*ft } end
m:ground {
  name = "left ground", base_level = -100*ft, material = concrete, support = "fixed",
  steps = { step(-150, -20) }, to = 14.9*ft }
m:ground {
  name = "right ground", base_level = -100*ft, material = concrete, support = "fixed",
  steps = { step(17, -40), step(60, -50), step(130, -60), step(290, -50), step(360, -40),
            step(404, -20) }, to = 570*ft }

-- Bearings: for a span of 80 ft 60 kip/in in shear and 3000 kip/in vertically, for others by their
-- weight. A fixed one is 2 in high: when it fails, the deck drops onto its seat.
local function spring(k) return trilith.linear { stiffness = k*kip/inch } end
local function fixed(L)
  return m:bearing_type {
    name = "fixed " .. L, height = 2*inch, along = spring(60*L/80), axial = spring(3000*L/80),
    limit = { along = 10*inch }, becomes = "expansion bearing" }
end
local fixed_30, fixed_60, fixed_80 = fixed(30), fixed(60), fixed(80)

-- Expansion bearings are contact. As sliding bearings they have its stiffness, and its damping across the seat, and
-- carry the deck until it has slid along its whole seat. Friction over speed: unfilled PTFE at 6.9 MPa (Constantinou,
-- Mokha and Reinhorn 1990).
local function sliding_bearing(slow, fast, rate)
  local k = kn*seat*width
  return { name = "expansion", along = trilith.friction { mu = slow, mu_fast = fast, rate = rate,
    stiffness = k/2 }, axial = trilith.gap { stiffness = k, opening = 0, side = -1, damping = beta*k },
    limit = { along = seat }, becomes = "expansion bearing" }
end
local expansion = m:bearing_type(p.slider == "contact" and { name = "expansion" }
  or p.slider == "constant" and sliding_bearing(p.mu, p.mu, 0) or sliding_bearing(0.027, 0.119, 23.6))

-- The bridge, from left to right, in ft. Heights are from the ground to the underside of the decks;
-- a pier weighs 9.6 kip a foot of its stem and 460 kip for its footing, which is 4 ft thick.
local function pier(name, height, footing_width)
  return { name = name, height = height*ft, footing_width = footing_width*ft,
           weight = (9.6*(height - 4) + 460)*kip }
end
local function span(name, length, depth, left, right)
  return { name = name, length = length*ft, depth = depth*ft, weight = length*dead_load,
           left = left, right = right }
end
m:bridge {
  soffit_level = 0, gap = p.gap, seat = seat, material = concrete,
  abutment = { height = 20*ft, width = 12*ft, back_wall_height = 2.5*ft },
  pier = { footing_thickness = 4*ft },
  supports = {
    { name = "A0" },
    --    name  height  footing's width
    pier("P1", 40, 20),
    pier("P2", 50, 24),
    pier("P3", 60, 24),
    pier("P4", 60, 24),
    pier("P5", 50, 24),
    pier("P6", 40, 20),
    { name = "A7" },
  },
  spans = {
    --   name  length  depth  bearings left and right
    span("S1", 30, 2.5, fixed_30, expansion),
    span("S2", 60, 4.0, expansion, fixed_60),
    span("S3", 80, 5.0, fixed_80, expansion),
    span("S4", 80, 5.0, expansion, fixed_80),
    span("S5", 80, 5.0, fixed_80, expansion),
    span("S6", 60, 4.0, expansion, fixed_60),
    span("S7", 30, 2.5, fixed_30, expansion),
  },
}

-- Results; dead load, until all is at rest; then the two records, which start together.
m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
m:consolidate { duration = 60*s, rest = { ratio = 1e-5, speed = still } }

local along = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
along = along:scale { factor = p.sign }
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(along)
local function late(motion) return p.onset > 0 and motion:delay(p.onset) or motion end
local function firm(motion) return motion:time_scale(0.8):delay(0.204*s) end
local begun = m.time + 1.02*s + p.onset -- the records rest for 1.02 s before they begin
local chain = m:keep { fails = {}, leaves = {} } -- bearing or seat: time
m:on("bearing.failed", function(e) chain.fails[e.bearing.name] = e.time - begun end)
m:on("seat.lost", function(e)
  local name = e.text:match "%((.-)%)" or e.seat.name
  chain.leaves[name] = chain.leaves[name] or e.time - begun
end)
m:shake {
  motions = { { body = "right ground", x = late(along), y = late(up) },
              { body = "left ground", x = late(firm(along)), y = late(firm(up)) } },
  duration = 150*s, rest = { speed = still, hold = 1*s, from = 55.9*s } }

-- Figures of a study: times of the chain, from the start of the record.
local figures = {}
for word, times in pairs(chain) do
  local count = 0
  for name, time in pairs(times) do
    figures[name .. " " .. word], count = { time, unit = "s" }, count + 1
  end
  figures["ends that " .. (word == "fails" and "fail" or "leave")] = count
end
return figures
