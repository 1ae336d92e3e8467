-- The masonry wall of R. Barbosa, "Discontinuous structural analysis": three storeys of 8 ft, 16 ft wide, openings
-- without symmetry, rigid slabs and base, mortar of very low strength; El Centro NS scaled to 1.0 g at its base.
-- The paper finds most damage in the top storey, where the weight above is least, and early failure, in the strong
-- phase. Results, also for other strengths, other bodies and copies: docs/gallery/wall.md.
-- Data missing in the paper are chosen. Units: 16 x 8 x 8 in, 120 lb/ft3; eleven courses and a slab per storey.
-- Openings: 4 ft wide, with lintels of one course bearing 8 in. Slabs: 1.2 kip/ft. Joints: 1e5 psi/in.
local trilith = require "trilith"
local ft, inch, kip, g, s, pcf, psi = trilith.units "ft inch kip g s pcf psi"
local p = trilith.params {
  body = { "quad", "model of a unit: quad (one finite element), rigid, or mesh (2 by 2)" },
  tension = { 400, unit = "psf", "tensile strength of the mortar" },
  cohesion = { 0.51, "shear strength at no pressure, as a share of the tensile strength" },
  friction = { 35, unit = "deg", "friction angle" }, kn = { 1e5, unit = "psi", "stiffness of a joint, per inch" },
  pga = { 1.0, unit = "g", "peak horizontal acceleration" }, sign = { 1, "sign of the record: 1 or -1" },
  crack = { 0, unit = "psi", "tensile strength of rigid units that may crack at mid-length; 0: they do not crack" },
  damping = { 1, "factor of the damping" }, onset = { 0, unit = "s", "more time at rest before the record" },
  jitter = { 0, unit = "m", "largest random shift of the head joints" }, seed = { 1, "seed of the jitter" },
  stand = { 0, unit = "s", "time at rest before the shaking" },
  duration = { 30, unit = "s", "duration of the shaking" }, out = { "out/wall.h5", "results file" } }
local m = trilith.model { name = "masonry wall", thickness = 8*inch }
local brick = m:material { name = "brick", unit_weight = 120*pcf, E = 1.5e6*psi, nu = 0.2 }
local concrete = m:material { name = "concrete", unit_weight = 150*pcf }
local kn, mass = p.kn/inch, 120*pcf*16*inch*(8*inch)^2/g
local beta = p.damping*2*0.1/math.sqrt(kn*16*8*inch^2/mass) -- 10 % of critical for one unit on its bed joint
if p.crack > 0 then -- cohesion twice the tension, fracture energy 40 um times the tension, as in the experiments
  m:contact { between = { "*", "*" }, name = "unit", law = trilith.cohesive { kn = 10*kn, ks = 4*kn, mu = 0.7,
    beta = beta/3, tension = p.crack, cohesion = 2*p.crack, energy_tension = 40e-6*p.crack,
    energy_shear = 400e-6*p.crack } }
end
m:contact { between = { "*", "*" }, name = "mortar", law = trilith.bonded {
  kn = kn, ks = 0.4*kn, mu = trilith.math.tan(p.friction), beta = beta,
  tension = p.tension, cohesion = p.cohesion*p.tension } }
local sill, side = 2*ft + 8*inch, 4*ft
local function window(storey, x) return { storey = storey, x = x, sill = sill, width = side, height = side } end
local wall = m:wall {
  name = "wall", length = 16*ft, unit_length = 16*inch, unit_height = 8*inch, bond = "running",
  storeys = 3, storey_height = 8*ft, slab_height = 8*inch, base_height = 2*ft, base_margin = 100*ft,
  openings = { { storey = 1, x = 2*ft + 8*inch, width = side, height = sill + side }, window(1, 9*ft + 4*inch),
               window({ 2, 3 }, 2*ft + 8*inch), window({ 2, 3 }, 10*ft + 8*inch) },
  lintel_bearing = 8*inch, jitter = p.jitter, seed = p.seed, material = brick, fixed = "base",
  body = p.body == "mesh" and { mesh = { 2, 2 } } or p.body,
  cracks = p.crack > 0 and "mid" or nil, crack_law = p.crack > 0 and "unit" or nil,
  by_group = { slabs = { weight = 1.2*kip/ft*16*ft, body = "rigid", cracks = p.crack > 0 and false or nil },
               base = { material = concrete, body = "rigid", cracks = p.crack > 0 and false or nil } } }
print(("%d bodies, %.1f kip"):format(#wall, (wall - "wall.base").mass*g/kip))

m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
for k = 1, 3 do m:history { name = "slab " .. k, body = "wall.s" .. k .. ".slab", what = "ux" } end
m:consolidate { duration = 20*s, rest = { ratio = 1e-5, speed = 1e-7 }, safety = 0.8, fresh = true } -- mortar sets then
local bonds, broken, times = { 0, 0, 0 }, { 0, 0, 0 }, {} -- by storey
local function add(list, a, b)
  local k = tonumber(a.name:match "wall%.s(%d)" or b.name:match "wall%.s(%d)")
  list[k] = list[k] + 1
end
for _, c in ipairs(m:contacts()) do if c.hold == "bonded" then add(bonds, c.a, c.b) end end
m:on("bond.broken", function(e) add(broken, table.unpack(e.bodies)); times[#times + 1] = e.time end)
if p.stand > 0 then
  local top, before = m:body "wall.s3.slab", m:body("wall.s3.slab").ux
  m:run { name = "standing", duration = p.stand }
  print(("stood %g s: top drifted by %.1e m, %d bonds broke"):format(p.stand, math.abs(top.ux - before), #times))
end
local cracked = m:keep { units = 0 }
if p.crack > 0 then m:on("unit.cracked", function() cracked.units = cracked.units + 1 end) end
local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }:scale { factor = p.sign }
if p.onset > 0 then ns = ns:delay(p.onset) end
local report = m:shake { body = "wall.base", x = ns, duration = p.duration, safety = 0.8 }

-- Joints are apart that opened or slipped by more than half an inch; units are out of place that moved against the
-- floor under their storey, or fell, by more than an inch.
local figures, storeys = {}, wall:damage_by_storey { apart = 0.5*inch, out_of_place = 1*inch }
for k = #storeys, 1, -1 do
  local storey = storeys[k]
  figures["broken " .. k], figures["apart " .. k] = broken[k]/math.max(1, bonds[k]), storey.joints_apart/storey.joints
  print(("storey %d: %d of %d bonds broke, %d of %d joints apart by half an inch, %d of %d units out of place"):format(
    k, broken[k], bonds[k], storey.joints_apart, storey.joints, storey.units_out_of_place, storey.units))
end
local function at(i) return times[i] and ("%.2f s"):format(times[i] - report.begun) or "never" end
if times[1] then
  figures["first bond"] = { times[1] - report.begun - p.onset, unit = "s" }
  figures["half of all"] = { times[(#times + 1)//2] - report.begun - p.onset, unit = "s" }
end
print(("first bond broke after %s, half of all by %s"):format(at(1), at((#times + 1)//2)))
if p.crack > 0 then print(("%d units cracked"):format(cracked.units)) end
figures["units cracked"] = cracked.units
figures.collapsed = m:body "wall.s3.slab".uy < -1*ft
return figures
