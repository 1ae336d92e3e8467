-- A square tower of dry blocks in running bond, shaken by the three components of El Centro 1940.
--
-- The defaults are 11,520 blocks of 0.5 m x 0.25 m x 0.25 m, 144 courses, 36 m high, 10 m wide; `courses=12 side=3` is
-- small. `trilith run tests/bench/tower3d.lua --profile` prints the time per step.
local trilith = require "trilith"
local p = trilith.params {
  courses = { 144, "courses" }, side = { 10, "length of a side", "m" }, seconds = { 0.2, "of shaking" },
  kn = { 1e9, "stiffness of joints", "Pa/m" }, pga = { 0.3*9.80665, "largest acceleration", "m/s2" },
}
local long, high = 0.5, 0.25
assert(p.side % long == 0, "side must be a multiple of 0.5 m")

local m = trilith.model { name = "tower", dim = 3 }
m:material { name = "stone", density = 2200 }
local beta = 2*0.05/math.sqrt(p.kn/(2200*high)) -- 5 % of critical for a block on its bed
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = p.kn, ks = 0.4*p.kn, mu = 0.7, beta = beta } }
m:block { name = "base", size = { p.side + 2, p.side + 2, 1 }, at = { -1, -1, -1 }, material = "stone",
  support = "fixed" }

-- A course is a ring of four rows: each begins behind the end of the one before. Odd courses leave out the other end of
-- each side, so that corners interlock and blocks overlap by half.
local count, last = 0, p.side - high
local function block(course, x0, y0, x1, y1)
  count = count + 1
  m:block { name = ("c%d.%d"):format(course, count), size = { x1 - x0, y1 - y0, high },
    at = { x0, y0, (course - 1)*high }, material = "stone" }
end
for course = 1, p.courses do
  -- Along a side from its corner: even courses from the corner to the last quarter metre, odd ones from the first
  -- quarter metre on.
  local from = course % 2 == 0 and 0 or high
  local a = from
  while a < from + last - 1e-9 do
    local b = math.min(a + long, from + last)
    block(course, a, 0, b, high)
    block(course, last, a, p.side, b)
    block(course, p.side - b, last, p.side - a, p.side)
    block(course, 0, p.side - b, high, p.side - a)
    a = b
  end
end

local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
local ew = trilith.motion "elcentro_1940_rest_ew.csv":scale_as(ns)
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(ns)
m:run { name = "settle", duration = 0.1, local_damping = 0.8 }
local report = { steps = 0 }
if p.seconds > 0 then report = m:shake { body = "base", x = ns, y = ew, z = up, duration = p.seconds } end
print(("%d bodies, %d contacts, %g s: %d steps, hash %s"):format(count, #m:contacts(), p.seconds, report.steps, m.hash))
