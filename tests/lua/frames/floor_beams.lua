-- Beam floors of a building in space: a house stands with them, each wall carries half of a beam's load; rejected
-- input.
local trilith = require "trilith"
local given = dofile "wrong_input.lua"
local g = 9.80665
local function near(a, b, share) assert(math.abs(a - b) <= share*math.abs(b), ("%.9g is not %.9g"):format(a, b)) end

local function new()
  local m = trilith.model { name = "house", dim = 3 }
  m:material { name = "stone", density = 2200 }
  m:material { name = "timber", density = 600 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4 } }
  return m
end
--- Keys of a house of four walls with three beams, extended by the keys of `more`.
local function plan(more)
  local keys = { name = "house", material = "stone", fixed = "base", unit_length = 0.4, unit_height = 0.2,
    walls = { { name = "south", from = { 0, 0.1 }, to = { 3.2, 0.1 } },
      { name = "north", from = { 0, 2.3 }, to = { 3.2, 2.3 } },
      { name = "west", from = { 0.1, 0.1 }, to = { 0.1, 2.3 } },
      { name = "east", from = { 3.1, 0.1 }, to = { 3.1, 2.3 } } },
    courses = 5, base_height = 0.3, base_margin = 0.5,
    beams = { along = "x", count = 3, width = 0.16 },
    by_group = { beams = { material = "timber" }, floors = { density = 3000 } } }
  for key, value in pairs(more) do keys[key] = value end
  return keys
end

--- Upward contact force of the bodies of a group on a body [N].
local function carried(m, body, group)
  local sum = 0
  for _, c in ipairs(m:contacts { between = { body, m:bodies { group = group } } }) do
    sum = sum + (c.b.name == body.name and 1 or -1)*c.force[3]
  end
  return sum
end

-- The house stands, its base carries the full weight, and each of a beam's two walls carries half of its load.
do
  local m = new()
  local all = m:building(plan {})
  local base, beam, above = m:body "house.base", m:body "house.s1.beam2", all - m:body "house.base"
  assert(#m:bodies { group = "beams" } == 3 and #m.storeys == 1)
  near(m.storeys[1].height, 1, 1e-12)
  near(beam.mass, 600*3.2*0.16*0.2, 1e-12) -- a beam of the first group
  m:consolidate { rest = { ratio = 1e-5 } }
  local at = beam.z
  m:run { duration = 0.2 }
  assert(math.abs(beam.z - at) < 1e-6 and m.top_drift < 1e-5, beam.z - at)
  local function check(load)
    for _, wall in ipairs { "west", "east" } do near(carried(m, beam, wall), (beam.mass*g + load)/2, 0.02) end
    near(carried(m, beam, "units"), beam.mass*g + load, 1e-3)
    near(-carried(m, base, "storey 1"), above.mass*g + load, 1e-3)
  end
  check(0)
  m:point_load { body = beam, force = { 0, 0, -4e3 }, load_curve = { ramp = 0.1 } }
  m:run { duration = 2, local_damping = 0.8, rest = { ratio = 1e-5, from = 0.3 } }
  check(4e3)
end

-- Beam ends under a wall, in walls thicker than the bearing length: both walls share the load of a slab and of a heavy
-- floor as they share the weight above.
do
  local m = new()
  local all = m:building(plan {
    storeys = { { courses = 3, slab_height = 0.1 }, { courses = 2, beams = false } },
    by_group = { beams = { density = 8e3 } },
    walls = { { name = "west", thickness = 0.4, from = { 0.2, 0 }, to = { 0.2, 2 } },
      { name = "east", thickness = 0.4, from = { 3, 0 }, to = { 3, 2 } } },
    beams = { along = "x", spacing = 0.6, width = 0.16, bearing = 0.25 } })
  local base = m:body "house.base"
  assert(#m.storeys == 2 and #m:bodies { group = "floors" } == 4 and #m:bodies { group = "beams" } == 3)
  m:consolidate { rest = { ratio = 1e-5 } }
  near(-carried(m, base, "storey 1"), (all - base).mass*g, 1e-3)
  for _, wall in ipairs { "west", "east" } do near(-carried(m, base, wall), (all - base).mass*g/2, 1e-3) end
  for i = 1, 3 do
    local beam = m:body("house.s1.beam" .. i)
    for _, wall in ipairs { "west", "east" } do
      near(carried(m, beam, wall), (beam.mass*g - carried(m, beam, "floors"))/2, 0.02)
    end
  end
  near(m.storeys[1].height, 0.7, 1e-12)
end

local function beams(more) return plan { beams = more } end
given.check {
  { function() new():building(beams {}) end,
    "building 'house': beams: 'along' is missing; give \"x\" or \"y\": direction of their span" },
  { function() new():building(beams(true)) end,
    "building 'house': 'beams' is true, must be a table { along = , spacing = , width = }, a list of such tables, or "
      .. "false for none" },
  { function() new():building(beams { along = "z", count = 3, width = 0.1 }) end,
    "building 'house': beams: 'along' is 'z', must be one of x, y" },
  { function() new():building(beams { along = "x", count = 0, width = 0.1 }) end,
    "building 'house', beams, row 1: count is 0, must be a whole number from 1 to 10000" },
  { function() new():building(beams { { along = "x", count = 3, widht = 0.1 } }) end,
    "building 'house': beams, row 1: unknown key 'widht'; did you mean 'width'?" },
  { function() new():building(beams { along = "x", width = 0.1 }) end,
    "building 'house': storey 1: beams: give their spacing in m from centre to centre, or their count" },
  { function() new():building(beams { along = "x", count = 3, width = 160 }) end,
    "building 'house': storey 1: beams: 3 beams of 160 m width need 480 m, but the room has 2 m, from y = 0.2 to 2.2 "
      .. "m; "
      .. "give fewer, narrower or closer beams" },
  { function() new():wall { name = "w", length = 3, storeys = { { courses = 2, beams = {} } } } end,
    "wall 'w': storey 1: unknown key 'beams'; known: courses, height, slab_height" },
}
