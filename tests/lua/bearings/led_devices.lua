-- A device between two bodies with prescribed cyclic motion: an elastic device returns all energy it takes, so the net
-- input over a cycle is almost zero. The step error relative to this small number does not make the verdict unsound.
local trilith = require "trilith"

local reach, period, stiffness, slack = 0.04, 0.8, 4e6, 0.01
local w = 2*math.pi/period

local function to_and_fro(cycles)
  local acceleration = {}
  for i = 0, 400*cycles do acceleration[i + 1] = -reach*w*w*math.sin(2*math.pi*i/400) end
  return trilith.motion { acceleration = acceleration, dt = period/400, v0 = reach*w, allow_drift = true }
end

-- Energy put in and stored after `cycles` of this motion, in the plane or along an azimuth in space.
local function led(dim, azimuth, integrator, cycles)
  local m = trilith.model { name = "device", dim = dim, gravity = 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  local plane = dim == 2
  for i, name in ipairs { "base", "head" } do
    local z = 1.2*(i - 1)
    local block = { name = name, material = "steel", support = "fixed", at = plane and { 0, z } or { 0, 0, z } }
    if plane then block.width, block.height = 1, 1 else block.size = { 1, 1, 1 } end
    m:block(block)
  end
  m:bearing { name = "cable", between = { "base", "head" }, at = plane and { 0.5, 1.1 } or { 0.5, 0.5, 1.1 },
    angle = azimuth, along = trilith.cable { stiffness = stiffness, slack = slack, side = -1 } }
  local motion = to_and_fro(cycles)
  local report = m:shake { body = "head", x = motion:scale { factor = math.cos(azimuth) },
    y = azimuth ~= 0 and motion:scale { factor = math.sin(azimuth) } or nil, integrator = integrator,
    dt = integrator == "implicit" and 1e-3 or 1e-4 }
  assert(report.ending == "time" and m.verdict.sound, m.verdict.text)
  local put_in, held = m.energy.support, m.energy.bearing_elastic
  m:close()
  return put_in, held
end

local most = 0.5*stiffness*(reach - slack)^2
for _, case in ipairs { { 2, 0, "implicit" }, { 2, 0, "explicit" }, { 3, 0.6, "implicit" }, { 3, -2.5, "explicit" } } do
  local dim, azimuth, integrator = table.unpack(case)
  local put_in, held = led(dim, azimuth, integrator, 2)
  assert(math.abs(put_in) < 1e-4*most and held == 0, ("%g J put in, %g J held"):format(put_in, held))
  put_in, held = led(dim, azimuth, integrator, 0.75) -- at its full reach
  local off = math.max(math.abs(held/most - 1), math.abs(put_in/most - 1))
  assert(off < 2e-3, ("%g J put in and %g J held for %g J"):format(put_in, held, most))
end
