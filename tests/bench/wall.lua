-- The benchmark wall in the plane: units of 0.4 m x 0.2 m in running bond on a base that is shaken at 2 Hz and 0.5 g.
-- 24 courses of 18 are 444 units, 48 of 36 are 1,752, 192 of 145 are about 28,000.
--
-- `trilith run tests/bench/wall.lua --profile` prints the time per step.
local trilith = require "trilith"
local p = trilith.params {
  courses = { 24, "courses" }, columns = { 18, "whole units in a course" }, seconds = { 0.5, "of shaking" },
  body = { "rigid", "type of a unit: rigid, quad (one finite element), or mesh (2 by 2)" },
  step = { 0, "length of a step; 0: as long as is stable", "s" },
  safety = { 0.5, "share of the longest stable step" },
  scaled = { 0, "length of a step that masses are scaled for; 0: they are not", "s" },
}

local m = trilith.model { name = "wall in the plane", thickness = 1 }
m:material { name = "stone", density = 2000, E = 10e9, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 4e9, mu = 0.7, beta = 2e-5 } }

local long, high = 0.4, 0.2
local length = p.columns * long
m:block { name = "base", width = length + 2, height = 0.4, at = { -1, -0.4 }, material = "stone", support = "fixed" }
local kind = p.body == "mesh" and { mesh = { 2, 2 } } or p.body
for course = 1, p.courses do
  local half, x, n = course % 2 == 0, 0, 0
  while x < length - 1e-6 do
    local wide = half and (n == 0 or x > length - 0.75 * long) and long / 2 or long
    n = n + 1
    m:block {
      name = ("c%d.u%d"):format(course, n), width = wide, height = high, at = { x, (course - 1) * high },
      material = "stone", body = kind,
    }
    x = (half and (n - 0.5) or n) * long
  end
end

local step = p.step > 0 and p.step or nil
local safety = step == nil and p.safety or nil
local scaling = p.scaled > 0 and { step = p.scaled } or nil
m:run {
  name = "settle", duration = p.seconds / 5, dt = step, local_damping = 0.8, safety = safety, mass_scaling = scaling,
}
local samples = {}
for i = 0, 2000 do samples[i + 1] = 0.5 * 9.81 * math.sin(4 * math.pi * 0.005 * i) end
local motion = trilith.motion { acceleration = samples, dt = 0.005 }
local report = m:shake {
  body = "base", x = motion, duration = p.seconds, dt = step, safety = safety, mass_scaling = scaling,
}
print(("%d units, %d contacts, %d steps, hash %s"):format(#m:bodies() - 1, #m:contacts(), report.steps, m.hash))
