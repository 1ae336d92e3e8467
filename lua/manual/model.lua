return {
  name = "model", title = "Models: what they are made of",
  { "trilith.model", "A new model. Any number of them live side by side.", keys = [[
name             text = ""           what messages call it
dim              integer = 2         2 in the plane, 3 in space: see "Models in space"
thickness        number m = 1        out of the plane, of every contact
gravity          number m/s2 = 9.80665  downwards; or a vector {x, y}, in space {x, y, z}
threads          integer = as many as pay  that may share a step, 1 to 64; any number gives the same bits
mass_damping     number 1/s = 0      damping force per momentum
impact_speed     number m/s = 0.5    a contact made faster than this is an impact
apart_time       number s = 0.02     a contact that has been open this long is lost
still_speed      number m/s?         a body slower than this for still_time is at rest
still_time       number s = 0.5      see still_speed
body             body form = "rigid"  what bodies are made as: "rigid", "quad", { mesh = {nx, ny} }; in space "brick"
overlap_allowed  number = 1e-6  share of a body's size by which bodies may overlap at the start]],
    gives = "model" },
  { "model:close", "Ends the recording and frees the model." },
  { "model:material", "A material, which bodies name.", keys = [[
name         text              its name
density      number kg/m3?     either this
unit_weight  number N/m3?      or this
E            number Pa?        Young's modulus, for bodies that deform
nu           number = 0  Poisson's ratio
damping      number s = 0  stress per strain rate over E
band_damping  table?           of members of frames: { ratio =, from =, to = }, the same between two frequencies [Hz]
solid        solid law?        instead of E: a law such as trilith.mohr_coulomb{...}
plane        text = "stress"   "stress" or "strain"
form         text = "assumed"  "assumed" or "plain": the element; "plain" keeps the limit of perfect plasticity
strain_limit  number = 0.5     strain its elements are made for; beyond, the stage diverges]], gives = "string" },
  { "model:contact", "Which law holds between materials, groups or bodies. Later calls win. Two bodies that may " ..
    "meet " ..
    "need one before a stage begins.", keys = [[
between  names          two names of materials, groups or bodies; "*" for any
law      contact law    a law, the name of one, or "none": they pass through each other
name     text = kind and number  the law's name in results]] },
  { "model:body", "Makes a body; with a name alone, finds one.",
    args = "name  text?  of a body that is there; or the table",
    keys = [[
name     text     its name
outline  points?  corners in order
shape    table?   or a part, such as trilith.block{...}
mesh     table?   or a mesh: { file = } or { nodes = , elements = }; with body = "rigid": a rigid body of its pieces]],
    with = "body", gives = "body" },
  { "model:add", "Parts as from trilith.build become bodies.", args = [[
parts    table   list of { name, outline, groups }
options  table?  what bodies take, and fixed = , by_group = ]], gives = "set" },
  { "model:bearing", "A bearing between two bodies: a law for each direction, in its own axes, which turn with the "
    .. "first body. In the plane along, axial and turning; in space along (lengthwise), across (sideways), axial "
    .. "(vertical), and turning_along, turning_across, turning_axial about them. There horizontal is one law of along "
    .. "and across at once, with a circle for its limit: linear, elastic_plastic, lead_rubber, bouc_wen, friction or "
    .. "pendulum. Each point goes rigidly with its body, and lies in it or no farther from it than the body is large, "
    .. "unless a rigid arm is allowed to hold it. Where from and to are apart, the bearing has the length "
    .. "between them: "
    .. "displacements count from there, and the forces on both bodies act along one line through the second point.",
    keys = [[
name               text           its name
between            two bodies     or their names
at                 point?         where it is; or from and to
from               point?         its point on the first body
to                 point?         its point on the second, through which its forces act on both
arm                number m = 0   farthest that a rigid arm without mass may hold a point from its body
angle              number rad = 0  of its direction along, counted from x to y
turn               table?         in space: { axis = , angle = } instead, of all its axes
along              direction law?  force along
across             direction law?  in space: force across
horizontal         direction law?  in space: force along and across, instead of these
axial              direction law?  force in the axial direction
turning            direction law?  in the plane: moment
turning_along      direction law?  in space: moment about along
turning_across     direction law?  in space: moment about across
turning_axial      direction law?  in space: moment about axial
limit              table?         displacement at its end: { along = , axial = }; horizontal: of both
becomes            bearing or law?  what follows its failure: a law, or another bearing that waits
becomes_from       text or table = "start"  "here": that bearing counts from where it takes over; or { along = "here" }
waiting            flag = false   it goes live only as another's successor
replaces_contact  flag = false   it stands for the flat contact it sits in]],
    beside = { across = true, horizontal = true, turn = true, turning_across = true, turning_along = true,
               turning_axial = true }, gives = "bearing" },
  { "model:seat", "A body's end on the edge of a support: how much is left is followed.", keys = [[
name     text    its name
body     body    what sits
support  body    on what
at_end   point   the body's end
edge     point   the edge of the seat
inward   point?  from the edge over the seat; without it level from the edge towards at_end]], gives = "seat" },
  { "model:remove", "Takes bodies, bearings or loads away: at once between stages, else at the next step border. What "
    .. "leaned on them is free from the next step on.",
    args = "what  bodies  a body, set, bearing, name of one, of a group or of a load, or a list of these" },
  { "model:put_back", "Puts back bodies, at rest where they stood if that is free, and bearings, which begin anew "
    .. "where "
    .. "they are, free of force.",
    args = "what  bodies  what was removed: a body, set, bearing, name or a list of these\nhow   table?  for bearings: "
      .. '{ from = "start" }: displacements count from where the bearing was placed first' },
  shared = { body = [[
material        text?            its material
groups          names?           groups it belongs to
density         number kg/m3?    instead of the material's
unit_weight     number N/m3?     or this
mass            number kg?       or this
weight          number N?        or this
inertia         number kg m2?    about the centroid
body_thickness  number m = the model's  out of the plane
support         text = "free"  "fixed", "free" or directions { x = "fixed" }
velocity        point = {0, 0}  at the start [m/s]
spin            number rad/s = 0  at the start
load            point = {0, 0}  steady force [N]
floating        flag = false     it may stand on nothing
body            body form = the model's  "rigid", "quad" or { mesh = {nx, ny} }
hold            table?           boxes { from = , to = } whose nodes are held, in each direction that is not "free"]],
    bodies = [[
fixed           names?           names or groups that are fixed
by_group        table?           what holds for a group alone]] },
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
}
