return {
  name = "geometry", title = "Geometry: parts of masonry and bridges",
  makers = {
    { "block", "A rectangle in any pose.", keys = [[
name    text?                its name
width   number m             along its own x
height  number m             along its own y
at      point = {0, 0}       where its anchor is
anchor  text = "lower_left"  "lower_left" or "centre"
angle   number rad = 0       counter-clockwise]] },
    { "polygon", "A polygon of given points.", keys = [[
name     text?   its name
outline  points  corners in order]] },
    { "stack", "Blocks on top of each other.", keys = [[
name    text?           their names begin with it
at      point = {0, 0}  middle of the bottom
blocks  list            { { width = , height = , offset = 0 }, ... } from below]] },
    { "harmonic_stack", "Equal blocks that reach out over an edge.", keys = [[
name          text?           their names begin with it
count         integer = 5  how many
length        number m = 1  of one
height        number m = 0.2  of one
factor        number = 1  1: as far as just balances
at            point = {0, 0}  the edge
table_height  number m = 0  of the table they stand on]] },
    { "arch", "An arch of voussoirs: semicircular, segmental or pointed.", keys = [[
name             text?           names begin with it
voussoirs        integer = 15  how many
radius           number m = 1  of the mid line
thickness        number m = 0.15  of the ring
half_angle       number rad = pi/2  half of the angle it spans
offset           number m = 0  of the two centres of a pointed arch
span             number m?       instead of radius: clear span, with rise
rise             number m?       see span
key              number = 1  width of the keystone over the others
sub_edges        integer = 1  edges for each curved side
centre           point = {0, 0}  of the circle
abutments        flag = true  make them too
abutment_depth   number m = the thickness  of the abutments
abutment_margin  number m = half the thickness  beyond the ring
jitter           number m = 0  joints are moved at random by up to this
seed             integer = 1  of the random numbers]] },
    { "flying_buttress", "A flying buttress: half an arch that leans from a pier against the head of a wall.", keys = [[
name         text?           names begin with it
voussoirs    integer = 9     how many
span         number m = 4    from the pier to the wall
rise         number m = 2    of the intrados
radius       number m = level at the head  of the intrados
thickness    number m = 0.4  of the ring; with a coping upright at the wall
slope        number rad = 0  of a straight coping that rises to the wall; 0: none
sub_edges    integer = 1     edges for each curved side
springing    point = {0, 0}  of the intrados, at the pier's edge
pier_width   number m = 1.5 times the thickness  of the pier
pier_height  number m = 0    below the springing; 0: no pier
wall_width   number m = 0    of a wall to lean against; 0: none
wall_height  number m = the thickness  above the intrados' head]] },
    { "wall", "A masonry wall of storeys, with openings, lintels and slabs.", keys = [[
name            text?             names begin with it
at              point = {0, 0}    lower left corner
length          number m = from units  of the wall; or units
units           integer = from length  in a course
unit_length     number m = 0.4  of a stretcher, half its joints included
unit_height     number m = 0.2  of a course
header_length   number m = half a stretcher  of a header
head_joint      number m = 0  added to the units' length
bed_joint       number m = 0  added to their height
bond            text = "running"  running, stack, english, flemish, header or english_garden
first_row       integer = 1  row of the bond's pattern to begin with
least_length    number m = a quarter of a unit  shortest piece that is cut
short_pieces    text = "merge"    "merge" or "refuse"
jitter          number m = 0  head joints are moved at random by up to this
seed            integer = 1  of the random numbers
courses         integer = from storey_height  in a storey
storey_height   number m = from courses  or its height
storeys         storeys = 1       how many, or a list of { courses = , height = , slab_height = }
slab_height     number m = 0  of the slab on each storey
slab_overhang   number m = 0  beyond the wall
base_height     number m = 0  of the base under it
base_margin     number m = 0  beyond the wall
lintel_height   number m = one course  over openings
lintel_bearing  number m = half a unit  its length on the wall
snap            flag = false  openings are moved to the nearest joints
openings        list?             { storey = , x = , sill = , width = , height = , lintel = , sill_height = }, ...]] },
    { "rubble", "Irregular stones that fill a polygon.", keys = [[
name         text?     names begin with it
outline      points    to be filled
stones       integer = 50  how many
relaxations  integer = 3  more of them make the stones more even
aspect       number = 1  width over height
least_edge   number m = a tenth of a stone  shorter edges are left out
joint        number m = 0  between the stones
jitter       number m = 0  points are moved at random by up to this
seed         integer = 1  of the random numbers]] },
    { "running_bond", "A plain panel on a grid of half units, for limit loads.", keys = [[
name          text?          names begin with it
columns       integer = 5  units in a course
courses       integer = 6  how many
unit_width    number m = 0.4  of a unit
unit_height   number m = 0.2  of a unit
half_courses  text = "even"  which courses begin with a half unit: "odd" or "even"
at            point = {0, 0}  lower left corner
base_height   number m = 0  of the base
base_margin   number m = 0  beyond the panel
openings      list?          { from = , to = , first_course = , last_course = }, ...
lintels       list?          the same]] },
    { "bench_wall", "The wall that run times are measured on.", keys = "courses  integer = 24  how many" },
    { "ground", "Ground under a surface line.", keys = [[
name        text?      its name
surface     points?    its top, from left to right; or steps
steps       list?      { { from = , level = }, ... }
to          number m?  where the last step ends
base_level  number m   its bottom]], beside = { to = true } },
    { "pier", "A pier of footing, stem and cap.", keys = [[
name               text?         its name
x                  number m      its axis
ground_level       number m = 0  top of the ground
height             number m      above the ground
stem_width         number m = the top's  of the stem; with seat and gap it may be left out
top_width          number m = the stem's  of the cap
cap_thickness      number m = 0  of the cap
footing_width      number m = 0  of the footing
footing_thickness  number m = 0  of the footing
seat               number m?     length of each of its two seats: its top is as wide as both and the joint
gap                number m?     joint between the two decks that meet on it]] },
    { "abutment", "A stub abutment with a back wall.", keys = [[
name              text?          its name
side              text = "left"  "left" or "right"
x                 number m?      edge of its seat; or axis
axis              number m?      middle of the joint between deck and back wall; needs seat and gap
ground_level      number m = 0   its bottom
height            number m       from there to the seat
width             number m       of all of it
back_wall_height  number m = 0  above the seat
back_wall_width   number m = from seat and gap  of the back wall; or seat and gap
seat              number m?      length of the seat under the deck
gap               number m?      joint between deck and back wall]] },
  },
  { "model:span", "A deck on two supports made before: where it lies, its seats and its bearings follow from them; or "
    .. "a deck alone, between x0 and x1. Seats, and bearings of types with a law, are named such as \"S1.left\": "
    .. "span.seats.left, span.bearings.right.", keys = [[
name               text = "span"  its name
from               body?          left support: an abutment, a pier or a body with a level top
to                 body?          right support
left               text?          bearing type on the left support, see model:bearing_type
right              text?          bearing type on the right support
gap                number m?      joint on supports that do not say theirs
depth              number m       its height
soffit_level       number m = on its left bearing  its underside; without it, where its left bearing has it
weight_per_length  number N/m?    of the deck from end to end; or weight, mass, density
x0                 number m?      of a deck alone: axis of the left support
x1                 number m?      axis of the right support
end_gap            number m = 0   from the axis to its end]], with = "body", gives = "body" },
  { "model:bearing_type", "A kind of bearing for the ends of spans. Without a law the deck lies and slides on its "
    .. "seat, as on an expansion bearing.", keys = [[
name     text            its name
height   number m = 0    from the seat to the deck; above 0 it needs an axial law
along    direction law?  force along; alone it is a dowel: the deck lies on its seat
axial    direction law?  force across, which carries the deck; without height instead of their flat contact
turning  direction law?  moment
limit    table?          { along = , axial = , turning = }: displacements that end it
becomes  contact law?    of deck and support after it failed; or the name of one
contact  contact law?    of deck and support from the start; or the name of one]], gives = "string" },
  { "model:bridge", "Simple spans on piers between two abutments, from two tables. What it gives has supports and "
    .. "spans: bodies, in order and by name.", keys = [[
supports      list          from left to right: name, height from ground to deck, what model:pier, model:abutment take
spans         list          from left to right: name, length from axis to axis, what model:span takes
x             number m = 0  axis of the first support
soffit_level  number m = 0  underside of the decks; seats are lower by the height of their bearings
gap           number m?     joints, where a support says nothing else
seat          number m?     length of seats, where a support says nothing else
material      text?         where a row says nothing else
abutment      table?        what both abutments have in common; its back_wall_height counts from the deck's underside
pier          table?        what all piers have in common
span          table?        what all spans have in common]], gives = "table" },
}
