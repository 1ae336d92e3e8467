return {
  name = "values", title = "Units, parameters, laws and motions",
  { "trilith.units", "Returns the factors that convert units to SI: local ft, kip = trilith.units \"ft kip\".",
    args = "names  text  unit names, separated by blanks", gives = "number..." },
  -- As in Lua's `math`, which calls the C library (docs/decisions/code/0011-same-bits.md).
  { "trilith.math.sin", "Sine, bit-identical on every processor.", args = "angle  number rad  any", gives = "number" },
  { "trilith.math.cos", "Cosine, bit-identical on every processor.", args = "angle  number rad  any",
    gives = "number" },
  { "trilith.math.tan", "Tangent, bit-identical on every processor.", args = "angle  number rad  any",
    gives = "number" },
  { "trilith.math.asin", "Arc sine [rad], bit-identical on every processor.", args = "x  number  -1 to 1",
    gives = "number" },
  { "trilith.math.acos", "Arc cosine [rad], bit-identical on every processor.", args = "x  number  -1 to 1",
    gives = "number" },
  { "trilith.math.atan", "Angle of (x, y) from the x axis [rad], bit-identical on every processor.", args = [[
y  number      height
x  number = 1  distance]], gives = "number" },
  { "trilith.math.exp", "Exponential, bit-identical on every processor.", args = "x  number  any", gives = "number" },
  { "trilith.math.log", "Natural logarithm, bit-identical on every processor.", args = "x  number  above 0",
    gives = "number" },
  { "trilith.math.pow", "base^exponent, bit-identical on every processor. Lua's ^ is bit-identical only for squares.",
    args = [[
base      number  base
exponent  number  exponent]], gives = "number" },
  { "trilith.rayleigh", "Rayleigh damping: mass and stiffness coefficients for two damping ratios at two frequencies. "
    .. "Returns { mass_damping, beta }: mass_damping of the model, beta of laws and materials.", keys = [[
ratios       numbers     two damping ratios
frequencies  numbers     their frequencies, in Hz]], gives = "table" },
  { "trilith.joint_stiffness", "Stiffness of joints from the measured modulus of a wall under vertical load, with "
    .. "units and joints in series: kn = 1/(h (1/E_wall - 1/E_unit)). Several moduli give kn as a power of the stress. "
    .. "Joints that open are softer than under vertical load. Returns { kn, ks, wall_modulus } in Pa/m and Pa.",
    also = "joint stiffness, calibration, modulus of masonry, Young's modulus, kn, ks", keys = [[
wall_modulus   table or number  modulus of the wall, in Pa, or rows { {stress, modulus}, ... } in Pa
unit_modulus   number Pa?    modulus of the units, above the wall's modulus; rigid units if left out  <above 0>
course_height  number m      height of a course with its joint  <above 0>
stress         number Pa?    with rows: stress at which the stiffness is wanted  <above 0>
shear_ratio    number = 0.4  ks over kn  <above 0>]], gives = "table" },
  { "trilith.calibrate", "Fits any numbers of a script to measured frequencies, by least squares of the logarithms. It "
    .. "builds one model for each trial, in the plane or in space, and closes it. Returns as m:calibrate with "
    .. "frequencies.",
    also = "model updating, system identification, Young's modulus, soil stiffness, measured frequencies", keys = [[
build        function         f(values): builds a model, brings it to rest and returns it
vary         table            start values by name, above 0, such as { E = 3e9, kn = 1e9 }
frequencies  numbers          measured frequencies, at least as many as numbers vary, in Hz
modes        table?           numbers of their modes; 1, 2, ... if left out; or
shapes       table?           their shapes, { body = { x =, y = } }, in space z too; the most similar modes are used
range        number = 1000    greatest factor by which a number changes  <above 0>
scatter      number = 0.01    relative scatter of the measured frequencies, for deviations  <above 0>
tolerance    number = 0.0001  relative tolerance of the numbers  <above 0>]], gives = "table" },
  { "trilith.params", "Parameters of the script, set by trilith run model.lua name=value.",
    args = "declared  table  name = { default, unit = , choices = , \"sentence\" }", gives = "table" },
  { "trilith.version", "Version of the program.", type = "string" },
  { "trilith.motion", "A ground motion: a file, samples, or a steady velocity. The ground rests before the first "
    .. "sample and after the last one. A motion that ends at speed therefore stops its body within one step, with a "
    .. "note.",
    args = "file  text?  file of accelerations; or the table",
    keys = [[
file          text?              file of accelerations
acceleration  numbers?           samples [m/s2]
dt            number s?          time step of the samples, also of a file of plain columns  <1e-9 to 1e6>
unit          text?              file of plain columns: unit of the accelerations, as in "cm/s2" or "g"
column        text?              file of plain columns: number or name of the column; "rows": samples line by line
skip          integer?           file of plain columns: number of header lines  <0 to 1000000>
decimal       text?              file of plain columns: decimal sign, "." or ","
v0            number m/s = 0     velocity at the start
u0            number m = 0       displacement at the start
velocity      number m/s?        instead of samples: steady velocity
duration      number s?          duration of the steady velocity  <above 0>
allow_drift   flag = false       the motion may end at speed
name          text?              name in messages]], gives = "motion",
    beside = { duration = true, unit = true, column = true, skip = true, decimal = true } },
  { "trilith.ramp", "A smooth motion from rest to rest, for supports.", keys = [[
by        number           displacement [m] or rotation [rad]
duration  number s         duration  <above 0>]], gives = "motion" },
  { "motion:scale", "Scales a motion; factor 0 gives a control run.", keys = [[
pga      number m/s2?   peak acceleration after scaling; or  <at least 0>
factor   number?        factor; or
sa       number m/s2?   spectral acceleration at the period
period   number s?      period of sa  <0, or 0.001 to 100>
damping_ratio  number = 0.05  damping ratio of sa  <at least 0, below 1>]], gives = "motion" },
  { "motion:match", "Scales a motion so that its spectrum fits a target, by the mean of the logarithm.", keys = [[
spectrum  list           { { period, acceleration [m/s2] }, ... }
from      number s?      ignore shorter periods  <at least 0>
to        number s?      ignore longer periods  <above 0>
damping_ratio  number = 0.05  damping ratio of the spectrum  <at least 0, below 1>]], gives = "motion" },
  { "trilith.spectrum", "An elastic design spectrum by code name. Returns a list of points { period [s], "
    .. "acceleration [m/s2] } for motion:match, with the fields S, TB, TC, TD (asce7: SDS, SD1) and the function "
    .. "at(period). Code eurocode8 (EN 1998-1) takes type, ground and ag. Code asce7 (ASCE 7-16) takes SDS and SD1, "
    .. "or Ss, S1 and ground A to D. Code ntc2018 takes ground, ag, F0 and TC_star.",
    also = "response spectrum, Eurocode 8, ASCE 7, NTC 2018, code spectrum", keys = [[
code           text            "eurocode8", "asce7" or "ntc2018"
type           number = 1      eurocode8: 1 for surface-wave magnitudes above 5.5, or 2
ground         text?           ground type or site class: "A", "B", "C", "D" or "E"
ag             number m/s2?    eurocode8, ntc2018: peak acceleration on rock  <above 0>
F0             number?         ntc2018: amplification of the spectrum on rock  <above 0>
TC_star        number s?       ntc2018: start of the branch of constant velocity on rock  <above 0>
topography     number = 1      ntc2018: topographic factor  <above 0>
Ss             number?         asce7: mapped acceleration at short periods, as a share of g  <above 0>
S1             number?         asce7: mapped acceleration at 1 s, as a share of g  <above 0>
SDS            number?         asce7: design acceleration at short periods, instead of Ss, as a share of g  <above 0>
SD1            number?         asce7: design acceleration at 1 s, instead of S1, as a share of g  <above 0>
TL             number s = 8    asce7: long-period transition  <above 0>
damping_ratio  number = 0.05   eurocode8, ntc2018: damping ratio  <above 0>
periods        numbers?        periods of the points, in s; default 60 from 0.02 s to 4 s and the corners]],
    gives = "list" },
  { "trilith.stochastic_motion", "An artificial ground motion: noise with the spectrum of Kanai and Tajimi and the "
    .. "filter of Clough and Penzien, under an envelope. Equal seeds give the same bits. Velocity and displacement end "
    .. "at 0. Give rms or pga.",
    also = "synthetic ground motion, random process, Kanai-Tajimi, Clough-Penzien, artificial accelerogram", keys = [[
seed               integer = 1      seed of the random numbers
rms                number m/s2?     standard deviation of the strong part; or
pga                number m/s2?     peak acceleration
duration           number s = 20    duration
dt                 number s = 0.01  time step
ground_frequency   number Hz = 2.5  frequency of the ground; 2.5 Hz firm, 1.5 Hz medium, 0.8 Hz soft
ground_damping     number = 0.6     damping ratio of the ground
filter_frequency   number Hz = 0.25  frequency below which the filter removes the motion
filter_damping     number = 0.6     damping ratio of the filter
highest_frequency  number Hz?       end of the spectrum; default the smaller of 25 Hz and 0.25/dt
envelope           table?           { rise = [s], strong = [s], decay = [1/s] }, or false: stationary]],
    gives = "motion" },
  { "motion:baseline", "Baseline correction: subtracts the polynomial that fits the acceleration best.",
    args = "degree  integer  0 to 10", gives = "motion" },
  { "motion:filter", "Butterworth filter, forward and backward: no phase shift, -3 dB at the corner frequencies.",
    keys = [[
low    number Hz?    remove lower frequencies  <at least 0>
high   number Hz?    remove higher frequencies  <at least 0>
order  integer = 4   order of each side  <1 to 10>
pad    number s = 0  time of rest added before and after the record  <0 to 10000>]], gives = "motion" },
  { "motion:resample", "Resamples by linear interpolation; a filter precedes a longer step.",
    args = "dt  number s  new time step", gives = "motion" },
  { "motion:rotate", "Rotates two horizontal components counter-clockwise: a cos + b sin, and "
    .. "b cos - a sin.", args = [[
other  motion      the other component
angle  number rad  angle of rotation]], gives = "motion, motion" },
  { "motion:passage", "Delays a motion by the travel time of a wave, for supports along a bridge.", keys = [[
distance  number m    distance from the origin of the motion
velocity  number m/s  velocity of the wave  <above 0>]], gives = "motion" },
  { "motion:difference", "Largest relative displacement and velocity of two motions, such as those at two supports: "
    .. "{ displacement, displacement_time, velocity, velocity_time }, in m, s and m/s.",
    args = "other  motion  other motion", gives = "table" },
  { "motion:sa", "Pseudo-acceleration of an oscillator on this ground [m/s2].", args = [[
period   number s       period
damping  number = 0.05  damping ratio]], gives = "number" },
  { "motion:scale_as", "Scales a motion by the factor of another motion.", args = "other  motion  other motion",
    gives = "motion" },
  { "motion:time_scale", "Scales the time axis; accelerations stay.", args = "factor  number  above 0",
    gives = "motion" },
  { "motion:delay", "Delays a motion.", args = "time  number s  delay", gives = "motion" },
  { "motion:reverse", "Reverses the sign of a motion.", gives = "motion" },
  { "motion:start_velocity", "Sets the velocity at the start; accelerations stay.",
    args = "velocity  number m/s  velocity at the start", gives = "motion" },
  { "motion:at", "Acceleration, velocity and displacement at a time.", args = "time  number s  time",
    gives = "number, number, number" },
  fields = { motion = { description = "string" }, ["contact law"] = { name = "string" } },
  examples = {
    ["trilith.units"] = [[
local ft, kip = trilith.units "ft kip"
print(12*ft, 3*kip)]],
    ["trilith.math.sin"] = [[
print(trilith.math.sin(math.pi/6))]],
    ["trilith.math.cos"] = [[
print(trilith.math.cos(math.pi/3))]],
    ["trilith.math.tan"] = [[
print(trilith.math.tan(math.pi/4))]],
    ["trilith.math.asin"] = [[
print(trilith.math.asin(0.5))]],
    ["trilith.math.acos"] = [[
print(trilith.math.acos(0.5))]],
    ["trilith.math.atan"] = [[
print(trilith.math.atan(1, 2))]],
    ["trilith.math.exp"] = [[
print(trilith.math.exp(-0.5))]],
    ["trilith.math.log"] = [[
print(trilith.math.log(10))]],
    ["trilith.math.pow"] = [[
print(trilith.math.pow(2, 0.5))]],
    ["trilith.params"] = [[
local p = trilith.params { pga = { 0.4, unit = "g", "peak acceleration" },
  bond = { "english", choices = { "english", "flemish" } } }
print(p.pga, p.bond)]],
    ["trilith.version"] = [[
print(trilith.version)]],
    ["trilith.rayleigh"] = [[
local damping = trilith.rayleigh { ratios = { 0.05, 0.05 }, frequencies = { 1, 10 } }
print(damping.mass_damping, damping.beta)]],
    ["trilith.calibrate"] = [[
local found = trilith.calibrate { frequencies = { 36 }, vary = { E = 2e11 }, build = function(v)
  local mast = trilith.model { name = "mast", thickness = 1, gravity = 0 }
  mast:material { name = "steel", density = 7850, E = v.E }
  mast:frame { name = "mast", material = "steel", floating = true,
    joints = { foot = { at = { 0, 0 }, support = "fixed" }, head = { 0, 3 } },
    members = { { from = "foot", to = "head", section = trilith.rectangle_section { width = 0.1, depth = 0.2 } } } }
  return mast
end }
print(found.values.E)]],
    ["trilith.joint_stiffness"] = [[
local joint = trilith.joint_stiffness { wall_modulus = { { 1.5e5, 5.66e8 }, { 5e5, 7.56e8 } }, stress = 3e5,
  unit_modulus = 15.5e9, course_height = 0.1 }
print(joint.kn, joint.ks)]],
    ["trilith.spectrum"] = [[
local target = trilith.spectrum { code = "eurocode8", type = 1, ground = "C", ag = 2.5 }
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
print(target.at(0.5), pulse:match { spectrum = target, from = 0.2, to = 2 }.pga)]],
    ["trilith.stochastic_motion"] = [[
local bin = {}
for seed = 1, 3 do bin[seed] = trilith.stochastic_motion { seed = seed, pga = 3, duration = 10 } end
print(bin[1].pga, bin[2]:at(2))]],
    ["trilith.motion"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
print(pulse.pga)]],
    ["trilith.ramp"] = [[
local ramp = trilith.ramp { by = 0.05, duration = 2 }]],
    ["motion:scale"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
print(pulse:scale { pga = 3 }.pga)]],
    ["motion:match"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local scaled = pulse:match { spectrum = { { 0.1, 4 }, { 0.5, 4 }, { 1, 2 } }, from = 0.1, to = 1 }]],
    ["motion:baseline"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
print(pulse:baseline(1).pga)]],
    ["motion:filter"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local smooth = pulse:filter { low = 0.2, high = 4, order = 4, pad = 1 }]],
    ["motion:resample"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local fine = pulse:resample(0.01)]],
    ["motion:rotate"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local other = trilith.motion { acceleration = { 0, 0.5, -0.5, 0 }, dt = 0.1 }
local along, across = pulse:rotate(other, math.pi/6)]],
    ["motion:passage"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local at_pier = pulse:passage { distance = 120, velocity = 800 }]],
    ["motion:difference"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local later = pulse:delay(0.05)
print(pulse:difference(later).displacement)]],
    ["motion:scale_as"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local scaled = pulse:scale { pga = 3 }
local vertical = trilith.motion { acceleration = { 0, 0.5, -0.5, 0 }, dt = 0.1 }:scale_as(scaled)]],
    ["motion:time_scale"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local slow = pulse:time_scale(2)]],
    ["motion:delay"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local later = pulse:delay(0.5)]],
    ["motion:reverse"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local other_way = pulse:reverse()]],
    ["motion:start_velocity"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local moving = pulse:start_velocity(-0.1)]],
    ["motion:at"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
local acceleration, velocity, displacement = pulse:at(0.15)]],
    ["motion:sa"] = [[
local pulse = trilith.motion { acceleration = { 0, 1, -1, 0 }, dt = 0.1 }
print(pulse:sa(0.5))]],
  },
}
