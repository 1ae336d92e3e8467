-- Cost of a step callback: the same run without one, with an empty one, and with one that reads two properties.
local trilith = require "trilith"
local function run(handler)
  local m = trilith.model {}
  m:block { name = "block", width = 1, height = 1, mass = 1, floating = true }
  if handler then m:on_step(handler(m)) end
  local begun = os.clock()
  local report = m:run { duration = 40, dt = 1e-4 }
  return (os.clock() - begun) / report.steps * 1e9
end
local none, empty, reading = math.huge, math.huge, math.huge
for _ = 1, 3 do
  none = math.min(none, run())
  empty = math.min(empty, run(function() return function() end end))
  reading = math.min(reading, run(function(m)
    local block = m:body "block"
    return function() return block.x + block.vy end
  end))
end
print(("a step of one free body: %.0f ns; an empty on_step adds %.0f ns, reading two properties %.0f ns more")
  :format(none, empty - none, reading - empty))
