-- A hemisphere of dry stones in rings. Its springing ring is cut into one stone for each sector of the dome. These
-- stones slowly move outwards, like walls that lean under the thrust: the dome cracks along its meridians and falls.
-- Results: docs/gallery/dome.md.
local trilith = require "trilith"
local s = trilith.units "s"
local p = trilith.params {
  radius = { 5, unit = "m", "radius of the middle surface" },
  t = { 0.08, "thickness over radius; 0.042 is enough on a fixed ring" },
  rings = { 8, "number of rings from springing to key" }, sectors = { 16, "number of stones in a ring" },
  mu = { 0.6, "friction of the joints" }, kn = { 2e9, unit = "Pa/m", "stiffness of a joint" },
  spread = { 0.2, "outward displacement of the springing over radius; 0: fixed" },
  over = { 12, unit = "s", "duration of this displacement" },
  out = { "out/dome.h5", "results" } }
local R, t, n = p.radius, p.t*p.radius, p.sectors
local m = trilith.model { name = "dome", dim = 3 }
m:material { name = "stone", density = 2000 }
local side = R*math.pi/2/p.rings
local beta = 2*0.1/math.sqrt(p.kn/(2000*side)) -- 10 % of critical for a stone on its bed
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = p.kn, ks = 0.5*p.kn, mu = p.mu, beta = beta } }
m:block { name = "ground", size = { 4*R, 4*R, 0.5 }, at = { -2*R, -2*R, -1.5 }, material = "stone", support = "fixed",
          groups = { "ground" } }
local dome = m:dome { name = "dome", radius = R, thickness = t, rings = p.rings, sectors = n, material = "stone" }
local ring = {}
for k = 1, n do -- one stone of the springing ring under each sector, between the same two planes through the axis
  local points = {}
  for _, angle in ipairs { (k - 1)*2*math.pi/n, k*2*math.pi/n } do
    for _, r in ipairs { R - t, R + t } do
      for _, z in ipairs { -0.5, 0 } do
        points[#points + 1] = { r*trilith.math.cos(angle), r*trilith.math.sin(angle), z }
      end
    end
  end
  ring[k] = m:hull { name = "springing " .. k, points = points, material = "stone", support = "fixed",
                   groups = { "springing" } }
end
print(("%d stones, %.1f t, t/R = %g"):format(#dome, 1e-3*dome.mass, p.t))

m:results { file = p.out, frames = 0.1*s, energy = 0.1*s }
m:consolidate { rest = { ratio = 1e-4 }, duration = 30*s }
local key = m:body "dome.key"
print(("stands: the key has settled by %.2f mm"):format(-1e3*key.uz))

local begun, z0, came, fallen = m.time, key.z, nil, nil
local function spread() return math.sqrt(ring[1].ux^2 + ring[1].uy^2)/R end
m:on("impact", function(e)
  if fallen then return end
  for _, b in ipairs(e.bodies) do
    if b.name == "ground" then
      fallen = e.time - begun
      print(("%.2f s: first stone on the ground, springing spread by %.4f R"):format(fallen, spread()))
    end
  end
end)
local motions = {}
for k = 1, p.spread > 0 and n or 0 do  -- 0: the ring holds
  local angle = (k - 0.5)*2*math.pi/n
  local function out(share) return trilith.ramp { by = p.spread*R*share, duration = p.over } end
  motions[k] = { body = ring[k], x = out(trilith.math.cos(angle)), y = out(trilith.math.sin(angle)) }
end
if p.spread > 0 then m:drive { motions = motions } end
m:every(0.02, function()
  if not came and key.vz < -1 then
    came = m.time
    print(("%.2f s: collapse, springing spread by %.4f R, key lowered by %.4f R"):format(came - begun, spread(),
      (z0 - key.z)/R))
  end
  if came and m.time > came + 2 then m:stop() end
end)
m:run { name = "spreading", duration = p.over }
