return {
  name = "edges", title = "Ground and anchors: absorbing boundaries, bolts, creep",
  { "model:absorbing_boundary", "Dashpots on an edge of a mesh of ground: rho cp along the normal and rho cs across "
    .. "it, per area. Waves leave through the edge. With `motion` a wave enters through it; with `free_field` a side "
    .. "follows the motion of the ground far away. Returns { name, area, bearings }. Its energy: dashpots in "
    .. "bearing_damping, waves that enter in load.",
    also = "viscous boundary, Lysmer, quiet boundary, transmitting boundary, half space, free field, deconvolution, "
      .. "radiation damping", keys = [[
body        body           mesh of ground
edge        text           straight edge of it: left, right, bottom or top; in space front and back too
density     number kg/m3?  density of the ground beyond the edge; of its layer of the free field by default  <above 0>
cs          number m/s?    its velocity of shear waves  <above 0>
cp          number m/s?    its velocity of pressure waves, cs sqrt((2 - 2 nu)/(1 - 2 nu))  <above 0>
directions  text = all     directions of the dashpots: x, y or both as in "xy"; in space x, y, z
motion      table?         velocity of the wave that enters, { x = , y = }: motions or { {time, velocity}, ... }
free_field  table?         of a side: { base, surface or layers, motion, half_space }; layer { top, density, cs, cp }
from        vector?        in space: corner of a rectangle on the edge
to          vector?        in space: its opposite corner
divisions   table?         in space: number of dashpots along both of its sides, such as { 4, 10 }
name        text?          name; default: body and edge]], gives = "table",
    beside = { from = true, to = true, divisions = true },
    example = 'm:material { name = "soil", density = 1800, E = 1.8e8, nu = 0.25, plane = "strain" }\n'
      .. 'm:block { name = "soil", width = 4, height = 2, at = { 20, 0 }, material = "soil", floating = true,\n'
      .. '  body = { mesh = { 8, 4 } } }\n'
      .. 'm:absorbing_boundary { body = "soil", edge = "bottom", density = 1800, cs = 200, cp = 346,\n'
      .. '  motion = { { 0, 0 }, { 0.05, 0.1 }, { 0.1, 0 } } }' },
  { "model:bolt", "A grouted bolt, anchor or tie bar through bodies, with slip along its length. In each body it is a "
    .. "frame held by bond springs; across a joint the bar yields and breaks. Returns { name, rods, bonds, bars, "
    .. "force, lock }: force(i) is the tension at joint i [N], lock() ends the prestressing.",
    also = "rock bolt, anchor, dowel, reinforcement, tie rod, pull-out, bond slip, prestress, grout", keys = [[
name           text            name
bodies         list            bodies that it passes, in order
from           point           start
to             point           end
joints         list?           distance of each joint between two of these bodies from the start [m]
material       text            material of the bar, with E and density
E              number Pa       Young's modulus of the bar  <above 0>
diameter       number m        diameter of the bar  <above 0>
bond           number N/m2     stiffness of the bond per length  <above 0>
bond_strength  number Pa?      shear strength of the bond on the surface of the bar; without it no slip  <above 0>
dowel          number N/m2 = bond  stiffness across the bar per length  <above 0>
spacing        number m?       distance of the bond springs; default a twentieth of the shortest part  <above 0>
yield          number Pa?      yield strength of the bar at joints  <above 0>
hardening      number = 0      stiffness after yield over elastic stiffness  <at least 0, below 1>
rupture        number m?       elongation across a joint at which the bar breaks  <above 0>
prestress      number N?       force of the bar at joints, constant until it is locked  <above 0>
prestress_ramp  number s?      time in which the prestress grows; default at once  <above 0>]], gives = "table",
    example = 'm:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }\n'
      .. 'm:block { name = "slab", width = 2, height = 0.5, at = { 20, 0 }, material = "stone", floating = true }\n'
      .. 'm:block { name = "rock", width = 2, height = 1, at = { 20, -1 }, material = "stone", support = "fixed" }\n'
      .. 'm:bolt { name = "anchor", bodies = { "slab", "rock" }, from = { 21, 0.5 }, to = { 21, -0.9 },\n'
      .. '  joints = { 0.5 }, material = "steel", E = 2.1e11, diameter = 0.02, bond = 5e8, bond_strength = 3e6 }' },
  { "model:creep", "Lets a bearing creep: a Kelvin element, or a chain of them, stands behind the spring of one "
    .. "direction. The bearing has a linear law of the same stiffness at first. Time passes in m:creep_process alone.",
    also = "viscoelastic, relaxation, mortar, concrete, long-term deformation, ageing", keys = [[
bearing    bearing    bearing or its name
direction  text       along, axial or turning; in space across, turning_along, turning_across and turning_axial too
stiffness  number     stiffness of its linear law [N/m] or [N m/rad]  <above 0>
factor     number?    final creep displacement over the elastic one; needed without chain  <above 0>
time       number s?  time constant of creep under constant force; needed without chain  <above 0>
chain      list?      1 to 20 elements { factor = , time = } instead, as of trilith.concrete_creep]],
    example = 'local day = 86400\n'
      .. 'm:bearing { name = "pad", between = { "ground", "block" }, at = { 0, 0 },\n'
      .. '  axial = trilith.linear { stiffness = 2e8 }, along = trilith.linear { stiffness = 1e8 } }\n'
      .. 'm:creep { bearing = "pad", direction = "axial", stiffness = 2e8, factor = 2, time = 30*day }' },
  { "model:creep_process", "A process in which bearings creep, such as years under dead load. After each step the "
    .. "structure is brought to static equilibrium. Returns the time of all such processes [s].",
    also = "creep, long-term analysis, season", keys = [[
duration   number s      duration  <above 0>
step       number s      longest step; the error is of second order  <above 0>
heat       flag = false  the clock of the heat runs too: m:process of the same steps
within     number?       as for m:consolidate
tolerance  number?       as for m:consolidate
each       function?     called after each step with the time [s]
name       text = "creep"  name in results]], gives = "number",
    example = 'local day = 86400\n'
      .. 'm:bearing { name = "pad", between = { "ground", "block" }, at = { 0, 0 },\n'
      .. '  axial = trilith.linear { stiffness = 2e8 }, along = trilith.linear { stiffness = 1e8 },\n'
      .. '  turning = trilith.linear { stiffness = 1e8 } }\n'
      .. 'm:creep { bearing = "pad", direction = "axial", stiffness = 2e8, factor = 2, time = 30*day }\n'
      .. 'm:consolidate { integrator = "static" }\n'
      .. 'm:creep_process { duration = 30*day, step = 10*day }' },
  { "trilith.concrete_creep", "The creep coefficient of concrete of EN 1992-1-1:2004, annex B.1, for a load from "
    .. "the given age on. Returns { notional, chain, coefficient }: the final coefficient, a chain for m:creep that "
    .. "follows it within 0.3 % from one day to 100 years after loading, and a function of the time under load [s].",
    also = "Eurocode 2, creep coefficient, shrinkage, humidity, notional size", keys = [[
strength   number Pa     mean compressive strength at 28 days  <10e6 to 120e6>
humidity   number        relative humidity, 0.4 to 1  <0.4 to 1>
size       number m      notional size: twice the area of the section over its drying perimeter  <0.05 to 3>
age        number s      age at loading  <43200 to 3155760000>
cement     text = "N"    S slow, N normal or R rapid ]], gives = "table",
    example = 'local day = 86400\n'
      .. 'local creep = trilith.concrete_creep { strength = 38e6, humidity = 0.7, size = 0.3, age = 28*day }\n'
      .. 'print(creep.notional, creep.coefficient(365*day))' },
}
