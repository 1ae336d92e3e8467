return {
  name = "model", title = "Models: materials, bodies, contacts and bearings",
  { "trilith.model", "Makes a new model. Several models can exist at the same time.", keys = [[
name             text = ""           name in messages
dim              integer = 2         2 in the plane, 3 in space: see "Models in space"  <2 or 3>
thickness        number m = 1        thickness out of the plane, of every contact  <above 0>
gravity          number m/s2 = 9.80665  gravity, downwards; or a vector {x, y}, in space {x, y, z}  <at least 0>
threads          integer = chosen at run time  number of threads; results do not depend on it  <1 to 64>
mass_damping     number 1/s = 0      mass-proportional damping: damping force over momentum  <at least 0>
impact_speed     number m/s = 0.5    closing speed above which a new contact is an impact  <above 0>
apart_time       number s = 0.02     time after which an open contact is lost  <at least 0>
still_speed      number m/s?         speed below which a body is at rest, after still_time  <above 0>
still_time       number s = 0.5      see still_speed  <at least 0>
units            text = "SI"         units of all numbers of the script: "kN m", "N mm", "kip ft", ...; see units.md
body             body form = "rigid"  default form of bodies: "rigid", "quad", { mesh = {nx, ny} }; in space "brick"
overlap_allowed  number = 1e-6  allowed overlap at the start, as a share of the size of a body  <at least 0>]],
    beside = { units = true }, gives = "model" },
  { "model:close", "Ends the recording and deletes the model." },
  { "model:material", "Declares a material. Bodies refer to it by name.", keys = [[
name         text              name
density      number kg/m3?     density; or  <above 0>
unit_weight  number N/m3?      unit weight  <above 0, at most 225553>
E            number Pa?        Young's modulus, for bodies that deform  <above 0>
nu           number = 0  Poisson's ratio  <0 to 0.499>
beta         number s = 0  stiffness-proportional damping: stress per strain rate over E  <0 to 1>
band_damping  table?           of members of frames: { ratio =, from =, to = }, damping ratio between frequencies [Hz]
solid        solid law?        instead of E: a constitutive law such as trilith.mohr_coulomb{...}
plane        text = "stress"   "stress" or "strain"
form         text = "assumed"  element formulation, "assumed" or "plain"; "plain" keeps the limit of perfect plasticity
strain_limit  number = 0.5     largest valid strain of its elements; beyond it the stage diverges  <above 0>]],
    gives = "string" },
  { "model:contact", "Sets the contact law between materials, groups or bodies. A later call takes precedence. "
    .. "Two bodies that may meet need a law before a stage begins.", keys = [[
between  names          two names of materials, groups or bodies; "*" for any
law      contact law    a law, its name, or "none": the bodies pass through each other
name     text = kind and number  name of the law in results]] },
  { "model:body", "Makes a body. With only a name, returns the body of that name.",
    args = "name  text?  name of a body; or the table",
    keys = [[
name     text     name
outline  points?  corners in order
shape    table?   or a part, such as trilith.block{...}
mesh     table?   or { file = , scale = 1 } or { nodes = , elements = }; body = "rigid": rigid, of these pieces]],
    with = "body", gives = "body" },
  { "model:add", "Adds parts, such as the results of trilith.build, as bodies.", args = [[
parts    table   list of { name, outline, groups }
options  table?  keys of bodies, and fixed = , by_group = ]], gives = "set" },
  { "model:bearing", "A bearing between two bodies: a law for each direction, in axes that turn with the first "
    .. "body. In the plane: along, axial and turning. In space: along (lengthwise), across (sideways), axial "
    .. "(vertical), and rotations about these axes. In space horizontal is one law of along and across with a circular "
    .. "limit: linear, elastic_plastic, lead_rubber, bouc_wen, friction or pendulum. Each point moves rigidly with its "
    .. "body and lies in it, or no farther away than the size of the body, unless `arm` is longer. If from and to "
    .. "differ, displacements count from their distance, and both forces act along one line through the second point.",
    also = "isolator, spring, dashpot, hysteresis, connector, link element, restrainer",
    keys = [[
name               text           name
between            two bodies     two bodies, or their names
at                 point?         place; or from and to
from               point?         point on the first body
to                 point?         point on the second body, through which both forces act
arm                number m = 0   largest length of a massless rigid arm from a body to its point  <at least 0>
angle              number rad = 0  angle of the direction along, from x to y
turn               table?         in space, instead: { axis = , angle = } of all its axes
along              direction law?  law of the force along
across             direction law?  in space: law of the force across
horizontal         direction law?  in space: one law for along and across
axial              direction law?  law of the axial force
turning            direction law?  in the plane: law of the moment
turning_along      direction law?  in space: law of the moment about along
turning_across     direction law?  in space: law of the moment about across
turning_axial      direction law?  in space: law of the moment about axial
limit              table?         displacements at failure: { along = , axial = }; horizontal: of the resultant
becomes            bearing or law?  successor after failure: a contact law, or a waiting bearing
becomes_from       text or table = "start"  "here": the successor starts without force; or { along = "here" }
waiting            flag = false   it becomes active only as a successor
replaces_contact  flag = false   it replaces the flat contact at its place]],
    beside = { across = true, horizontal = true, turn = true, turning_across = true, turning_along = true,
               turning_axial = true }, gives = "bearing" },
  { "model:seat", "The end of a body on the edge of a support. Its remaining length can be read.", keys = [[
name     text    name
body     body    supported body
support  body    supporting body
at_end   point   end of the body
edge     point   edge of the seat
inward   point?  direction from the edge over the seat; default horizontal, towards at_end]], gives = "seat" },
  { "model:remove", "Removes bodies, bearings or loads: at once between stages, in a handler at the end of the step. "
    .. "Bodies that rested on them lose this support from the next step on.",
    args = "what  bodies  a body, set, bearing, name of one, of a group or of a load, or a list of these" },
  { "model:put_back", "Returns removed bodies, at rest at their last position if it is free, and bearings, which "
    .. "restart without force at their present position.",
    args = "what  bodies  a removed body, set, bearing, name or a list of these\nhow   table?  for bearings: "
      .. '{ from = "start" }: displacements count from the first placement' },
  shared = { body = [[
material        text?            material
groups          names?           groups of the body
density         number kg/m3?    density instead of the material's; or  <above 0>
unit_weight     number N/m3?     unit weight; or  <above 0>
mass            number kg?       mass; or  <above 0>
weight          number N?        weight  <above 0>
inertia         number kg m2?    moment of inertia about the centroid  <above 0>
body_thickness  number m = the model's  thickness out of the plane  <above 0>
support         text = "free"  "fixed", "free" or directions { x = "fixed" }
velocity        point = {0, 0}  velocity at the start [m/s]
spin            number rad/s = 0  angular velocity at the start
load            point = {0, 0}  steady force [N]
floating        flag = false     it needs no support at the start
cracks          planes?          planes on which a body may crack, no frame: "mid", "quarter", "diagonals", n or a list
crack_law       text?            contact law of these planes: strengths before, contact of the parts afterwards
body            body form = the model's  "rigid", "quad" or { mesh = {nx, ny} }
hold            table?           boxes { from = , to = } whose nodes are held, except in "free" directions]],
    bodies = [[
fixed           names?           names or groups that are fixed
by_group        table?           { group = { keys } }: keys for the bodies of a group]] },
  fields = {
    model = { name = "string", energy = "table", gravity = "number[]", bearings = "trilith.bearing[]",
      seats = "trilith.seat[]",
      storeys = "trilith.storey[]", events = "trilith.event[]", hash = "string", notes = "string[]",
      worst = "trilith.findings", verdict = "table", dim = "integer" },
    body = { name = "string", material = "string", groups = "string[]", outline = "number[][]", kind = "string",
      resting = "boolean", present = "boolean", removed_at = "number?",
      bearings = "table<string, trilith.bearing>?", seats = "table<string, trilith.seat>?" },
    ["set of bodies"] = { names = "string[]" },
    bearing = { name = "string", status = "string", bodies = "trilith.body[]", force = "table", displacement = "table",
      limited = "boolean" },
    seat = { name = "string", lost = "boolean" },
    history = { name = "string", unit = "string", t = "number[]", values = "number[]" },
  },
  examples = {
    ["trilith.model"] = [[
local column = trilith.model { name = "column", thickness = 0.5 }]],
    ["model:close"] = [[
local short = trilith.model { name = "short" }
short:close()]],
    ["model:material"] = [[
m:material { name = "brick", density = 1900, E = 10e9, nu = 0.2 }]],
    ["model:contact"] = [[
m:material { name = "brick", density = 1900 }
m:contact { between = { "brick", "*" },
  law = trilith.bonded { kn = 6e9, ks = 3e9, mu = 0.6, beta = 1e-4, tension = 1e5, cohesion = 2e5 } }]],
    ["model:body"] = [[
m:body { name = "wedge", outline = { { 1, 0 }, { 2, 0 }, { 1.5, 0.5 } }, material = "stone" }
print(m:body "wedge".mass)]],
    ["model:add"] = [[
local parts = trilith.build.stack { name = "pier", at = { 1, 0 }, blocks = { { width = 0.5, height = 0.5 } } }
m:add(parts, { material = "stone" })]],
    ["model:bearing"] = [[
m:bearing { name = "spring", between = { "ground", "block" }, at = { 0, 0 },
  along = trilith.linear { stiffness = 1e6, damping = 1e3 }, limit = { along = 0.1 } }]],
    ["model:seat"] = [[
m:seat { name = "edge", body = "block", support = "ground", at_end = { 0.25, 0 }, edge = { 2, 0 } }]],
    ["model:remove"] = [[
m:run { duration = 0.01 }
m:remove "block"]],
    ["model:put_back"] = [[
m:run { duration = 0.01 }
m:remove "block"
m:put_back "block"]],
  },
}
