-- Conversion of tables between SI and the units of a script's models. A rule is a function (value, system, direction);
-- direction 1 converts to SI, -1 from SI. The rules here are of keys and results that their declarations do not
-- describe; lib/unit_tables has the rules of nested tables.
local _, core = ...
local rules = {}
core.unit_rules = rules

--- Fails for a value that has no rule.
local function refuse(what, system)
  core.fail(("%s is not converted to units = \"%s\"; leave 'units' out and give numbers in SI, with trilith.units")
    :format(what, system.text))
end
rules.refuse = refuse

local function scaled(value, factor, exponent, direction)
  if type(value) == "number" then return core.convert_number(value, factor, exponent, direction) end
  if type(value) ~= "table" then return value end
  local copy = {}
  for key, one in next, value do copy[key] = scaled(one, factor, exponent, direction) end
  return setmetatable(copy, getmetatable(value))
end

-- Units with temperatures, or of powers, by units of force, length and time that convert alike.
local mechanical = { ["W/(m K)"] = "N/s", ["W/(m2 K)"] = "N/m s", ["J/(kg K)"] = "m2/s2", ["K/m"] = "1/m",
  ["1/K"] = "1", degC = "1" }

--- All numbers of a value have this unit.
function rules.of(unit, turning)
  unit = mechanical[unit] or unit
  return function(value, system, direction)
    local factor, exponent = system:factor(unit, turning)
    if not factor then refuse(("a number in %s"):format(unit), system) end
    if factor == 1 then return value end
    return scaled(value, factor, exponent, direction)
  end
end

--- The value has no unit, or is a handle, whose numbers are in SI inside.
function rules.same(value) return value end

local function has_number(value)
  if type(value) == "number" then return true end
  if type(value) ~= "table" then return false end
  for _, one in next, value do
    if has_number(one) then return true end
  end
  return false
end

--- A table whose fields have rules or units; a number in another field is refused.
function rules.fields(what, known)
  local by_name = {}
  for name, rule in pairs(known) do by_name[name] = type(rule) == "string" and rules.of(rule) or rule end
  return function(value, system, direction)
    if type(value) ~= "table" then return value end
    local copy = {}
    for key, one in next, value do
      local rule = by_name[key]
      if not rule and has_number(one) then refuse(("'%s' of %s"):format(tostring(key), what), system) end
      if rule then copy[key] = rule(one, system, direction) else copy[key] = one end
    end
    return setmetatable(copy, getmetatable(value))
  end
end

--- A list, or a table by name, of values with the same rule. Another value is given to the rule itself.
function rules.each(rule)
  return function(value, system, direction)
    if type(value) ~= "table" then return value end
    local copy = {}
    for key, one in next, value do copy[key] = rule(one, system, direction) end
    return setmetatable(copy, getmetatable(value))
  end
end

--- Rows of numbers, a unit for each column.
function rules.rows(...)
  local units = { ... }
  return rules.each(function(row, system, direction)
    if type(row) ~= "table" then return row end
    local copy = {}
    for i, one in next, row do copy[i] = units[i] and rules.of(units[i])(one, system, direction) or one end
    return copy
  end)
end

local of, same, fields, each, rows = rules.of, rules.same, rules.fields, rules.each, rules.rows

local box = { from = "m", to = "m" }
local function joint_rule()
  local full = fields("a joint", { at = "m", outline = "m", hull = "m", mass = "kg", inertia = "kg m2",
    density = "kg/m3", thickness = "m" })
  return function(value, system, direction)
    if type(value) == "table" and type(value[1]) == "number" then return of "m"(value, system, direction) end
    return full(value, system, direction)
  end
end

--- A number of lengths, or a list of rows { time, length }.
local function level(value, system, direction)
  if type(value) ~= "table" then return of "m"(value, system, direction) end
  return rows("1", "m")(value, system, direction)
end

--- A course: a number, or a list of rows { time, value } with the key period [s].
local function course(unit)
  local of_rows = rows("1", unit)
  return function(value, system, direction)
    if type(value) ~= "table" then return of(unit)(value, system, direction) end
    local copy = of_rows(value, system, direction)
    copy.period = value.period
    return copy
  end
end

