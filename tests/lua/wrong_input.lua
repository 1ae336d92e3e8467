-- Shared by the scripts on wrong input: their models, and the check of messages.
local trilith = require "trilith"

local given = {
  stone = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.5 },
  spring = trilith.linear { stiffness = 1e6 },
  square = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } },
}

function given.new()
  local m = trilith.model { name = "wrong" }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "stone", "stone" }, law = given.stone }
  m:block { name = "base", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
  return m
end
function given.built()
  local m = given.new()
  m:block { name = "block", width = 1, height = 1, material = "stone", groups = "top" }
  m:block { name = "other", width = 1, height = 1, at = { 1.5, 0 }, material = "stone" }
  m:bearing { name = "B1", between = { "block", "other" }, at = { 1.2, 0.5 }, along = given.spring }
  return m
end
function given.with_block(name, y)
  local w = given.new()
  w:block { name = name, width = 1, height = 1, at = { 0, y }, material = "stone" }
  return w
end
function given.late()
  local w = given.built()
  w:run { duration = 1e-3 }
  return w
end

-- Each case is a function of one line of script and the expected one-line message with its line number. A message in a
-- table is a pattern: it contains a path of this machine.
function given.check(cases)
  local wrong = 0
  for _, case in ipairs(cases) do
    local info = debug.getinfo(case[1], "S")
    local good, message = pcall(case[1])
    local pattern = type(case[2]) == "table"
    local expected = ("%s:%d: %s"):format(info.short_src, info.linedefined, pattern and case[2][1] or case[2])
    if good or not (pattern and message:find("^" .. expected .. "$") or message == expected) then
      wrong = wrong + 1
      print(("line %d\n  expected: %s\n  was:      %s"):format(info.linedefined, expected, message or "no error"))
    end
  end
  assert(wrong == 0, wrong .. " messages are not as they should be")
end

return given
