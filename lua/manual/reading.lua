return {
  name = "reading", title = "Reading and recording",
  { "model:bodies", "Returns a set of bodies. In names, * matches any letters and ? one letter.", keys = [[
group     names?  only of these groups
material  names?  only of these materials
name      names?  only with these names]], gives = "set" },
  { "set:has", "True if the set contains all of these bodies.",
    args = "bodies  bodies  a body, set, name or list", gives = "boolean" },
  { "set:damage_by_storey", "Damage of a wall or a building: rows { storey, joints, joints_apart, units, "
    .. "units_out_of_place }, lowest storey first. Joints between bodies of the set at the start are counted. A unit "
    .. "is out of place if its centroid has moved by more than the limit, down or sideways relative to the floor "
    .. "under its storey.",
    keys = [[
apart         number m = 0.0127  limit of opening or slip of a joint that is apart (half an inch)  <at least 0>
out_of_place  number m = 0.0254  limit of motion of a unit that is out of place (an inch)  <at least 0>]],
    gives = "table[]" },
  { "body:point", "Present position of a material point, given by its position at the start: x and y, in space z too.",
    args = "place  place  {x, y} at the start, in space {x, y, z}; or the name of a frame's joint",
    gives = "number, number" },
  { "body:reactions", "Reactions at each node of a held or driven body: { x, y, fx, fy, m }, in space "
    .. "{ x, y, z, fx, fy, fz, mx, my, mz }. They include the weight and inertia of the node. "
    .. "Sums are body.reaction_x, reaction_y and, in space, reaction_z.", gives = "table[]" },
  { "model:contacts", "Contacts that carry force: { a, b, law, hold, slip, normal, shear, point, force }. Point "
    .. "and force are {x, y}; the force acts on b. In space {x, y, z}, with area and direction of the normal too.",
    keys = "between  two bodies?  or sets, or names", gives = "table[]" },
  { "model:history", "Records a number over time.", keys = [[
name     text       name in results
what     text?      name of the reading
body     body?      body of the reading
bearing  bearing?   or bearing
seat     seat?      or seat
storey   integer?   or storey; the model if none is given  <at least 1>
seepage  text?      or a joint of m:seepage: pressure, head, aperture, fill; volume, wet_length, inflow, outflow
at       number m?  distance from the first end of that joint; the first four readings need it  <at least 0>
point    point?     with body and what = "temperature": a point of the body at the start
of       function?  or a function; its value is recorded
unit     text?      unit of the function's values
doc      text?      description of the values
every    number s?  without a results file: interval  <above 0>]], gives = "history",
    beside = { unit = true, doc = true } },
  { "model:results", "Sets the contents of the results file and the intervals.", keys = [[
file        text              name of the HDF5 file
frames      number s = 0.05   interval of frames, the states of the whole model  <above 0>
histories   number s = 0.01   interval of the samples of histories  <above 0>
energy      number s = 0.05   interval of the energy terms  <above 0>
velocities  flag = false      write the velocities in each frame
joints      flag = true       write opening, slip and damage of each joint]] },
  { "model:explain_dt", "Describes the body and the contacts that govern the time step.", gives = "string" },
  { "model:joints", "Joints: faces in contact at the start, as { a, b, opening, slip, damage, storey, x, y }. In "
    .. "space z and area of plane faces too, and a slip that is a length.",
    gives = "table[]" },
  { "model:thrust_line", "Line of thrust: resultant between successive bodies as { a, b, x, y, fx, fy }, in space z "
    .. "and fz too.",
    args = "bodies  bodies  in order", gives = "table[]" },
  { "model:modes", "Natural modes of the present state, lowest first: { frequency, period, square, mass_x, mass_y, "
    .. "factor_x, factor_y, damping, shape }; shape by body's name: { x, y, rotation }. "
    .. "In space mass_z and factor_z too, and shapes { x, y, z, rotation_x, rotation_y, rotation_z }. "
    .. "Prints as a table, and is written to the results file.",
    keys = "count  integer = 10  number of modes  <at least 1>", gives = "table[]" },
  { "model:damping", "Damping ratio of each mode in the present state: { frequency, ratio, contacts, bearings, "
    .. "elements, bands, mass }, the sum and its parts. The fields step and unbanded_step [s] are the longest stable "
    .. "step with and without band damping. Prints as a table.",
    keys = "count  integer = 10  number of modes  <at least 1>", gives = "table[]" },
  { "model:calibrate", "Fits stiffnesses of joints to measured frequencies. The model keeps them. With frequency: one "
    .. "number, until the mode has this frequency; returns { value, values, frequency, mode, tries }. With "
    .. "frequencies: "
    .. "several numbers by least squares of the logarithms; returns { values, factors, frequencies, modes, likeness, "
    .. "sensitivity, deviations, rms, rounds }. Both print as a table. sensitivity[i][j] is the relative change of "
    .. "frequency i for a unit relative change of number j.",
    also = "model updating, system identification, operational modal analysis, MAC, ambient vibration", keys = [[
frequency  number Hz?       measured frequency; or frequencies  <above 0>
frequencies  numbers?       measured frequencies, at least as many as numbers vary, in Hz
vary       names            such as "mortar.kn"; several keep their ratio; with frequencies each entry is one unknown
mode       integer = 1      with frequency: number of its mode; or  <at least 1>
shape      table?           with frequency: a shape from m:modes; the most similar mode is used
modes      table?           with frequencies: numbers of their modes; 1, 2, ... if left out; or
shapes     table?           with frequencies: their shapes, { body = { x =, y = } }; the most similar modes are used
between    numbers?         with frequency: least and greatest value; default 0.001 and 1000 times the present one
range      number = 1000    with frequencies: greatest factor by which a number changes  <above 0>
scatter    number = 0.01    with frequencies: relative scatter of the measured frequencies, for deviations  <above 0>
tolerance  number = 0.0001  relative tolerance of the frequency, or of the numbers  <above 0>
settle     flag = false     finds rest by statics after each change]], gives = "table" },
  { "model:stresses", "Mean stress by body name, in the plane: { xx, yy, xy, major, minor } [Pa].", gives = "table" },
  examples = {
    ["model:results"] = [[
m:results { file = "out/manual_example.h5", frames = 0.1, histories = 0.02 }
m:run { duration = 0.1 }]],
    ["model:calibrate"] = [[
m:contact { between = { "block", "ground" }, name = "mortar",
  law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 2e-4 } }
m:consolidate { integrator = "static" }
print(m:calibrate { frequency = 40, vary = { "mortar.kn", "mortar.ks" }, mode = 1 }.value)]],
    ["model:bodies"] = [[
print(#m:bodies { material = "stone" })]],
    ["set:has"] = [[
print(m:bodies { name = "b*" }:has "block")]],
    ["set:damage_by_storey"] = [[
local wall = m:wall { name = "wall", units = 2, courses = 2, at = { 1, 0 }, material = "stone" }
m:consolidate { rest = { ratio = 1e-3 } }
for _, row in ipairs(wall:damage_by_storey()) do print(row.joints_apart) end]],
    ["body:point"] = [[
m:run { duration = 0.01 }
local x, y = m:body("block"):point { 0.25, 1 }
print(x, y)]],
    ["body:reactions"] = [[
m:consolidate { rest = { ratio = 1e-4 } }
print(m:body("ground").reaction_y)]],
    ["model:contacts"] = [[
m:consolidate { rest = { ratio = 1e-4 } }
for _, c in ipairs(m:contacts { between = { "block", "ground" } }) do print(c.normal) end]],
    ["model:history"] = [[
local h = m:history { name = "top", body = "block", what = "ux" }
m:run { duration = 0.1 }
print(h.max)]],
    ["model:explain_dt"] = [[
print(m:explain_dt())]],
    ["model:joints"] = [[
m:consolidate { rest = { ratio = 1e-4 } }
for _, joint in ipairs(m:joints()) do print(joint.opening, joint.slip) end]],
    ["model:thrust_line"] = [[
m:consolidate { rest = { ratio = 1e-4 } }
print(#m:thrust_line { "ground", "block" })]],
    ["model:modes"] = [[
m:consolidate { integrator = "static" }
print(m:modes { count = 3 })]],
    ["model:damping"] = [[
m:consolidate { integrator = "static" }
print(m:damping { count = 3 })]],
    ["model:stresses"] = [[
m:consolidate { rest = { ratio = 1e-4 } }
print(m:stresses().block.yy)]],
  },
}
