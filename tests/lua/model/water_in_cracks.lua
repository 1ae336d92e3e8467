-- Water enters the crack of a mesh where a wet face reaches its edge. A bar under water is held at its left end, and by
-- a spring at its right end. It floats, or has nearly no weight. Once the crack is open the water presses both ends of
-- the right part alike, and the spring carries the loads alone. Where no wet face reaches the crack, the spring carries
-- the pressure on the right end as well.
local trilith = require "trilith"

local function bar(dim, mesh, wet, cohesive)
  local b, L, depth, w, K = 0.1, 0.5, 5, 9806.65, 1e8
  local m = trilith.model { name = "wet crack", dim = dim, thickness = dim == 2 and b or nil }
  m:material { name = "concrete", density = wet == "all" and 1000 or 1, E = 30e9, nu = 0 }
  local strengths = { kn = 1e13, ks = 5e12, mu = 0.5, tension = 1e4, cohesion = 2e4 }
  if cohesive then strengths.energy_tension, strengths.energy_shear = 1e-2, 4e-2 end
  m:contact { between = { "*", "*" }, name = "plane",
    law = cohesive and trilith.cohesive(strengths) or trilith.bonded(strengths) }
  local function at(x, y) return dim == 3 and { x, y, y } or { x, y } end
  local function block(t, length)
    t.material = "concrete"
    if dim == 3 then t.size = { length, b, b } else t.width, t.height = length, b end
    m:block(t)
  end
  block({ name = "bar", at = at(0, 0), cracks = "mid", crack_law = "plane", body = { mesh = mesh },
    hold = { { from = at(0, 0), to = at(0, b), x = "fixed", y = "fixed", z = dim == 3 and "fixed" or nil } } }, L)
  block({ name = "anchor", at = at(L + 0.3, 0), support = "fixed" }, 0.1)
  local spring = trilith.linear { stiffness = K }
  local s = m:bearing { name = "spring", between = { "bar", "anchor" }, from = at(L, b/2), to = at(L + 0.3, b/2),
    along = spring, axial = spring, across = dim == 3 and spring or nil }
  m:water { name = "lake", body = "bar", level = depth, side = wet }
  local cracked, total = false, 0
  m:on("unit.cracked", function() cracked = true end)
  for k = 1, 8 do
    total = total + 150
    m:point_load { name = "pull " .. k, body = cracked and "bar.b" or "bar", at = at(L, b/2),
      force = dim == 3 and { 150, 0, 0 } or { 150, 0 } }
    m:consolidate { integrator = "static" }
  end
  assert(cracked and math.abs(m.residual) < 1e-9)
  local carried = wet == "all" and total or total - w*(depth - b/2)*b*b
  assert(math.abs(-s.force_along - carried) < 1e-3*total, ("%s: %g is not %g"):format(wet, -s.force_along, carried))
end

for _, cohesive in ipairs { false, true } do
  bar(2, { 10, 2 }, "all", cohesive)
  bar(2, { 10, 2 }, "right", cohesive)
  bar(3, { 10, 2, 2 }, "all", cohesive)
end
bar(3, { 10, 2, 2 }, "right", false)
