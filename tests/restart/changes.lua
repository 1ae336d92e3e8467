-- A model that its handlers change while a stage runs: bodies come and go, a law changes, a body is freed. A story
-- waits. Handlers register another handler and a timer, and remove one.
-- They draw random numbers.
local trilith = require "trilith"
local p = trilith.params { out = { "out/changes.h5", "results" }, duration = { 6, unit = "s", "of the stage" } }
local m = trilith.model { name = "changes" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, name = "joint",
  law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4 } }
m:block { name = "base", width = 8, height = 0.2, at = { -4, -0.2 }, material = "stone", support = "fixed" }
for i = 1, 8 do
  m:block { name = "b" .. i, width = 0.5, height = 0.25, at = { -0.25 + 0.01 * (i % 3), 0.25 * (i - 1) },
            material = "stone" }
end
m:block { name = "held", width = 0.4, height = 0.4, at = { 2, 1 }, material = "stone", support = "fixed" }
m:results { file = p.out, frames = 0.05, histories = 0.01, energy = 0.05 }
m:history { name = "top", body = m:body "b8", what = "y" }
local state = m:keep { dropped = 0, off = false }
m:consolidate { rest = { ratio = 1e-4 } }

local function drop(x, y)
  state.dropped = state.dropped + 1
  x = x + 0.02 * math.random()
  m:block { name = "drop " .. state.dropped, width = 0.3, height = 0.2, at = { x, y }, material = "stone",
            floating = true }
end
local clock = m:every(0.5, function()
  if state.dropped < 6 then drop(m:body "b8".x - 0.15, m:body "b8".y + 1 + 0.1 * state.dropped) end
end)
m:story(function()
  m:wait(1.2)
  m:free("held", "xyr")
  local event = m:wait { "impact", body = "held", within = 5 }
  if event then m:change { law = "joint", mu = 0.3 } end
  m:wait(0.4)
  m:remove("b3")
  m:wait(0.5)
  m:every(0.7, function() state.late = (state.late or 0) + 1 end)
  m:on({ "impact", above = 1 }, function() state.hard = (state.hard or 0) + 1 end)
end)
m:on("body.removed", function()
  if not state.off then
    state.off = true
    m:off(clock)
  end
end)
m:run { name = "changing", duration = p.duration }
print("hash " .. m.hash, state.dropped, state.late, state.hard)
m:run { name = "after", duration = 0.5 }
print("hash " .. m.hash)
