-- A bridge of two spans on a pier, loaded by traffic. The river removes the ground under the footing of the pier,
-- piece by piece from upstream, while the load remains. Results: docs/gallery/scour.md.
local trilith = require "trilith"
local s = trilith.units "s"
local p = trilith.params {
  traffic = { 20e3, unit = "N/m", "traffic load per length of a strip of 1 m width" },
  every = { 0.5, unit = "s", "time between two removals of ground" },
  pieces = { 10, "number of pieces of ground under the footing" },
  stop = { 10, "largest number of removed pieces" },
  out = { "out/scour.h5", "results" } }
local m = trilith.model { name = "scour", thickness = 1 }
m:material { name = "concrete", density = 2400 }
m:material { name = "gravel", density = 2000 }
local function law(kn, mu, size)
  return trilith.frictional { kn = kn, ks = 0.5*kn, mu = mu, beta = 2*0.1/math.sqrt(kn/(2400*size)) }
end
m:contact { between = { "*", "*" }, law = law(2e9, 0.6, 1) }
m:contact { between = { "concrete", "gravel" }, law = law(2e8, 0.5, 4) }

m:block { name = "rock", width = 40, height = 1, at = { -20, -3 }, material = "gravel", support = "fixed" }
local width, ground = 4, {}
for i = 1, p.pieces do
  ground[i] = m:block { name = "ground " .. i, groups = { "ground" }, width = width/p.pieces, height = 2,
    at = { -0.5*width + (i - 1)*width/p.pieces, -2 }, material = "gravel", support = "fixed" }
end
m:block { name = "footing", width = width, height = 1, at = { -0.5*width, 0 }, material = "concrete" }
m:block { name = "pier", width = 1.2, height = 6, at = { -0.6, 1 }, material = "concrete" }
m:block { name = "left abutment", width = 2, height = 9, at = { -16, -2 }, material = "concrete", support = "fixed" }
m:block { name = "right abutment", width = 2, height = 9, at = { 14, -2 }, material = "concrete", support = "fixed" }
local left = m:block { name = "left span", width = 15, height = 0.9, at = { -15.02, 7 }, material = "concrete" }
local right = m:block { name = "right span", width = 15, height = 0.9, at = { 0.02, 7 }, material = "concrete" }

m:results { file = p.out, frames = 0.05*s, energy = 0.05*s }
local pier = m:body "pier"
m:history { name = "tilt of the pier", body = pier, what = "rotation" }
m:consolidate { rest = { ratio = 1e-4 } }
local force = { 0, -p.traffic*15 }
for i, span in ipairs { left, right } do
  m:point_load { body = span, force = force, load_curve = { smooth = 1 }, name = "traffic " .. i }
end
m:run { name = "traffic", duration = 10*s, local_damping = 0.8, rest = { from = 1, ratio = 1e-4 } }
print(("%.2f s: under traffic; the footing has settled by %.2f mm"):format(m.time, -1e3*m:body("footing").uy))

local gone = 0
m:every(p.every, function()
  if gone == p.stop or gone == p.pieces then return end
  gone = gone + 1
  m:remove(ground[gone])
  print(("%.2f s: %2d of %d pieces removed, rotation of the pier %6.2f mrad"):format(m.time, gone, p.pieces,
    1e3*pier.rotation))
end)
m:on("impact", function(e) if e.value > 2 then print(tostring(e)) end end)
local last = m:run { name = "scour", duration = p.every*(p.pieces + 1) + 4*s, until_collapse = { drop = 2 } }
print(("%.2f s: %s; %d of %d pieces of ground are removed"):format(m.time,
  last.ending == "stopped" and last.reason or "it stands", gone, p.pieces))
print(("energy removed with the ground %.3g J"):format(m.energy.removed))
