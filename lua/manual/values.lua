return {
  name = "values", title = "Units, parameters, laws and motions",
  { "trilith.units", "Factors that turn a number with a unit into SI: local ft, kip = trilith.units \"ft kip\".",
    args = "names  text  unit names, separated by blanks", gives = "number..." },
  -- As in Lua's `math`, which calls the C library (docs/decisions/0011-same-bits.md).
  { "trilith.math.sin", "Sine, the same bits on every processor.", args = "angle  number rad  any", gives = "number" },
  { "trilith.math.cos", "Cosine, the same bits on every processor.", args = "angle  number rad  any",
    gives = "number" },
  { "trilith.math.tan", "Tangent, the same bits on every processor.", args = "angle  number rad  any",
    gives = "number" },
  { "trilith.math.asin", "Arc sine [rad], the same bits on every processor.", args = "x  number  -1 to 1",
    gives = "number" },
  { "trilith.math.acos", "Arc cosine [rad], the same bits on every processor.", args = "x  number  -1 to 1",
    gives = "number" },
  { "trilith.math.atan", "Angle of (x, y) from the x axis [rad], the same bits on every processor.", args = [[
y  number      height
x  number = 1  distance]], gives = "number" },
  { "trilith.math.exp", "Exponential, the same bits on every processor.", args = "x  number  any", gives = "number" },
  { "trilith.math.log", "Natural logarithm, the same bits on every processor.", args = "x  number  above 0",
    gives = "number" },
  { "trilith.math.pow", "base^exponent, the same bits on every processor; Lua's ^ has them for squares alone.",
    args = [[
base      number  what is raised
exponent  number  to which power]], gives = "number" },
  { "trilith.rayleigh", "Damping of mass and of stiffness that gives two ratios at two frequencies: { mass_damping, "
    .. "beta }, for the model, and for its laws (beta) and materials (damping).", keys = [[
ratios       numbers     two shares of critical damping
frequencies  numbers     at which they are, Hz]], gives = "table" },
  { "trilith.params", "Parameters of the script, set by trilith run model.lua name=value.",
    args = "declared  table  name = { default, unit = , choices = , \"sentence\" }", gives = "table" },
  { "trilith.version", "Version of the program.", type = "string" },
  { "trilith.motion", "A ground motion: a file's name, samples, or a steady velocity. Before its first sample and "
    .. "after "
    .. "its last one the ground rests: a motion that ends at speed stops what follows it within one step, and a note "
    .. "says so.",
    args = "file  text?  name of a file with accelerations; or the table",
    keys = [[
file          text?              a file with accelerations
acceleration  numbers?           samples [m/s2]
dt            number s?          step of the samples; with a file of plain columns: of its samples
unit          text?              with a file of plain columns: of its accelerations, as in "cm/s2" or "g"
column        text?              with a file of plain columns: number or name of the accelerations; "rows": line by line
skip          integer?           with a file of plain columns: lines of head before the numbers
decimal       text?              with a file of plain columns: sign before decimals, "." or ","
v0            number m/s = 0     velocity at the start
u0            number m = 0       displacement at the start
velocity      number m/s?        instead of samples: a steady velocity
duration      number s?          of the steady velocity
allow_drift   flag = false       it need not end at rest, where it stops within one step
name          text?              what messages call it]], gives = "motion",
    beside = { duration = true, unit = true, column = true, skip = true, decimal = true } },
  { "trilith.ramp", "A motion from rest to rest, smoothly: for supports that are moved.", keys = [[
by        number           how far: m, or rad of a rotation
duration  number s         how long]], gives = "motion" },
  { "motion:scale", "The same times a factor; 0 makes a control run.", keys = [[
pga      number m/s2?   so that the largest acceleration is this
factor   number?        or times this
sa       number m/s2?   or so that the spectrum has this at the period
period   number s?      with sa
damping  number = 0.05  with sa]], gives = "motion" },
  { "motion:match", "Scaled so that its spectrum comes nearest to a target, in the mean of the logarithm.", keys = [[
spectrum  list           { { period, acceleration [m/s2] }, ... }
from      number s?      leave out shorter periods
to        number s?      leave out longer ones
damping   number = 0.05  of the spectrum]], gives = "motion" },
  { "motion:baseline", "Without the polynomial that fits its acceleration best.",
    args = "degree  integer  0 to 10", gives = "motion" },
  { "motion:filter", "Through a Butterworth filter forward and backward: no shift of phase, -3 dB at the corners.",
    keys = [[
low    number Hz?    take out what is slower
high   number Hz?    take out what is faster
order  integer = 4   of each side, 1 to 10
pad    number s = 0  rest set before and after the record, which stays]], gives = "motion" },
  { "motion:resample", "Samples at another step, linear between the old ones; a longer step is filtered first.",
    args = "dt  number s  the new step", gives = "motion" },
  { "motion:rotate", "Two horizontal components along axes turned counter-clockwise: a cos + b sin, and "
    .. "b cos - a sin.", args = [[
other  motion      the other component
angle  number rad  by which]], gives = "motion, motion" },
  { "motion:passage", "Later by the time a wave takes: supports along a bridge.", keys = [[
distance  number m    from where the motion comes
velocity  number m/s  of the wave]], gives = "motion" },
  { "motion:difference", "How far and how fast it moves against another motion, at most: { displacement, "
    .. "displacement_time, velocity, velocity_time }, in m, m/s and s. Of two supports of one bridge, however their "
    .. "motions were made.", args = "other  motion  the other one", gives = "table" },
  { "motion:sa", "Pseudo-acceleration of an oscillator on this ground [m/s2].", args = [[
period   number s       its period
damping  number = 0.05  share of the critical one]], gives = "number" },
  { "motion:scale_as", "The same by the factor another one was scaled by.", args = "other  motion  the other one",
    gives = "motion" },
  { "motion:time_scale", "The time axis times a factor; accelerations are kept.", args = "factor  number  above 0",
    gives = "motion" },
  { "motion:delay", "The same later.", args = "time  number s  how much later", gives = "motion" },
  { "motion:reverse", "The same the other way.", gives = "motion" },
  { "motion:start_velocity", "The same accelerations from another velocity at the start.",
    args = "velocity  number m/s  at the start", gives = "motion" },
  { "motion:at", "Acceleration, velocity and displacement at a time.", args = "time  number s  when",
    gives = "number, number, number" },
  fields = { motion = { description = "string" }, ["contact law"] = { name = "string" } },
}
