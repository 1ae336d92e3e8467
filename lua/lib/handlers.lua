-- Handlers: m:on(event, f), m:every(interval, f), m:on_step(f), m:off(handler). The engine tests for due handlers; Lua
-- is entered only then.
local _, core = ...
local model_methods = core.members "model"

local function check_function(f, owner)
  if type(f) == "function" then return end
  core.fail(("%s: needs a function; this is %s"):format(owner, f == nil and "nil" or "a " .. type(f)))
end

core.check_function = check_function

--- The function, whose time a profile lists at its place in the script.
local function timed(f, what) return core.timed(f, what, core.written(f)) end

-- Handler object of m:on and similar functions, removed by m:off. `list`: the list that contains it.
local handler_type = {
  __name = "handler",
  __tostring = function(h) return ("handler of %s%s"):format(h.what, h.off and ", which is off" or "") end,
}

local function new_handler(model, what, call, list)
  core.effect(model)
  local called = core.own(model).called
  called[#called + 1] = call
  local handler = setmetatable({ model = model, what = what, call = call, list = list }, handler_type)
  if list then list[#list + 1] = handler end
  return handler
end

core.made[#core.made + 1] = function(model, own)
  local by_event, clocks, steps, samples = {}, {}, {}, {}
  own.by_event, own.clocks, own.steps, own.samples = by_event, clocks, steps, samples
  own.sampled = {} -- names of histories whose values a function of the script gives

  -- A removed handler is skipped at once, and deleted from the list when that is traversed from its end.
  local function hand_to(list, value)
    if not list then return end
    local gone = false
    for i = 1, #list do
      local handler = list[i]
      if handler.off then gone = true else handler.call(value) end
    end
    if not gone then return end
    for i = #list, 1, -1 do
      if list[i].off then table.remove(list, i) end
    end
  end

  function own.dispatch(event)
    hand_to(by_event[event.type], event)
    hand_to(by_event["*"], event)
    own.tell_stories(event)
  end

  function own.tick(index)
    local handler = clocks[index]
    if not handler.off then handler.call(model) end
  end

  function own.stepped()
    hand_to(steps, model)
    if #steps == 0 then core.step_handler(model, false) end
  end

  function own.sample(index) return samples[index](model) end
end

local on_keys = { "body", "bearing", "seat", "group", "above" }

--- Converts { "impact", body = b, above = 2 } to the argument of core.fits.
local function wanted_of(model, options)
  for key in pairs(options) do
    local known = key == 1
    for _, name in ipairs(on_keys) do known = known or key == name end
    if not known then
      core.fail(("on: unknown key '%s'%s"):format(tostring(key), core.hint(tostring(key), on_keys)))
    end
  end
  if type(options[1]) ~= "string" then core.fail 'on: give an event first, as in { "impact", body = b }' end
  return core.wanted(model, options, "on")
end

--- m:on("bearing.failed", f): calls f(event) at each such event; "*" for every event; { "impact", body = b }: for that
--- body only. Returns the handler, for m:off.
function model_methods.on(model, event, f)
  check_function(f, "on")
  if type(event) == "table" then
    local wanted, all = wanted_of(model, event), f
    f = function(e) if core.fits(e, wanted) then all(e) end end
    event = wanted.event
  end
  core.listen(model, event, "on")
  local by_event = core.own(model).by_event
  by_event[event] = by_event[event] or {}
  return new_handler(model, event, timed(f, "on " .. event), by_event[event])
end

--- m:every(interval, f): calls f(model) at each interval of simulated time. Returns the handler.
function model_methods.every(model, interval, f)
  check_function(f, "every")
  local handler = new_handler(model, "every " .. tostring(interval) .. " s", timed(f, "every"))
  core.own(model).clocks[core.timer(model, interval)] = handler
  return handler
end

--- m:on_step(f): calls f(model) after each step. Returns the handler.
function model_methods.on_step(model, f)
  check_function(f, "on_step")
  local handler = new_handler(model, "each step", timed(f, "on_step"), core.own(model).steps)
  core.step_handler(model, true)
  return handler
end

--- m:off(handler): removes a handler of m:on, m:every or m:on_step.
function model_methods.off(model, handler)
  if getmetatable(handler) ~= handler_type then
    core.fail(("off: takes the handler returned by m:on, m:every or m:on_step; this is a %s"):format(type(handler)))
  end
  if handler.model ~= model then core.fail "off: the handler belongs to another model" end
  if handler.off then core.fail(("off: the handler of %s is off already"):format(handler.what)) end
  handler.off = true
  core.effect(model)
end

local follow = model_methods.history
--- m:history{...}; a function given as `of` is stored here.
function model_methods.history(model, options)
  local history = follow(model, options)
  local own = core.own(model)
  own.history_count = (own.history_count or 0) + 1
  own.samples[own.history_count] = timed(rawget(options, "of"), "history")
  if type(rawget(options, "of")) == "function" then
    own.called[#own.called + 1] = rawget(options, "of")
    own.sampled[history.name] = true
  end
  return history
end
