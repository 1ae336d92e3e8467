-- Spans between supports: positions follow from the supports; complete bridges from tables; rejected input.
local trilith = require "trilith"
local linear = trilith.linear { stiffness = 5e7, damping = 1e5 }
local slide = trilith.frictional { name = "slide", kn = 1e9, ks = 5e8, mu = 0.05, beta = 1e-3 }

local function near(a, b, what) assert(math.abs(a - b) < 1e-9, ("%s: %.12g, not %.12g"):format(what, a, b)) end
local function new()
  local m = trilith.model { name = "bridge", thickness = 10 }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-4 } }
  m:ground { name = "ground", surface = { { -10, -6 }, { 60, -6 } }, base_level = -8, material = "concrete",
             support = "fixed" }
  m:bearing_type { name = "fixed", height = 0.1, along = linear, axial = linear, limit = { along = 0.2 },
                   becomes = slide }
  m:bearing_type { name = "expansion", contact = "slide" }
  m:bearing_type { name = "flush", along = linear, axial = trilith.linear { stiffness = 5e9, damping = 1e7 } }
  return m
end
local function refused(pattern, f, ...)
  local good, message = pcall(f, ...)
  message = tostring(message)
  assert(not good and message:find(pattern, 1, true), message)
  assert(not message:find "\n", message)
end

-- one span after the other
local m = new()
local A0 = m:abutment { name = "A0", station = 0, seat = 0.5, gap = 0.1, ground_level = -6, height = 5.9, width = 4,
                        back_wall_height = 1.6, material = "concrete" }
local P1 = m:pier { name = "P1", station = 20, seat = 0.5, gap = 0.2, ground_level = -6, height = 5.9,
                    footing_width = 6, footing_thickness = 1, material = "concrete" }
m:abutment { name = "A2", side = "right", station = 50, seat = 0.4, gap = 0.1, ground_level = -6, height = 6, width = 4,
             back_wall_height = 1.5, material = "concrete" }
local S1 = m:span { name = "S1", from = A0, to = "P1", left = "fixed", right = "fixed", depth = 1.2,
                    weight_per_length = 2e5, material = "concrete" }
