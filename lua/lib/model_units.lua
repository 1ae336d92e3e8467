-- Units of a script's models: trilith.model{ units = "kN m" }. From then on each function of the module converts the
-- numbers that it takes and returns; the engine and its results stay in SI. While the door is shut (bindings/core/
-- unit_door.hpp) the script cannot call a function that does not convert.
local trilith, core = ...
local rules, calls = core.unit_rules, core.unit_calls
local raw_model, si_units, declare = trilith.model, trilith.units, trilith.params

local system            -- of this script; nil: SI
local declarations
local made = setmetatable({}, { __mode = "k" })   -- how a law or a ramp was made: { function, keys as given }
local read_before = core.quantities_read()

local pack, inside, raise, is_shut = calls.pack, calls.inside, calls.raise, calls.is_shut
local convert_event, wrap_table_functions = calls.convert_event, calls.wrap_table_functions

-- Results whose values are the same in all units.
local same_results = {}
for _, name in ipairs { "body", "set", "bearing", "seat", "history", "motion", "section", "model", "string", "boolean",
  "integer", "law", "contact law", "direction law", "solid law", "fibre law", "hinge law", "motion, motion", "string[]",
  "findings" } do
  same_results[name] = true
end

--- The rule of the result of a function; nil if it has none.
local function result_rule(entry)
  local special = rules.results[entry.name] or rules.results[entry.name:gsub("^space:", "model:")]
  if special then return special end
  if entry.gives == nil or same_results[entry.gives] then return rules.same end
  local list = entry.gives:match "^(.*)%[%]$"
  if entry.gives == "part" then return rules.fields("a part", { outline = "m" }) end
  if list == "part" then return rules.each(rules.fields("a part", { outline = "m" })) end
  return declarations.tables[entry.gives]
end

--- A law of forces and displacements that acts on moments and rotations: made again with rotational units.
local function turned_law(law, key)
  local how = made[law]
  if system.length == 1 or type(law) ~= "userdata" then return law end
  if not how then rules.refuse(("the law '%s'"):format(key), system) end
  local copy = {}
  for name, value in next, how.given do copy[name] = value end
  for _, p in ipairs(how.entry.parameters) do
    copy[p.name] = rules.of(p.unit, true)(how.given[p.name], system, 1)
  end
  if how.given.points then rules.refuse(("the law '%s', a table of points,"):format(key), system) end
  return how.raw(copy)
end

--- A ramp that turns a body is in rad.
local function turned_motion(motion, key)
  if system.length == 1 or type(motion) ~= "userdata" then return motion end
  local how = made[motion]
  if not how or how.entry.member ~= "ramp" then
    rules.refuse(("a motion as '%s', unless it is a trilith.ramp,"):format(key), system)
  end
  return how.raw { by = how.given.by, duration = how.given.duration }
end

local has_directions = { bearing = true, bearing_type = true, change = true, foundation = true }
--- Keys of a call whose laws and motions act on rotations.
local function with_rotations(entry, given, copy)
  local member = entry.member
  for key, value in next, given do
    if type(key) == "string" and key:find "^turning" and has_directions[member] then
      copy[key] = turned_law(value, key)
    elseif type(key) == "string" and key:find "^rotation" and (member == "drive" or member == "shake") then
      copy[key] = turned_motion(value, key)
    elseif key == "motions" and type(value) == "table" then
      copy[key] = {}
      for i, row in ipairs(value) do
        copy[key][i] = {}
        for name, one in next, row do
          copy[key][i][name] = name:find "^rotation" and turned_motion(one, name) or one
        end
      end
    end
  end
end

--- Laws of rotations of the foundations of a bridge.
local function turn_foundations(given, copy)
  local function turn(row, converted)
    if type(row) == "table" and type(row.foundation) == "table" then
      with_rotations({ member = "foundation" }, row.foundation, converted.foundation)
    end
  end
  for _, key in ipairs { "abutment", "pier" } do turn(given[key], copy[key]) end
  for i, row in ipairs(type(given.supports) == "table" and given.supports or {}) do turn(row, copy.supports[i]) end
end

