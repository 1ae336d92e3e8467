-- Bridges in space from tables: bearing forces, positions of seats, rotation of a skewed deck, handles for scripts;
-- rejected input, one line each.
local trilith = require "trilith"
local g = 9.80665
local stiff = trilith.linear { stiffness = 2e9, damping = 4e6 }
local soft = trilith.linear { stiffness = 2e7, damping = 2e5 }

local function near(a, b, relative, what)
  if math.abs(a - b) > relative*math.max(math.abs(b), 1e-12) then error(("%s: %.9g, not %.9g"):format(what, a, b),
    2) end
end
local function new(threads)
  local m = trilith.model { name = "bridge", dim = 3, threads = threads }
  m:material { name = "concrete", density = 2400, E = 30e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5e8, ks = 2e8, mu = 0.6, beta = 2e-4 } }
  m:bearing_type { name = "pad", height = 0.1, horizontal = soft, axial = stiff, limit = { horizontal = 0.15 },
                   becomes = trilith.frictional { name = "slide", kn = 5e8, ks = 2e8, mu = 0.1, beta = 2e-4 } }
  m:bearing_type { name = "flush", along = soft, across = soft, axial = stiff }
  m:bearing_type { name = "slick", contact = trilith.frictional { name = "oiled", kn = 5e8, ks = 2e8, mu = 0.05,
    beta = 2e-4 } }
  m:bearing_type { name = "guided", height = 0.1, across = soft, axial = stiff }
  return m
end
local function tables(change)
  local given = {
    gap = 0.1, seat = 0.6, breadth = 10, skew = 0.4, material = "concrete", ground = { margin = 1, thickness = 1.5 },
    girders = { count = 3, spacing = 3.2, breadth = 0.6 },
    abutment = { height = 8, width = 4, back_wall_height = 1.5 },
    pier = { height = 8, footing_width = 4, footing_breadth = 9, footing_thickness = 1, cap_thickness = 1.2,
             stem_width = 1, columns = 2, column_spacing = 5, column_breadth = 1 },
    span = { length = 25, depth = 1.5, slab = 0.25, diaphragm = { thickness = 0.3, count = 3 },
             weight_per_length = 1.5e5, left = "pad", right = "pad" },
    supports = { {}, { name = "middle" }, {} }, spans = { {}, {} },
  }
  if change then change(given) end
  return given
