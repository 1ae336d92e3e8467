-- Breakpoints of a run: m:break_on, m:breaks, m:break_off. A pause opens the console at the next step border.
local _, core = ...
local model_methods = core.members "model"

local break_keys = { "body", "bearing", "seat", "group", "above", "when", "line", "once" }
local is_break_key = {}
for _, key in ipairs(break_keys) do is_break_key[key] = true end

core.made[#core.made + 1] = function(_, own) own.breaks = {} end

local function pause_at(model, stop, why)
  if stop.once then stop.off = true end
  core.pause(model, why)
end

--- " m/s": the unit of the value of events of a type; "" for no unit.
local function unit_of(kind)
  for _, known in ipairs(core.event_types()) do
    if known.name == kind and known.unit ~= "" and known.unit ~= "1" then return " " .. known.unit end
  end
  return ""
end

local function filter_text(options)
  local parts = {}
  for _, key in ipairs { "body", "bearing", "seat", "group", "above" } do
    if options[key] ~= nil then parts[#parts + 1] = key .. " " .. tostring(options[key]) end
  end
  if options.above ~= nil then parts[#parts] = parts[#parts] .. unit_of(options[1]) end
  return #parts == 0 and "" or " (" .. table.concat(parts, ", ") .. ")"
end

local function on_event(model, stop, options)
  core.listen(model, options[1], "break_on")
  local wanted = core.wanted(model, options, "break_on")
  stop.text = "event " .. options[1] .. filter_text(options)
  model_methods.on(model, options[1], function(event)
    if not stop.off and core.fits(event, wanted) then pause_at(model, stop, tostring(event)) end
  end)
end

local function on_condition(model, stop, when)
  core.check_function(when, "break_on: when")
  local info = debug.getinfo(core.written(when), "S")
  stop.text = ("condition at %s:%d"):format(info.short_src, info.linedefined)
  local was = false
  model_methods.on_step(model, function()
    if stop.off then return end
    local is = when(model) and true or false
    if is and not was then pause_at(model, stop, stop.text) end
    was = is
  end)
end

-- Breakpoints at lines of scripts. A hook tests each line, so it is set only while there are such breakpoints.
local lines = {}

local function at_line(_, line)
  local here = lines[line]
  if not here then return end
  local source = debug.getinfo(2, "S").short_src
  for _, stop in ipairs(here) do
    if not stop.off and (stop.file == "" or source:sub(-#stop.file) == stop.file) and core.is_users(source) then
      if stop.once then stop.off = true end
      core.open_console(("%s:%d"):format(source, line))
      return
    end
  end
end

--- Sets the hook if necessary; the console calls it after an interrupt, which removes the hook.
function core.arm_lines()
  if next(lines) and core.has_console() then debug.sethook(at_line, "l") end
end

function core.is_users(source) return not source:find "^trilith/" and source ~= "console" end

local function on_line(stop, place)
  local text = (type(place) == "string" or math.type(place) == "integer") and tostring(place) or ""
  local file, line = text:match "^(.-):?(%d+)$"
  if not line then
    core.fail(("break_on: 'line' is %s, must be a number or a text such as \"bridge.lua:12\""):format(tostring(place)))
  end
  line = tonumber(line)
  stop.file, stop.text = file, "line " .. tostring(place)
  lines[line] = lines[line] or {}
  table.insert(lines[line], stop)
  core.arm_lines()
end

--- m:break_on "bearing.failed", m:break_on{ "impact", body = "S3", above = 1 }, m:break_on(function(m) return ... end),
--- m:break_on{ line = "bridge.lua:40" }: pauses the run there. Returns the number of this breakpoint.
function model_methods.break_on(model, options)
  if type(options) == "string" then options = { options } end
  if type(options) == "function" then options = { when = options } end
  if type(options) ~= "table" then
    core.fail(("break_on: takes an event, a function or a table; this is a %s"):format(type(options)))
  end
  for key in pairs(options) do
    if key ~= 1 and not is_break_key[key] then
      core.fail(("break_on: unknown key '%s'%s"):format(tostring(key), core.hint(tostring(key), break_keys)))
    end
  end
  if options.once ~= nil and type(options.once) ~= "boolean" then
    core.fail(("break_on: 'once' is %s, must be true or false"):format(tostring(options.once)))
  end
  local breaks = core.own(model).breaks
  local stop = { number = #breaks + 1, once = options.once }
  if options[1] then
    on_event(model, stop, options)
  elseif options.when then
    on_condition(model, stop, options.when)
  elseif options.line then
    on_line(stop, options.line)
  else
    core.fail "break_on: give an event, when = a function, or line = a place in a script"
  end
  breaks[stop.number] = stop
  return stop.number
end

--- m:break_off(number): removes that breakpoint; without a number all of them.
function model_methods.break_off(model, number)
  local breaks = core.own(model).breaks
  if number ~= nil and not breaks[number] then
    core.fail(("break_off: there is no break %s; see m:breaks()"):format(tostring(number)))
  end
  for i, stop in ipairs(breaks) do
    if number == nil or i == number then stop.off = true end
  end
end

--- m:breaks(): the active breakpoints, in words by number.
function model_methods.breaks(model)
  local list = {}
  for i, stop in ipairs(core.own(model).breaks) do
    if not stop.off then list[i] = stop.text end
  end
  return list
end

--- m:continue(): continues a paused run, or the stage that rewind has restored.
model_methods["continue"] = function(model)
  if core.paused(model) then return core.leave_pause() end
  return core.resume(model)
end
