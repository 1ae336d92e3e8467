-- Masonry builders: groups, options by group, storeys, notes.
local trilith = require "trilith"
local function near(a, b, tolerance) assert(math.abs(a - b) <= (tolerance or 1e-9), a .. " is not " .. b) end

local m = trilith.model { name = "m", thickness = 0.2 }
m:material { name = "brick", density = 1800 }
m:material { name = "concrete", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 4e9, mu = 0.6, beta = 2e-5 } }
local wall = m:wall {
  name = "w", length = 4, unit_length = 0.4, unit_height = 0.2, storeys = 2, storey_height = 2, slab_height = 0.2,
  base_height = 0.5, openings = { { storey = { 1, 2 }, x = 1.2, sill = 0.6, width = 0.8, height = 0.8 } },
  material = "brick", fixed = "base",
  by_group = { slabs = { weight = 1e4, groups = "heavy" }, base = { material = "concrete" },
               ["w.s1.c1.u1"] = { mass = 7 } },
}
local slabs = m:bodies { group = "slabs" }
assert(#slabs == 2 and slabs == m:bodies { group = "heavy" } and #(slabs * m:bodies { group = "storey 2" }) == 1)
near(slabs[1].mass, 1e4 / 9.80665)
near(m:body("w.base").mass, 4 * 0.5 * 0.2 * 2400)
near(m:body("w.s1.c1.u1").mass, 7)
near(m:body("w.s1.c1.u2").mass, 0.4 * 0.2 * 0.2 * 1800)
assert(#m:bodies { group = "lintels" } == 2 and #wall == #m:bodies { group = "w" })
assert(#m:bodies { group = "pier 1" } > 0 and #m:bodies { group = "spandrel 1" } > 0)
local report = m:consolidate { rest = { ratio = 1e-4, speed = 1e-4 }, duration = 5 }
assert(report.rests and m:body("w.base").uy == 0)

-- damage by storey: 0 at rest, 1 if no displacement is allowed
local damage = wall:damage_by_storey()
assert(#damage == #m.storeys and damage[1].storey == 1 and damage[2].storey == 2)
local joints, units = 0, 0
for k, storey in ipairs(damage) do
  assert(storey.joints_apart == 0 and storey.units_out_of_place == 0)
  joints, units = joints + storey.joints, units + storey.units
  assert(storey.units == #(m:bodies { group = "units" } * m:bodies { group = "storey " .. k }))
end
assert(joints == #m:joints() and units == #m:bodies { group = "units" })
local strict = wall:damage_by_storey { apart = 0, out_of_place = 0 }
assert(strict[1].joints_apart > 0 and strict[1].units_out_of_place == strict[1].units)
assert((slabs:damage_by_storey()[1].units) == 0)
local function refused(pattern, f, ...)
  local good, message = pcall(f, ...)
  assert(not good and tostring(message):find(pattern), tostring(message))
end
refused("unknown key 'appart'; did you mean 'apart'?", wall.damage_by_storey, wall, { appart = 1 })
refused("'out_of_place' is %-1 m, must not be below 0", wall.damage_by_storey, wall, { out_of_place = -1 })
local base = m:bodies { name = "w.base" }
refused("none of these 1 bodies is in a group \"storey 1\"", base.damage_by_storey, base)

-- storeys with their own options, and a note on snapped dimensions
local n = trilith.model { name = "n" }
n:material { name = "brick", density = 1800 }
n:wall { units = 6, unit_length = 0.24, head_joint = 0.01, unit_height = 0.115, bed_joint = 0.01, bond = "flemish",
         storeys = { { courses = 8 }, { height = 1.1, slab_height = 0.1 } }, snap = true, material = "brick",
         openings = { { x = 0.5, sill = 0.3, width = 0.375, height = 0.45 } } }
assert(#n:bodies { group = "storey 2" } > 50 and n:body "s2.slab" and #n.notes == 1)
assert(n.notes[1]:find "sill is moved from 0.3 to 0.25 m", n.notes[1])
near(n:body("s2.slab").y, 8 * 0.125 + 1.05)
assert(#trilith.build.wall { length = 2, courses = 2, jitter = 1e-6, seed = 3 } == 11)

local a = trilith.model { name = "a" }
a:material { name = "stone", density = 2400 }
local arch = a:arch { voussoirs = 11, span = 4, rise = 3, thickness = 0.5, key = 1.5, material = "stone",
                      fixed = "abutments" }
assert(#arch == 13 and #a:bodies { group = "key" } == 1 and a:bodies { group = "key" }[1].name == "v6")
near(a:body("v6").x, 0)
local stones = a:rubble { name = "heap", outline = { { 10, 0 }, { 13, 0 }, { 13, 2 }, { 10, 2 } }, stones = 40,
                          seed = 3, material = "stone" }
near(stones.mass, 3 * 2 * 2400, 1e-6)
assert(stones == a:bodies { group = "heap" } and a:body "heap.r1".y < a:body "heap.r40".y)
