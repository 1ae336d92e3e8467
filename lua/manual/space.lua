return {
  name = "space", title = "Models in space: dim = 3", has_makers_in_space = true,
  shared = {
    solid = [[
material     text?            material
groups       names?           groups of the body
density      number kg/m3?    density instead of the material's; or  <above 0>
unit_weight  number N/m3?     unit weight; or  <above 0, at most 225553>
mass         number kg?       mass; or  <above 0>
weight       number N?        weight  <above 0>
inertia      vector?          rigid body: moments [kg m2] about x, y, z through its centroid; or one number for all
support      text or table?   "fixed", "free" or { x = , y = , z = , rotation_x = , rotation_y = , rotation_z = }
velocity     vector = {0, 0, 0}  velocity at the start [m/s]
spin         vector = {0, 0, 0}  angular velocity at the start [rad/s]
load         vector = {0, 0, 0}  steady force at the centroid [N]
floating     flag = false     it needs no support at the start
cracks       planes?          planes on which a body may crack, no frame: "mid", "quarter", n or a list
crack_law    text?            contact law of these planes: strengths before, contact of the parts afterwards
body         body form?       "rigid", "brick" or { mesh = {nx, ny, nz}, element = "brick", "wedge", "tet4" or "tet10" }
hold         list?            deformable body: { { from = , to = , x = , y = , z = }, ... } holds nodes in boxes]],
    solids = [[
fixed        names?           names or groups of parts that are fixed
by_group     table?           { name = { keys } }: keys for parts of that name or group]],
  },
  { "model:extruded", "Makes a model in space from a model in the plane. Bodies extend over their thickness about "
    .. "y = 0, and y of the plane becomes z.", keys = [[
name  text?        name in messages; default: name of the model in the plane
held  flag = true  bodies stay in the plane, without motion along y or rotation about x and z]], gives = "model" },
  { "space:beam", "A straight beam with bending about both axes, axial deformation and torsion.", keys = [[
name          text             name
from          vector           start, on the axis of the section
to            vector           end
section       section          such as trilith.rectangle_section{...}, or trilith.fibre_section{...}
orientation   vector?          direction of the top of the section; default up, for a vertical member x
divisions     integer = 8      number of beam elements  <1 to 1000>
shear         flag = false     with shear deformation (Timoshenko)
pinned        names?           "from", "to" or both: ends without bending moment
hinge         hinge law?       a plastic hinge at both ends, with `across`
from_hinge    hinge law?       plastic hinge at the start
to_hinge      hinge law?       plastic hinge at the end
mass_matrix   text = "lumped"  "lumped" or "consistent"; explicit steps always use lumped mass
stations      integer = 4      number of integration points (fibre sections) in each beam element  <2 to 6>
rule          text = "lobatto"  rule of integration: "lobatto" (with the ends) or "gauss"
from_support  text or table?   "fixed", "free" or { x = , y = , z = , rotation_x = , rotation_y = , rotation_z = }
to_support    text or table?   support of the end]], with = "solid", gives = "body" },
  { "space:frame", "Beams that meet at joints, as one body.", keys = [[
name     text   name
joints   table  { A = {x, y, z}, B = { at = , support = , mass = , inertia = }, C = { hull = , density = }, ... }
members  list   { { from = , to = , section = , orientation = , from_at = , to_at = , hinge = , ... }, ... }
mass_matrix  text = "lumped"  "lumped" or "consistent"; explicit steps always use lumped mass]],
    with = "solid", gives = "body" },
  { "space:bearing_type", "A type of bearing for the ends of spans. Without a law the deck slides on its seat, as "
    .. "on an expansion bearing.", keys = [[
name            text            name
height          number m = 0    height from the seat to the deck; above 0 an axial law is needed  <at least 0>
along           direction law?  law along the bridge
across          direction law?  law across the bridge
horizontal      direction law?  instead of both: one law of their resultant
axial           direction law?  vertical law of the deck; without height it replaces the flat contact
turning_along   direction law?  law of rotation about along
turning_across  direction law?  law of rotation about across
turning_axial   direction law?  law of rotation about axial
limit           table?          { along = , across = , horizontal = , axial = , ... }: displacements at failure
becomes         contact law?    contact law of deck and support after failure; or its name
contact         contact law?    contact law of deck and support from the start; or its name]], gives = "string" },
  { "space:bridge", "Simple spans on bents or walls between two abutments, with girder lines and skew. The keys of "
    .. "its rows: docs/guide/space/bridges.md. The result has spans, supports and grounds (bodies), foundations "
    .. "(bearings), and bearings, seats and places by span, end and line. It also has side_seats, keys, axes, lines, "
    .. "and motions{ x = , y = , z = , velocity = , delay = } for model:shake.", keys = [[
supports      list           from left to right: an abutment, piers, an abutment
spans         list           from left to right
breadth       number m       breadth of the decks, and default breadth of the tops of supports  <above 0>
girders       table          { count = , spacing = , breadth = } or { at = { y, ... }, breadth = }
skew          number rad = 0  skew angle of supports and joints, about z; a support may have its own
x             number m = 0   axis of the first support
soffit_level  number m = 0   z of the underside of the decks; seats are lower by the height of their bearings
gap           number m?      default joint along the bridge  <at least 0>
seat          number m?      default length of seats along the bridge  <above 0>
material      text?          default material
ground        table or body?  { thickness = 1, margin = 1 }: a fixed block under each support; or a body
abutment      table?         default keys of both abutments
pier          table?         default keys of all piers
span          table?         default keys of all spans]], gives = "table" },
  { "space:body", "Makes a body of hulls. With only a name, returns the body of that name.",
    args = "name  text?  name of a body; or the table",
    keys = [[
name    text      name
hull    vectors?  points; the body is their convex hull
pieces  list?     or { { hull = }, ... }: convex pieces that share faces
mesh    table?    or { file = , scale = 1 } or { nodes = , elements = }; body = "rigid": rigid, of these pieces
]], with = "solid", gives = "body" },
  { "space:add", "Adds parts of the plane, such as the results of trilith.build, with a depth. x stays, y becomes z.",
    args = [[
parts    table  list of { name, outline, groups }
options  table  depth = , from = , centred = , and keys of solids]], gives = "set" },
  examples = {
    ["space:beam"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
box:beam { name = "post", from = { 0, 0, 0 }, to = { 0, 0, 3 }, material = "steel", from_support = "fixed",
  section = trilith.rectangle_section { width = 0.1, depth = 0.2 } }]],
    ["space:frame"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
local section = trilith.rectangle_section { width = 0.1, depth = 0.2 }
box:frame { name = "portal", material = "steel",
  joints = { A = { at = { 0, 0, 0 }, support = "fixed" }, B = { 0, 0, 3 }, C = { 3, 0, 3 } },
  members = { { from = "A", to = "B", section = section }, { from = "B", to = "C", section = section } } }]],
    ["space:building"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2200 }
