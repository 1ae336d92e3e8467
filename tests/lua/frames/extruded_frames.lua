-- Frames and triangle meshes of the plane converted to space by m:extruded, and bearings that act in one sense of
-- rotation only.
local trilith = require "trilith"

--- Whether `value` is within `share` of `size` of the expected value.
local function near(value, expected, share, size)
  local off = math.abs(value - expected)
  if off ~= off or off > share*(size or math.abs(expected)) then
    error(("%.9g, expected %.9g"):format(value, expected), 2)
  end
end
local friction = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.5, beta = 1e-4 }
local steel, stone = { name = "steel", density = 7850, E = 2e11, nu = 0.3 }, { name = "stone", density = 2400 }
local function model(options)
  local m = trilith.model(options)
  m:material(steel)
  m:material(stone)
  m:contact { between = { "*", "*" }, law = friction }
  return m
end
--- Results of `go` for both models; `up` returns the height, `turn` the rotation of a body.
local function both(m, go)
  local space = m:extruded()
  return go(m, function(b) return b.y end, function(b) return b.rotation end),
    go(space, function(b) return b.z end, function(b) return -b.rotation_y end)
end
local function compare(flat, space, share)
  for i, v in ipairs(flat) do near(space[i], v, share) end
end

-- A shaken portal with fixed and pinned feet and a beam with a point mass: elastic, with hinges, with fibres, with
-- shear, with a joint block and members whose ends are offset from another member.
local rectangle = trilith.rectangle_section { width = 0.1, depth = 0.2 }
local given = trilith.section { area = 0.02, inertia = 6e-5, depth = 0.2 } -- has no bending stiffness across
local fibres = trilith.fibre_section { shape = rectangle, law = trilith.bilinear_steel { E = 2e11, yield = 2.4e8,
  hardening = 0.01 }, layers = 10 }
local cases = {
  { section = rectangle }, { section = given }, { section = rectangle, shear = true },
  { section = rectangle, hinge = trilith.end_hinge { sagging = 1e5, hardening = 1e6 } }, { section = fibres },
  { section = rectangle, blocks = true },
}
for _, case in ipairs(cases) do
  local m = model { name = "portal", thickness = 0.3 } -- of members and of the block
  local function member(from, to)
    return { from = from, to = to, section = case.section, shear = case.shear, hinge = case.hinge, divisions = 4,
      to_at = case.blocks and to == "C" and { 4, 2.9 } or nil }
  end
  m:frame { name = "portal", material = "steel",
    joints = { A = { at = { 0, 0 }, support = "fixed" },
      B = case.blocks and { outline = { { -0.2, 2.8 }, { 0.2, 2.8 }, { 0.2, 3.2 }, { -0.2, 3.2 } } } or { 0, 3 },
      C = { at = { 4, 3 }, mass = 2e4, inertia = 10 },
      D = { at = { 4, 0 }, support = { x = "fixed", y = "fixed" } } },
    members = { member("A", "B"), member("B", "C"), member("D", "C") } }
  local flat, space = both(m, function(any, up)
    local portal, sway, sag = any:body "portal", 0, 0
    any:point_load { body = "portal", at = "B", force = any.dim == 3 and { 6e4, 0, 0 } or { 6e4, 0 } }
    any:on_step(function() sway, sag = math.max(sway, (portal:point "B")), math.min(sag, up(portal)) end)
    any:run { duration = 0.2, dt = 1e-5 }
    return { sway, sag }
  end)
  assert(flat[1] > 0.02, flat[1])
  compare(flat, space, case.section == fibres and 2e-3 or 1e-6)
end

-- A block falls onto a beam that lies on two others: contact over the thickness, whatever the section.
do
  local m = model { name = "shelf", thickness = 0.4 }
  for i, x in ipairs { 0, 2.9 } do
    m:block { name = "wall" .. i, width = 0.2, height = 1, at = { x, -1.05 }, material = "stone", support = "fixed" }
  end
  m:beam { name = "shelf", from = { 0, 0 }, to = { 3.1, 0 }, material = "steel", divisions = 8,
    section = trilith.rectangle_section { width = 0.05, depth = 0.1 } }
  m:block { name = "weight", width = 0.5, height = 0.5, at = { 1.3, 0.1 }, material = "stone", floating = true }
  local flat, space = both(m, function(any, up)
    local weight, low = any:body "weight", 1
    any:on_step(function() low = math.min(low, up(weight)) end)
    any:run { duration = 0.3 }
    return { 0.35 - low }
  end)
  assert(flat[1] > 0.05, flat[1])
  near(space[1], flat[1], 0.01)
