local until_keys = [[

until_true      function?     by time: end where f(model), asked after each step, is true; the limit is then "until"
until_collapse  flag = false  by time: end as something comes down: true, or { drop = [m], bodies = how many }]]
local course = "a factor, { ramp = seconds }, { smooth = seconds } or { {time, share}, ... }"

return {
  name = "loads", title = "Loads over time, pushes and quiet release",
  { "model:point_load", "A force or moment on a body from now on. Gives its name.", keys = [[
body    bodies          on what
force   point?          the force [N]; in space {x, y, z}
moment  number N m = 0  the moment; in space a vector {x, y, z}
at      place = "centroid"  a point {x, y} of the body, {x, y, z} in space, or the name of a place or of a frame's joint
follow  flag = false    it turns with the body
course  course = all at once  its share over time: ]] .. course .. [[

name    text?           what results call it]], gives = "string" },
  { "model:pressure", "A pressure on faces of a body from now on. Gives its name.", keys = [[
body       bodies     on what
value      number Pa  onto the face
face       text?      top, bottom, left, right or all; in space front and back too
from       point?     in the plane: or from this point of the outline
to         point?     to this one, counter-clockwise
direction  point = against the face  where it acts; in space {x, y, z}
follow     flag?      it turns with the body
course     course = all at once  its share over time: ]] .. course .. [[

name       text?      what results call it]], gives = "string" },
  { "model:set_load", "A load's share from now on, reached smoothly.", keys = [[
name      text          of the load
factor    number        its share
duration  number s = 0  over which it is reached]] },
  { "model:release", "Lets a support, a load or a push go without a jolt.", keys = [[
body      bodies?       bodies whose supports go; or
load      text?         a load; or
push      text?         a push
x         flag = false  of bodies: this direction; all where none is given
y         flag = false  this direction; z too in space
rotation  flag = false  this direction
fade      number s = 1  over which it goes]] },
  { "model:pushover", "A stage that pushes bodies steadily, and what that takes.", keys = [[
body          bodies           what is pushed
at            place = "centroid"  a point {x, y} of one body, {x, y, z} in space, or the name of a place or joint
direction     text = "x"       x, -x, y or -y; in space z or -z too
pattern       text = "mass"    share of each body: mass, uniform or triangle
control       text = "time"    "time": pushed steadily; "arc": by equilibria past limit points
rate          number m/s?      by time: how fast; left out, so slow that inertia stays small
arc           number m?        by arc: length of the first step; a hundredth of the displacement
displacement  number m?        how far; or drift
drift         number m?        until this drift of the top, in space along the push
storey        integer?         of this storey
drop          number?          until the force has fallen to this share of its peak
samples       integer?         of the curve; by arc at most so many
damping       number = 0.8     by time: share of the unbalanced force that brakes each body
name          text?            what results call it
dt            number s?        by time: fixed step
safety        number = 0.5     by time: share of the longest stable step, at most 0.9]] .. until_keys,
    gives = "report" },
}
