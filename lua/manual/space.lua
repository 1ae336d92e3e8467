local beams = 'beams of each floor, or a list of such rows: { along = "x" or "y", spacing = or count = , width = , '
  .. "height = whole courses (1), bearing = length in the walls (default: through them), from = {x, y}, to = {x, y} }. "
  .. "false in a storey: none"

return {
  name = "space", title = "Models in space: dim = 3",
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
stations      integer = 4      number of integration points (fibre sections) in each beam element
rule          text = "lobatto"  rule of integration: "lobatto" (with the ends) or "gauss"
from_support  text or table?   "fixed", "free" or { x = , y = , z = , rotation_x = , rotation_y = , rotation_z = }
to_support    text or table?   support of the end]], with = "solid", gives = "body" },
  { "space:frame", "Beams that meet at joints, as one body.", keys = [[
name     text   name
joints   table  { A = {x, y, z}, B = { at = , support = , mass = , inertia = }, C = { hull = , density = }, ... }
members  list   { { from = , to = , section = , orientation = , from_at = , to_at = , hinge = , ... }, ... }
mass_matrix  text = "lumped"  "lumped" or "consistent"; explicit steps always use lumped mass]],
    with = "solid", gives = "body" },
  { "space:block", "A box in any pose.", keys = [[
name    text                   name
size    vector                 size along its own x, y and z [m]
at      vector = {0, 0, 0}     position of the anchor
anchor  text = "lower_corner"  "lower_corner" or "centre"
turn    table?                 rotation about the anchor: { axis = {x, y, z}, angle = }]], with = "solid",
    gives = "body" },
  { "space:extrusion", "An outline extruded along an axis. A concave outline gives several pieces.", keys = [[
name     text                name
outline  points              corners in order
plane    text = "upright"    "upright": outline in x and z, depth along y; "level": outline in x and y, depth along z
from     number m = 0        begin along that axis
depth    number m            depth along that axis  <above 0>
centred  flag = false        `from` is the middle of the depth
at       vector = {0, 0, 0}  origin of the outline
turn     table?              rotation about `at`: { axis = , angle = }]], with = "solid", gives = "body" },
  { "space:hull", "The convex hull of points.", keys = [[
name    text       name
points  vectors    at least four points, not in a plane
flat    number = 1e-9  distance from a plane, as a share of the size, below which points are in it  <1e-12 to 0.01>]],
    with = "solid",
    gives = "body" },
  { "space:prism", "An upright regular prism.", keys = [[
name    text                name
sides   integer = 6         number of sides  <3 to 1000>
radius  number m            radius of the circle through the corners  <above 0>
height  number m            height  <above 0>
phase   number rad = 0      angle of the first corner, from x
at      vector = {0, 0, 0}  middle of the foot
turn    table?              rotation about `at`: { axis = , angle = }]], with = "solid", gives = "body" },
  { "space:column", "A column of drums, with base and capital.", keys = [[
name        text?               prefix of names
drums       integer = 1         number of drums  <1 to 10000>
height      number m            height of all drums  <above 0>
sides       integer = 16        number of sides of a drum  <3 to 1000>
radius      number m            radius at the foot  <above 0>
top_radius  number m = as the foot  radius at the top  <at least 0>
of          text = "area"       circle of the radii: equal "area", through the "corners", or within the "sides"
phase       number rad = 0      angle of the first corners, from x
base        table?              { width = , height = } under the drums
capital     table?              { width = , height = } on the drums
at          vector = {0, 0, 0}  middle of the foot]], with = "solids", gives = "set" },
  { "space:wall", "A masonry wall with a thickness, along x.", keys = [[
name            text?                prefix of names
length          number m             length along x  <above 0>
thickness       number m = half a unit's length  thickness along y; with headers the length of a unit  <at least 0>
unit_length     number m = 0.4       length of a stretcher with its joint  <above 0>
unit_height     number m = 0.2       height of a course  <above 0>
header_length   number m = half a stretcher  length of a header along the wall  <at least 0>
bond            text = "stretcher"   stretcher, header, english or flemish
courses         integer = from storey_height  number of courses in a storey; or  <1 to 100000>
storey_height   number m = from courses  height of a storey
storeys         storeys = 1          number of storeys, or a list of { courses = , height = , slab_height = }
slab_height     number m = 0         height of the floor slab on each storey  <at least 0>
slab_overhang   number m = 0         length of slabs beyond the walls  <at least 0>
base_height     number m = 0         height of the base  <at least 0>
base_margin     number m = 0         length of the base beyond the walls  <at least 0>
lintel_height   number m = one course  height of lintels  <at least 0>
lintel_bearing  number m = half a unit  bearing length of lintels  <at least 0>
least_length    number m = a fifth of a unit  length of the shortest cut piece  <at least 0>
snap            flag = false         move openings to the nearest course lines
openings        list?                { storey = , from = , sill = , width = , height = , lintel = }, ...
at              vector = {0, 0, 0}   lower left corner of the front
angle           number rad = 0       rotation about z through that corner]], with = "solids", gives = "set" },
  { "space:building", "Walls of a plan in storeys, with interlocking corners and junctions. Floors are slabs, "
    .. "beams in pockets of two walls, or slabs on beams.", keys = [[
name            text?                prefix of names
walls           list                 { name = , from = {x, y}, to = {x, y}, thickness = , bond = , openings = }, ...
unit_length     number m = 0.4       length of a stretcher with its joint  <above 0>
unit_height     number m = 0.2       height of a course  <above 0>
header_length   number m = half a stretcher  length of a header along the wall  <at least 0>
bond            text = "stretcher"   stretcher, header, english or flemish
courses         integer = from storey_height  number of courses in a storey; or
storey_height   number m = from courses  height of a storey
storeys         storeys = 1          number of storeys, or a list of { courses = , height = , slab_height = , beams = }
slab_height     number m = 0         height of the floor slab on each storey  <at least 0>
beams           table?               ]] .. beams .. [[

slab_overhang   number m = 0         length of slabs beyond the walls  <at least 0>
slab_outline    points = around all walls  outline of the floors
base_height     number m = 0         height of the base  <at least 0>
base_margin     number m = 0         length of the base beyond the walls  <at least 0>
lintel_height   number m = one course  height of lintels  <at least 0>
lintel_bearing  number m = half a unit  bearing length of lintels  <at least 0>
least_length    number m = a fifth of a unit  length of the shortest cut piece  <at least 0>
snap            flag = false         move openings to the nearest course lines
first_along_y   flag = false         walls along y run through in odd courses
at              vector = {0, 0, 0}   position of the origin of the plan
angle           number rad = 0       rotation about z through that point]], with = "solids", gives = "set" },
  { "space:vault", "A barrel vault of stones in bond: the arch of model:arch, extended along y.", keys = [[
name             text?               prefix of names
voussoirs        integer = 15  number of voussoirs of the arch  <1 to 10000>
radius           number m = 1  radius of the centre line  <above 0>
thickness        number m = 0.15  thickness of the ring  <above 0>
half_angle       number rad = pi/2  half of the opening angle  <above 0>
offset           number m = 0  offset of the two centres of a pointed arch  <at least 0>
span             number m?           instead of radius: clear span, with rise
rise             number m?           clear rise, with span
abutments        flag = true  make abutments
abutment_depth   number m = the thickness  depth of the abutments  <above 0>
abutment_margin  number m = half the thickness  width of the abutments beyond the ring
stone_length     number m            length of a stone along y  <above 0>
stones           integer = 1         number of whole stones in a course  <1 to 10000>
bond             flag = true         joints shift from course to course
half_first       flag = false        the first course begins with half a stone
from             number m = 0        y of the start
at               vector = {0, 0, 0}  translation]], with = "solids", gives = "set" },
  { "space:cross_vault", "Two barrels that meet along the diagonals of a square bay.", keys = [[
name             text?               prefix of names
voussoirs        integer = 15  number of voussoirs of the arch  <1 to 10000>
radius           number m = 1  radius of the centre line  <above 0>
thickness        number m = 0.15  thickness of the ring  <above 0>
half_angle       number rad = pi/2  half of the opening angle  <above 0>
offset           number m = 0  offset of the two centres of a pointed arch  <at least 0>
span             number m?           instead of radius: clear span, with rise
rise             number m?           clear rise, with span
abutments        flag = true  not used
abutment_depth   number m = the thickness  not used
abutment_margin  number m = half the thickness  not used
half_bay         number m = to the arch's edge  distance from the middle to each end  <at least 0>
stone_length     number m            length of a stone along each web  <above 0>
bond             flag = true         joints shift from course to course
at               vector = {0, 0, 0}  middle of the bay
angle            number rad = 0      rotation about z]], with = "solids", gives = "set" },
  { "space:dome", "A dome of rings and sectors of stones with plane faces.", keys = [[
name       text?               prefix of names
radius     number m = 1        radius of the middle surface  <above 0>
thickness  number m = 0.1      thickness  <above 0>
rings      integer = 8         number of rings  <1 to 1000>
sectors    integer = 16        number of sectors  <3 to 1000>
springing  number rad = pi/2  angle of the lowest bed from the vertical; default a hemisphere  <above 0>
crown      number rad = pi/18  angle of the uppermost bed, 10 degrees by default  <above 0>
top        text = "key"        "key" or "oculus"
phase      number rad = 0      angle of the first joint, from x
centre     vector = {0, 0, 0}  centre of the sphere]], with = "solids", gives = "set" },
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
  { "space:rubble", "Irregular stones that fill a box.", keys = [[
name         text?         prefix of names
low          vector        corner of the box
high         vector        opposite corner
stones       integer = 50  number of stones  <1 to 10000>
relaxations  integer = 3   number of relaxations; more give more even stones  <0 to 100>
aspect       number = 1    width of stones over height  <0.1 to 10>
joint        number m = 0  gap between stones  <at least 0>
jitter       number m = 0  largest random shift of points  <at least 0>
seed         integer = 1   seed of the random numbers]], with = "solids", gives = "set" },
  { "space:sphere", "A sphere.", keys = [[
name    text                name
radius  number m            radius  <above 0>
at      vector = {0, 0, 0}  centre]], with = "solid", gives = "body" },
  { "space:clump", "Overlapping or touching spheres as one body. Its mass is the mass of their union. Each "
    .. "sphere has its own contacts.", keys = [[
name     text                name
spheres  list                { { at = {x, y, z}, radius = }, ... }, relative to its own origin
at       vector = {0, 0, 0}  position of that origin
turn     table?              rotation about it: { axis = {x, y, z}, angle = }]], with = "solid", gives = "body" },
  { "space:pour", "Spheres, or clumps of one shape, at random in a box without contact, ready to fall.",
    keys = [[
name     text?            prefix of names
low      vector           corner of the box
high     vector           opposite corner
count    integer = 100    number of bodies  <1 to 200000>
radius   number or list   radius of all, or { least, greatest } [m]  <above 0>
grading  text = "number"  uniform distribution of the radii by "number" or by "mass"
clump    list?            { { at = {x, y, z}, radius = }, ... }: a shape, scaled to the size of a sphere of the radius
share    number = 1       share of clumps among the bodies, with a shape  <0 to 1>
seed     integer = 1      seed of the random numbers]], with = "solids", gives = "set" },
  { "space:solids", "Solids of an OBJ or STL file.", keys = [[
name               text?           prefix of names
file               text            path, relative to the folder of the script
scale              number = 1      metres for each unit of the file  <above 0>
y_up               flag = false    y is the vertical axis of the file
shells_are_bodies  flag = false    each closed shell is a body, instead of a piece of one
weld               number = 1e-7  distance below which corners are merged, as a share of the size  <0 to 0.01>
flat               number = 1e-6  distance from a plane below which faces are in it, over the size  <1e-12 to 0.01>]],
    with = "solids", gives = "set" },
  { "space:body", "Makes a body of hulls. With only a name, returns the body of that name.",
    args = "name  text?  name of a body; or the table",
    keys = [[
name    text      name
hull    vectors?  points; the body is their convex hull
pieces  list?     or { { hull = }, ... }: convex pieces that share faces
mesh    table?    or a mesh: { file = } or { nodes = , elements = }; body = "rigid": rigid, of these pieces
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
