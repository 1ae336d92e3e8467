-- An error raised in a handler reaches the pcall around the run unchanged; a script's own debug.sethook stays active.
local trilith = require "trilith"

local function falling()
  local m = trilith.model { name = "errors" }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e7, ks = 5e6, mu = 0.6, beta = 2e-3 } }
  m:block { name = "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
  m:block { name = "b", width = 0.5, height = 0.3, at = { -0.25, 0.01 }, material = "stone", floating = true }
  return m
end

local ways = {
  on = function(m, f) m:on("stage.begun", f) end,
  every = function(m, f) m:every(0.01, f) end,
  on_step = function(m, f) m:on_step(f) end,
  history = function(m, f) m:history { name = "h", of = f } end,
  story = function(m, f) m:story(function() m:wait(0.01) f() end) end,
  ["story on an event"] = function(m, f) m:story(function() m:wait "stage.begun" f() end) end,
  ["a run within a handler"] = function(m, f)
    m:every(0.01, function()
      local inner = falling()
      inner:on_step(f)
      inner:run { duration = 0.01 }
    end)
  end,
}
local named = setmetatable({}, { __tostring = function() return "the one with a name" end })
local faulty = setmetatable({}, { __tostring = function() error "no name" end })
for way, set in pairs(ways) do
  for _, object in ipairs { { code = 5 }, named, faulty, 42, 0.5, false, print, io.stdout, "nil" } do
    if object == "nil" then object = nil end
    local m = falling()
    set(m, function() error(object) end)
    local good, got = pcall(m.run, m, { duration = 0.05 })
    assert(not good and rawequal(got, object), ("%s: %s became %s"):format(way, type(object), type(got)))
    assert(m.time < 0.05 and not pcall(m.body, m, "nobody")) -- the model can still be read
  end
  local m = falling()
  set(m, function() error "in words" end)
  local good, got = pcall(m.run, m, { duration = 0.05 })
  assert(not good and got:find "errors%.lua:%d+: in words\nstack traceback:", got)
end

for _, mask in ipairs { "c", "r", "l", "" } do
  local m, calls = falling(), 0
  m:every(0.01, function() debug.sethook(function() calls = calls + 1 end, mask, mask == "" and 10 or 0) end)
  local report = m:run { duration = 0.05 }
  debug.sethook()
  assert(report.ending == "time" and calls > 0, report.ending)
end