end

-- With free out-of-plane motion, a section given by numbers needs its bending stiffness across; a section with a shape
-- has it.
do
  local m = model { name = "mast", thickness = 0.1 }
  m:beam { name = "mast", from = { 0, 0 }, to = { 0, 2 }, from_support = "fixed", section = given, material = "steel" }
  local fine, message = pcall(function() m:extruded { held = false } end)
  assert(not fine and message:find("without a torsion constant", 1, true), message)
  local n = model { name = "mast", thickness = 0.1 }
  n:beam { name = "mast", from = { 0, 0 }, to = { 0, 2 }, from_support = "fixed", section = rectangle,
    material = "steel" }
  local free = n:extruded { held = false }
  free:point_load { body = "mast", at = "to", force = { 0, 1e3, 0 }, load_curve = { smooth = 0.5 } }
  free:run { duration = 1.5, local_damping = 0.3 }
  local _, y = free:body("mast"):point "to"
  near(y, 1e3*2^3/(3*2e11*0.2*0.1^3/12), 0.02) -- bends about its weak axis: 0.2 deep, 0.1 wide
end

-- Triangles, alone and with a quadrilateral, become wedges and bricks and deform as in the plane. In plane stress each
-- of these few elements has its own thickness; in space the thickness is a displacement of the nodes.
local triangles = { { 1, 2, 5 }, { 1, 5, 4 }, { 2, 3, 6 }, { 2, 6, 5 }, { 4, 5, 8 }, { 4, 8, 7 }, { 5, 6, 9, 8 } }
for _, plane in ipairs { "strain", "stress" } do
  local m = model { name = "plate", thickness = 0.05, gravity = { 3, -9.81 } }
  m:material { name = "soft", density = 2400, E = 5e6, nu = 0.3, plane = plane }
  m:body { name = "plate", material = "soft", hold = { { from = { 0, 0 }, to = { 0.6, 0 } } },
    mesh = { elements = triangles,
    nodes = { { 0, 0 }, { 0.3, 0 }, { 0.6, 0 }, { 0, 0.5 }, { 0.32, 0.55 }, { 0.6, 0.5 }, { 0, 1.1 }, { 0.3, 1 },
      { 0.6, 1.2 } } } }
  local flat, space = both(m, function(any, up)
    local b = any:body "plate"
    local start, low, most = up(b), up(b), b.x
    any:on_step(function() low, most = math.min(low, up(b)), math.max(most, b.x) end)
    any:run { duration = 0.2 }
    return { start - low, most - 0.3 }
  end)
  assert(flat[1] > 1e-3 and flat[2] > 3e-3)
  compare(flat, space, plane == "strain" and 1e-4 or 0.02)
end

-- A bearing that resists a single sense of rotation resists the same one in space.
for _, side in ipairs { 1, -1 } do
  local m = model { name = "flap", thickness = 0.5, gravity = { 0, 0 } }
  m:block { name = "post", width = 0.4, height = 1, at = { -0.4, 0 }, material = "stone", support = "fixed" }
  m:block { name = "flap", width = 1, height = 0.1, at = { 0.1, 0.45 }, material = "stone", floating = true, spin = 2 }
  m:bearing { name = "hinge", between = { "post", "flap" }, from = { 0, 0.5 }, to = { 0.1, 0.5 },
    along = trilith.linear { stiffness = 1e7 }, axial = trilith.linear { stiffness = 1e7 },
    turning = trilith.gap { stiffness = 2e4, opening = 0.01, side = side } }
  local flat, space = both(m, function(any, _, turn)
    local flap, most = any:body "flap", 0
    any:on_step(function() most = math.max(most, turn(flap)) end)
    any:run { duration = 0.2, dt = 2e-5 }
    return { most, turn(flap) }
  end)
  assert(side < 0 and flat[1] > 0.08 or side > 0 and flat[1] < 0.07, flat[1])
  compare(flat, space, 1e-4)
end
