-- Units of nested tables: of builders, bridges, boundaries of ground, changes of laws and fits to frequencies. They
-- complete the rules of lib/unit_rules.
local _, core = ...
local rules = core.unit_rules
local of, same, fields, each, rows = rules.of, rules.same, rules.fields, rules.each, rules.rows
local keys, results = rules.keys, rules.results

--- A table of its own, or a list of such tables.
local function one_or_each(rule)
  local list = each(rule)
  return function(value, system, direction)
    local first = type(value) == "table" and value[1] or nil
    return (type(first) == "table" and list or rule)(value, system, direction)
  end
end

-- Builders.
local block = fields("a block", { width = "m", height = "m" })
local openings = each(fields("an opening", { storey = "1", x = "m", from = "m", to = "m", sill = "m", width = "m",
  height = "m", lintel_height = "m", lintel_bearing = "m", sill_height = "m", sill_bearing = "m", first_course = "1",
  last_course = "1" }))
local beams = one_or_each(fields("beams", { count = "1", spacing = "m", width = "m", height = "m", bearing = "m",
  from = "m", to = "m" }))
local spheres = each(fields("a sphere", { at = "m", radius = "m" }))
keys.base, keys.capital, keys.openings, keys.lintels, keys.beams = block, block, openings, openings, beams
keys.spheres, keys.clump = spheres, spheres
keys.storeys = each(fields("a storey", { courses = "1", height = "m", slab_height = "m", beams = beams }))
keys.walls = each(fields("a wall", { from = "m", to = "m", thickness = "m", openings = openings }))
keys.pieces = each(fields("a piece", { hull = "m", outline = "m" }))

--- Planes of cracks: { point =, normal = } or { point, normal }; the normal is a direction.
keys.cracks = each(function(plane, system, direction)
  if type(plane) ~= "table" then return plane end
  local copy = {}
  for key, one in next, plane do
    copy[key] = (key == "point" or key == 1) and of "m"(one, system, direction) or one
  end
  return copy
end)

--- A mesh. The coordinates in a file are lengths in the unit of the models, unless scale gives them in it.
keys.mesh = function(value, system, direction)
  local copy = fields("mesh", { nodes = "m", elements = same, scale = "1" })(value, system, direction)
  if type(value) == "table" and value.file and system.length ~= 1 then
    copy.scale = keys["solids.scale"](value.scale, system)
  end
  return copy
end

-- Boundaries of ground.
local velocities = rows("1", "m/s")
local function wave(value, system, direction)
  if type(value) ~= "table" then return value end
  if value[1] ~= nil then return velocities(value, system, direction) end
  return each(velocities)(value, system, direction)
end
keys["absorbing_boundary.motion"] = wave
keys["absorbing_boundary.divisions"] = same
keys["absorbing_boundary.free_field"] = fields("free_field", { base = "m", surface = "m", motion = wave,
  half_space = fields("half_space", { density = "kg/m3", cs = "m/s", cp = "m/s" }),
  layers = each(fields("a layer", { top = "m", density = "kg/m3", cs = "m/s", cp = "m/s" })) })
results["model:absorbing_boundary"] = fields("the boundary", { area = "m2", bearings = same })

-- Fits to frequencies.
keys["calibrate.shape"], keys["calibrate.shapes"] = rules.shape_of_mode, each(rules.shape_of_mode)
for _, name in ipairs { "frequencies", "modes", "vary", "between" } do keys["calibrate." .. name] = same end
results["trilith.calibrate"] = same

--- Units of the numbers of a contact law of a model, by key.
function rules.units_of_law(model, name)
  for _, law in ipairs(core.contact_laws(model)) do
    if law.name == name then
      local declared, units = core.laws()[tostring(law):match "^[%w_]+"], {}
      for _, p in ipairs(declared and declared.parameters or {}) do units[p.name] = p.unit end
      return units
    end
  end
  return {}
end

--- The unit of a number such as "mortar.kn".
local function unit_of_number(model, name)
  local law, key = tostring(name):match "^(.*)%.(.-)$"
  return law and rules.units_of_law(model, law)[key] or "1"
end

--- Bounds of m:calibrate, in the unit of the first number that varies.
function rules.bounds(model, given, system)
  local first = type(given.vary) == "table" and given.vary[1] or given.vary
  return of(unit_of_number(model, first))(given.between, system, 1)
end