--- Arguments of a call, after the object for methods: the table of keys, or single values.
local function convert_arguments(entry, arguments, first)
  local given = arguments[first]
  if type(given) == "table" and next(entry.keys) then
    local copy = core.convert_keys(entry.keys, given, system, 1, entry.member)
    with_rotations(entry, given, copy)
    if entry.member == "solids" or entry.member == "gmsh" then
      copy.scale = rules.keys["solids.scale"](given.scale, system)
    end
    arguments[first] = copy
    return
  end
  for i, name in ipairs(entry.args) do
    local at, rule = first + i - 1, entry.args[name]
    if rule == "function" then
      arguments[at] = core.outside(arguments[at], entry.member, name)
    elseif arguments[at] ~= nil then
      arguments[at] = rule(arguments[at], system, 1)
    end
  end
end

local function refusal(name, raw)
  return function(...)
    if not is_shut() then return raw(...) end
    core.fail(("%s does not convert to units = \"%s\"; leave 'units' out and give numbers in SI, with trilith.units")
      :format(name, system.text))
  end
end

--- A bolt has functions of its own.
rules.results["model:bolt"] = function(bolt)
  local force, lock = bolt.force, bolt.lock
  function bolt.force(...) return rules.of "N"(inside(force, ...), system, -1) end
  function bolt.lock(...) return inside(lock, ...) end
  return bolt
end

--- Results of a call of several numbers, by name.
local number_lists = { ["model:temperature"] = { "1", "1" }, ["motion:at"] = { "m/s2", "m/s", "m" },
  ["body:point"] = { "m", "m", "m" } }

--- add takes parts, then keys; on a filter, then a function.
local special_arguments = {
  add = function(entry, arguments)
    local parts = rules.each(rules.fields("a part", { outline = "m" }))
    arguments[2] = parts(arguments[2], system, 1)
    local body = declarations.entries[entry.owner == "space" and "space:body" or "model:body"]
    local own = { depth = rules.of "m", from = rules.of "m", fixed = rules.same }
    local keys = setmetatable(own, { __index = body.keys })
    keys.by_group = rules.each(function(value, of, direction)
      return core.convert_keys(body.keys, value, of, direction, "add")
    end)
    arguments[3] = core.convert_keys(keys, arguments[3], system, 1, "add")
  end,
  on = function(_, arguments)
    arguments[2] = calls.convert_filter(arguments[2], "'above' of on")
    arguments[3] = core.outside(arguments[3], "on")
  end,
  wait = function(_, arguments) arguments[2] = calls.convert_filter(arguments[2], "'above' of wait") end,
  break_on = function(_, arguments) arguments[2] = calls.convert_break(arguments[2]) end,
  -- The law gives the units of its numbers.
  change = function(entry, arguments)
    local given = arguments[2]
    convert_arguments(entry, arguments, 2)
    if type(given) ~= "table" or type(given.law) ~= "string" then return end
    for key, unit in pairs(rules.units_of_law(arguments[1], given.law)) do
      if given[key] ~= nil then arguments[2][key] = rules.of(unit)(given[key], system, 1) end
    end
  end,
  calibrate = function(entry, arguments)
    local first = entry.owner == "trilith" and 1 or 2
    local given = arguments[first]
    convert_arguments(entry, arguments, first)
    if first == 2 and type(given) == "table" and type(given.between) == "table" then
      arguments[2].between = rules.bounds(arguments[1], given, system)
    end
  end,
  bridge = function(_, arguments)
    local given = arguments[2]
    if type(given) ~= "table" then return end
    arguments[2] = rules.bridge(arguments[1], given, system, declarations.entries)
    turn_foundations(given, arguments[2])
  end,
  -- The direction of a bearing gives the unit of its stiffness.
  creep = function(entry, arguments)
    convert_arguments(entry, arguments, 2)
    local given = arguments[2]
    if type(given) ~= "table" or type(given.stiffness) ~= "number" then return end
    local turns = type(given.direction) == "string" and given.direction:find "^turning"
    given.stiffness = rules.of(turns and "N m" or "N/m")(given.stiffness, system, 1)
  end,
}

local function convert_results(entry, rule, results, arguments)
  local units = number_lists[entry.name]
  for i = 2, results.n do
    if units then
      results[i] = rules.of(units[i - 1])(results[i], system, -1)
    else
      results[i] = rule(results[i], system, -1, arguments)
    end
  end
  return table.unpack(results, 2, results.n)