--- The keys of functions, by "function.key" or by "key" for all of them.
rules.keys = {
  rest = fields("rest", { ratio = "1", speed = "m/s", hold = "s", from = "s" }),
  until_collapse = fields("until_collapse", { drop = "m", bodies = "1" }),
  mass_scaling = fields("mass_scaling", { step = "s", most = "1" }),
  limit = fields("limit", { along = "m", across = "m", horizontal = "m", axial = "m", turning = "1",
    turning_along = "1", turning_across = "1", turning_axial = "1" }),
  hold = each(fields("hold", box)),
  body = same, band_damping = same, turn = same, load_curve = same, becomes_from = same,
  support = same, from_support = same, to_support = same, motions = same, level = level, elements = same,
  shape = fields("shape", { outline = "m" }),
  drain = fields("drain", { at = "m", efficiency = "1" }),
  bars = each(fields("bars", { area = "m2", height = "m", count = "1", across = "m", spread = "m" })),
  ["stack.blocks"] = each(fields("blocks", { width = "m", height = "m", offset = "m" })),
  ["ground.steps"] = each(fields("steps", { from = "m", level = "m" })),
  ["frame.joints"] = each(joint_rule()),
  ["frame.members"] = each(fields("a member", { from_at = "m", to_at = "m", divisions = "1", stations = "1",
    orientation = same })),
  ["solids.scale"] = function(value, system) return (value or 1)*system.length end,
  ["match.spectrum"] = rows("1", "m/s2"), ["spectrum.periods"] = same, ["ramp.by"] = of "m",
  ["table.points"] = rows("m", "N"), ["end_hinge.axial"] = rows("N", "1"), ["motion.acceleration"] = of "m/s2",
  ["fibre_section.core"] = same, ["off.handler"] = same, ["keep.state"] = same, ["put_back.how"] = same,
  ["heat_exchange.temperature"] = same, ["seepage_head.head"] = course "m", ["bolt.joints"] = of "m",
  ["bolt.bodies"] = same, ["creep.chain"] = same,
  ["history.every"] = same, ["stochastic_motion.envelope"] = same,
  ["at"] = function(value, system, direction)
    return type(value) == "table" and of "m"(value, system, direction) or value
  end,
}

local place = { x = "m", y = "m", z = "m" }
local function with_place(more)
  for key, unit in pairs(place) do more[key] = unit end
  return more
end
local rotations = { "moment", "moment_y", "moment_z", "torque", "m", "mx", "my", "mz" }
local function with_moments(more)
  for _, key in ipairs(rotations) do more[key] = "N m" end
  return more
end

--- Points of a design spectrum, whose field `at` is a function of the period.
local function spectrum(value, system, direction)
  local points, about = rows("1", "m/s2")(value, system, direction), {}
  for key, one in next, getmetatable(value).__index do about[key] = one end
  local at = about.at
  function about.at(period) return of "m/s2"(at(period), system, direction) end
  return setmetatable(points, { __index = about })
end

local shape_of_mode = each(fields("a shape", { x = "1", y = "1", z = "1", rotation = "1/m", rotation_x = "1/m",
  rotation_y = "1/m", rotation_z = "1/m" }))
rules.shape_of_mode = shape_of_mode

--- A natural mode. Its factors of participation belong to a shape of mass 1, so they are roots of masses.
local function mode(value, system, direction)
  local root = math.sqrt(system.mass)
  local function factor(number) return direction == -1 and number/root or number*root end
  local known = { frequency = "1", period = "1", square = "1", damping = "1", shape = shape_of_mode }
  for _, axis in ipairs { "x", "y", "z" } do known["mass_" .. axis], known["factor_" .. axis] = "kg", factor end
  return fields("a mode", known)(value, system, direction)
end

local fibre = each(fields("a fibre", { height = "m", up = "m", across = "m", area = "m2", strain = "1",
  stress = "Pa" }))
local heat_source = each(fields("a surrounding", { temperature = "1", supplied = "J" }))
local flow_node = each(fields("a node", { head = "m", elevation = "m", inflow = "m3/s", supplied = "m3" }))

