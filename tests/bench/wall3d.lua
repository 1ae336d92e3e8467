-- The benchmark wall in space: units of 0.4 m x 0.2 m x 0.2 m in running bond on a base that is shaken.
--
-- `trilith run tests/bench/wall3d.lua --profile` prints the time per step; 24 courses are 444 units; `courses=48
-- columns=36` are 1,752. `body=mesh step=0 scaled=5e-5` uses meshed units with longer steps by mass scaling.
local trilith = require "trilith"
local p = trilith.params {
  courses = { 24, "courses" }, columns = { 18, "whole units in a course" }, seconds = { 0.2, "of shaking" },
  body = { "rigid", "type of a unit: rigid, brick (one finite element), or mesh (2 by 2 by 2)" },
  step = { 1e-4, "length of a step; 0: as long as is stable", "s" },
  scaled = { 0, "length of a step by mass scaling; 0: none", "s" },
}

local m = trilith.model { name = "wall in space", dim = 3 }
m:material { name = "stone", density = 2000, E = 10e9, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 4e9, mu = 0.7, beta = 2e-5 } }

local long, high, deep = 0.4, 0.2, 0.2
local length = p.columns * long
local kind = p.body == "mesh" and { mesh = { 2, 2, 2 } } or p.body
m:block { name = "base", size = { length, deep, 0.4 }, at = { 0, 0, -0.4 }, material = "stone", support = "fixed" }
for course = 1, p.courses do
  local half, x, n = course % 2 == 0, 0, 0
  while x < length - 1e-6 do
    local wide = half and (n == 0 or x > length - 0.75 * long) and long / 2 or long
    n = n + 1
    m:block {
      name = ("c%d.u%d"):format(course, n), size = { wide, deep, high }, at = { x, 0, (course - 1) * high },
      material = "stone", body = kind,
    }
    x = (half and (n - 0.5) or n) * long
  end
end

local step, scaling = p.step > 0 and p.step or nil, p.scaled > 0 and { step = p.scaled } or nil
m:run { name = "settle", duration = 0.05, dt = step, local_damping = 0.8, mass_scaling = scaling }
local samples = {}
for i = 0, 400 do samples[i + 1] = 0.5 * 9.81 * math.sin(4 * math.pi * 0.005 * i) end
local motion = trilith.motion { acceleration = samples, dt = 0.005 }
local report = m:shake {
  body = "base", x = motion, y = motion, duration = p.seconds, dt = step, mass_scaling = scaling,
}
print(("%d contacts, %d steps, hash %s"):format(#m:contacts(), report.steps, m.hash))
