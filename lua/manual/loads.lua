local until_keys = [[

until_true      function?     control "time": ends when f(model), called after each step, is true; limit "until"
until_collapse  flag = false  control "time": ends at a collapse: true, or { drop = [m], bodies = number of bodies }]]
local load_curve = "a factor, { ramp = seconds }, { smooth = seconds } or { {time, share}, ... }"

return {
  name = "loads", title = "Loads over time, pushover and release",
  { "model:point_load", "Applies a force or moment to a body, from the call on. Returns its name.", keys = [[
body    bodies          loaded bodies
force   point?          force [N]; in space {x, y, z}
moment  number N m = 0  moment; in space a vector {x, y, z}
at      place = "centroid"  point {x, y} of the body, {x, y, z} in space, or the name of a place or of a frame's joint
follow  flag = false    the force turns with the body
load_curve  load curve = all at once  factor over time: ]] .. load_curve .. [[

name    text?           name in results]], gives = "string",
    example = 'm:point_load { body = "block", force = { 100, 0 }, load_curve = { ramp = 0.1 } }' },
  { "model:pressure", "Applies a pressure to faces of a body, from the call on. Returns its name.", keys = [[
body       bodies     loaded bodies
value      number Pa  pressure onto the face
face       text?      top, bottom, left, right or all; in space front and back too
from       point?     in the plane, instead of face: start of a part of the outline
to         point?     end of that part, counter-clockwise
direction  point = against the face  direction of the pressure; in space {x, y, z}
follow     flag?      the pressure turns with the body
load_curve  load curve = all at once  factor over time: ]] .. load_curve .. [[

name       text?      name in results]], gives = "string",
    example = 'm:pressure { body = "block", face = "left", value = 500 }' },
  { "model:water", "Water at rest against faces of bodies, from the call on. The pressure follows the faces as "
    .. "they lie, so buoyancy is included. Returns its name.",
    also = "hydrostatic pressure, buoyancy, reservoir, flood, level, dam, uplift, float", keys = [[
body     bodies          bodies in contact with the water
level    level           elevation of the surface [m]: a number, or { {time, level}, ..., smooth = true }
side     text?           faces that the water reaches: left, right, top, bottom or all; in space front and back too
from     point?          in the plane, instead of side: start of a part of the outline
to       point?          end of that part, counter-clockwise
density  number kg/m3 = 1000  density of the water  <above 0>
joints   text = "sealed"  "sealed": the parts of faces in contact are dry; "wet": water reaches the whole face
name     text?           name in results]], gives = "string",
    example = 'm:water { body = "block", level = 0.5, side = "left" }' },
  { "model:set_level", "Changes the level of a water, smoothly, from the call on. Uplift follows it.", keys = [[
name      text          name of the water
level     number m      new elevation of the surface
duration  number s = 0  time in which it is reached  <at least 0>]],
    example = 'local lake = m:water { body = "block", level = 0.5, side = "left" }\n'
      .. 'm:set_level { name = lake, level = 0.2, duration = 1 }' },
  { "model:uplift", "Water in the joint between two bodies: a linear head from the water upstream to the water "
    .. "downstream or the toe, and the full head in the part that opens from the heel. Returns its name.",
    also = "uplift pressure, crack, drain, heel, toe, gravity dam", keys = [[
upper       body            the body above the joint
lower       body            the body below it; their faces lie on each other at the start
upstream    text            name of the water that enters at the heel
downstream  text?           name of the water at the toe; none: pressure 0 at the toe
head        text = "linear"  "linear" or "full": the head upstream acts everywhere
drain       table?          { at = distance from the heel [m], efficiency = share of the head that it takes, 0 to 1 }
heel        point?          a point at the end where the water enters; from the faces upstream if left out
name        text?           name in results]], gives = "string",
    example = 'local lake = m:water { name = "lake", body = "block", level = 0.5, side = "left" }\n'
      .. 'm:uplift { upper = "block", lower = "ground", upstream = lake }' },
  { "model:drag", "Drag of a flow on a body, c rho A u^2 / 2 with the velocity u of the flow relative to the body. "
    .. "Returns its name.", also = "current, flood, pier, stream", keys = [[
body         body            the body
velocity     point           velocity of the flow {x, y} [m/s]; in space {x, y, z}
coefficient  number          drag coefficient  <above 0>
area         number m2       area across the flow  <above 0>
density      number kg/m3 = 1000  density of the water  <above 0>
at           point = the centroid  point of action; must be given for a body that deforms
load_curve   load curve = all at once  factor of the velocity: ]] .. load_curve .. [[

name         text?           name in results]], gives = "string",
    example = 'm:drag { body = "block", velocity = { 2, 0 }, coefficient = 1.2, area = 0.5 }' },
  { "model:added_mass", "Mass of the water that moves with a body: on an upright face by Westergaard, across the face "
    .. "alone, or around a slender cylinder, along all horizontal axes. Returns its name.",
    also = "Westergaard, hydrodynamic mass, earthquake, reservoir, pier", keys = [[
body     body            a body; in space a rigid one or a frame
level    number m        elevation of the surface at the start
bed      number m        elevation of the bed
from     number m = the bed  elevation from which this body has the face, if others lie below it
to       number m = the level  elevation up to which this body has the face
side     text?           left or right, in space front or back too: the side of the face
form     text = "exact"  "exact": the series for incompressible water; "parabola": 7/8 of its square root law
width    number m?       in space: width of the face  <above 0>
radius   number m?       instead of side: of a cylinder whose axis goes through the body's centre  <above 0>
density  number kg/m3 = 1000  density of the water  <above 0>
name     text?           name in results]], gives = "string",
    example = 'm:added_mass { body = "block", side = "left", level = 0.8, bed = 0.2 }' },
  { "model:water_state", "Force and level of a water, or the state of a joint with uplift, at the present instant. "
    .. "A water has level [m], force [N] and moment about the origin [N m]. An uplift has these for the upper "
    .. "body, and crack, open_toe and length of the joint [m].",
    args = "name  text  name of the water or uplift", gives = "table",
    example = 'local lake = m:water { body = "block", level = 0.5, side = "left" }\n'
      .. 'print(m:water_state(lake).force[1])' },
  { "model:set_load", "Changes the share of a load, smoothly, from the call on.", keys = [[
name      text          name of the load
factor    number        new share
duration  number s = 0  time in which the share is reached  <at least 0>]],
    example = 'local push = m:point_load { body = "block", force = { 100, 0 } }\n'
      .. 'm:set_load { name = push, factor = 0.5, duration = 1 }' },
  { "model:release", "Releases a support, a load or a push without a jolt.", keys = [[
body      bodies?       bodies whose supports are released; or
load      text?         name of a load; or
push      text?         name of a push
x         flag = false  for bodies: release this direction; all directions if none is given
y         flag = false  release this direction; z too in space
rotation  flag = false  release this direction
fade      number s = 1  time in which the force decreases to 0  <at least 0>]],
    example = 'm:fix("block", "x")\nm:run { duration = 0.01 }\nm:release { body = "block", x = true, fade = 0.1 }' },
  { "model:pushover", "A stage under displacement control: pushes bodies steadily and returns the capacity curve.",
    also = "nonlinear static analysis, capacity curve, pushover curve, limit load, displacement control, arc length",
    keys = [[
body          bodies           pushed bodies
at            place = "centroid"  a point {x, y} of one body, {x, y, z} in space, or the name of a place or joint
direction     text = "x"       x, -x, y or -y; in space z or -z too
top           text = "free"    "level": the pushed bodies do not rotate any more; "locked": they keep their height too
pattern       text = "mass"    distribution of the force over the bodies: mass, uniform or triangle
control       text = "time"    "time": steady motion; "arc": states of equilibrium by arc length, past limit points
rate          number m/s?      control "time": speed; if left out, slow enough that inertia stays small  <above 0>
arc           number m?        control "arc": length of the first step; 0.01 of the displacement if left out  <above 0>
displacement  number m?        displacement at which the stage ends; or drift  <above 0>
drift         number m?        drift of the top at which the stage ends; in space along the push  <above 0>
storey        integer?         storey of this drift  <at least 1>
drop          number?          share of the peak force at which the stage ends  <at least 0, below 1>
samples       integer?         number of points of the curve; control "arc": largest number  <at least 2>
local_damping  number = 0.8    control "time": local damping coefficient  <at least 0, below 1>
name          text?            name in results
dt            number s?        control "time": fixed time step  <at least 0>
safety        number = 0.5     control "time": share of the longest stable step  <above 0, at most 0.9>
watch         flag = true      control "time": ends as diverged if speeds or energies have no physical source
on_sample     function?        f(model, sample) at each sample { t, displacement, force, drift }]] .. until_keys,
    gives = "pushover report", example = 'm:consolidate { rest = { ratio = 1e-4 } }\n'
      .. 'local p = m:pushover { body = "block", rate = 0.01, displacement = 1e-3 }\n'
      .. 'print(p.peak_force, p.displacement_at_peak, #p.curve.t)' },
  { "trilith.bilinear", "Bilinear idealisation of a capacity curve by code, with the displacements of the limit "
    .. "states, and the target displacement under a spectrum. Code eurocode8 (EN 1998-1 annex B) takes the peak "
    .. "force as yield force, with equal areas up to the peak. Code ntc2018 takes the secant stiffness at a share of "
    .. "the peak, with equal areas up to the drop.",
    also = "capacity curve, N2 method, idealised curve, performance point, ductility, limit states", keys = [[
curve          table         report of m:pushover, or its curve
code           text = "eurocode8"  "eurocode8" or "ntc2018"
drop           number = 0.2  ultimate displacement: share of the peak force lost; ntc2018: 0.15  <above 0, below 1>
elastic        number = 0.6  ntc2018: share of the peak force for the stiffness  <above 0, below 1>
mass           number kg?    mass of the equivalent oscillator, for the period  <above 0>
participation  number = 1    participation factor of the oscillator  <above 0>
spectrum       table?        demand from trilith.spectrum, for the target displacement]], gives = "bilinear",
    example = 'local curve = { displacement = { 0.01, 0.02, 0.06 }, force = { 8e4, 1e5, 1e5 } }\n'
      .. 'print(trilith.bilinear { curve = curve, code = "ntc2018" }.ductility)' },
  { "trilith.drift_limit", "Drift limit of a masonry wall in its plane as a share of its height, by EN 1998-3 "
    .. "annex C. At significant damage it is 0.004 in shear and 0.008 height/depth in flexure. Secondary walls have "
    .. "0.006 and 0.012. At near collapse it is 4/3 of this.",
    keys = [[
mode       text          failure mode: "flexure" or "shear"
state      text = "significant damage"  limit state: "significant damage" or "near collapse"
secondary  flag = false  a secondary wall
height     number m?     flexure: distance from the section to the point of contraflexure  <above 0>
depth      number m?     flexure: length of the wall in its plane  <above 0>]], gives = "number",
    example = 'print(trilith.drift_limit { mode = "flexure", height = 2.5, depth = 1.5 })' },
}
