-- The wall of the benchmarks in space: units of 0.4 x 0.2 x 0.2 m in running bond on a base that is shaken.
--
-- `trilith run tests/bench/wall3d.lua --profile` says what a step costs; 24 courses are 444 units; `courses=48
-- columns=36` 1,752.
local trilith = require "trilith"
local p = trilith.params {
  courses = { 24, "courses" }, columns = { 18, "whole units in a course" }, seconds = { 0.2, "of shaking" },
  step = { 1e-4, "length of a step", "s" },
}

local m = trilith.model { name = "wall in space", dim = 3 }
m:material { name = "stone", density = 2000 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 4e9, mu = 0.7, beta = 2e-5 } }

local long, high, deep = 0.4, 0.2, 0.2
local length = p.columns * long
m:block { name = "base", size = { length, deep, 0.4 }, at = { 0, 0, -0.4 }, material = "stone", support = "fixed" }
for course = 1, p.courses do
  local half, x, n = course % 2 == 0, 0, 0
  while x < length - 1e-6 do
    local wide = half and (n == 0 or x > length - 0.75 * long) and long / 2 or long
    n = n + 1
    m:block {
      name = ("c%d.u%d"):format(course, n), size = { wide, deep, high }, at = { x, 0, (course - 1) * high },
      material = "stone",
    }
    x = (half and (n - 0.5) or n) * long
  end
end

m:run { name = "settle", duration = 0.05, dt = p.step, damping = 0.8 }
local samples = {}
for i = 0, 400 do samples[i + 1] = 0.5 * 9.81 * math.sin(4 * math.pi * 0.005 * i) end
local motion = trilith.motion { acceleration = samples, dt = 0.005 }
local report = m:shake { body = "base", x = motion, y = motion, duration = p.seconds, dt = p.step }
print(("%d contacts, %d steps, hash %s"):format(#m:contacts(), report.steps, m.hash))