end

--- A function of the module that converts its arguments and results.
local function converting(entry, raw, first)
  local rule = number_lists[entry.name] and rules.same or result_rule(entry)
  if not rule then return refusal(entry.name, raw) end
  return function(...)
    if not is_shut() then return raw(...) end
    local arguments = pack(...)
    local before = core.unit_door "open"
    local converted = pack(pcall(special_arguments[entry.member] or convert_arguments, entry, arguments, first))
    local results = converted[1] and pack(pcall(raw, table.unpack(arguments, 1, math.max(arguments.n, first))))
      or converted
    local good = results[1] and converted[1]
    local back = good and pack(pcall(convert_results, entry, rule, results, arguments)) or results
    core.unit_door(before)
    wrap_table_functions()
    if not back[1] then raise(back[2]) end
    if type(back[2]) == "userdata" and (entry.parameters or entry.member == "ramp") then
      local given = {}
      for key, value in next, type((...)) == "table" and (...) or {} do given[key] = value end
      made[back[2]] = { entry = entry, raw = raw, given = given }
    elseif entry.member == "history" and type(arguments[2]) == "table" and arguments[2].of ~= nil then
      made[back[2]] = true
    end
    return table.unpack(back, 2, back.n)
  end
end

--- Chooses the declaration of a method by the dimension of the model.
local function by_dimension(name, raw)
  local plane, space = declarations.entries["model:" .. name], declarations.entries["space:" .. name]
  local in_plane, in_space = plane and converting(plane, raw, 2), space and converting(space, raw, 2)
  if not space then return in_plane or refusal("model:" .. name, raw) end
  return function(model, ...)
    local dim = inside(function() return model.dim end)
    return ((dim == 3 and in_space or in_plane) or refusal("model:" .. name, raw))(model, ...)
  end
end

local kinds = { model = "model", body = "body", ["set of bodies"] = "set", bearing = "bearing", seat = "seat",
  history = "history", storey = "storey", motion = "motion", section = "section", ["contact law"] = "contact law" }