--- Results, by "owner.member" of a function or a reading.
rules.results = {
  ["motion:sa"] = of "m/s2", ["trilith.spectrum"] = spectrum,
  ["motion:difference"] = fields("the difference", { displacement = "m", displacement_time = "s", velocity = "m/s",
    velocity_time = "s" }),
  ["body:reactions"] = each(fields("a reaction", with_place(with_moments { fx = "N", fy = "N", fz = "N" }))),
  ["model:contacts"] = each(fields("a contact", { normal = "N", shear = "N", point = "m", force = "N", area = "m2",
    slip = "m", direction = same })),
  ["model:joints"] = each(fields("a joint", with_place { opening = "m", slip = "m", damage = "1", storey = "1",
    area = "m2" })),
  ["model:thrust_line"] = each(fields("a resultant", with_place { fx = "N", fy = "N", fz = "N" })),
  ["model:stresses"] = each(of "Pa"),
  ["body:forces"] = each(fields("a section", with_place(with_moments { along = "m", normal = "N", shear = "N",
    shear_y = "N", shear_z = "N" }))),
  ["body:hinges"] = each(fields("a hinge", with_place(with_moments { rotation = "1", rotation_y = "1", rotation_z = "1",
    stretch = "m", normal = "N", given_off = "J" }))),
  ["model:water_state"] = fields("the state of water", { level = "m", force = "N", moment = "N m", crack = "m",
    open_toe = "m", length = "m" }),
  ["section:moment_curvature"] = fields("the curve", { curvature = "1/m", moment = "N m", axial = same,
    yield_curvature = "1/m", yield_moment = "N m", peak_moment = "N m", peak_curvature = "1/m" }),
  ["section:interaction"] = fields("the interaction", { normal = "N", sagging = "N m", hogging = "N m" }),
  ["body:fibres"] = each(fields("a section", with_moments { along = "m", axial = "1", curvature = "1/m",
    curvature_y = "1/m", curvature_z = "1/m", normal = "N", moment = "N m", fibres = fibre })),
  ["model:modes"] = each(mode),
  ["model:temperature"] = same, ["model:creep_process"] = same, ["trilith.concrete_creep"] = same,
  ["model:heat_state"] = fields("the state of the heat", { clock = "1", content = "J", cells = "1", friction = "J",
    surroundings = heat_source }),
  ["model:seepage_state"] = fields("the state of seepage", { head = "m", pressure = "Pa", aperture = "m", fill = "1",
    volume = "m3", wet_length = "m", length = "m", head_from = "m", head_to = "m", inflow = "m3/s", outflow = "m3/s",
    force = "N", moment = "N m", clock = "1", cells = "1", nodes = flow_node }),
  ["set:damage_by_storey"] = same, ["model:damping"] = same, ["model:on"] = same, ["model:every"] = same,
  ["model:on_step"] = same, ["model:keep"] = same, ["set:names"] = same,
  ["model:explain_dt"] = function(value, system) return system:message(value) end,
  -- Readings of handles that are not numbers.
  ["body.outline"] = of "m", ["body.removed_at"] = same, ["model.gravity"] = of "m/s2",
  ["bearing.force"] = fields("force", { along = "N", across = "N", axial = "N", turning = "N m", turning_along = "N m",
    turning_across = "N m", turning_axial = "N m" }),
  ["bearing.displacement"] = fields("displacement", { along = "m", across = "m", axial = "m", turning = "1",
    turning_along = "1", turning_across = "1", turning_axial = "1" }),
  ["model.verdict"] = fields("the verdict", { sound_until = "s", left = "1",
    text = function(value, system) return system:message(value) end }),
  ["model.notes"] = each(function(value, system) return system:message(value) end),
}
for _, name in ipairs { "body.name", "body.material", "body.groups", "body.kind", "body.bearings", "body.seats",
  "body.resting", "seat.name", "seat.lost", "set.names", "model.name", "model.dim", "model.bearings", "model.seats",
  "model.storeys", "model.hash", "bearing.name", "bearing.status", "bearing.bodies", "bearing.limited", "history.name",
  "history.t", "motion.description", "contact law.name", "section.name", "storey.number", "body.present" } do
  rules.results[name] = rules.results[name] or same
end

--- Functions that take and return numbers in any consistent units, or none.
rules.plain = { ["trilith.joint_stiffness"] = true, ["trilith.bilinear"] = true, ["trilith.rayleigh"] = true,
  ["trilith.drift_limit"] = true, ["trilith.version"] = true, ["trilith.params"] = true, ["trilith.units"] = true }
