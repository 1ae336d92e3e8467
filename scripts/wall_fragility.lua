-- A fragility curve: the probability that a small wall collapses, over the peak acceleration of the ground.
--
-- One storey of rigid units in weak mortar, 4 m long and 2.6 m high, with a door and a window under a slab. The motions
-- are the two horizontal components of El Centro 1940, rotated by 20 angles. These copies of one earthquake differ less
-- than 20 earthquakes. The wall settles once, and every case continues from this state. Each motion is scaled up until
-- the slab has fallen, and no further. `trilith study scripts/wall_fragility.lua` takes some minutes;
--   trilith plot out/wall_fragility.h5 --fragility collapsed --over pga -o fragility.svg
--   trilith plot out/wall_fragility.h5 --ida drift --over pga --fragility collapsed -o ida.svg
local trilith = require "trilith"
local p = trilith.params {
  out = { "out/wall_fragility.h5", "table of the study" }, motions = { 20, "number of rotated components" },
  levels = { 8, "number of levels of acceleration" }, step = { 0.2, "difference between levels, in g" },
  duration = { 8, unit = "s", "duration of the shaking" }, tension = { 2e4, unit = "Pa", "strength of the mortar" } }
local motions, levels = {}, {}
for k = 1, p.motions do motions[k] = k end
for k = 1, p.levels do levels[k] = tonumber(("%.6g"):format(k*p.step)) end
levels.unit = "g"

local function wall_at_rest()
  local m = trilith.model { name = "small wall", thickness = 0.2 }
  local brick = m:material { name = "brick", density = 1900 }
  local kn, mass = 2e9, 1900*0.5*0.2*0.2
  local beta = 2*0.1/math.sqrt(kn*0.5*0.2/mass) -- 10 % of critical for one unit on its bed joint
  m:contact { between = { "*", "*" }, name = "mortar", law = trilith.bonded {
    kn = kn, ks = 0.4*kn, mu = 0.6, beta = beta, tension = p.tension, cohesion = 1.5*p.tension } }
  m:wall {
    name = "wall", length = 4, unit_length = 0.5, unit_height = 0.2, bond = "running", storeys = 1,
    storey_height = 2.6, slab_height = 0.2, base_height = 0.4, base_margin = 20,
    openings = { { storey = 1, x = 0.75, width = 1, height = 2 },
                 { storey = 1, x = 2.5, sill = 1, width = 0.75, height = 1 } },
    lintel_bearing = 0.25, material = brick, fixed = "base", body = "rigid",
    by_group = { slabs = { weight = 1.2e4*4 } } }
  m:consolidate { duration = 10, rest = { ratio = 1e-5, speed = 1e-6 }, fresh = true }
  return m
end

local study = trilith.study {
  file = p.out, ida = { over = "pga", stop = "collapsed" }, before = wall_at_rest,
  parameters = { pga = levels, motion = motions },
  case = function(case, m)
    local ns = trilith.motion "elcentro_1940_rest_ns.csv"
    local turned = ns:rotate(trilith.motion "elcentro_1940_rest_ew.csv", 2*math.pi*(case.motion - 1)/p.motions)
    local slab = m:body "wall.s1.slab"
    local y0, drift = slab.uy, 0
    m:every(0.02, function() drift = math.max(drift, math.abs(m.top_drift)) end)
    m:on_step(function() if slab.uy - y0 < -0.2 then m:stop() end end)
    m:shake { body = "wall.base", x = turned:scale { pga = case.pga }, duration = p.duration }
    return { collapsed = slab.uy - y0 < -0.2, drift = { drift, unit = "m" }, sank = { y0 - slab.uy, unit = "m" } }
  end,
}
print(("%d cases finished, %d passed over, %d failed"):format(study.finished, study.passed_over, study.failed))
