-- Builds a dry arch stone by stone on falsework, then removes the falsework from the crown down: the arch stands.
-- With key=false the falsework is removed before the key is placed, and the arch falls.
-- Results: docs/gallery/arch_staged.md.
local trilith = require "trilith"
local s = trilith.units "s"
local p = trilith.params {
  radius = { 4, unit = "m", "radius of the centre line of the ring" },
  thickness = { 0.5, unit = "m", "thickness of the ring" },
  voussoirs = { 15, "number of stones, odd" },
  mu = { 0.6, "friction of the joints" }, kn = { 5e9, unit = "Pa/m", "stiffness of a joint" },
  every = { 0.05, unit = "s", "time between the removals of two pieces of falsework" },
  key = { true, "false: the falsework is removed without the keystone" },
  out = { "out/arch_staged.h5", "results" } }
local R, t, n = p.radius, p.thickness, math.tointeger(p.voussoirs)
local half = 0.39*math.pi
local m = trilith.model { name = "an arch on falsework" }
m:material { name = "stone", density = 2400 }
m:material { name = "timber", density = 600 }
local beta = 2*0.1/math.sqrt(p.kn/(2400*t)) -- 10 % of critical for a stone on its bed
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = p.kn, ks = 0.5*p.kn, mu = p.mu, beta = beta } }

local parts = {}
for _, part in ipairs(trilith.build.arch { name = "arch", voussoirs = n, radius = R, thickness = t, half_angle = half,
  abutments = true }) do parts[part.name] = part end
local function stone(i) return parts["arch.v" .. i] end
m:add({ parts["arch.left"], parts["arch.right"] }, { material = "stone", fixed = { "abutments" } })
local lagging = {}
for i = 1, n do -- a piece of falsework under each stone, along its lower face
  local a, b = stone(i).outline[1], stone(i).outline[2]
  local low = (R - 0.5*t - 0.25)/(R - 0.5*t)
  lagging[i] = m:body { name = "lagging " .. i, groups = { "falsework" }, material = "timber", support = "fixed",
    outline = { { low*a[1], low*a[2] }, { low*b[1], low*b[2] }, b, a } }
end

local ring = m:add({ stone(1), stone(n) }, { material = "stone" })
m:results { file = p.out, frames = 0.02*s, energy = 0.02*s }
m:consolidate { rest = { ratio = 1e-4 } }
local middle = (n + 1)//2
local function rest(name)
  m:run { name = name, duration = 5*s, local_damping = 0.8, rest = { ratio = 1e-4, hold = 0.1 } }
end
for i = 2, middle - 1 do
  ring = ring + m:add({ stone(i), stone(n + 1 - i) }, { material = "stone" })
  rest(("stones %d and %d"):format(i, n + 1 - i))
end
if p.key then
  ring = ring + m:add({ stone(middle) }, { material = "stone" })
  rest "the key"
end
print(("%.2f s: %d stones on falsework, %.1f t"):format(m.time, #ring, 1e-3*ring.mass))

local crown = p.key and m:body("arch.v" .. middle) or m:body("arch.v" .. middle - 1)
local before, struck = crown.y, 0
local striking
striking = m:every(p.every, function() -- from the crown down, on both sides
  m:remove { lagging[middle - struck], struck > 0 and lagging[middle + struck] or nil }
  struck = struck + 1
  if struck == middle then m:off(striking) end
end)
local last = m:run { name = "struck", duration = 6*s, until_collapse = true,
  rest = { from = p.every*middle, ratio = 1e-3, speed = 1e-4 } }
if last.ending == "rest" then
  local joint = m:contacts { between = { crown, m:body("arch.v" .. middle - 1) } }[1]
  local thrust = math.abs(joint.force[1])/(ring.mass*9.80665)
  print(("%.2f s: the arch stands without falsework; the crown has settled by %.3f mm, thrust %.3f of the weight")
    :format(m.time, 1e3*(before - crown.y), thrust))
else
  local outcome = last.ending == "stopped" and "has collapsed" or "is not at rest"
  print(("%.2f s: the arch %s (%s)"):format(m.time, outcome, last.reason))
end
local e = m.energy
print(("energy removed with the falsework %.3g J, added with the stones %.3g J"):format(e.removed, e.added))
