-- A bridge pier in a flood: the water rises and flows past it, scours the ground under its footing, and then an
-- earthquake shakes it in the water.
--
-- Physics: pier and footing are rigid, on gravel in pieces that the flow removes one by one from upstream. The water
-- stands against the pier, lifts it, and drags on it; joints are wet, because gravel lets the water pass. In the
-- earthquake the water moves with the pier as added mass. The section is across the bridge, along the flow.
local trilith = require "trilith"
local s, g = trilith.units "s", trilith.units "g"
local p = trilith.params {
  level = { 8, unit = "m", "of the flood above the ground" },
  flow = { 4, unit = "m/s", "velocity of the flood" },
  scoured = { 4, "number of pieces of ground that the flood removes" },
  pieces = { 12, "number of pieces of ground under the footing" },
  pga = { 0.3*g, unit = "m/s2", "of the ground motion" },
  duration = { 15*s, unit = "s", "duration of the shaking" },
  out = { "out/pier_flood.h5", "results" } }
local m = trilith.model { name = "pier in a flood", thickness = 3 }
m:material { name = "concrete", density = 2400 }
m:material { name = "gravel", density = 2000 }
local function law(kn, mu, size)
  return trilith.frictional { kn = kn, ks = 0.5*kn, mu = mu, beta = 2*0.1/math.sqrt(kn/(2400*size)) }
end
m:contact { between = { "*", "*" }, law = law(2e9, 0.6, 1) }
m:contact { between = { "concrete", "gravel" }, law = law(3e8, 0.55, 4) }
local width, ground = 9, {}
m:block { name = "rock", width = 60, height = 1, at = { -30, -3 }, material = "gravel", support = "fixed" }
for i = 1, p.pieces do
  ground[i] = m:block { name = "ground " .. i, width = width/p.pieces, height = 2, groups = { "ground" },
    at = { -0.5*width + (i - 1)*width/p.pieces, -2 }, material = "gravel", support = "fixed" }
end
m:block { name = "footing", width = width, height = 1.5, at = { -0.5*width, 0 }, material = "concrete",
          groups = { "wet" } }
local pier = m:block { name = "pier", width = 5, height = 11, at = { -2.5, 1.5 }, material = "concrete",
                       groups = { "wet" } }
m:block { name = "deck", width = 8, height = 1.2, at = { -4, 12.5 }, material = "concrete", weight = 2.5e6 }

m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
m:history { name = "tilt of the pier", body = pier, what = "rotation" }
m:consolidate { integrator = "static" }
local function report(title)
  local rock = m:body("rock").ux
  print(("%-24s tilt %7.3f mrad, top %7.2f mm, footing %7.2f mm downstream and %5.2f mm down"):format(title,
    -1e3*pier.rotation, 1e3*(pier:point { 0, 12.5 } - rock), 1e3*(m:body("footing").ux - rock),
    -1e3*m:body("footing").uy))
end
report "dead load"

-- The flood: still water first, then the flow.
local names = {}
for _, side in ipairs { "left", "right", "top", "bottom" } do
  names[#names + 1] = m:water { name = "river " .. side, body = "wet", level = 0, side = side, joints = "wet" }
end
for _, name in ipairs(names) do m:set_level { name = name, level = p.level } end
m:consolidate { integrator = "static" }
report "flood, still"
m:drag { name = "flow", body = pier, at = { -2.5, 0.5*(1.5 + p.level) }, velocity = { p.flow, 0 }, coefficient = 1.4,
         area = 3*(p.level - 1.5) }
m:consolidate { integrator = "static" }
report "flood, flowing"
for i = 1, p.scoured do
  m:remove(ground[i])
  m:run { name = "scour " .. i, duration = 4*s, local_damping = 0.7, rest = { ratio = 1e-4, from = 0.3*s } }
  report(("scour, %d of %d pieces"):format(i, p.pieces))
end

m:added_mass { body = pier, side = "left", level = p.level, bed = 0, from = 1.5, to = p.level }
m:added_mass { body = pier, side = "right", level = p.level, bed = 0, from = 1.5, to = p.level }
local most = 0
m:every(0.02*s, function() most = math.max(most, math.abs(pier.rotation)) end)
local motion = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
local driven = { { body = "rock", x = motion } }
for i = p.scoured + 1, p.pieces do driven[#driven + 1] = { body = ground[i], x = motion } end
m:shake { motions = driven, duration = p.duration, until_collapse = { drop = 2 } }
report "after the earthquake"
print(("largest tilt in the earthquake %.2f mrad; work of the water %.1f kJ"):format(1e3*most, 1e-3*m.energy.water))
