return {
  name = "geometry", title = "Builders: parts of masonry and bridges",
  has_makers = true,
  { "model:span", "A deck on two supports, which give its position, seats and bearings; or a deck alone, between "
    .. "x0 and x1. Seats, and bearings of types with a law, have names such as \"S1.left\": span.seats.left, "
    .. "span.bearings.right.", keys = [[
name               text = "span"  name
from               body?          left support: an abutment, a pier or a body with a horizontal top
to                 body?          right support
left               text?          with from and to: bearing type on the left support, see model:bearing_type
right              text?          with from and to: bearing type on the right support
gap                number m?      joint on supports without a gap of their own  <at least 0>
depth              number m       height of the deck  <above 0>
soffit_level       number m = on its left bearing  level of the underside
weight_per_length  number N/m?    weight of the deck over its full length; or weight, mass, density  <above 0>
x0                 number m?      deck alone: axis of the left support
x1                 number m?      deck alone: axis of the right support
end_gap            number m = 0   distance from the axis to the end of the deck  <at least 0>]],
    with = "body", gives = "body" },
  { "model:bearing_type", "A type of bearing for the ends of spans. Without a law the deck slides on its seat, as on "
    .. "an expansion bearing.", keys = [[
name     text            name
height   number m = 0    height from the seat to the deck; above 0 an axial law is needed  <at least 0>
along    direction law?  law of the force along; alone it is a dowel, and the deck lies on its seat
axial    direction law?  law of the axial force on the deck; without height it replaces the flat contact
turning  direction law?  law of the moment
limit    table?          { along = , axial = , turning = }: displacements at failure
becomes  contact law?    contact law of deck and support after failure; or its name
contact  contact law?    contact law of deck and support from the start; or its name]], gives = "string" },
  { "model:bridge", "Simple spans on piers between two abutments, from two tables. The result has supports and "
    .. "spans: bodies, by number and by name.", keys = [[
supports      list          from left to right: name, height from ground to deck, keys of model:pier, model:abutment
spans         list          from left to right: name, length from axis to axis, keys of model:span
x             number m = 0  axis of the first support
soffit_level  number m = 0  underside of the decks; seats are lower by the height of their bearings
gap           number m?     default joint at supports  <at least 0>
seat          number m?     default length of seats  <at least 0>
material      text?         default material
abutment      table?        default keys of both abutments; back_wall_height counts from the underside of the deck
pier          table?        default keys of all piers
span          table?        default keys of all spans]], gives = "table" },
  { "model:level_ground", "Level ground under the whole model, in the plane and in space: one fixed body, ten times "
    .. "as large as the model, so that no body reaches its end. Also m:ground { level = , ... }. Call it after the "
    .. "bodies.",
    also = "ground plane, floor, soil, infinite ground", keys = [[
level     number m        height of its surface
material  text?           its material; without one the ground has 2000 kg/m3, which no result depends on
name      text = "ground"  name
groups    names?          groups; default "ground"
reach     number m?       distance from the bodies to its edges; default 10 times the size of the model  <above 0>]],
    gives = "body" },
  { "model:gmsh", "Bodies from the physical groups of a Gmsh mesh, version 4.1 or 2.2: of surfaces in the plane, of "
    .. "volumes in space. Each connected part of a group is a body with the name of the group, or name.1, name.2, ..., "
    .. "and belongs to the group of this name. Each surface or volume must be in one group with a name. Returns the "
    .. "set of bodies.",
    also = "mesh, import, finite elements, physical surface, physical volume", keys = [[
file         text             path, from the current folder or from the folder of the script
scale        number = 1       factor of the coordinates in the file, to m  <above 0>
name         text?            prefix of the names of bodies
material     text?            material
groups       names?           further groups of all bodies
fixed        names?           physical groups whose bodies are fixed
by_group     table?           { group = { keys of bodies } }: keys for the bodies of a physical group
density      number kg/m3?    density instead of the material's; or  <above 0>
unit_weight  number N/m3?     unit weight  <above 0>
support      text or table?   support of the bodies, as in model:body
velocity     vector?          velocity at the start [m/s]
floating     flag = false     they need no support at the start
body         text?            "rigid": rigid bodies of these pieces
hold         table?           boxes whose nodes are held, as in model:body]], gives = "set" },
  { "trilith.dxf", "Closed outlines of an ASCII DXF drawing as parts for m:add. Outlines are closed polylines, "
    .. "circles, and lines, arcs and open polylines of a layer whose ends meet, also of inserted blocks. A part has "
    .. "its layer as name and group; blanks become underscores. The fields open and skipped count open chains and "
    .. "entities of other types.",
    also = "CAD, AutoCAD, drawing, facade, import", keys = [[
file          text           path, from the current folder or from the folder of the script
unit          text?          "mm", "cm", "dm", "m", "in" or "ft"; default: $INSUNITS of the file
layers        names?         layers to read; default all
origin        point = {0, 0}  point of the drawing that becomes the origin, in m
arc_segments  integer = 4    chords per quarter circle of an arc  <1 to 1000>
tolerance     number m = 0.0001  largest distance of ends that meet  <above 0>]], gives = "part[]" },
  examples = {
    ["trilith.dxf"] = [[
local path = os.tmpname() .. ".dxf"
local file = io.open(path, "w")
file:write("0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\nstone\n90\n4\n70\n1\n10\n1\n20\n0",
  "\n10\n2\n20\n0\n10\n2\n20\n1\n10\n1\n20\n1\n0\nENDSEC\n0\nEOF\n")
file:close()
m:add(trilith.dxf { file = path, unit = "m" }, { material = "stone" })]],
    ["model:gmsh"] = [[
local path = os.tmpname() .. ".msh"
local file = io.open(path, "w")
file:write "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"pier\"\n$EndPhysicalNames\n"
file:write "$Nodes\n4\n1 3 0 0\n2 4 0 0\n3 4 2 0\n4 3 2 0\n$EndNodes\n"
file:write "$Elements\n1\n1 3 2 1 1 1 2 3 4\n$EndElements\n"
file:close()
m:gmsh { file = path, material = "stone", body = "rigid", fixed = "pier" }
print(m:body "pier".mass)]],
    ["model:level_ground"] = [[
m:block { name = "upper", width = 0.4, height = 0.5, at = { 0, 1 }, material = "stone" }
m:level_ground { level = -1, material = "stone", name = "plain" }]],
    ["model:ground"] = [[
m:ground { name = "valley", surface = { { 10, 0 }, { 20, -6 }, { 30, 0 } }, base_level = -10, material = "stone",
  support = "fixed" }]],
    ["model:pier"] = [[
m:pier { name = "P1", station = 12, height = 8, stem_width = 1.2, seat = 0.6, gap = 0.1, material = "stone" }]],
    ["model:abutment"] = [[
m:abutment { name = "A0", side = "left", station = 10, height = 4, width = 3, seat = 0.6, gap = 0.1,
  back_wall_height = 1.5, material = "stone" }]],
    ["model:span"] = [[
local left = m:abutment { name = "A0", side = "left", station = 10, height = 4, width = 3, seat = 0.6, gap = 0.1,
  back_wall_height = 1.5, material = "stone" }
local pier = m:pier { name = "P1", station = 25, height = 4, seat = 0.6, gap = 0.1, material = "stone" }
m:bearing_type { name = "sliding" }
local span = m:span { name = "S1", from = left, to = pier, left = "sliding", right = "sliding", depth = 1.5,
  material = "stone" }
print(span.seats.left.length)]],
    ["model:bearing_type"] = [[
m:contact { between = { "ground", "block" }, name = "sliding",
  law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.1, beta = 2e-4 } }
m:bearing_type { name = "dowel", along = trilith.linear { stiffness = 2e8 }, limit = { along = 0.01 },
  becomes = "sliding" }]],
    ["model:bridge"] = [[
m:bearing_type { name = "sliding" }
local bridge = m:bridge {
  x = 10, soffit_level = 5, gap = 0.1, seat = 0.5, material = "stone",
  abutment = { height = 5, width = 4, back_wall_height = 1.5 }, pier = { height = 5 },
  span = { depth = 1.5, left = "sliding", right = "sliding" },
  supports = { { name = "A0" }, { name = "P1" }, { name = "A2" } },
  spans = { { name = "S1", length = 20 }, { name = "S2", length = 20 } } }
print(bridge.spans.S1.mass)]],
    ["model:harmonic_stack"] = [[
m:harmonic_stack { name = "leaning", count = 5, length = 0.4, height = 0.1, table_height = 0.5, material = "stone" }]],
    ["model:flying_buttress"] = [[
m:flying_buttress { name = "flyer", material = "stone" }]],
    ["model:running_bond"] = [[
m:running_bond { name = "panel", material = "stone" }]],
    ["model:bench_wall"] = [[
m:bench_wall { courses = 6, material = "stone" }]],
    ["trilith.build.span"] = [[
local deck = trilith.build.span { x0 = 0, x1 = 20, depth = 1.5, soffit_level = 6 }
m:add(deck, { material = "stone", floating = true })]],
    ["model:block"] = [[
m:block { name = "upper", width = 0.4, height = 0.5, at = { -0.2, 1 }, material = "stone" }]],
    ["model:stack"] = [[
m:stack { name = "pier", at = { 1, 0 }, material = "stone",
  blocks = { { width = 0.5, height = 0.5 }, { width = 0.4, height = 0.5 } } }]],
    ["model:arch"] = [[
m:arch { name = "arch", voussoirs = 9, radius = 0.8, thickness = 0.2, centre = { 4, 0 }, material = "stone",
  fixed = "abutments" }]],
    ["model:wall"] = [[
m:wall { name = "wall", length = 0.8, courses = 3, at = { 0.5, 0 }, material = "stone" }]],
    ["model:rubble"] = [[
m:rubble { name = "rubble", outline = { { 0.5, 0 }, { 1.5, 0 }, { 1.5, 0.5 }, { 0.5, 0.5 } },
  stones = 6, material = "stone" }]],
    ["model:polygon"] = [[
m:polygon { name = "wedge", outline = { { 1, 0 }, { 2, 0 }, { 1.5, 0.5 } }, material = "stone" }]],
  },
}
