local rest = "true, or { speed = [m/s], ratio = , hold = [s], from = [s] }" -- ratio: out-of-balance ratio
local until_keys = [[

until_true       function?  the stage ends when f(model), called after each step, is true
until_collapse   flag = false  ends at a collapse: true, or { drop = [m], bodies = number of bodies }]]
local drive = [[
body      bodies   moved bodies
x         motion?  motion along x
y         motion?  motion along y
z         motion?  motion along z, in space
rotation  motion?  rotation about the centroid, in the plane
rotation_x    motion?  rotation about the world axis x through the centroid, in space
rotation_y    motion?  rotation about y
rotation_z    motion?  rotation about z
motions   list?    instead: { { body = , x = , y = , rotation = }, ... }]]
local in_space = { z = true, rotation_x = true, rotation_y = true, rotation_z = true } -- of drive
local scaling = "mass_scaling  table?  { step = [s], most = 30, bodies = }: longer steps by added mass that acts only "
  .. "on deformation"
local in_time = [[

integrator       text = "explicit"   "explicit", "implicit" (Newton's method), or "auto" (chosen at run time)
alpha            number = -0.05      implicit, HHT: from -1/3 to 0; 0 has no numerical damping (Newmark)  <-1/3 to 0>
spectral_radius  number?             implicit, instead: generalised alpha, 0 to 1  <0 to 1>
tolerance        number = 1e-8       implicit: residual force, as a share of the largest force  <above 0, at most 0.01>
accuracy         number?             energy error of a step, 0: any; default implicit 1e-3, explicit 0.02  <0 to 1>
watch       flag = true   ends the stage as diverged if speeds or energies have no physical source]]

return {
  name = "stages", title = "Stages: runs, and changes between and within them",
  { "model:run", "A stage of motion. Where the model pauses, it continues the paused stage up to that time.",
    also = "time history analysis, transient analysis, time integration", keys = [[
duration    number s?     duration  <above 0>
to          number s?     or the end time
name        text = "run"  name in results
local_damping  number = 0  local damping coefficient: braking share of the unbalanced force  <at least 0, below 1>
dt          number s?     fixed time step; by default automatic. Implicit: the longest step (5 ms)  <at least 0>
safety      number = 0.5  share of the longest stable step; 0.8 where accuracy is given  <above 0, at most 0.9>
]] .. scaling .. in_time .. [[

rest  rest?         ends the stage at rest: ]] .. rest .. until_keys, gives = "report",
    example = "local report = m:run { duration = 0.1 }\nprint(report.ending, report.steps)" },
  { "model:consolidate", "Brings the model to rest under dead load, by dynamic relaxation or statics.",
    also = "dead load, self weight, dynamic relaxation, static equilibrium", keys = [[
duration  number s = 60           longest duration  <above 0>
rest      rest?                   limits of rest: { ratio = 1e-5, speed = [m/s], hold = [s], from = [s] }
local_damping  number = 0.8       local damping coefficient: braking share of the residual  <at least 0, below 1>
grow      number s = 0.5          time in which gravity grows  <at least 0>
fresh     flag = false            mortar sets at the end: joints are bonded in their state at the end
or_go_on  flag = false            without rest, or at rest in another place: a note instead of an error
within    number = 0.25           largest motion of a body over its size; beyond it the model is unstable  <above 0>
integrator  text = "explicit"     "explicit", or "static": equilibrium by Newton's method, without time and damping
shares     integer = 1            static: number of load increments  <1 to 1000>
tolerance  number = 1e-8          static: residual force, as a share of the largest force  <above 0, at most 0.01>
name      text = "consolidation"  name in results
dt        number s?               fixed time step  <at least 0>
safety    number = 0.5            share of the longest stable step  <above 0, at most 0.9>
]] .. scaling .. [[

watch     flag = true             ends the stage as diverged if speeds or energies have no physical source]]
    .. until_keys, gives = "report",
    example = "local report = m:consolidate { rest = { ratio = 1e-4 } }\nprint(report.ending, report.ratio)" },
  { "model:shake", "Bodies follow ground motions.",
    also = "time history analysis, response history, earthquake, base excitation, seismic, ground motion",
    keys = drive .. [[

duration  number s?       duration; up to the end of the motions if left out  <above 0>
rest      rest?           ends the stage at rest after the motions: ]] .. rest .. [[

name      text = "shake"  name in results
dt        number s?       fixed time step  <at least 0>
safety    number = 0.5    share of the longest stable step; 0.8 where accuracy is given  <above 0, at most 0.9>
]] .. scaling .. in_time .. until_keys,
    beside = in_space, gives = "report",
    example = "local pulse = trilith.motion { acceleration = { 0, 2, -2, 0 }, dt = 0.05 }\n"
      .. 'm:shake { body = "ground", x = pulse, duration = 0.2 }' },
  { "model:drive", "A body follows a motion, from the call on.", also = "prescribed displacement, cyclic loading",
    keys = drive, beside = in_space,
    example = 'm:drive { body = "ground", x = trilith.ramp { by = 0.01, duration = 0.5 } }' },
  { "model:fix", "Holds bodies in some or all directions.", args = [[
bodies      bodies  a body, set, name, group or list of these
directions  text = all  of x, y and r, as in "xy"; in space of x, y, z and r; r means all rotations]],
    also = "boundary condition, constraint", example = 'm:fix("block", "x")' },
  { "model:free", "Frees bodies in some or all directions.", args = [[
bodies      bodies  a body, set, name, group or list of these
directions  text = all  of x, y and r, as in "xy"; in space of x, y, z and r; r means all rotations]],
    example = 'm:fix("block")\nm:free("block", "x")' },
  { "model:tilt", "Turns gravity, from the call on.", keys = [[
rate     number rad/s    counter-clockwise rate; 0 stops it
by       number rad?     angle at which it stops  <above 0>
towards  number rad = 0  in space: azimuth of the tilt, counted from x to y]], beside = { towards = true },
    example = "m:tilt { rate = 0.05, by = 0.1 }" },
  { "model:bounds", "Sets the region outside which bodies leave the model. A body that leaves stops, has no more "
    .. "contacts and causes an event. Default: ten times the extent of all bodies at the start, at least 100 m away.",
    keys = [[
left    number m?  least x
right   number m?  greatest x
front   number m?  least y, in space
back    number m?  greatest y, in space
bottom  number m?  least y, in space z
top     number m?  greatest y, in space z]], beside = { front = true, back = true },
    example = "m:bounds { bottom = -5 }" },
  { "model:stop", "Ends the running stage at the end of the step.",
    example = 'm:on("impact", function() m:stop() end)' },
}
