-- The module table: its constructor of models, and errors for unknown names.
local trilith, core = ...

-- A list of a model's rows by name or number; # returns their number, ipairs traverses them.
local function rows(model, one, count)
  return setmetatable({}, {
    __index = function(_, key) return one(model, key) end,
    __newindex = function()
      core.fail("bearings and seats are added with m:bearing{...} and m:seat{...}, storeys by groups \"storey 1\", ...")
    end,
    __len = function() return count(model) end,
    __metatable = "rows",
  })
end

core.module = trilith
core.made = {} -- functions called with each new model

local function made(model)
  local own = core.own(model)
  own.bearings = rows(model, core.bearing, core.bearing_count)
  own.seats = rows(model, core.seat, core.seat_count)
  own.storeys = rows(model, core.storey, core.storey_count)
  for _, prepare in ipairs(core.made) do prepare(model, own) end
  return model
end

function trilith.model(options) return made(core.model(options)) end

--- m:extruded{ name =, held = }: the model in space of a plane model.
local model_methods = core.members "model"
function model_methods.extruded(model, options) return made(core.extruded(model, options)) end

local declare, exit = trilith.params, os.exit
--- trilith.params{...}; without values they were listed, as requested from a stock interpreter, and the script ends.
function trilith.params(declared)
  local values = declare(declared)
  if not values then exit(true, true) end
  return values
end

core.event.__tostring = function(event) return ("%.4f s  %s"):format(event.time, event.text) end

local event_fields = { "type", "severity", "time", "id", "cause", "step", "value", "value_name", "x", "y", "z", "mode",
  "text", "bodies", "body", "bearing", "seat" }
local is_event_field = {}
for _, name in ipairs(event_fields) do is_event_field[name] = true end

--- Access to an unknown field of an event: nil if other events have it.
core.event.__index = function(event, name)
  if is_event_field[name] then return nil end
  core.fail(("event '%s' has no '%s'%s"):format(rawget(event, "type"), tostring(name),
    core.hint(tostring(name), event_fields)))
end

local function names_of(t)
  local names = {}
  for name in pairs(t) do names[#names + 1] = name end
  table.sort(names)
  return names
end

local function strict(t, title)
  return setmetatable(t, {
    __index = function(_, key)
      core.fail(("%s has no '%s'%s"):format(title, tostring(key), core.hint(tostring(key), names_of(t))))
    end,
  })
end
strict(trilith, "trilith")
strict(trilith.build, "trilith.build")
strict(trilith.math, "trilith.math")
