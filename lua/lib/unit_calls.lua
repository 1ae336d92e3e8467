-- Calls between a script with units of its own and the library, which works in SI. The door of
-- bindings/core/unit_door.hpp opens and shuts around them.
local _, core = ...
local rules = core.unit_rules
local calls = {} -- `system`: the units of this script
core.unit_calls = calls

function calls.pack(...) return { n = select("#", ...), ... } end

--- Raises an error of a call again, in the units of the models. Its place is known already.
function calls.raise(message)
  if type(message) == "string" then core.raise(calls.system:message(message)) end
  error(message, 0)
end

--- Calls f with the door open, and shuts it afterwards as it was.
function calls.inside(f, ...)
  local before = core.unit_door "open"
  local results = calls.pack(pcall(f, ...))
  core.unit_door(before)
  if not results[1] then calls.raise(results[2]) end
  return table.unpack(results, 2, results.n)
end

function calls.is_shut()
  local state = core.unit_door "unchanged"
  return state == "shut"
end

local written = setmetatable({}, { __mode = "k" })
--- The function of the script that core.outside has wrapped; another function itself.
function core.written(f) return written[f] or f end

--- A function of the script, called by the library: with the door shut, and its arguments converted.
function core.outside(f, owner, key)
  if type(f) ~= "function" then return f end
  local function wrapped(...)
    local arguments = calls.pack(...)
    if key == "on_sample" then
      arguments[2] = rules.fields("a sample", { t = "s", displacement = "m", force = "N", drift = "m" })(arguments[2],
        calls.system, -1)
    elseif owner == "on" then
      arguments[1] = calls.convert_event(arguments[1])
    end
    local before = core.unit_door "shut"
    local results = calls.pack(pcall(f, table.unpack(arguments, 1, arguments.n)))
    core.unit_door(before)
    if not results[1] then error(results[2], 0) end
    return table.unpack(results, 2, results.n)
  end
  written[wrapped] = f
  return wrapped
end

local event_units
--- The SI unit of the value of an event of a type; nil for an unknown type.
local function unit_of_event(kind)
  if not event_units then
    event_units = {}
    for _, known in ipairs(core.event_types()) do event_units[known.name] = known.unit end
  end
  return event_units[kind]
end

--- A filter of events { type, above = , ... }: the limit is in the unit of the value of these events.
function calls.convert_filter(filter, what)
  if type(filter) ~= "table" or type(filter.above) ~= "number" then return filter end
  local unit, copy = unit_of_event(filter[1]), {}
  if not unit or not calls.system:factor(unit) then rules.refuse(what, calls.system) end
  for key, value in next, filter do copy[key] = value end
  copy.above = rules.of(unit)(filter.above, calls.system, 1)
  return copy
end

--- The place of m:break_on: a text, a condition, or a table of both.
function calls.convert_break(where)
  if type(where) ~= "table" then return core.outside(where, "break_on") end
  local copy = {}
  for key, one in next, calls.convert_filter(where, "'above' of break_on") do copy[key] = one end
  copy.when = core.outside(copy.when, "break_on")
  return copy
end

--- An event with its value, place and text in the units of the models.
function calls.convert_event(event)
  if type(event) ~= "table" then return event end
  local copy = {}
  for key, value in next, event do copy[key] = value end
  local unit = unit_of_event(event.type) or ""
  if calls.system:factor(unit) then
    copy.value = rules.of(unit)(event.value, calls.system, -1)
  else
    copy.value = nil
  end
  for _, axis in ipairs { "x", "y", "z" } do copy[axis] = rules.of "m"(rawget(event, axis), calls.system, -1) end
  copy.text = calls.system:message(event.text, rawget(event, "value"), unit)
  return setmetatable(copy, getmetatable(event))
end

local opened = {}
--- Tables with functions of the engine, which the first of them creates: reports and energies open the door for these.
function calls.wrap_table_functions()
  for _, name in ipairs { "trilith.report", "trilith.energy" } do
    local metatable = not opened[name] and rawget(debug.getregistry(), name)
    if metatable then
      opened[name] = true
      local index, text_of = metatable.__index, metatable.__tostring
      metatable.__index = function(...) return calls.inside(index, ...) end
      metatable.__tostring = text_of and function(found) return calls.system:message(calls.inside(text_of, found)) end
    end
  end
end
