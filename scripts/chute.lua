-- Grains behind a gate at the head of a chute: the gate opens, the grains slide down and fill a bin. Some are
-- spheres, the others clumps of three spheres. Results: docs/gallery/chute.md.
local trilith = require "trilith"
local deg, s = trilith.units "deg", trilith.units "s"
local p = trilith.params {
  count = { 1200, "number of grains" }, least = { 0.011, unit = "m", "smallest radius" },
  most = { 0.016, unit = "m", "largest radius" },
  clumps = { 0.3, "share of clumps of three spheres" },
  angle = { 30*deg, unit = "rad", "slope of the chute" }, length = { 2, unit = "m", "length of the chute" },
  width = { 0.4, unit = "m", "width of chute and bin" }, mu = { 0.4, "friction coefficient" },
  kn = { 1.5e9, unit = "Pa/m", "contact stiffness" }, beta = { 1.5e-4, unit = "s", "contact damping" },
  settle = { 0.6, unit = "s", "time before the gate opens" }, flow = { 2.5, unit = "s", "time after that" },
  out = { "out/chute.h5", "results" } }
local w, t, wall = p.width, 0.04, 0.35
local slope, run = trilith.math.tan(p.angle), p.length*trilith.math.cos(p.angle)
local lip = 0.35 -- height of the lower end over the floor of the bin
local function top(x) return lip + (run - x)*slope end

local m = trilith.model { name = "chute", dim = 3, impact_speed = 10 }
m:material { name = "grain", density = 2600 }
m:material { name = "steel", density = 7800 }
m:contact { between = { "*", "*" },
  law = trilith.frictional { kn = p.kn, ks = 0.5*p.kn, mu = p.mu, beta = p.beta } }
local function plate(name, outline, from, depth)
  m:extrusion { name = name, outline = outline, from = from, depth = depth, material = "steel", support = "fixed" }
end
local function band(x0, x1, below, above)
  return { { x0, top(x0) - below }, { x1, top(x1) - below }, { x1, top(x1) + above }, { x0, top(x0) + above } }
end
plate("chute floor", band(0, run, t, 0), 0, w)
plate("chute left", band(0, run, t, wall), -t, t)
plate("chute right", band(0, run, t, wall), w, t)
local high = top(0) + 4*w
plate("head", { { -t, top(0) - t }, { 0, top(0) - t }, { 0, high }, { -t, high } }, -t, w + 2*t)
local gate_x, tall = 0.6, 0.6
plate("gate", { { gate_x, top(gate_x) }, { gate_x + t, top(gate_x + t) }, { gate_x + t, top(gate_x) + tall },
  { gate_x, top(gate_x) + tall } }, 0, w)
-- Higher walls at the head of the chute.
for _, side in ipairs { { "hopper left", -t }, { "hopper right", w } } do
  plate(side[1], { { 0, top(0) + wall }, { gate_x, top(gate_x) + wall }, { gate_x, high }, { 0, high } }, side[2], t)
end
local far, rim = run + 1.2, 0.3
plate("bin floor", { { run - 0.3, -t }, { far, -t }, { far, 0 }, { run - 0.3, 0 } }, -t, w + 2*t)
plate("bin end", { { far, -t }, { far + t, -t }, { far + t, 2*rim }, { far, 2*rim } }, -t, w + 2*t)
plate("bin back", { { run - 0.3 - t, -t }, { run - 0.3, -t }, { run - 0.3, rim - 0.1 },
  { run - 0.3 - t, rim - 0.1 } }, -t, w + 2*t)
plate("bin left", { { run - 0.3, 0 }, { far, 0 }, { far, rim - 0.1 }, { run - 0.3, rim - 0.1 } }, -t, t)
plate("bin right", { { run - 0.3, 0 }, { far, 0 }, { far, rim - 0.1 }, { run - 0.3, rim - 0.1 } }, w, t)

local stone = { { at = { 0, 0, 0 }, radius = 0.6 }, { at = { 0.5, 0, 0 }, radius = 0.5 },
  { at = { 0, 0.45, 0.1 }, radius = 0.45 } }
local grains = m:pour { name = "grains", low = { 0, 0, top(0) + 0.001 }, high = { gate_x, w, top(0) + 400 },
  count = p.count, radius = { p.least, p.most }, clump = p.clumps > 0 and stone or nil, share = p.clumps,
  material = "grain" }
print(("%d grains, %.1f kg"):format(#grains, grains.mass))

m:results { file = p.out, frames = 0.05*s, energy = 0.02*s, histories = 0.02*s }
local function beyond()
  local count = 0
  for _, g in ipairs(grains) do
    if g.x > run then count = count + 1 end
  end
  return count
end
m:history { name = "past the lip", of = beyond, unit = "1", doc = "grains that have left the chute" }
m:run { name = "settling", duration = p.settle }
local begun, counts = m.time, {}
m:drive { body = "gate", z = trilith.ramp { by = tall, duration = 0.4 } }
m:every(0.1, function() counts[#counts + 1] = { m.time - begun, beyond() } end)
m:run { name = "flow", duration = p.flow }

local before = { 0, 0 }
local most, at = 0, 0
for _, now in ipairs(counts) do
  local rate = (now[2] - before[2])/(now[1] - before[1])
  if rate > most then most, at = rate, now[1] end
  before = now
end
local first, tenth, nine
for _, now in ipairs(counts) do
  if not first and now[2] > 0 then first = now[1] end
  if not tenth and now[2] >= 0.1*#grains then tenth = now[1] end
  if not nine and now[2] >= 0.9*#grains then nine = now[1] end
end
local function time(at_time) return at_time and ("%.1f s"):format(at_time) or "-" end
print(("first grain past the lip after %s, a tenth after %s, nine tenths after %s"):format(time(first), time(tenth),
  time(nine)))
print(("largest flow %.0f grains/s, %.2f kg/s, after %.1f s"):format(most, most*grains.mass/#grains, at))
-- The surface of the heap: the highest grain in each twelfth of the bin.
local heap, n, reach = {}, 12, 0
for _, g in ipairs(grains) do
  if g.x > run - 0.3 and g.z < lip then
    local k = math.ceil((g.x - run + 0.3)/(far - run + 0.3)*n)
    heap[k] = math.max(heap[k] or 0, g.z)
    reach = math.max(reach, g.x - run)
  end
end
for k = 1, n do
  local x = (k - 0.5)*(far - run + 0.3)/n - 0.3
  if heap[k] then print(("x = %.2f m from the lip: grains up to %.3f m"):format(x, heap[k])) end
end
print(("%d grains in the bin, the farthest %.2f m from the lip"):format(beyond(), reach))
