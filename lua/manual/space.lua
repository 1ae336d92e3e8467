local beams = 'of each floor: { along = "x" or "y", spacing = or count = , width = , height = whole courses, one '
  .. "without it, bearing = how far into the walls, through them without it, from = {x, y}, to = {x, y} }, or a list "
  .. "of such rows; false in a storey: none"

return {
  name = "space", title = "Models in space: dim = 3",
  shared = {
    solid = [[
material     text?            of it
groups       names?           names of groups
density      number kg/m3?    instead of the material's
unit_weight  number N/m3?     or so
mass         number kg?       or so
weight       number N?        or so
inertia      vector?          of a rigid body [kg m2]: about x, y, z through its centroid; or one number for all
support      text or table?   "fixed", "free" or { x = , y = , z = , turn_x = , turn_y = , turn_z = }
velocity     vector = {0, 0, 0}  at the start [m/s]
spin         vector = {0, 0, 0}  at the start [rad/s]
load         vector = {0, 0, 0}  steady force at the centroid [N]
floating     flag = false     it may start with nothing that holds it up
body         body form?       "rigid", "brick" or { mesh = {nx, ny, nz}, element = "brick", "wedge", "tet4" or "tet10" }
hold         list?            of one that deforms: { { from = , to = , x = , y = , z = }, ... } holds nodes in boxes]],
    solids = [[
fixed        names?           names or groups of parts that are fixed
by_group     table?           { name = { ... } }: what holds instead for parts of that name or group]],
  },
  { "model:extruded", "The model in space that one of the plane is: bodies reach over their thickness about y = 0, "
    .. "and the plane's y is z.", keys = [[
name  text?        what messages call it; without it, as the other
held  flag = true  bodies stay in the plane: none moves along y or turns about x or z]], gives = "model" },
  { "space:beam", "A straight beam that bends about both axes, stretches and twists.", keys = [[
name          text             its name
from          vector           its start, on the axis of the section
to            vector           its end
section       section          such as trilith.rectangle_section{...}, or trilith.fibre_section{...}
orientation   vector?          to the top of the section; without it up, of an upright member to x
divisions     integer = 8      beam elements in a row
shear         flag = false     with shear deformation (Timoshenko)
pinned        names?           "from", "to" or both: carries no bending moment there
hinge         hinge law?       a plastic hinge at both ends, with `across`
from_hinge    hinge law?       ... at its start
to_hinge      hinge law?       ... at its end
mass_matrix   text = "lumped"  or "consistent", which implicit steps and modes take; explicit ones lump
stations      integer = 4      of fibres, along each beam element
rule          text = "lobatto"  where those are: "lobatto" (ends too) or "gauss"
from_support  text or table?   "fixed", "free" or { x = , y = , z = , turn_x = , turn_y = , turn_z = }
to_support    text or table?   the same of its end]], with = "solid", gives = "body" },
  { "space:frame", "Beams that meet at joints, as one body.", keys = [[
name     text   its name
joints   table  { A = {x, y, z}, B = { at = , support = , mass = , inertia = }, C = { hull = , density = }, ... }
members  list   { { from = , to = , section = , orientation = , from_at = , to_at = , hinge = , ... }, ... }
mass_matrix  text = "lumped"  or "consistent", which implicit steps and modes take; explicit ones lump]],
    with = "solid", gives = "body" },
  { "space:block", "A box in any pose.", keys = [[
name    text                   its name
size    vector                 along its own x, y and z [m]
at      vector = {0, 0, 0}     where its anchor is
anchor  text = "lower_corner"  "lower_corner" or "centre"
turn    table?                 { axis = {x, y, z}, angle = }: about the anchor]], with = "solid", gives = "body" },
  { "space:extrusion", "What an outline sweeps over; one that is not convex comes in several pieces.", keys = [[
name     text                its name
outline  points              corners in order
plane    text = "upright"    "upright": its second number is z, depth along y; "level": it is y, depth along z
from     number m = 0        where it begins along that axis
depth    number m            how far it goes
centred  flag = false        `from` is its middle
at       vector = {0, 0, 0}  the outline's origin
turn     table?              about `at`: { axis = , angle = }]], with = "solid", gives = "body" },
  { "space:hull", "The convex hull of points.", keys = [[
name    text       its name
points  vectors    at least four, not in a plane
flat    number = 1e-9  points this near a plane, as a share of its size, are in it]], with = "solid", gives = "body" },
  { "space:prism", "An upright regular prism.", keys = [[
name    text                its name
sides   integer = 6         how many
radius  number m            of the circle through its corners
height  number m            of it
phase   number rad = 0      of its first corner, from x
at      vector = {0, 0, 0}  middle of its foot
turn    table?              about `at`: { axis = , angle = }]], with = "solid", gives = "body" },
  { "space:column", "A column of drums, with base and capital.", keys = [[
name        text?               names begin with it
drums       integer = 1         how many
height      number m            of all drums
sides       integer = 16        of a drum
radius      number m            of the lowest foot
top_radius  number m = as the foot  of the uppermost top
of          text = "area"       of the circle of the same "area", through "corners" or in the "sides"
phase       number rad = 0      of the first corners, from x
base        table?              { width = , height = } under the drums
capital     table?              { width = , height = } on them
at          vector = {0, 0, 0}  middle of its foot]], with = "solids", gives = "set" },
  { "space:wall", "A masonry wall with a thickness, along x.", keys = [[
name            text?                names begin with it
length          number m             along x
thickness       number m = half a unit's length  along y; where there are headers a unit's
unit_length     number m = 0.4       of a stretcher with its joint
unit_height     number m = 0.2       of a course
header_length   number m = half a stretcher  of a header along the wall
bond            text = "stretcher"   stretcher, header, english or flemish
courses         integer = from storey_height  in a storey
storey_height   number m = from courses  or its height
storeys         storeys = 1          how many, or a list of { courses = , height = , slab_height = }
slab_height     number m = 0         of the floor on each storey
slab_overhang   number m = 0         beyond the walls
base_height     number m = 0         of the block under it
base_margin     number m = 0         beyond the walls
lintel_height   number m = one course  over openings
lintel_bearing  number m = half a unit  its length on the wall
least_length    number m = a fifth of a unit  shortest piece that is cut
snap            flag = false         openings are moved to the nearest course lines
openings        list?                { storey = , from = , sill = , width = , height = , lintel = }, ...
at              vector = {0, 0, 0}   lower left corner of its front
angle           number rad = 0       about z through that corner]], with = "solids", gives = "set" },
  { "space:building", "Walls of a plan, whose corners and junctions interlock, storey upon storey; their floors are "
    .. "slabs, beams in pockets of two walls, or slabs on beams.", keys = [[
name            text?                names begin with it
walls           list                 { name = , from = {x, y}, to = {x, y}, thickness = , bond = , openings = }, ...
unit_length     number m = 0.4       of a stretcher with its joint
unit_height     number m = 0.2       of a course
header_length   number m = half a stretcher  of a header along the wall
bond            text = "stretcher"   stretcher, header, english or flemish
courses         integer = from storey_height  in a storey
storey_height   number m = from courses  or its height
storeys         storeys = 1          how many, or a list of { courses = , height = , slab_height = , beams = }
slab_height     number m = 0         of the floor on each storey
beams           table?               ]] .. beams .. [[

slab_overhang   number m = 0         beyond the walls
slab_outline    points = around all walls  of the floors, instead
base_height     number m = 0         of the block under it
base_margin     number m = 0         beyond the walls
lintel_height   number m = one course  over openings
lintel_bearing  number m = half a unit  its length on the wall
least_length    number m = a fifth of a unit  shortest piece that is cut
snap            flag = false         openings are moved to the nearest course lines
first_along_y   flag = false         in odd courses the walls along y run through
at              vector = {0, 0, 0}   where the plan's origin is
angle           number rad = 0       about z through it]], with = "solids", gives = "set" },
  { "space:vault", "A barrel vault of stones in bond: an arch as model:arch makes it, along y.", keys = [[
name             text?               names begin with it
voussoirs        integer = 15  of the arch
radius           number m = 1  of its mid line
thickness        number m = 0.15  of the ring
half_angle       number rad = pi/2  half of the angle it spans
offset           number m = 0  of the two centres of a pointed arch
span             number m?           instead of radius: clear span, with rise
rise             number m?           see span
abutments        flag = true  make them too
abutment_depth   number m = the thickness  of the abutments
abutment_margin  number m = half the thickness  beyond the ring
stone_length     number m            along y
stones           integer = 1         whole stones in a course
bond             flag = true         joints shift from course to course
half_first       flag = false        the first course begins with half a stone
from             number m = 0        y where it begins
at               vector = {0, 0, 0}  by which it is moved]], with = "solids", gives = "set" },
  { "space:cross_vault", "Two barrels that meet along the diagonals of a square bay.", keys = [[
name             text?               names begin with it
voussoirs        integer = 15  of the arch
radius           number m = 1  of its mid line
thickness        number m = 0.15  of the ring
half_angle       number rad = pi/2  half of the angle it spans
offset           number m = 0  of the two centres of a pointed arch
span             number m?           instead of radius: clear span, with rise
rise             number m?           see span
abutments        flag = true  not used
abutment_depth   number m = the thickness  not used
abutment_margin  number m = half the thickness  not used
half_bay         number m = to the arch's edge  from the middle to each end
stone_length     number m            along each web
bond             flag = true         joints shift from course to course
at               vector = {0, 0, 0}  middle of the bay
angle            number rad = 0      about z]], with = "solids", gives = "set" },
  { "space:dome", "A dome of rings and sectors of stones with plane faces.", keys = [[
name       text?               names begin with it
radius     number m = 1        midway through its thickness
thickness  number m = 0.1      of it
rings      integer = 8         how many
sectors    integer = 16        how many
springing  number rad = pi/2  angle of the lowest bed from the vertical; a half dome without it
crown      number rad = pi/18  of the uppermost bed, 10 degrees without it
top        text = "key"        "key" or "oculus"
phase      number rad = 0      of the first joint, from x
centre     vector = {0, 0, 0}  of its spheres]], with = "solids", gives = "set" },
  { "space:bearing_type", "A kind of bearing for the ends of spans. Without a law the deck lies and slides on its "
    .. "seat, as on an expansion bearing.", keys = [[
name            text            its name
height          number m = 0    from the seat to the deck; above 0 it needs an axial law
along           direction law?  lengthwise
across          direction law?  sideways
horizontal      direction law?  instead of both: one law of their resultant
axial           direction law?  vertical, which carries the deck; without height instead of their flat contact
turning_along   direction law?  about along
turning_across  direction law?  about across
turning_axial   direction law?  about axial
limit           table?          { along = , across = , horizontal = , axial = , ... }: what ends it
becomes         contact law?    of deck and support after it failed; or the name of one
contact         contact law?    of deck and support from the start; or the name of one]], gives = "string" },
  { "space:bridge", "Simple spans on bents or walls between two abutments, with girder lines and skew; what its rows "
    .. "take, docs/guide/space.md tells. What it gives: supports, spans, grounds: bodies; foundations: bearings; "
    .. "bearings, seats, places: by span, then left or right, then line; side_seats: by span, end and side; keys; "
    .. "axes; lines; motions{ x = , y = , z = , velocity = , delay = }, which model:shake takes.", keys = [[
supports      list           from left to right: an abutment, piers, an abutment
spans         list           from left to right
breadth       number m       of the decks, across, and of tops of supports that say nothing else
girders       table          { count = , spacing = , breadth = } or { at = { y, ... }, breadth = }
skew          number rad = 0  turn of supports and joints about z from square to the bridge; or each says it
x             number m = 0   axis of the first support
soffit_level  number m = 0   z of the underside of the decks; seats are lower by their bearings
gap           number m?      joints along the bridge, where a support says nothing else
seat          number m?      length of seats along the bridge, where a support says nothing else
material      text?          where a row says nothing else
ground        table or body?  { thickness = 1, margin = 1 }: a fixed block under each support; or a body
abutment      table?         what both abutments have in common
pier          table?         what all piers have in common
span          table?         what all spans have in common]], gives = "table" },
  { "space:rubble", "Irregular stones that fill a box.", keys = [[
name         text?         names begin with it
low          vector        corner of the box
high         vector        the opposite one
stones       integer = 50  how many
relaxations  integer = 3   more of them make the stones more even
aspect       number = 1    width over height
joint        number m = 0  between the stones
jitter       number m = 0  points are moved at random by up to this
seed         integer = 1   of the random numbers]], with = "solids", gives = "set" },
  { "space:sphere", "A sphere.", keys = [[
name    text                its name
radius  number m            of it
at      vector = {0, 0, 0}  its centre]], with = "solid", gives = "body" },
  { "space:clump", "Spheres that overlap or touch, as one body: its mass is that of their union; each touches "
    .. "others for itself.", keys = [[
name     text                its name
spheres  list                { { at = {x, y, z}, radius = }, ... }, about its own origin
at       vector = {0, 0, 0}  where that origin stands
turn     table?              { axis = {x, y, z}, angle = }: about it]], with = "solid", gives = "body" },
  { "space:pour", "Spheres, or clumps of one shape, at random in a box, none touching another, ready to fall.",
    keys = [[
name     text?            names begin with it
low      vector           corner of the box they begin in
high     vector           the opposite one
count    integer = 100    how many
radius   number or list   of all, or { least, most } [m]
grading  text = "number"  "number": as many of each radius; "mass": as much mass of each
clump    list?            { { at = {x, y, z}, radius = }, ... }: a shape, as large as the ball of a grain's radius
share    number = 1       of clumps among the grains, where there is a shape
seed     integer = 1      of the random numbers]], with = "solids", gives = "set" },
  { "space:solids", "Solids of an OBJ or STL file.", keys = [[
name               text?           names begin with it
file               text            its path, from the script's folder
scale              number = 1      m for each unit of the file
y_up               flag = false    the file's y is up
shells_are_bodies  flag = false    each closed shell is a body, not a piece of one
weld               number = 1e-7  corners nearer than this, as a share of the size, are one
flat               number = 1e-6  faces this near a plane, as a share of the size, are in it]], with = "solids",
    gives = "set" },
  { "space:body", "Makes a body of hulls; with a name alone, finds one.", args = "name  text?  of a body; or the table",
    keys = [[
name    text      its name
hull    vectors?  points around it
pieces  list?     or { { hull = }, ... }: convex pieces that share faces
mesh    table?    or a mesh: { file = } or { nodes = , elements = }; body = "rigid": one of its elements as pieces
]], with = "solid", gives = "body" },
  { "space:add", "Parts of the plane, as from trilith.build, become bodies with a depth: x stays, y becomes z.",
    args = [[
parts    table  list of { name, outline, groups }
options  table  depth = , from = , centred = , and what solids take]], gives = "set" },
}
