-- Members along their axes are watched against strain_limit. Runs that diverge end the program with exit code 3, so
-- this script says at its end that all was as it must be.
local trilith = require "trilith"

local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed*math.abs(expected), ("%.9g instead of %.9g"):format(value, expected))
end

-- A bar that is stretched or squeezed along its axis beyond what its material is made for ends the stage, as an element
-- does; within that it comes to rest where its force has it, F = E A u / L.
for _, share in ipairs { -0.6, -0.09, 0.09, 0.7 } do
  local bar = trilith.model { name = "bar", gravity = 0 }
  bar:material { name = "soft", density = 1000, E = 2e8, strain_limit = 0.1 }
  local rod = bar:beam { name = "b", material = "soft", floating = true, from = { 0, 0 }, to = { 1, 0 }, divisions = 1,
    section = trilith.rectangle_section { width = 1, depth = 0.5 }, from_support = "fixed",
    to_support = { y = "fixed", rotation = "fixed" } }
  bar:point_load { body = rod, at = { 1, 0 }, force = { share*2e8*0.5, 0 }, course = { smooth = 0.2 } }
  local report = bar:run { duration = 5, damping = 0.8, until_rest = { ratio = 1e-6, from = 0.3 } }
  if math.abs(share) < 0.1 then
    assert(report.ending == "rest" and bar.verdict.sound, report.reason)
    near((rod:point { 1, 0 }), 1 + share, 1e-4)
  else
    assert(report.ending == "diverged" and not bar.verdict.sound, report.ending)
    local words = ("element 1 of b was %s by"):format(share < 0 and "squeezed" or "stretched")
    assert(report.reason:find(words, 1, true) and report.reason:find("its solid is made for 10 %", 1, true),
      report.reason)
  end
  bar:close()
end

-- Along its axis a member is made for so much strain, of either sign.
for _, share in ipairs { -0.6, 0.09, 0.7 } do
  local bar = trilith.model { name = "bar", dim = 3, gravity = 0 }
  bar:material { name = "soft", density = 1000, E = 2e8, nu = 0.2, strain_limit = 0.1 }
  local f = bar:frame { name = "f", material = "soft", floating = true,
    joints = { A = { at = { 0, 0, 0 }, support = "fixed" }, B = { 0.6, 0, 0.8 } },
    members = { { name = "tie", from = "A", to = "B", divisions = 2,
      section = trilith.rectangle_section { width = 0.5, depth = 0.5 } } } }
  local force = share*2e8*0.25
  bar:point_load { body = f, at = { 0.6, 0, 0.8 }, force = { 0.6*force, 0, 0.8*force }, course = { smooth = 0.2 } }
  local report = bar:run { duration = 1, damping = 0.8, until_rest = { ratio = 1e-5, from = 0.3 } }
  if share == 0.09 then
    assert(bar.verdict.sound, report.reason)
  else
    assert(report.ending == "diverged", report.ending)
    assert(report.reason:find(" of tie of f was " .. (share < 0 and "squeezed" or "stretched"), 1, true), report.reason)
  end
  bar:close()
end

print "members are watched as they must be"
