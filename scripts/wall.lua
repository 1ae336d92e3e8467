-- The masonry wall of R. Barbosa, "Discontinuous structural analysis": three storeys of 8 ft, 16 ft wide, openings
-- without symmetry, rigid slabs and base, mortar of very low strength; El Centro NS scaled to 1.0 g at its base.
--
-- The paper finds: most damage in the top storey, where the weight above is least; failure early, in the strong phase.
-- What it does not give is chosen: units 16 x 8 in, 8 in thick, 120 lb/ft3; eleven courses and a slab a storey; openings
-- of 4 ft with lintels of one course bearing 8 in; slabs of 1.2 kip/ft; joints of 1e5 psi/in.
local trilith = require "trilith"
local ft, inch, kip, g, s, psi, pcf = trilith.units "ft inch kip g s psi pcf"
local p = trilith.params {
  tension = { 400, unit = "psf", "tensile strength of the mortar" },
  cohesion = { 0.51, "shear strength at no pressure, as a share of the tensile strength" },
  friction = { 35, unit = "deg", "friction angle" }, kn = { 1e5, unit = "psi", "stiffness of a joint, per inch" },
  pga = { 1.0, unit = "g", "peak horizontal acceleration" }, sign = { 1, "1: as the agency gives it, or -1" },
  jitter = { 0, unit = "m", "by which head joints are moved at random" }, seed = { 1, "of the jitter" },
  stand = { 0, unit = "s", "how long it stands by itself before the shaking" },
  duration = { 30, unit = "s", "of the shaking" }, out = { "out/wall.h5", "results" } }

local m = trilith.model { name = "masonry wall", thickness = 8*inch }
local brick = m:material { name = "brick", unit_weight = 120*pcf }
local concrete = m:material { name = "concrete", unit_weight = 150*pcf }
local kn, mass = p.kn/inch, 120*pcf*16*8*8*inch^3/g
local beta = 2*0.1/math.sqrt(kn*16*8*inch^2/mass) -- 10 % of critical for one unit on its bed joint
m:contact { between = { "*", "*" }, name = "mortar", law = trilith.bonded {
  kn = kn, ks = 0.4*kn, mu = math.tan(p.friction), beta = beta, tension = p.tension, cohesion = p.cohesion*p.tension } }

local window = { storey = { 2, 3 }, sill = 2*ft + 8*inch, width = 4*ft, height = 4*ft }
local function at(x, opening)
  local copy = { x = x }
  for key, value in pairs(opening) do copy[key] = value end
  return copy
end
local wall = m:wall {
  name = "wall", length = 16*ft, unit_length = 16*inch, unit_height = 8*inch, bond = "running",
  storeys = 3, storey_height = 8*ft, slab_height = 8*inch, base_height = 2*ft, base_margin = 24*ft,
  openings = { { storey = 1, x = 2*ft + 8*inch, width = 4*ft, height = 6*ft + 8*inch },
               { storey = 1, x = 9*ft + 4*inch, sill = 2*ft + 8*inch, width = 4*ft, height = 4*ft },
               at(2*ft + 8*inch, window), at(10*ft + 8*inch, window) },
  lintel_bearing = 8*inch, jitter = p.jitter, seed = p.seed, material = brick, fixed = "base",
  by_group = { slabs = { weight = 1.2*kip/ft*16*ft }, base = { material = concrete } } }
print(("%d bodies, %.1f kip"):format(#wall, (wall - "wall.base").mass*g/kip))

m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
for storey = 1, 3 do
  m:history { name = "slab " .. storey, body = "wall.s" .. storey .. ".slab", what = "ux" }
end
m:consolidate { duration = 20*s, ratio = 1e-5, speed = 1e-7 }
if p.stand > 0 then m:run { name = "standing", duration = p.stand } end
local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }:scale { factor = p.sign }
m:shake { body = "wall.base", x = ns, duration = p.duration }