assert(#m.bearings == 2 and #m.seats == 2 and m.bearings[2].name == "S1.right" and S1.groups[1] == "spans")
assert(S1.bearings.left == m.bearings["S1.left"] and S1.seats.right == m.seats["S1.right"] and P1.bearings == nil)
near(S1.outline[1][1], 0.05, "left end")
near(S1.outline[3][1], 19.9, "right end")
near(S1.outline[1][2], 0, "underside")
near(S1.mass*9.80665, 2e5*19.85, "weight")
refused("span 'S2': its underside is at y = 0 m, but on 'A2' (seat at 0 m, bearing type 'fixed' 0.1 m high) it would "
  .. "be at 0.1 m; make seats or bearings fit", m.span, m,
  { name = "S2", from = "P1", to = "A2", left = "fixed", right = "fixed", depth = 1.2 })
local S2 = m:span { name = "S2", from = P1, to = "A2", left = "fixed", right = "expansion", depth = 1.2,
                    material = "concrete" }
assert(S2.bearings.right == nil and S2.bearings.left.name == "S2.left" and #m.bearings == 3 and #m.seats == 4)
near(S1.seats.left.length, 0.5, "seat of S1")
near(S2.seats.right.length, 0.4, "seat of S2")
assert(m:consolidate { duration = 20 }.rests and not S2.seats.right.lost)
local carried = -S1.bearings.left.force_axial - S1.bearings.right.force_axial
assert(math.abs(carried - S1.mass*9.80665) < 1e-3*carried)
local contact = m:contacts { between = { S2, "A2" } }[1]
assert(contact.law == "slide", contact.law)
assert(S1.bearings.left.limited and not pcall(function() S1.bearings = {} end))

-- a bearing without height replaces the flat contact around it
local f = new()
for i = 0, 1 do
  f:pier { name = "P" .. i, station = 20*i, stem_width = 1, ground_level = -6, height = 6, material = "concrete" }
end
local flush = f:span { from = "P0", to = "P1", left = "flush", right = "flush", gap = 0.1, depth = 1,
                       material = "concrete" }
near(flush.seats.left.length, 0.45, "seat that is what the joint leaves of the top")
assert(flush.name == "span" and f:consolidate { duration = 20 }.rests)
assert(#f:contacts { between = { flush, "P0" } } == 0)

-- a dowel acts along the span and leaves the weight to the contact
local d = new()
for i = 0, 1 do
  d:pier { name = "P" .. i, station = 20*i, stem_width = 1, ground_level = -6, height = 6, material = "concrete" }
end
d:bearing_type { name = "dowel", along = linear }
local pinned = d:span { from = "P0", to = "P1", left = "dowel", right = "expansion", gap = 0.1, depth = 1,
                        material = "concrete" }
assert(d:consolidate { duration = 20 }.rests and #d.bearings == 1 and pinned.bearings.left.force_axial == 0)
local lies = 0
for _, c in ipairs(d:contacts { between = { pinned, "P0" } }) do lies = lies + c.normal end
assert(math.abs(lies - pinned.mass*9.80665/2) < 1e-3*lies, lies)

-- the same bridge from tables
local t = new()
local function tables()
  return {
    gap = 0.1, seat = 0.5, material = "concrete",
    abutment = { height = 6, width = 4, back_wall_height = 1.5 },
    pier = { footing_width = 6, footing_thickness = 1 },
    span = { depth = 1.2, left = "fixed", right = "fixed" },
    supports = { { name = "A0" }, { name = "P1", height = 6, gap = 0.2 }, { name = "A2", seat = 0.4 } },
    spans = { { name = "S1", length = 20 }, { name = "S2", length = 30 } },
  }
end
local bridge = t:bridge(tables())
assert(#bridge.supports == 3 and bridge.supports.P1 == bridge.supports[2] and bridge.spans.S2 == bridge.spans[2])
near(bridge.spans.S2.outline[1][1], 20.1, "left end of S2")
near(bridge.supports.P1.outline[6][2], -0.1, "seat of P1")
near(bridge.supports.A0.outline[4][2], 1.5, "back wall of A0")
near(bridge.spans.S2.seats.right.length, 0.4, "seat on A2")
assert(t:consolidate { duration = 20 }.rests)

-- rejected input, one line each
local function bridge_with(change)
  local e, given = new(), tables()
  change(given)
  return e.bridge, e, given
end
local e = new()
refused("bridge: unknown key 'suports'; did you mean 'supports'?", e.bridge, e, { suports = {} })
refused("bridge: 'spans' is missing", e.bridge, e, {})
refused("bridge: takes a table", e.bridge, e)
refused("bridge: 2 spans and 2 supports; there is one support more than spans",
  bridge_with(function(b) b.supports[3] = nil end))
refused("bridge: 'gap' is the text 'wide', must be a finite number in m", bridge_with(function(b) b.gap = "wide" end))
refused("span 'S1': 'length' is missing", bridge_with(function(b) b.spans[1].length = nil end))
refused("span 'S2': 'length' is -30 m, must be above 0", bridge_with(function(b) b.spans[2].length = -30 end))
refused("abutment 'A0': 'height' is missing", bridge_with(function(b) b.abutment.height = nil end))
refused("span 'S1': left: there is no bearing type 'fixd'; did you mean 'fixed'?",
  bridge_with(function(b) b.spans[1].left = "fixd" end))
refused("span 'S2': left is nil, must be the name of a bearing type, as returned by m:bearing_type",
  bridge_with(function(b) b.span.left = nil; b.spans[1].left = "fixed" end))
refused("span 'S1': 'length' is missing; is it misspelled as 'lenght'?",
  bridge_with(function(b) b.spans[1] = { name = "S1", lenght = 20 } end))
refused("pier 'P1': 'x' is given, but follows from lengths and heights of the bridge; leave it out",
  bridge_with(function(b) b.supports[2].x = 3 end))
refused("span 'S2': 'from' is given, but follows from", bridge_with(function(b) b.spans[2].from = "P1" end))
refused("abutment 'A0': 'seat' is missing; give a number in m, there or for the whole bridge",
  bridge_with(function(b) b.seat, b.supports[2].seat = nil, 0.5 end))
refused("pier 'P1': unknown key 'footing'", bridge_with(function(b) b.supports[2].footing = 3 end))

-- A bridge rejected at its last span leaves nothing behind: the correct bridge is then built as in a new model.
local again, wrong = new(), tables()
wrong.spans[2].depth = -1
refused("span 'S2': depth is -1", again.bridge, again, wrong)
assert(#again:bodies {} == 1 and #again.bearings + #again.seats == 0) -- the ground
local bare, slides = new(), tables()
slides.span.left, slides.span.right, slides.spans[2].depth = "expansion", "expansion", -1
refused("span 'S2': depth is -1", bare.bridge, bare, slides)
bare:run { duration = 0.01 } -- needs no contact law of a missing span
local made = again:bridge(tables())
assert(again:consolidate { duration = 20 }.rests)
assert(#again.bearings == #t.bearings and made.spans.S2.y == bridge.spans.S2.y)

-- and single spans, bearing types and supports
local function span_with(change)
  local n = new()
  n:pier { name = "P1", station = 0, seat = 0.5, gap = 0.1, ground_level = -6, height = 6, material = "concrete" }
  n:pier { name = "P2", station = 20, seat = 0.5, gap = 0.1, ground_level = -6, height = 6, material = "concrete" }
  local given = { name = "S1", from = "P1", to = "P2", left = "expansion", right = "expansion", depth = 1,
                  material = "concrete" }
  change(given, n)
  return n.span, n, given
end
refused("span 'S1': from: there is no support 'P3'; did you mean 'P1'?", span_with(function(s) s.from = "P3" end))
refused("span 'S1': 'to' is missing; give a pier, an abutment or another body, or its name",
  span_with(function(s) s.to = nil end))
refused("span 'S1': 'from' is 3, must be a pier", span_with(function(s) s.from = 3 end))
refused("span 'S1': from is abutment 'A', of which only the outline is known; make it with m:abutment",
  span_with(function(s, n)
    n:body { name = "A", material = "concrete", shape = trilith.abutment { x = 0, height = 5, width = 3 } }
    s.from = "A"
  end))
refused("span 'S1': from and to are both 'P2'", span_with(function(s) s.from = "P2" end))
refused("span 'S1': 'P1' at x = 0 m is not to the right of 'P2' at 20 m; from is the left support",
  span_with(function(s) s.from, s.to = "P2", "P1" end))
refused("span 'S1': 'x0' is given in addition to from and to", span_with(function(s) s.x0 = 1 end))
refused("span 'S1': 'weight_per_length' is -1 N/m, must be above 0",
  span_with(function(s) s.weight_per_length = -1 end))
refused("span 'S1': both weight_per_length and another weight", span_with(function(s)
  s.weight, s.weight_per_length = 1, 1
end))
refused("span 'S1': the seat on 'P1' to the right of its joint already carries span 'S0'; each seat carries one span",
  span_with(function(s, n)
    local other = {}
    for key, value in pairs(s) do other[key] = value end
    other.name = "S0"
    n:span(other)
  end))
refused("span 'span': 'from' is missing; give the supports from and to, or the places x0 and x1", e.span, e,
  { depth = 1 })
refused("span 'S1': 'left' needs from and to", e.span, e, { name = "S1", x0 = 0, x1 = 1, left = "fixed" })
refused("span 'S1': unknown key 'form'; did you mean 'from'?", e.span, e, { name = "S1", form = "P1" })
refused("bearing type 'fixed': exists already", e.bearing_type, e, { name = "fixed" })
refused("bearing type 'x': 'limit' is given, but no law", e.bearing_type, e, { name = "x", limit = { along = 1 } })
refused("bearing type 'x': 'height' is given, but no law that supports the deck; give axial",
  e.bearing_type, e, { name = "x", height = 0.1, along = linear })
refused("bearing type 'x': becomes: there is no contact law 'slid'; did you mean 'slide'?", e.bearing_type, e,
  { name = "x", along = linear, becomes = "slid" })
refused("abutment 'A': both x and station are given; keep one", e.abutment, e,
  { name = "A", x = 1, station = 1, seat = 1, gap = 0, height = 1, width = 3 })
refused("pier 'P': 'stem_width' is missing", e.pier, e, { name = "P", station = 0, height = 5 })