end
local function loads(bridge, span)
  local all, sum = {}, 0
  for _, side in ipairs { "left", "right" } do
    for k in ipairs(bridge.lines) do
      all[#all + 1] = -bridge.bearings[span][side][k].force_axial
      sum = sum + all[#all]
    end
  end
  return all, sum
end

-- A straight bridge: each bearing carries its share of the weight. Handles of a bridge for a script.
do
  local m = new()
  local bridge = m:bridge(tables(function(b) b.skew = 0 end))
  assert(m:consolidate { rest = { ratio = 1e-5 }, duration = 30 }.rests)
  local weight = 1.5e5*24.9
  near(bridge.spans.S1.mass*g, weight, 1e-9, "weight")
  for _, span in ipairs { "S1", "S2" } do
    for _, load in ipairs(loads(bridge, span)) do near(load, weight/6, 1e-4, "a sixth of the deck") end
  end
  assert(#bridge.spans == 2 and #bridge.supports == 3 and #bridge.lines == 3 and bridge.lines[3] == "g3")
  assert(bridge.supports.middle == bridge.supports[2] and bridge.supports.A2.name == "A2")
  assert(bridge.grounds.A0.name == "A0.ground" and bridge.grounds[2].name == "middle.ground")
  local bearing = bridge.bearings.S2.left.g1
  assert(bearing.name == "S2.left.g1" and bearing == m.bearings["S2.left.g1"] and bearing == bridge.bearings[2].left[1])
  local place = bridge.places.S2.left.g1
  near(place[1], 25 + 0.05 + 0.3, 1e-12, "the middle of the seat")
  assert(place[2] == -3.2 and place[3] == 0)
  near(bridge.seats.S1.right.g2.length, 0.6, 2e-3, "seat along")
  near(bridge.side_seats.S1.right.right.length, 5 - 3.2, 1e-4, "seat to the right")
  assert(bridge.side_seats.S1.left.left.name == "S1.left leftward" and #m.seats == 12 + 8 and #m.bearings == 12)
  assert(bridge.spans.S1.groups[1] == "spans" and bridge.supports.middle.groups[1] == "piers")
  near(bridge.axes.A2, 50, 1e-12, "axis")
end

-- With a skew the weight is the same, and obtuse corners carry more than acute ones if supports are flexible in
-- rotation.
do
  local m = new()
  local bridge = m:bridge(tables(function(b)
    b.abutment.foundation, b.pier.foundation = { soil = 60e6, beta = 0.02 }, { soil = 60e6, beta = 0.02 }
  end))
  assert(m:consolidate { rest = { ratio = 1e-5 }, duration = 30 }.rests)
  local all, sum = loads(bridge, "S1")
  near(sum, 1.5e5*24.9, 1e-4, "weight on skewed bearings")
  assert(all[3] > 1.1*all[1] and all[4] > 1.1*all[6],
    "the obtuse corners: left at the left end, right at the right one")
  near(bridge.seats.S1.right.g2.length, 0.6*math.cos(0.4), 1e-2, "a seat is measured square to its edge")
  -- A rigid disc on a half space: the stiffnesses of a footing of 4 m x 9 m.
  local r = math.sqrt(4*9/math.pi)
  local carried = -bridge.foundations.middle[1].force_axial
  near(carried/bridge.foundations.middle[1].displacement_axial, -4*60e6*r/0.65, 1e-3, "the ground's stiffness")
  near(carried, bridge.supports.middle.mass*g + 1.5e5*24.9, 1e-4, "what the pier's ground carries")
end

-- Shaken along its axis, a skewed deck that strikes its abutments rotates against the skew (Maragakis and Jennings
-- 1987). An impact at the obtuse corner causes this rotation if sin(2 skew) > 2 breadth/length (Dimitrakopoulos 2011).
-- Its mirror image rotates the other way by as much, and a straight deck not at all.
local function struck(skew, length, breadth, way)
  local m = trilith.model { name = "one span", dim = 3 }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5e8, ks = 2e8, mu = 0, beta = 2e-4 } }
  local slide = m:bearing_type { name = "slide", height = 0.1, axial = stiff,
                                 horizontal = trilith.friction { mu = 0.02, stiffness = 5e7 } }
  local bridge = m:bridge {
    gap = 0.05, seat = 0.6, breadth = breadth, skew = skew, material = "concrete",
    girders = { count = 2, spacing = 0.6*breadth, breadth = 0.6 },
    abutment = { height = 5, width = 3, back_wall_height = 1.5, support = "fixed" },
    span = { length = length, depth = 1.5, slab = 0.3, left = slide, right = slide }, supports = { {}, {} },
      spans = { {} },
  }
  m:consolidate { rest = { ratio = 1e-4 } }
  local pulse = trilith.motion { acceleration = { 0, 3*way, 0, -3*way, 0, 3*way, 0, -3*way, 0 }, dt = 0.15 }
  m:shake { motions = bridge:motions { x = pulse }, duration = 1.5 }
  return bridge.spans.S1.rotation_z
end
do
  local turned = struck(0.5, 30, 10, 1)
  assert(turned < -0.02, turned)
  near(struck(-0.5, 30, 10, 1), -turned, 1e-6, "the mirror image")
  near(struck(0.5, 30, 10, -1), turned, 1e-6, "struck at the other end")
  assert(math.abs(struck(0, 30, 10, 1)) < 1e-9)
  local wide = struck(0.5, 14, 20, 1)
  assert(math.abs(wide) < 0.05*math.abs(turned), wide)
end

-- Shaken across: without keys the deck leaves its bearings and slides sideways; solid keys and breakable ones hold it.
local function shaken_across(change, threads)
  local m = new(threads)
  local bridge = m:bridge(tables(function(b)
    b.abutment.breadth, b.pier.breadth, b.skew, b.span.left, b.span.right = 10.6, 10.6, 0, "slick", "slick"
    if change then change(b) end
  end))
  m:consolidate { rest = { ratio = 1e-4 }, duration = 30 }
  m:checkpoints { on = true, every = 0.5 }
  local pulse = trilith.motion { acceleration = { 0, 8, 0, -8, 0 }, dt = 0.3 }
  m:shake { motions = bridge:motions { y = pulse, velocity = 500 }, duration = 1.5 }
  return bridge.spans.S1.uy - bridge.supports.A0.uy, m, bridge
end
do
  local free, m = shaken_across()
  assert(math.abs(free) > 0.1, free)
  local _, other = shaken_across(nil, 2)
  local hash = m.hash
  assert(other.hash == hash, "the same bits with two threads")
  m:rewind(0.7)
  m:continue()
  assert(m.hash == hash, "gone back and on again: the same bits")
  local held = shaken_across(function(b)
    local key = { gap = 0.05, height = 0.6, breadth = 0.5 }
    b.abutment.shear_key, b.pier.shear_key = key, key
  end)
  assert(math.abs(held) < 0.06, held)
  local law = trilith.shear_key { stiffness = 1e9, strength = 1e5 }
  local _, _, bridge = shaken_across(function(b) b.abutment.shear_key = { law = law } end)
  assert(bridge.keys.S1.left.name == "S1.left.key" and not bridge.keys.S1.right)
  assert(bridge.keys.S1.left.status ~= "intact", bridge.keys.S1.left.status)
end

-- Columns and girders as members: the weight arrives at the feet, and members report their forces.
do
  local m = new()
  local column = trilith.rectangle_section { width = 1, depth = 1 }
  local girder = trilith.i_section { depth = 1.5, web = 0.2, top_width = 0.6, top_thickness = 0.2, bottom_width = 0.6,
                                     bottom_thickness = 0.25 }
  local bridge = m:bridge(tables(function(b)
    b.pier.section, b.pier.column_breadth, b.pier.divisions, b.skew = column, nil, 3, 0.2
    b.pier.foundation, b.pier.footing_weight = { soil = 60e6, beta = 0.01 }, 1e6
    b.spans[2] = { section = girder, divisions = 4, diaphragm = { section = column, count = 2 } }
    b.span.depth, b.span.slab, b.span.diaphragm = nil, nil, nil
    b.spans[1] = { depth = 1.5 }
  end))
  assert(bridge.supports.middle.kind == "frame" and bridge.spans.S2.kind == "frame" and #bridge.foundations.middle == 2)
  m:consolidate { integrator = "static" }
  local carried = 0
  for _, foot in ipairs(bridge.foundations.middle) do carried = carried - foot.force_axial end
  -- The deck's ends on S2 are set back: its weight is still computed from end to end.
  near(carried, bridge.supports.middle.mass*g + 1.5e5*24.9, 2e-3, "what both feet carry")
  local forces = bridge.supports.middle:forces "column1"
  assert(forces[1].normal < -1e5, forces[1].normal)
  assert(bridge.spans.S2:forces("diaphragm1.1") and bridge.spans.S2:forces("g2.1"))
end

-- Motions: one for all supports, one for each, delayed by a list or by a passing wave; motions of bridges without
-- movable supports are rejected.
local function refused(pattern, f, ...)
  local good, message = pcall(f, ...)
  message = tostring(message)
  if good or not message:find(pattern, 1, true) then error(("not '%s': %s"):format(pattern, message), 2) end
  assert(not message:find "\n", message)
end
do
  local m = new()
  local bridge = m:bridge(tables())
  local a = trilith.motion { acceleration = { 0, 1, 0 }, dt = 0.1 }
  local rows = bridge:motions { x = a, z = { a, a, a } }
  assert(#rows == 3 and rows[2].body == bridge.grounds.middle and rows[2].x == a and rows[3].y == nil)
  assert(#bridge:motions { y = a, delay = { 0, 0.1, 0.2 } } == 3)
  refused("motions: unknown key 'w'; known: delay, velocity, x, y, z", bridge.motions, bridge, { w = a })
  refused("motions: 'x' is 3, must be a motion", bridge.motions, bridge, { x = 3 })
  refused("motions: 'x' lists 2 motions for 3 supports", bridge.motions, bridge, { x = { a, a } })
  refused("motions: gives no motion", bridge.motions, bridge, {})
  refused("motions: 'velocity' is 0 m/s, must be above 0", bridge.motions, bridge, { x = a, velocity = 0 })
  refused("motions: both velocity and delay", bridge.motions, bridge, { x = a, velocity = 1, delay = { 0, 0, 0 } })
  refused("motions: delay 2 is -1, must be a number of seconds", bridge.motions, bridge, { x = a, delay = { 0, -1,
    0 } })
  refused("motions: 'delay' lists 1 delays for 3 supports", bridge.motions, bridge, { x = a, delay = { 1 } })
end

-- Rejected input.
local function bridge_with(change)
  local m = new()
  return m.bridge, m, tables(change)
end
local function walk(places, values)
  for path, keys in pairs(places) do
    for key in keys:gmatch "%S+" do
      for _, value in ipairs(values) do
        refused(("'%s' is "):format(key), bridge_with(function(b)
          local t = b
          for part in path:gmatch "%S+" do
            t[part] = t[part] or {}
            t = t[part]
          end
          t[key] = value
        end))
      end
    end
  end
end
walk({ [""] = "gap seat breadth skew x soffit_level", girders = "spacing breadth",
       abutment = "height width back_wall_height breadth seat gap skew",
       pier = "height stem_width stem_breadth cap_thickness footing_width footing_breadth footing_thickness "
         .. "column_spacing column_breadth footing_weight",
       span = "length depth slab weight_per_length", ["span diaphragm"] = "thickness depth",
       ["pier shear_key"] = "gap height breadth limit", ["pier foundation"] = "soil poisson beta",
       ground = "thickness margin" }, { 0/0, math.huge, "text", {}, true })
walk({ [""] = "gap seat breadth", girders = "spacing breadth",
  abutment = "height width back_wall_height breadth seat gap",
       pier = "height stem_width cap_thickness footing_width footing_thickness column_spacing column_breadth",
       span = "length depth slab weight_per_length", ["span diaphragm"] = "thickness depth",
       ["pier shear_key"] = "gap height breadth", ["pier foundation"] = "soil poisson beta",
       ground = "thickness margin" }, { -1 })
walk({ [""] = "seat breadth", girders = "spacing breadth count", abutment = "height width",
  span = "length depth slab" },
  { 0 })
walk({ girders = "count", pier = "columns divisions", ["span diaphragm"] = "count" }, { -1, 1.5, 0/0, "two", 1e9 })
walk({ pier = "section cap_section", span = "section" }, { 1, "steel", {}, stiff })
walk({ ["pier shear_key"] = "law", ["pier foundation"] = "along axial horizontal" }, { 1, "steel", {} })
walk({ [""] = "supports spans abutment pier span" }, { 1, "text", true })
refused("bridge: 'skew' is 1.5708 rad, must not be above 1.309 rad; 30*deg is 30 degrees",
  bridge_with(function(b) b.skew = math.pi/2 end))
refused("'skew' is 30 rad", bridge_with(function(b) b.supports[2].skew = 30 end))
refused("bridge: takes a table", new().bridge, new())
refused("bridge: unknown key 'suports'; did you mean 'supports'?", new().bridge, new(), { suports = {} })
refused("bridge: 2 spans and 2 supports", bridge_with(function(b) b.supports[3] = nil end))
refused("span 1 is 3, must be a table", bridge_with(function(b) b.spans[1] = 3 end))
refused("pier 'middle': unknown key 'hight'; did you mean 'height'?",
  bridge_with(function(b) b.supports[2].hight = 1 end))
refused("left names 4 types of bearings for 3 girder lines",
  bridge_with(function(b) b.spans[1].left = { "pad", "pad", "pad", "pad" } end))
refused("left: there is no bearing type 'pd'; did you mean 'pad'?", bridge_with(function(b) b.spans[1].left = "pd" end))
refused("right is nil, must be the name of a bearing type", bridge_with(function(b) b.span.right = nil end))
refused("bearings 0.1 and 0 m high sit on its top", bridge_with(function(b) b.spans[2].left = "flush" end))
refused("lines 1 and 2 at y = -0.5 and 0 m are not farther apart than the breadth of a girder",
  bridge_with(function(b) b.girders = { at = { -0.5, 0 }, breadth = 0.6 } end))
refused("line 1 at y = -6 m with a girder 0.6 m broad reaches beyond the deck",
  bridge_with(function(b) b.girders.spacing = 6 end))
refused("both at and count or spacing are given", bridge_with(function(b) b.girders.at = { 0 } end))
refused("place 1 of 'at' is the text 'x'", bridge_with(function(b) b.girders = { at = { "x" }, breadth = 1 } end))
refused("has no seat on it", bridge_with(function(b) b.pier.breadth = 6 end))
refused("must be above seat and joint together, 0.7 m", bridge_with(function(b) b.abutment.width = 0.5 end))
refused("must be above footing, cap and bearings together", bridge_with(function(b) b.pier.height = 2 end))
refused("footing width is 0.5 m, must not be below the stem width of 1 m",
  bridge_with(function(b) b.pier.footing_width = 0.5 end))
refused("columns stand up to 10.5 m from the middle, beyond the cap",
  bridge_with(function(b) b.pier.column_spacing = 20 end))
refused("'section' is given, but no columns", bridge_with(function(b)
  b.pier.columns, b.pier.column_spacing, b.pier.column_breadth = nil, nil, nil
  b.pier.section = trilith.rectangle_section { width = 1, depth = 1 }
end))
refused("of deck, which must be above the 1.2 m of both seats", bridge_with(function(b) b.spans[1].length = 1 end))
refused("slab is 2 m, must be below the depth of 1.5 m", bridge_with(function(b) b.span.slab = 2 end))
refused("the deck is solid; give the slab", bridge_with(function(b) b.span.slab = nil end))
refused("depth is 2 m, must not be above the girders'", bridge_with(function(b) b.span.diaphragm.depth = 2 end))
refused("both weight_per_length and mass are given", bridge_with(function(b) b.spans[1].mass = 1 end))
refused("would reach into the slab of 'S1'",
  bridge_with(function(b) b.abutment.shear_key = { gap = 0.1, height = 1.4, breadth = 0.3 } end))
refused("shear keys next to the girders need 11.2 m",
  bridge_with(function(b) b.abutment.shear_key = { gap = 0.1, height = 1, breadth = 2 } end))
refused("'height' is missing; give gap, height and breadth, or a law",
  bridge_with(function(b) b.abutment.shear_key = { gap = 0.1, breadth = 2 } end))
refused("gives neither soil nor a law", bridge_with(function(b) b.pier.foundation = {} end))
refused("both soil and 'along' are given", bridge_with(function(b) b.pier.foundation = { soil = 1e7,
  along = soft } end))
refused("has a foundation, but no ground",
  bridge_with(function(b) b.ground = nil; b.pier.foundation = { soil = 1e7 } end))
refused("both ground and support are given", bridge_with(function(b) b.pier.support = "fixed" end))
refused("its ground and the ground of 'A0' would overlap", bridge_with(function(b) b.ground.margin = 20 end))
refused("'ground' is 3, must be a table", bridge_with(function(b) b.ground = 3 end))
refused("bridge: pier 2 is nil, must be a table", bridge_with(function(b)
  b.supports = { b.supports[1], nil, b.supports[3] }
end))
refused("span 'middle': there is already a support with that name",
  bridge_with(function(b) b.spans[1].name = "middle" end))
refused("'gap' is nan, must be a finite number", bridge_with(function(b) b.gap = 0/0 end))
refused("ground: 'margin' is -1 m", bridge_with(function(b) b.supports[3].ground = { margin = -1 } end))
refused("pier 'middle': ground: there is no body 'nowhere'", bridge_with(function(b)
  b.supports[2].ground = "nowhere"
end))

-- A bearing that carries a deck and slides without limit gets a note; a limit along, or a law that holds, avoids it.
do
  local function notes(type)
    local m = trilith.model { dim = 3 }
    type.name, type.axial, type.height = "kind", stiff, 0.1
    m:bearing_type(type)
    return m.notes
  end
  local told = notes { across = soft, limit = { across = 0.1 } }
  assert(#told == 1 and told[1] == "bearing type 'kind': supports the deck at any displacement along, even beyond "
    .. "the edge of its seat; to end it there, give limit = { along = the length of the seat }", told[1])
  assert(#notes { across = soft } == 1 and #notes { across = soft, limit = { along = 0.3 } } == 0)
  assert(#notes { along = soft } == 0 and #notes { horizontal = soft } == 0)
end

-- A bridge may be added to a model that has run: completely, or not at all.
do
  local m = new()
  m:bridge(tables(function() end))
  m:consolidate { rest = { ratio = 1e-3 } }
  local before = #m:bodies {}
  local function second(change)
    return tables(function(b)
      b.x = 200
      for i, s in ipairs(b.supports) do s.name = "Q" .. i end
      for i, v in ipairs(b.spans) do v.name = "T" .. i end
      if change then change(b) end
    end)
  end
  refused("'weight' is -3 N", m.bridge, m, second(function(b)
    b.span.weight_per_length, b.spans[2].weight = nil, -3
  end))
  assert(#m:bodies {} == before)
  local bridge = m:bridge(second())
  m:run { duration = 3, rest = true, local_damping = 0.8 }
  local carried = 0
  for _, laid in ipairs(bridge.bearings.T1.left) do carried = carried - laid.force_axial end
  near(carried, 0.5*m:body "T1".mass*g, 0.02, "half of the deck's weight")
  m:close()
end

-- A rejected bridge leaves nothing behind: the model then accepts the correct one and consolidates.
do
  local m = new()
  local function count() return #m:bodies {} + #m.bearings + #m.seats end
  local before = count()
  for text, change in pairs {
    ["there is no material 'steel'"] = function(b) b.supports[3].material = "steel" end,
    ["'weight' is -3 N"] = function(b) b.span.weight_per_length, b.spans[2].weight = nil, -3 end,
    ["there is no body 'nowhere'"] = function(b) b.supports[3].ground = "nowhere" end,
    ["would overlap"] = function(b) b.ground.margin = 20 end,
  } do
    refused(text, m.bridge, m, tables(change))
    assert(count() == before, text)
  end
  m:bearing_type { name = "once", height = 0.1, axial = trilith.linear { stiffness = 2e9 } }
  m:bridge(tables(function() end))
  m:consolidate { rest = { ratio = 1e-3 } }
  assert(#m:bodies {} == 8)
  m:close()
end
refused("there are two supports with that name", bridge_with(function(b) b.supports[3].name = "middle" end))
refused("there are two spans with that name", bridge_with(function(b) b.spans[1].name = "S2" end))
refused("'footing_weight' is missing", bridge_with(function(b)
  b.pier.section, b.pier.column_breadth = trilith.rectangle_section { width = 1, depth = 1 }, nil
  b.pier.foundation = { soil = 1e7 }
end))
refused("has no ground of the bridge", function()
  local m = new()
  m:bridge(tables(function(b) b.ground = nil end)):motions { x = trilith.motion { acceleration = { 0, 1, 0 },
    dt = 0.1 } }
end)
local e = new()
refused("bearing type 'x': 'limit' is given, but no law", e.bearing_type, e, { name = "x", limit = { along = 1 } })
refused("bearing type 'x': 'height' is given, but no law that supports", e.bearing_type, e,
  { name = "x", height = 1, across = soft })
refused("bearing type 'x': unknown key 'acros'; did you mean 'across'?", e.bearing_type, e, { name = "x",
  acros = soft })
refused("bearing type 'pad': exists already", e.bearing_type, e, { name = "pad" })
