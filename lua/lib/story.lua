-- Stories: functions that run alongside a model and wait for events. m:story(f), m:wait(...).
local _, core = ...
local model_methods = core.members "model"

local wait_keys = { "body", "bearing", "seat", "group", "above", "within" }
local is_wait_key = {}
for _, key in ipairs(wait_keys) do is_wait_key[key] = true end

local function has_body(event, name)
  for _, body in ipairs(event.bodies) do
    if body.name == name then return true end
  end
  return false
end

local function has_group(event, group)
  for _, body in ipairs(event.bodies) do
    for _, g in ipairs(body.groups) do
      if g == group then return true end
    end
  end
  return false
end

local function fits(event, wanted)
  return (wanted.event == "*" or wanted.event == event.type)
    and (not wanted.body or has_body(event, wanted.body))
    and (not wanted.group or has_group(event, wanted.group))
    and (not wanted.bearing or (event.bearing and event.bearing.name == wanted.bearing))
    and (not wanted.seat or (event.seat and event.seat.name == wanted.seat))
    and (not wanted.above or math.abs(event.value) > wanted.above)
end

core.fits = fits

local function check_wait(options)
  for key in pairs(options) do
    if key ~= 1 and not is_wait_key[key] then
      core.fail(("wait: unknown key '%s'%s"):format(tostring(key), core.hint(tostring(key), wait_keys)))
    end
  end
  for _, key in ipairs { "within", "above" } do
    local value = options[key]
    if value ~= nil and (type(value) ~= "number" or value ~= value or value < 0) then
      core.fail(("wait: '%s' is %s, must be a number not below 0"):format(key, core.what_is(value)))
    end
  end
  if not options[1] and not options.within then
    core.fail "wait: give an event, as in wait \"bearing.failed\", or within = a time"
  end
end

--- Converts an event and its filters to the argument of core.fits.
function core.wanted(model, options, owner)
  local above = options.above
  if above ~= nil and (type(above) ~= "number" or above ~= above or above < 0 or above == math.huge) then
    core.fail(("%s: 'above' is %s, must be a finite number not below 0"):format(owner, tostring(above)))
  end
  if options.group ~= nil and type(options.group) ~= "string" then
    core.fail(("%s: 'group' is %s, must be the name of one"):format(owner, tostring(options.group)))
  end
  local wanted = { event = options[1], group = options.group, above = above }
  for _, kind in ipairs { "body", "bearing", "seat" } do
    wanted[kind] = options[kind] ~= nil and core.name_of(model, kind, options[kind], owner) or nil
  end
  return wanted
end

core.made[#core.made + 1] = function(model, own)
  local waiting = {} -- in the order in which the stories began to wait

  local function resume(story, ...)
    core.effect(model)
    local good, wanted = coroutine.resume(story, ...)
    if not good then error(core.traced(story, wanted), 0) end
    if coroutine.status(story) == "dead" then return end
    if type(wanted) ~= "table" or not wanted.is_wait then
      core.fail "story: only m:wait may pause a story"
    end
    wanted.story = story
    waiting[#waiting + 1] = wanted
    if wanted.until_time then core.wake(model, wanted.until_time) end
  end

  -- Removes the stories for which `is_due` is true, then resumes them: their next wait sees only later events.
  local function resume_due(is_due, ...)
    local due, rest = {}, {}
    for _, wanted in ipairs(waiting) do
      local list = is_due(wanted) and due or rest
      list[#list + 1] = wanted
    end
    if #due == 0 then return end
    waiting = rest
    for _, wanted in ipairs(due) do resume(wanted.story, ...) end
  end

  function own.tell_stories(event)
    if #waiting == 0 then return end
    resume_due(function(wanted) return wanted.event and fits(event, wanted) end, event)
  end

  function own.wake()
    local now = model.time
    resume_due(function(wanted) return wanted.until_time and wanted.until_time <= now + 1e-12 end, nil)
    for _, wanted in ipairs(waiting) do
      if wanted.until_time then core.wake(model, wanted.until_time) end
    end
  end

  own.begin_story = resume
end

--- m:story(f): f(model) runs at once up to its first m:wait, and continues when that occurs.
function model_methods.story(model, f)
  core.check_function(f, "story")
  core.own(model).begin_story(coroutine.create(f), model)
end

--- m:wait "bearing.failed", m:wait{ "seat.lost", body = "S3", within = 10 }, m:wait(2): returns the event, or nil after
--- the time limit. Only in a story.
function model_methods.wait(model, options)
  if type(options) == "string" then options = { options } end
  if type(options) == "number" then options = { within = options } end
  if type(options) ~= "table" then
    core.fail(("wait: takes an event, a time or a table; this is a %s"):format(type(options)))
  end
  check_wait(options)
  if options[1] then core.listen(model, options[1], "wait") end
  local wanted = core.wanted(model, options, "wait")
  if not coroutine.isyieldable() then core.fail "wait: only within a story, see m:story(function() ... end)" end
  wanted.is_wait = true
  wanted.until_time = options.within and model.time + options.within
  return coroutine.yield(wanted)
end
