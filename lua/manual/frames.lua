return {
  name = "frames", title = "Frames: beams, members and their sections",
  { "model:beam", "A straight beam that bends and stretches; its top is on the left of the way to its end.",
    keys = [[
name          text                its name
from          point               its start, on the axis of the section
to            point               its end
section       section             such as trilith.rectangle_section{...}, or trilith.fibre_section{...}
divisions     integer = 8         beam elements in a row
shear         flag = false        with shear deformation (Timoshenko)
pinned        names?              "from", "to" or both: carries no moment there
hinge         hinge law?          a plastic hinge at both ends
from_hinge    hinge law?          ... at its start
to_hinge      hinge law?          ... at its end
stations      integer = 4         of fibres, along each beam element
rule          text = "lobatto"    where those are: "lobatto" (ends too) or "gauss"
from_support  text?               "fixed", "free" or directions { x = "fixed", rotation = "fixed" }
to_support    text?               the same of its end]], with = "beam", gives = "body" },
  { "model:frame", "Beams that meet at joints, as one body: a bent, a portal, a truss.", keys = [[
name     text   its name
joints   table  { A = {x, y}, B = { at = {x, y}, support = , mass = , inertia = }, C = { outline = , density = }, ... }
members  list   { { from = , to = , section = , name = , from_at = , to_at = , divisions = , hinge = , ... }, ... }]],
    with = "beam", gives = "body" },
  { "trilith.polygon_section", "A section of any simple polygon, in its own axes.", keys = [[
outline  points  corners in order: x out of the plane, y up metres]], gives = "section" },
  { "trilith.fibre_section", "A section of fibres, each with its law: concrete with bars, steel.", keys = [[
shape      section         its outline, such as trilith.rectangle_section{...}
law        fibre law       such as trilith.kent_park{...}; with a cover, of the core
layers     integer?        over the depth: 20; in space 8, of four fibres for each place across
layers_across  integer?    in space: places across; so many that cells are about square
cover      number m = 0    thickness outside of the core
cover_law  fibre law?      of the cover; else as the core
core       section?        its shape, instead of what the cover leaves
bars       list?           rows { area =, height = }, area of the row, height from below; in space count, across, spread
bar_law    fibre law?      of the bars, such as trilith.menegotto_pinto{...}]], gives = "section" },
  { "body:hinges", "Plastic hinges of a member: joint, state, rotation, stretch, moment, normal, given_off, x, y; in "
    .. "space z, and rotation_y, rotation_z, moment_y, moment_z.",
    args = "member  text?  its name", gives = "table[]" },
  { "body:fibres", "Sections along a member of fibres: along, axial, curvature, normal, moment, and fibres, each with "
    .. "height, area, strain, stress; in space curvature_y, curvature_z, moment_y, moment_z, and fibres with up and "
    .. "across.", args = "member  text?  its name", gives = "table[]" },
  { "body:forces", "Inner forces along a member of a beam or frame, a row for both ends of each of its beams: along, "
    .. "x, y, normal, shear, moment; in space z, shear_y, shear_z, torque, moment_y, moment_z (y to the section's top, "
    .. "z across).",
    args = "member  text?  its name; joints of one without a name are joined, as in \"A-B\"", gives = "table[]" },
  shared = { beam = [[
material        text             its material, which has E and nu
groups          names?           groups it belongs to
density         number kg/m3?    instead of the material's
unit_weight     number N/m3?     or this
mass            number kg?       of all members, or this
weight          number N?        or this
support         text?            of all its nodes: "fixed", "free" or directions { x = "fixed" }
mass_matrix     text = "lumped"  or "consistent", which implicit steps and modes take; explicit ones lump
velocity        point?           at the start [m/s]
spin            number rad/s = 0  at the start
load            point?           steady force [N], spread like the mass
floating        flag = false     it may stand on nothing
hold            table?           boxes whose nodes are held]] },
}