--- The result of m:calibrate, with numbers of laws in the units of the models.
results["model:calibrate"] = function(found, system, _, arguments)
  local model, vary = arguments[1], arguments[2].vary
  local copy, first = {}, type(vary) == "table" and vary[1] or vary
  for key, one in next, found do copy[key] = one end
  copy.values = {}
  for name, value in pairs(found.values) do
    copy.values[name] = of(unit_of_number(model, name))(value, system, -1)
  end
  if found.tries then
    local unit = unit_of_number(model, first)
    copy.value = of(unit)(found.value, system, -1)
    copy.tries = each(fields("a try", { value = unit, frequency = "1", mode = "1" }))(found.tries, system, -1)
    copy.text = core.calibration_text(copy.tries, first, system:name(unit))
  end
  return setmetatable(copy, getmetatable(found))
end

-- Findings: their texts are in the units of the models.
local function text(value, system) return system:message(value) end
results["model:lint"] = each(text)
results["model:breaks"] = each(text)
results["model.worst"] = fields("the worst body", { force = "N", ratio = "1", text = text })
results["model:rewind"], results["model:wait"] = same, core.unit_calls.convert_event

local function difference(row, system, direction)
  if type(row) ~= "table" then return row end
  local copy = fields("a history", { difference = "1", at = "1" })(row, system, direction)
  if system:factor(row.unit) and not row.own then
    copy.difference, copy.unit = of(row.unit)(row.difference, system, direction), system:name(row.unit)
  end
  return copy
end
results["model:compare"] = fields("the comparison", { from = "1", before = "1", now = "1", kept_from = "1",
  kept_to = "1", moved = each(fields("a body", { distance = "m", turn = "1" })),
  events = each(fields("an event", { time = "1", before = "1", now = "1" })), histories = each(difference),
  text = text })

-- Studies.
for _, name in ipairs { "parameters", "cases", "samples", "histories", "ida" } do keys["study." .. name] = same end
results["trilith.study"] = same

-- Bridges. Rows of the plane have the keys of their builders; of a bridge in space, of lib/bridge_rules.
--- The rules of a kind of row in space; `nested`: of tables within it.
local function row_rules(kind, nested)
  local known = {}
  for key, rule in pairs(core.bridge_rules.declared[kind]) do
    known[key] = rule.kind == "number" and of(rule.unit) or same
  end
  if known.density then
    known.density, known.unit_weight, known.mass, known.weight = of "kg/m3", of "N/m3", of "kg", of "N"
  end
  for key, rule in pairs(nested or {}) do known[key] = rule end
  return known
end

local function bridge_in_space()
  local ground = fields("ground", row_rules "ground")
  local support = row_rules("abutment", row_rules("pier", { ground = ground,
    foundation = fields("foundation", row_rules("foundation", { limit = keys.limit })),
    shear_key = fields("shear_key", row_rules "shear_key") }))
  local span = row_rules("span", { diaphragm = fields("diaphragm", row_rules "diaphragm") })
  local one, deck = fields("a support", support), fields("a span", span)
  return fields("bridge", row_rules("bridge", { supports = each(one), spans = each(deck), abutment = one, pier = one,
    span = deck, ground = ground, girders = fields("girders", row_rules("girders", { at = of "m" })) }))
end

--- Keys of builders in the plane, and `length` of a span.
local function bridge_in_plane(entries)
  local function row(...)
    local all = { length = of "m" }
    for _, name in ipairs { ... } do
      for key, rule in pairs(entries[name].keys) do all[key] = rule end
    end
    return function(value, system, direction) return core.convert_keys(all, value, system, direction, "bridge") end
  end
  local support, span = row("model:pier", "model:abutment"), row "model:span"
  local own = { supports = each(support), spans = each(span), abutment = support, pier = support, span = span }
  local all = setmetatable(own, { __index = entries["model:bridge"].keys })
  return function(value, system, direction) return core.convert_keys(all, value, system, direction, "bridge") end
end

--- The tables of m:bridge; `entries`: the declared functions by name.
function rules.bridge(model, given, system, entries)
  return (model.dim == 3 and bridge_in_space() or bridge_in_plane(entries))(given, system, 1)
end

--- The result of m:bridge. In space it has places, axes and the method `motions`.
results["model:bridge"] = function(bridge, system)
  local copy, motions = {}, bridge.motions
  for key, one in next, bridge do copy[key] = one end
  copy.places, copy.axes = of "m"(bridge.places, system, -1), of "m"(bridge.axes, system, -1)
  if motions then
    local convert = fields("motions", row_rules("motions", { delay = same }))
    copy.motions = function(_, given)
      return core.unit_calls.inside(function() return motions(bridge, convert(given, system, 1)) end)
    end
  end
  return copy
end
