-- A two-storey façade between two return walls, of stone blocks in weak mortar, with one floor. El Centro 1940 acts
-- until the façade separates from the return walls: NS across the façade, EW along it, the vertical component on
-- demand, all with the same factor.
-- Results and reasons for the data: docs/gallery/facade3d.md.
local trilith = require "trilith"
local s = trilith.units "s"
local p = trilith.params {
  pga = { 0.8, unit = "g", "peak acceleration across the façade; the other two components have the same factor" },
  vertical = { false, "true: with the vertical component" },
  sign = { 1, "sign of the NS component: 1 or -1" },
  duration = { 5.6, unit = "s", "duration of the shaking" },
  mortar = { 10, unit = "kPa", "tensile strength of the joints; 0: dry" },
  cohesion = { 1.5, "shear strength at no pressure, as a share of the tensile strength" },
  mu = { 0.6, "friction coefficient of the joints" },
  kn = { 5e8, unit = "Pa/m", "stiffness of a joint" },
  damping = { 1, "factor of the damping" }, onset = { 0, unit = "s", "more time at rest before the record" },
  returns = { 2.1, unit = "m", "length of the return walls" },
  safety = { 0.5, "share of the longest stable step" },
  out = { "out/facade3d.h5", "results" } }

local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
local ew = trilith.motion "elcentro_1940_rest_ew.csv":scale_as(ns)
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(ns)
if p.onset > 0 then ns, ew, up = ns:delay(p.onset), ew:delay(p.onset), up:delay(p.onset) end
local m = trilith.model { name = "facade", dim = 3 }
m:material { name = "stone", density = 2200 }
m:material { name = "concrete", density = 2400 }
local unit = { length = 0.6, height = 0.3, thickness = 0.3 }
local mass = 2200*unit.length*unit.height*unit.thickness
local beta = p.damping*2*0.03/math.sqrt(p.kn*unit.length*unit.thickness/mass) -- 3 % of critical for one unit on its bed
local joint = { kn = p.kn, ks = 0.4*p.kn, mu = p.mu, beta = beta }
local law = trilith.frictional(joint)
if p.mortar > 0 then
  joint.tension, joint.cohesion = p.mortar, p.cohesion*p.mortar
  law = trilith.bonded(joint)
end
m:contact { between = { "*", "*" }, name = "joint", law = law }

local length, middle = 4.8, unit.thickness/2
local house = m:building {
  name = "house", material = "stone", fixed = "base",
  walls = {
    { name = "front", from = { 0, middle }, to = { length, middle }, openings = {
      { storey = 1, from = 0.9, width = 0.9, height = 2.1 },             -- door
      { storey = 1, from = 2.7, sill = 0.9, width = 1.2, height = 1.2 }, -- window
      { storey = 2, from = 0.9, sill = 0.6, width = 0.9, height = 1.5 },
      { storey = 2, from = 2.7, sill = 0.6, width = 1.2, height = 1.5 } } },
    { name = "left", from = { middle, middle }, to = { middle, p.returns } },
    { name = "right", from = { length - middle, middle }, to = { length - middle, p.returns } } },
  storeys = { { courses = 9, slab_height = 0.2 }, { courses = 9, slab_height = 0 } },
  unit_length = unit.length, unit_height = unit.height, lintel_bearing = 0.3,
  base_height = 0.5, base_margin = 4,
  by_group = { floors = { material = "concrete" } } }
print(("%d solids, %.1f t without the base"):format(#house, 1e-3*(house - "house.base").mass))

m:results { file = p.out, frames = 0.05*s, energy = 0.05*s }
for i = 1, 2 do m:history { name = ("drift of storey %d across"):format(i), storey = i, what = "drift_y" } end
m:consolidate { rest = { ratio = 1e-4 }, fresh = true, duration = 20*s, safety = 0.8 } -- mortar sets under weight
local bonds = 0
for _, c in ipairs(m:contacts()) do if c.hold == "bonded" then bonds = bonds + 1 end end

local begun, lost, half, first = m.time, 0, nil, {}
local function tell(what, e)
  if first[what] then return end
  first[what] = e.time - begun
  local names = {}
  for i, b in ipairs(e.bodies) do names[i] = b.name end
  print(("%6.2f s: first %s: %s"):format(e.time - begun, what, table.concat(names, ", ")))
end
m:on("bond.broken", function(e)
  lost = lost + 1
  if not half and lost >= bonds/2 then half = e.time - begun end
  tell("bond lost", e)
end)
m:on("impact", function(e) -- on the base, of a stone that did not stand on it
  local a, b = e.bodies[1].name, e.bodies[2].name
  if a == "house.base" then a, b = b, a end
  if b == "house.base" and not a:match "%.s1%.c1%." then tell("stone on the ground", e) end
end)
local report = m:shake { body = "house.base", x = ew, y = ns:scale { factor = p.sign }, z = p.vertical and up or nil,
                         duration = p.duration, safety = p.safety }
local base, apart, all = m:body "house.base", {}, {}
for _, b in ipairs(house) do -- stones that have moved against the ground by more than 10 cm, by wall and storey
  local wall = b.name:match "^house%.(%a+%.s%d)"
  if wall then
    all[wall], apart[wall] = (all[wall] or 0) + 1, apart[wall] or 0
    local x, y, z = b.ux - base.ux, b.uy - base.uy, b.uz - base.uz
    if x*x + y*y + z*z > 0.1^2 then apart[wall] = apart[wall] + 1 end
  end
end
if bonds > 0 then
  print(("%d of %d joints lost their bond, half of them by %.2f s"):format(lost, bonds, half or p.duration))
end
for _, wall in ipairs { "front.s2", "left.s2", "right.s2", "front.s1", "left.s1", "right.s1" } do
  print(("%-8s %2d of %2d stones out of place by 10 cm"):format(wall, apart[wall], all[wall]))
end
for _, row in ipairs(house:damage_by_storey()) do
  print(("storey %d: %3d of %d joints are open or have slid by half an inch, drift across %4.0f mm"):format(row.storey,
    row.joints_apart, row.joints, 1e3*m.storeys[row.storey].drift_y))
end
local figures = {} -- of a study
for name, time in pairs { ["first bond"] = first["bond lost"] or false, ["half of all"] = half or false,
  ["first stone"] = first["stone on the ground"] or false } do
  if time then figures[name] = { time - p.onset, unit = "s" } end
end
for wall, count in pairs(apart) do figures["out of place " .. wall] = count/all[wall] end
for _, row in ipairs(house:damage_by_storey()) do figures["apart " .. row.storey] = row.joints_apart/row.joints end
print(("%s after %.2f s"):format(report.ending, report.ended - report.begun))
return figures
