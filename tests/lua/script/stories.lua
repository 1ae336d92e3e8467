-- Handlers and stories: times of their calls, their readings, allowed changes.
local trilith = require "trilith"
local function falling()
  local m = trilith.model { name = "fall", still_time = 0.1 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 6e9, ks = 3e9, mu = 0.6, beta = 2e-4 } }
  m:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
  m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, 0.2 }, material = "stone", floating = true }
  return m
end

-- clocks: the counts are exact, the times are within a step
local m = falling()
local ticks, steps = {}, 0
m:every(0.1, function(model) ticks[#ticks + 1] = model.time end)
m:on_step(function() steps = steps + 1 end)
local report = m:run { duration = 1 }
assert(#ticks == 10 and steps == report.steps)
for i, t in ipairs(ticks) do assert(math.abs(t - 0.1 * i) <= report.longest_dt) end

-- stories: in order, with times
m = falling()
local told = {}
m:story(function(model)
  assert(model == m)
  local hit = m:wait { "impact", body = "block", above = 1 }
  told[#told + 1] = ("hit %.2f"):format(hit.time)
  local never = m:wait { "bearing.failed", within = 0.05 }
  told[#told + 1] = ("waited %s %.2f"):format(never, m.time - hit.time)
  m:wait(0.1)
  told[#told + 1] = ("slept %.2f"):format(m.time - hit.time)
  local rest = m:wait { "body.rest", body = m:body "block", within = 10 }
  told[#told + 1] = rest.type
end)
m:story(function()
  m:wait "stage.ended"
  told[#told + 1] = "ended"
  m:wait "stage.begun"
  told[#told + 1] = "begun again"
end)
m:run { duration = 5, rest = true }
m:run { duration = 0.01 }
assert(table.concat(told, ", ") == "hit 0.20, waited nil 0.05, slept 0.15, body.rest, ended, begun again",
  table.concat(told, ", "))

-- a handler's changes act from the step border on; readings are immediate
m = falling()
local block = m:body "block"
m:on("impact", function()
  local y = block.y
  m:fix(block)
  m:stop()
  assert(block.y == y)
end)
report = m:run { duration = 5 }
assert(report.ending == "stopped" and report.ended < 0.21)
local y = block.y
m:run { duration = 0.5 }
assert(block.y == y and m.speed == 0)

-- a story that raises an error, and one that yields by itself
m = falling()
local good, message = pcall(m.story, m, function() error "wrong turn" end)
assert(not good and message:find "wrong turn" and message:find "stack traceback")
good, message = pcall(m.story, m, function() coroutine.yield(1) end)
assert(not good and message:find "only m:wait may pause a story")

-- an error in a handler ends the stage, passes through run, and leaves the model usable
m = falling()
local first = true
m:on("impact", function()
  if first then
    first = false
    error "handler is at fault"
  end
end)
good, message = pcall(m.run, m, { duration = 5 })
assert(not good and message:find "stories.lua:%d+: handler is at fault" and message:find "stack traceback", message)
assert(m.time > 0.2 and m.time < 0.21)
assert(m:run { duration = 5, rest = true }.rests)

-- a stage within a stage is rejected
m = falling()
m:on("impact", function() m:run { duration = 1 } end)
good, message = pcall(m.run, m, { duration = 1 })
assert(not good and message:find "a stage runs already", message)

-- a rewind to a time that has not come yet is rejected
m = falling()
m:checkpoints { every = 0.1 }
m:run { duration = 0.3 }
good, message = pcall(m.rewind, m, { to = m.time + 0.01 })
assert(not good and message:find "is later", message)
