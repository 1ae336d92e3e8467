return {
  name = "geometry", title = "Builders: parts of masonry and bridges",
  makers = {
    { "block", "A rectangle in any pose.", keys = [[
name    text?                name
width   number m             size along its own x
height  number m             size along its own y
at      point = {0, 0}       position of the anchor
anchor  text = "lower_left"  "lower_left" or "centre"
angle   number rad = 0       rotation, counter-clockwise]] },
    { "polygon", "A polygon of given points.", keys = [[
name     text?   its name
outline  points  corners in order]] },
    { "stack", "Blocks on top of each other.", keys = [[
name    text?           prefix of names
at      point = {0, 0}  middle of the foot
blocks  list            { { width = , height = , offset = 0 }, ... }, from the foot up]] },
    { "harmonic_stack", "Equal blocks that overhang an edge.", keys = [[
name          text?           prefix of names
count         integer = 5  number of blocks
length        number m = 1  length of a block
height        number m = 0.2  height of a block
factor        number = 1  overhang over the largest stable overhang
at            point = {0, 0}  position of the edge
table_height  number m = 0  height of the table under the blocks]] },
    { "arch", "An arch of voussoirs: semicircular, segmental or pointed.", keys = [[
name             text?           prefix of names
voussoirs        integer = 15  number of voussoirs
radius           number m = 1  radius of the centre line
thickness        number m = 0.15  thickness of the ring
half_angle       number rad = pi/2  half of the opening angle
offset           number m = 0  offset of the two centres of a pointed arch
span             number m?       instead of radius: clear span, with rise
rise             number m?       clear rise, with span
key              number = 1  width of the keystone over the width of the others
sub_edges        integer = 1  number of edges of each curved side
centre           point = {0, 0}  centre of the circle
abutments        flag = true  make abutments
abutment_depth   number m = the thickness  depth of the abutments
abutment_margin  number m = half the thickness  width of the abutments beyond the ring
jitter           number m = 0  largest random shift of joints
seed             integer = 1  of the random numbers]] },
    { "flying_buttress", "A flying buttress: half an arch that leans from a pier against the head of a wall.", keys = [[
name         text?           prefix of names
voussoirs    integer = 9     number of voussoirs
span         number m = 4    distance from the pier to the wall
rise         number m = 2    rise of the intrados
radius       number m = level at the head  radius of the intrados
thickness    number m = 0.4  thickness of the ring; with a coping vertical at the wall
slope        number rad = 0  slope of a straight coping that rises to the wall; 0: none
sub_edges    integer = 1     number of edges of each curved side
springing    point = {0, 0}  springing of the intrados, at the edge of the pier
pier_width   number m = 1.5 times the thickness  width of the pier
pier_height  number m = 0    height of the pier below the springing; 0: no pier
wall_width   number m = 0    width of the supporting wall; 0: none
wall_height  number m = the thickness  height of the wall above the head of the intrados]] },
    { "wall", "A masonry wall of storeys, with openings, lintels and slabs.", keys = [[
name            text?             prefix of names
at              point = {0, 0}    lower left corner
length          number m = from units  length of the wall; or units
units           integer = from length  number of units in a course
unit_length     number m = 0.4  length of a stretcher, with half of its joints
unit_height     number m = 0.2  height of a course
header_length   number m = half a stretcher  length of a header
head_joint      number m = 0  thickness of head joints, added to the length of units
bed_joint       number m = 0  thickness of bed joints, added to the height of units
bond            text = "running"  running, stack, english, flemish, header or english_garden
first_row       integer = 1  first row of the bond pattern
least_length    number m = a quarter of a unit  length of the shortest cut piece
short_pieces    text = "merge"    "merge" or "refuse": treatment of shorter pieces
jitter          number m = 0  largest random shift of head joints
seed            integer = 1  of the random numbers
courses         integer = from storey_height  number of courses in a storey; or
storey_height   number m = from courses  height of a storey
storeys         storeys = 1       number of storeys, or a list of { courses = , height = , slab_height = }
slab_height     number m = 0  height of the slab on each storey
slab_overhang   number m = 0  length of slabs beyond the wall
base_height     number m = 0  height of the base
base_margin     number m = 0  length of the base beyond the wall
lintel_height   number m = one course  height of lintels
lintel_bearing  number m = half a unit  bearing length of lintels
snap            flag = false  move openings to the nearest joints
openings        list?             { storey = , x = , sill = , width = , height = , lintel = , sill_height = }, ...]] },
    { "rubble", "Irregular stones that fill a polygon.", keys = [[
name         text?     prefix of names
outline      points    polygon to be filled
stones       integer = 50  number of stones
relaxations  integer = 3  number of relaxations; more give more even stones
aspect       number = 1  width of stones over height
least_edge   number m = a tenth of a stone  shorter edges are removed
joint        number m = 0  gap between stones
jitter       number m = 0  largest random shift of points
seed         integer = 1  of the random numbers]] },
    { "running_bond", "A plain panel on a grid of half units, for limit analysis.", keys = [[
name          text?          prefix of names
columns       integer = 5  number of units in a course
courses       integer = 6  number of courses
unit_width    number m = 0.4  width of a unit
unit_height   number m = 0.2  height of a unit
half_courses  text = "even"  courses that begin with a half unit: "odd" or "even"
at            point = {0, 0}  lower left corner
base_height   number m = 0  height of the base
base_margin   number m = 0  length of the base beyond the panel
openings      list?          { from = , to = , first_course = , last_course = }, ...
lintels       list?          lintels in the same form]] },
    { "bench_wall", "The wall of the benchmarks.", keys = "courses  integer = 24  number of courses" },
    { "ground", "Ground under a surface line.", keys = [[
name        text?      name
surface     points?    top of the ground, from left to right; or steps
steps       list?      { { from = , level = }, ... }
to          number m?  end of the last step
base_level  number m   bottom of the ground]], beside = { to = true } },
    { "pier", "A pier of footing, stem and cap.", keys = [[
name               text?         name
station            number m      position of the axis along the bridge
ground_level       number m = 0  top of the ground
height             number m      height above the ground
stem_width         number m = the top's  width of the stem; not needed with seat and gap
top_width          number m = the stem's  width of the cap
cap_thickness      number m = 0  thickness of the cap
footing_width      number m = 0  width of the footing
footing_thickness  number m = 0  thickness of the footing
seat               number m?     length of each of the two seats; the top is as wide as both and the joint
gap                number m?     joint between the two decks on the pier]] },
    { "abutment", "A stub abutment with a back wall.", keys = [[
name              text?          name
side              text = "left"  "left" or "right"
x                 number m?      edge of the seat; or station
station           number m?      middle of the joint between deck and back wall; needs seat and gap
ground_level      number m = 0   bottom of the abutment
height            number m       height of the seat above the bottom
width             number m       total width
back_wall_height  number m = 0  height of the back wall above the seat
back_wall_width   number m = from seat and gap  width of the back wall; or seat and gap
seat              number m?      length of the seat under the deck
gap               number m?      joint between deck and back wall]] },
  },
  { "model:span", "A deck on two supports, which give its position, seats and bearings; or a deck alone, between "
    .. "x0 and x1. Seats, and bearings of types with a law, have names such as \"S1.left\": span.seats.left, "
    .. "span.bearings.right.", keys = [[
name               text = "span"  name
from               body?          left support: an abutment, a pier or a body with a horizontal top
to                 body?          right support
left               text?          bearing type on the left support, see model:bearing_type
right              text?          bearing type on the right support
gap                number m?      joint on supports without a gap of their own
depth              number m       height of the deck
soffit_level       number m = on its left bearing  level of the underside
weight_per_length  number N/m?    weight of the deck over its full length; or weight, mass, density
x0                 number m?      deck alone: axis of the left support
x1                 number m?      deck alone: axis of the right support
end_gap            number m = 0   distance from the axis to the end of the deck]], with = "body", gives = "body" },
  { "model:bearing_type", "A type of bearing for the ends of spans. Without a law the deck slides on its seat, as on "
    .. "an expansion bearing.", keys = [[
name     text            name
height   number m = 0    height from the seat to the deck; above 0 an axial law is needed
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
gap           number m?     default joint at supports
seat          number m?     default length of seats
material      text?         default material
abutment      table?        default keys of both abutments; back_wall_height counts from the underside of the deck
pier          table?        default keys of all piers
span          table?        default keys of all spans]], gives = "table" },
  examples = {
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