--- A list of rows of the library, such as model.bearings, whose functions open the door.
local function opened_rows(list)
  return setmetatable({}, { __index = function(_, key) return inside(function() return list[key] end) end,
    __len = function() return inside(function() return #list end) end, __metatable = "rows" })
end

--- Numbers of a history are in the unit of its reading; values from a function of the script stay.
local function history_value(raw, history, name, value)
  local unit = raw(history, "unit")
  local own = made[history]
  if name == "unit" then return own and unit or system:name(unit) end
  if own or not system:factor(unit) then return value end
  return rules.of(unit)(value, system, -1)
end

--- The value of a property of a handle in the units of the models.
local function converted_property(owner, property, raw, object, value)
  if owner == "history" and ({ values = true, last = true, max = true, min = true, unit = true })[property.name] then
    return history_value(raw, object, property.name, value)
  end
  if property.number then
    if not system:factor(property.unit) then rules.refuse(("%s.%s"):format(owner, property.name), system) end
    return rules.of(property.unit)(value, system, -1)
  end
  local full = owner .. "." .. property.name
  if full == "model.events" then return rules.each(convert_event)(value) end
  wrap_table_functions()
  if full == "model.energy" then return rules.of "J"(value, system, -1) end
  if full == "model.bearings" or full == "model.seats" or full == "model.storeys" then return opened_rows(value) end
  local rule = rules.results[full] or rules.results[full:gsub("^body%.", "model.")]
  if not rule then rules.refuse(full, system) end
  return rule(value, system, -1)
end

--- Replaces reading and writing of the handles of a kind, and their other metamethods.
local function replace_metamethods(kind, owner, metatable)
  local properties = {}
  for _, p in ipairs(owner and core.properties(kind) or {}) do properties[p.name] = p end
  local index, newindex, tostring_of = metatable.__index, metatable.__newindex, metatable.__tostring
  metatable.__index = function(object, name)
    if not is_shut() then return index(object, name) end
    return inside(function()
      local value, property = index(object, name), properties[name]
      if property then return converted_property(owner, property, index, object, value) end
      if value == nil or type(value) == "function" or type(value) == "userdata" then return value end
      rules.refuse(("'%s' of a %s"):format(tostring(name), kind), system)
    end)
  end
  metatable.__newindex = function(object, name, value)
    if not is_shut() then return newindex(object, name, value) end
    return inside(function()
      local property = properties[name]
      if property and property.number then value = rules.of(property.unit)(value, system, 1) end
      newindex(object, name, value)
    end)
  end
  metatable.__tostring = function(object) return system:message(inside(tostring_of, object)) end
  for _, name in ipairs { "__len", "__pairs", "__call", "__eq", "__concat" } do
    local raw = rawget(metatable, name)
    if raw then metatable[name] = function(...) return inside(raw, ...) end end
  end
end

--- Replaces the methods of the handles of a kind.
local function replace_members(owner, members)
  for name, member in pairs(members) do
    if type(member) == "function" then
      local entry = owner and declarations.entries[owner .. ":" .. name]
      if owner == "model" then members[name] = by_dimension(name, member)
      elseif entry then members[name] = converting(entry, member, 2)
      else members[name] = refusal(tostring(owner) .. ":" .. name, member) end
    end
  end
end

local function replace_module(module, path)
  for name, member in next, module do
    local full = path .. "." .. name
    if type(member) == "table" and full ~= "trilith.math" then
      replace_module(member, full)
    elseif type(member) == "function" and full ~= "trilith.model" and not full:find "^trilith%.math" then
      local entry = declarations.entries[full]
      if rules.plain[full] then rawset(module, name, function(...) return inside(member, ...) end)
      elseif entry then rawset(module, name, converting(entry, member, 1))
      else rawset(module, name, refusal(full, member)) end
    end
  end
end

--- The console prints the properties of a handle with their units.
local function rename_units()
  local properties = core.properties
  function core.properties(kind)
    local list = properties(kind)
    for _, property in ipairs(list or {}) do property.unit = system:name(property.unit) end
    return list
  end
end

local function replace_all()
  for _, metatable in pairs(debug.getregistry()) do
    local members = type(metatable) == "table" and rawget(metatable, "members")
    local kind = members and rawget(metatable, "__metatable")
    if type(members) == "table" and type(kind) == "string" then
      replace_metamethods(kind, kinds[kind], metatable)
      replace_members(kinds[kind], members)
    end
  end
  rename_units()
  replace_module(trilith, "trilith")
  for name, f in pairs(trilith.math) do rawset(trilith.math, name, function(...) return inside(f, ...) end) end
end

--- trilith.units "mm kN": factors to the units of the models.
local function factors_of(...)
  local factors, i = pack(si_units(...)), 0
  for word in (...):gmatch "[^%s,]+" do
    i = i + 1
    factors[i] = factors[i]/system:factor(word)
  end
  return table.unpack(factors, 1, factors.n)
end

--- trilith.params{...}: numbers with a unit are in the units of the models.
local function parameters(declared)
  local values = declare(declared)
  for name, one in next, declared do
    local unit = type(one) == "table" and one.unit
    if unit then values[name] = values[name]/system:factor(unit) end
  end
  return values
end

--- Sets the units of the script, by its first model.
local function set_units(text)
  if core.quantities_read() > read_before then
    core.fail("model: 'units' must be given before other numbers: make the model first, and laws, parts, motions, "
      .. "parameters with a unit and factors of trilith.units after it")
  end
  declarations = core.unit_declarations()
  system = core.read_units(text)
  calls.system = system
  rawset(trilith, "units", factors_of)
  rawset(trilith, "params", parameters)
  replace_all()
end

function trilith.model(options)
  if type(options) ~= "table" then return raw_model(options) end
  local given, copy = rawget(options, "units"), {}
  if given == "SI" and not system then given = nil end
  if system and given ~= system.text then
    core.fail(("model: all models of a script have the same units; give units = \"%s\" here too"):format(system.text))
  end
  for key, value in next, options do copy[key] = value end
  copy.units = nil
  if given == nil then return raw_model(copy) end
  if not system then set_units(given) end
  local entry = declarations.entries["trilith.model"]
  core.unit_door "shut"
  return converting(entry, raw_model, 1)(copy)
end
