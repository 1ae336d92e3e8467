return {
  name = "frames", title = "Frames: beams, members and their sections",
  { "model:beam", "A straight beam with bending and axial deformation. Its top is on the left, seen from its start.",
    keys = [[
name          text                name
from          point               start, on the axis of the section
to            point               end
section       section             such as trilith.rectangle_section{...}, or trilith.fibre_section{...}
divisions     integer = 8         number of beam elements  <1 to 1000>
shear         flag = false        with shear deformation (Timoshenko)
pinned        names?              "from", "to" or both: ends without moment
hinge         hinge law?          a plastic hinge at both ends
from_hinge    hinge law?          plastic hinge at the start
to_hinge      hinge law?          plastic hinge at the end
stations      integer = 4         number of integration points (fibre sections) in each beam element  <2 to 6>
rule          text = "lobatto"    rule of integration: "lobatto" (with the ends) or "gauss"
from_support  text?               "fixed", "free" or directions { x = "fixed", rotation = "fixed" }
to_support    text?               support of the end]], with = "beam", gives = "body" },
  { "model:frame", "Beams that meet at joints, as one body: a bent, a portal or a truss.", keys = [[
name     text   name
joints   table  { A = {x, y}, B = { at = {x, y}, support = , mass = , inertia = }, C = { outline = , density = }, ... }
members  list   { { from = , to = , section = , name = , from_at = , to_at = , divisions = , hinge = , ... }, ... }]],
    with = "beam", gives = "body" },
  { "trilith.polygon_section", "A section of any simple polygon, in its own axes.", keys = [[
outline  points  corners in order: x out of the plane, y up, in metres]], gives = "section" },
  { "trilith.fibre_section", "A section of fibres with uniaxial laws: concrete with bars, or steel.", keys = [[
shape      section         outline, such as trilith.rectangle_section{...}
law        fibre law       law such as trilith.kent_park{...}; with a cover, law of the core
layers     integer?        layers over the depth; 20, in space 8 with four fibres at each place across  <1 to 1000>
layers_across  integer?    in space: number of places across; default gives about square cells  <at least 1>
cover      number m = 0    thickness of the cover outside the core  <at least 0>
cover_law  fibre law?      law of the cover; default: law of the core
core       section?        shape of the core, instead of the shape inside the cover
bars       list?           rows { area =, height = }: area of the row, height; in space count, across, spread
bar_law    fibre law?      law of the bars, such as trilith.menegotto_pinto{...}]], gives = "section" },
  { "section:moment_curvature", "Moment of a section of fibres under a constant normal force and a growing curvature. "
    .. "Lists: curvature, moment, axial (strain of the centroid). Numbers: yield_curvature and yield_moment, where the "
    .. "first fibre yields, peak_moment, peak_curvature. The text limit says why it ends.", keys = [[
normal       number N = 0      normal force, tension above 0
curvature    number 1/m?       largest curvature; below 0 the top is in tension; default: until a limit of the strain
points       integer = 200     number of equal steps of the curvature  <2 to 10000>
compression  number 1 = 0.01   strain in compression at which it ends  <above 0, at most 1>
tension      number 1 = 0.05   strain in tension at which it ends  <above 0, at most 1>]], gives = "table" },
  { "section:interaction", "Largest moments of a section of fibres for each normal force, from pure compression to "
    .. "pure tension, as lists normal, sagging and hogging.", keys = [[
points       integer = 31      number of normal forces  <3 to 10000>
compression  number 1 = 0.01   largest strain in compression  <above 0, at most 1>
tension      number 1 = 0.05   largest strain in tension  <above 0, at most 1>]], gives = "table" },
  { "section:plot", "Draws the moment-curvature curves of a section of fibres, or its interaction of normal force and "
    .. "moment.", keys = [[
file         text              picture to write: .svg, .pdf or .png
of           text = "moment_curvature"  or "interaction"
normal       list?             normal force or list of forces, a curve each [N]; default 0
curvature    number 1/m?       as in section:moment_curvature
points       integer?          number of steps or forces  <3 to 10000>
compression  number 1 = 0.01   largest strain in compression  <above 0, at most 1>
tension      number 1 = 0.05   largest strain in tension  <above 0, at most 1>]] },
  { "body:hinges", "Plastic hinges of a member, as joint, state, rotation, stretch, moment, normal, given_off, x, y; "
    .. "in space z, and rotation_y, rotation_z, moment_y, moment_z.",
    args = "member  text?  name of the member", gives = "table[]" },
  { "body:fibres", "Fibre sections along a member, as along, axial, curvature, normal, moment, and fibres, each with "
    .. "height, area, strain, stress; in space curvature_y, curvature_z, moment_y, moment_z, and fibres with up and "
    .. "across.", args = "member  text?  name of the member", gives = "table[]" },
  { "body:forces", "Internal forces along a member of a beam or frame, a row for both ends of each beam: along, "
    .. "x, y, normal, shear, moment; in space z, shear_y, shear_z, torque, moment_y, moment_z (y to the section's top, "
    .. "z across).",
    args = "member  text?  name of the member; without a name its joints, as in \"A-B\"", gives = "table[]" },
  shared = { beam = [[
material        text             material, with E and nu
groups          names?           groups of the body
density         number kg/m3?    density instead of the material's; or  <above 0>
unit_weight     number N/m3?     unit weight; or  <above 0>
mass            number kg?       mass of all members; or  <above 0>
weight          number N?        weight  <above 0>
support         text?            support of all nodes: "fixed", "free" or directions { x = "fixed" }
mass_matrix     text = "lumped"  "lumped" or "consistent"; explicit steps always use lumped mass
velocity        point?           velocity at the start [m/s]
spin            number rad/s = 0  angular velocity at the start
load            point?           steady force [N], distributed like the mass
floating        flag = false     it needs no support at the start
hold            table?           boxes { from = , to = } whose nodes are held]] },
  examples = {
    ["model:frame"] = [[
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
local section = trilith.rectangle_section { width = 0.1, depth = 0.2 }
m:frame { name = "portal", material = "steel",
  joints = { A = { at = { 3, 0 }, support = "fixed" }, B = { 3, 3 },
    C = { 6, 3 }, D = { at = { 6, 0 }, support = "fixed" } },
  members = { { from = "A", to = "B", section = section }, { from = "B", to = "C", section = section },
    { from = "D", to = "C", section = section } } }]],
    ["trilith.fibre_section"] = [[
local section = trilith.fibre_section {
  shape = trilith.rectangle_section { width = 0.4, depth = 0.6 }, law = trilith.kent_park { strength = 30e6 },
  bars = { { area = 1.2e-3, height = 0.05 }, { area = 1.2e-3, height = 0.55 } },
  bar_law = trilith.menegotto_pinto { E = 200e9, yield = 500e6 } }]],
    ["section:moment_curvature"] = [[
local column = trilith.fibre_section {
  shape = trilith.rectangle_section { width = 0.4, depth = 0.4 }, law = trilith.kent_park { strength = 30e6 },
  bars = { { area = 1.2e-3, height = 0.05 }, { area = 1.2e-3, height = 0.35 } },
  bar_law = trilith.menegotto_pinto { E = 200e9, yield = 500e6 } }
local curve = column:moment_curvature { normal = -500e3 }
print(curve.yield_curvature, curve.yield_moment, curve.peak_moment)]],
    ["section:interaction"] = [[
local column = trilith.fibre_section {
  shape = trilith.rectangle_section { width = 0.4, depth = 0.4 }, law = trilith.kent_park { strength = 30e6 },
  bars = { { area = 1.2e-3, height = 0.05 }, { area = 1.2e-3, height = 0.35 } },
  bar_law = trilith.menegotto_pinto { E = 200e9, yield = 500e6 } }
local curve = column:interaction { points = 11 }
print(curve.normal[1], curve.sagging[6])]],
    ["section:plot"] = [[
local column = trilith.fibre_section {
  shape = trilith.rectangle_section { width = 0.4, depth = 0.4 }, law = trilith.kent_park { strength = 30e6 },
  bars = { { area = 1.2e-3, height = 0.05 }, { area = 1.2e-3, height = 0.35 } },
  bar_law = trilith.menegotto_pinto { E = 200e9, yield = 500e6 } }
column:plot { file = "out/column.svg", normal = { 0, -500e3 } }
column:plot { file = "out/interaction.svg", of = "interaction" }]],
    ["body:hinges"] = [[
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
local post = m:beam { name = "post", from = { 3, 0 }, to = { 3, 2 }, material = "steel", from_support = "fixed",
  section = trilith.rectangle_section { width = 0.1, depth = 0.2 }, from_hinge = trilith.end_hinge { sagging = 1e5 } }
m:run { duration = 0.01 }
for _, hinge in ipairs(post:hinges()) do print(hinge.rotation, hinge.moment) end]],
    ["body:fibres"] = [[
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
local post = m:beam { name = "post", from = { 3, 0 }, to = { 3, 2 }, material = "steel", from_support = "fixed",
  section = trilith.fibre_section { shape = trilith.rectangle_section { width = 0.1, depth = 0.2 },
    law = trilith.bilinear_steel { E = 2.1e11, yield = 355e6 } } }
m:run { duration = 0.01 }
print(post:fibres()[1].curvature)]],
    ["model:beam"] = [[
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
m:beam { name = "post", from = { 3, 0 }, to = { 3, 2 }, material = "steel", from_support = "fixed",
  section = trilith.rectangle_section { width = 0.1, depth = 0.2 } }]],
    ["body:forces"] = [[
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
local post = m:beam { name = "post", from = { 3, 0 }, to = { 3, 2 }, material = "steel", from_support = "fixed",
  section = trilith.rectangle_section { width = 0.1, depth = 0.2 } }
m:consolidate { integrator = "static" }
print(post:forces()[1].normal)]],
    ["trilith.polygon_section"] = [[
local section = trilith.polygon_section { outline = { { 0, 0 }, { 0.2, 0 }, { 0.1, 0.3 } } }]],
  },
}
