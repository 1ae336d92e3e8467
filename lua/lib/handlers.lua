-- Handlers: m:on(event, f), m:every(interval, f), m:on_step(f). The engine tests what is due; Lua is entered only then.
local _, core = ...
local model_methods = core.members "model"

local function check_function(f, owner)
  if type(f) == "function" then return end
  core.fail(("%s: needs a function; this is %s"):format(owner, f == nil and "nil" or "a " .. type(f)))
end

core.check_function = check_function

core.made[#core.made + 1] = function(model, own)
  local by_event, clocks, steps, samples = {}, {}, {}, {}
  own.by_event, own.clocks, own.steps, own.samples = by_event, clocks, steps, samples

  local function hand_to(list, event)
    if not list then return end
    for i = 1, #list do list[i](event) end
  end

  function own.dispatch(event)
    hand_to(by_event[event.type], event)
    hand_to(by_event["*"], event)
    own.tell_stories(event)
  end

  function own.tick(index) clocks[index](model) end

  function own.stepped()
    for i = 1, #steps do steps[i](model) end
  end

  function own.sample(index) return samples[index](model) end
end

--- m:on("bearing.failed", f): f(event) at each such event; "*" for every event.
function model_methods.on(model, event, f)
  core.listen(model, event, "on")
  check_function(f, "on")
  local by_event = core.own(model).by_event
  by_event[event] = by_event[event] or {}
  table.insert(by_event[event], core.timed(f, "on " .. event))
end

--- m:every(interval, f): f(model) each interval of simulated time.
function model_methods.every(model, interval, f)
  check_function(f, "every")
  core.own(model).clocks[core.timer(model, interval)] = core.timed(f, "every")
end

--- m:on_step(f): f(model) after each step.
function model_methods.on_step(model, f)
  check_function(f, "on_step")
  table.insert(core.own(model).steps, core.timed(f, "on_step"))
  core.step_handler(model, true)
end

local follow = model_methods.history
--- m:history{...}; a function given as `of` is kept here.
function model_methods.history(model, options)
  local history = follow(model, options)
  local own = core.own(model)
  own.history_count = (own.history_count or 0) + 1
  own.samples[own.history_count] = core.timed(rawget(options, "of"), "history")
  return history
end
