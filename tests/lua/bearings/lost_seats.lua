-- A seat is lost at the step at which its length reaches zero, not before: spans that drift off with constant velocity.
local trilith = require "trilith"
local speed, length = 2, 0.05

for dim = 2, 3 do
  local m = trilith.model { name = "drift", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 2500 }
  m:contact { between = { "*", "*" }, law = "none" }
  local function block(o)
    o.material = "stone"
    if dim == 2 then o.width, o.height = 1, 1 else o.size = { 1, 1, 1 } end
    return m:block(o)
  end
  local function at(x, z) return dim == 2 and { x, z } or { x, 0, z } end
  block { name = "support", at = at(-1, -1), support = "fixed" }
  block { name = "span", at = at(-length, 0.01), floating = true,
          velocity = dim == 2 and { speed, 0 } or { speed, 0, 0 } }
  local seat = m:seat { name = "seat", body = "span", support = "support", at_end = at(-length, 0.01),
                        edge = at(0, 0), inward = dim == 2 and { -1, 0 } or { -1, 0, 0 } }
  local lost
  m:on("seat.lost", function(e)
    assert(not lost, "lost twice")
    lost = { time = e.time, length = seat.length + speed*(m.time - e.time) } -- the handler is called a step later
  end)
  local report = m:run { duration = 2*length/speed, dt = 1e-4 }
  assert(lost and lost.length <= 0 and lost.length >= -1.01*speed*report.longest_dt, lost and lost.length)
  assert(math.abs(lost.time - length/speed) <= 1.01*report.longest_dt, lost.time)
  m:close()
end
