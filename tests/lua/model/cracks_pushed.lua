-- A pushed wall whose units crack: the drift of its storey follows the parts, and the capacity of weak units.
local trilith = require "trilith"

-- The last reading of a pushover is made a step before its end.
local function near(a, b) assert(math.abs(a - b) < 1e-5*math.abs(b), a .. " is not " .. b) end

-- Two rows of units on a base. Their joints are strong, so that units crack where they are weak.
local function push(keys)
  local m = trilith.model { name = "pushed", thickness = 0.2, threads = keys.threads or 1 }
  m:material { name = "brick", density = 1800 }
  m:contact { between = { "*", "*" }, name = "unit", law = trilith.cohesive { kn = 1e11, ks = 4e10, mu = 0.7,
    beta = 5e-6, tension = keys.tension, cohesion = 2*keys.tension, energy_tension = 30, energy_shear = 300 } }
  m:contact { between = { "*", "*" }, name = "joint", law = trilith.bonded { kn = 1e10, ks = 4e9, mu = 0.7,
    beta = 2e-5, tension = 1e7, cohesion = 1e7 } }
  m:wall { name = "w", length = 0.8, unit_length = 0.4, unit_height = 0.2, courses = 2, material = "brick",
    base_height = 0.2, slab_height = keys.slab and 0.2 or 0, fixed = "base", cracks = "mid", crack_law = "unit",
    by_group = keys.slab and { slabs = { cracks = false } } or nil }
  local top = m:bodies { group = keys.slab and "slabs" or "course 2" }
  local number = #top
  local cracked, cracks_of_top = 0, 0
  m:on("unit.cracked", function(e)
    cracked = cracked + 1
    if e.body.name:find "c2" then cracks_of_top = cracks_of_top + 1 end
  end)
  m:history { name = "drift", what = "top_drift", every = 1e-3 }
  local r = m:pushover { body = top, rate = 0.02, drift = keys.drift, samples = 100 }
  return { m = m, r = r, cracked = cracked, cracks_of_top = cracks_of_top, units_at_top = number }
end

-- the slab moves by the drift, which was once read from a list of bodies that the first crack had replaced
local whole = push { tension = 2e6, drift = 4e-4, slab = true }
assert(whole.cracked == 0 and whole.r.limit == "drift")
local weak = push { tension = 1e5, drift = 4e-4, slab = true }
assert(weak.cracked > 0 and weak.r.limit == "drift", weak.r.limit)
local slab, base = weak.m:body "w.s1.slab", weak.m:body "w.base"
near(weak.r.drift, slab.ux - base.ux)
near(weak.r.drift, weak.m.top_drift)
assert(weak.r.peak_force < 0.9*whole.r.peak_force, weak.r.peak_force/whole.r.peak_force)
assert(math.abs(weak.m.residual) < 1e-2*weak.m.energy.contact_fracture, weak.m.residual)
assert(push({ tension = 1e5, drift = 4e-4, slab = true, threads = 2 }).m.hash == weak.m.hash)

-- without a slab the top is the last course: a unit that has cracked no longer counts, and its parts do
local open = push { tension = 1e5, drift = 4e-4 }
assert(open.cracks_of_top > 0)
local sum, count = 0, 0
for body in open.m:bodies { group = "course 2" } do
  if body.present then sum, count = sum + body.ux, count + 1 end
end
assert(count == open.units_at_top + open.cracks_of_top)
near(open.r.drift, sum/count)
near(open.m.top_drift, sum/count)
