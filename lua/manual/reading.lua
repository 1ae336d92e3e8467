return {
  name = "reading", title = "Reading and recording",
  { "model:bodies", "A set of bodies; * and ? stand for letters.", keys = [[
group     names?  of one of these groups
material  names?  of one of these materials
name      names?  of these names]], gives = "set" },
  { "set:has", "True where all of it is in this set.",
    args = "bodies  bodies  a body, set, name or list", gives = "boolean" },
  { "set:damage_by_storey", "What became of a wall or a building: rows, lowest storey first, of { storey, joints, "
    .. "joints_apart, units, units_out_of_place }. Joints are those of the start between bodies of the set. A unit "
    .. "is out of place when its centroid has moved sideways against the floor under its storey by more than the "
    .. "limit, or has come down by more than it.",
    keys = [[
apart         number m = 0.0127  a joint that opened or slipped by more is apart (half an inch)
out_of_place  number m = 0.0254  a unit that moved by more is out of place (an inch)]], gives = "table[]" },
  { "body:point", "Where the point is now that was there at the start: x and y, in space z too.",
    args = "place  place  {x, y} at the start, in space {x, y, z}; or the name of a frame's joint",
    gives = "number, number" },
  { "body:reactions", "What holds or drives each node of a body that is held or driven: { x, y, fx, fy, m }, in "
    .. "space { x, y, z, fx, fy, fz, mx, my, mz }; the force that the support has on it, its own weight and "
    .. "inertia with it. Sums are body.reaction_x, reaction_y and, in space, reaction_z.", gives = "table[]" },
  { "model:contacts", "Contacts that carry force: { a, b, law, hold, slip, normal, shear, point, force }; point and "
    .. "force are {x, y}, the force that acts on b. In space {x, y, z}, and area and direction, of the normal, too.",
    keys = "between  two bodies?  or sets, or names", gives = "table[]" },
  { "model:history", "Follows a number over time.", keys = [[
name     text       what results call it
what     text?      which number of
body     body?      this body
bearing  bearing?   or bearing
seat     seat?      or seat
storey   integer?   or storey; of the model where none is given
of       function?  or what a function gives
unit     text?      of the function's values
doc      text?      what they are
every    number s?  without results: how often]], gives = "history", beside = { unit = true, doc = true } },
  { "model:results", "What is written, and how often.", keys = [[
file        text              one HDF5 file
frames      number s = 0.05   between pictures of the whole model
histories   number s = 0.01   between samples of the histories
energy      number s = 0.05   between rows of the ledger
velocities  flag = false      with the velocities in each frame
joints      flag = true       with opening, slip and damage of each joint]] },
  { "model:explain_dt", "Which body and contacts govern the length of a step.", gives = "string" },
  { "model:joints", "Faces that lay on each other at the start: { a, b, opening, slip, damage, storey, x, y }; in "
    .. "space z and area too, of plane faces, and a slip that is a length.",
    gives = "table[]" },
  { "model:thrust_line", "Where the force goes through a chain of bodies: { a, b, x, y, fx, fy }, in space z and fz "
    .. "too.",
    args = "bodies  bodies  in order", gives = "table[]" },
  { "model:modes", "Natural frequencies as it stands, lowest first: { frequency, period, square, mass_x, mass_y, "
    .. "factor_x, factor_y, damping, shape }; shape by body's name: { x, y, rotation }. "
    .. "In space mass_z and factor_z too, and shapes { x, y, z, turn_x, turn_y, turn_z }. "
    .. "Prints as a table; goes to the results file.",
    keys = "count  integer = 10  how many", gives = "table[]" },
  { "model:damping", "Share of critical damping for each mode as it stands: { frequency, ratio, contacts, bearings, "
    .. "elements, bands, mass }, the sum and what gives it; step and unbanded_step [s], the longest stable one and "
    .. "that without damping over bands. Prints as a table.",
    keys = "count  integer = 10  how many modes", gives = "table[]" },
  { "model:calibrate", "Fits stiffnesses of joints to a measured frequency, in the plane; the model keeps them. Gives "
    .. "{ value, values, frequency, mode, tries }, which prints as a table of the tries.", keys = [[
frequency  number Hz        as measured
vary       names            such as "mortar.kn"; several keep their ratio: { "mortar.kn", "mortar.ks" }
mode       integer = 1      which mode is to have it; or
shape      table?           a shape from m:modes: the mode most like it
between    numbers?         least and most value of the first; a thousandth and a thousand times what it is
tolerance  number = 0.0001  of the frequency
settle     flag = false     finds rest by statics after each change]], gives = "table" },
  { "model:stresses", "In the plane, mean stress { xx, yy, xy, major, minor } by body's name [Pa].", gives = "table" },
}