box:building { name = "corner", material = "stone", fixed = "base", storeys = { { courses = 4 } }, base_height = 0.2,
  walls = { { name = "front", from = { 0, 0 }, to = { 2, 0 } }, { name = "side", from = { 0, 0 }, to = { 0, 2 } } } }]],
    ["space:vault"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2200 }
box:vault { name = "barrel", voussoirs = 9, radius = 2, thickness = 0.3, stone_length = 0.5, stones = 3,
  material = "stone", fixed = "abutments" }]],
    ["space:cross_vault"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2200 }
box:cross_vault { name = "groin", voussoirs = 9, radius = 2, thickness = 0.25, stone_length = 0.5,
  material = "stone" }]],
    ["space:bearing_type"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:bearing_type { name = "isolator", height = 0.2, axial = trilith.linear { stiffness = 2e9, damping = 4e6 },
  horizontal = trilith.lead_rubber { strength = 9e4, post_stiffness = 1e6 } }]],
    ["space:bridge"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "concrete", density = 2400 }
box:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5e8, ks = 2e8, mu = 0.6, beta = 2e-4 } }
box:bearing_type { name = "sliding" }
box:bridge { gap = 0.1, seat = 0.6, breadth = 8, material = "concrete", ground = { margin = 1 },
  girders = { count = 3, spacing = 2.5, breadth = 0.5 }, abutment = { height = 5, width = 4, back_wall_height = 1.5 },
  pier = { height = 5, stem_width = 1.3, stem_breadth = 6 },
  span = { length = 20, depth = 1.4, slab = 0.25, weight_per_length = 1e5, left = "sliding", right = "sliding" },
  supports = { { name = "A0" }, { name = "P1" }, { name = "A2" } }, spans = { { name = "S1" }, { name = "S2" } } }]],
    ["space:clump"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:clump { name = "pair", material = "stone",
  spheres = { { at = { 0, 0, 0.1 }, radius = 0.1 }, { at = { 0.15, 0, 0.1 }, radius = 0.08 } } }]],
    ["space:pour"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:pour { name = "grain", low = { 0, 0, 0 }, high = { 1, 1, 1 }, count = 20, radius = { 0.04, 0.06 },
  material = "stone" }]],
    ["space:solids"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
local path = os.tmpname() .. ".obj"
local file = io.open(path, "w")
file:write "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
file:close()
box:solids { name = "wedge", file = path, material = "stone" }]],
    ["space:body"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:body { name = "tip", hull = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, material = "stone" }
print(box:body("tip").mass)]],
    ["space:add"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:add(trilith.build.arch { voussoirs = 9, radius = 2 }, { depth = 0.5, material = "stone" })]],
    ["model:extruded"] = [[
local deep = m:extruded()
print(deep.dim)]],
    ["space:block"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:block { name = "step", size = { 1, 0.4, 0.2 }, at = { 0, 0, 0 }, material = "stone" }]],
    ["space:hull"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:hull { name = "tip", points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, material = "stone" }]],
    ["space:prism"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:prism { name = "post", sides = 8, radius = 0.2, height = 0.6, material = "stone" }]],
    ["space:extrusion"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:extrusion { name = "wedge", outline = { { 0, 0 }, { 1, 0 }, { 0, 1 } }, depth = 0.4, material = "stone" }]],
    ["space:column"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:column { name = "column", drums = 4, height = 2, radius = 0.25, material = "stone" }]],
    ["space:wall"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:wall { name = "wall", length = 1.2, courses = 3, material = "stone" }]],
    ["space:sphere"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:sphere { name = "ball", radius = 0.1, material = "stone" }]],
    ["space:dome"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:dome { name = "dome", radius = 2, thickness = 0.3, rings = 4, sectors = 8, material = "stone" }]],
    ["space:rubble"] = [[
local box = trilith.model { name = "box", dim = 3 }
box:material { name = "stone", density = 2400 }
box:rubble { name = "fill", low = { 0, 0, 0 }, high = { 1, 1, 1 }, stones = 8, material = "stone" }]],
  },
}
