return {
  name = "geometry", title = "Builders: parts of masonry and bridges",
  makers = {
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
