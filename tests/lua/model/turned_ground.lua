-- The ground rotates about its own axes in space: bodies on it follow, and topple as on a table.
local trilith = require "trilith"
local deg = trilith.units "deg"

local function model(dim)
  local m = trilith.model { name = "table", dim = dim, thickness = dim == 2 and 1 or nil }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  if dim == 2 then
    m:block { name = "ground", width = 2, height = 0.4, at = { -1, -0.4 }, material = "stone", support = "fixed" }
    m:block { name = "post", width = 0.2, height = 0.8, at = { -0.1, 0 }, material = "stone" }
  else
    m:block { name = "ground", size = { 2, 2, 0.4 }, at = { -1, -1, -0.4 }, material = "stone", support = "fixed" }
    m:block { name = "post", size = { 0.2, 1, 0.8 }, at = { -0.1, -0.5, 0 }, material = "stone" }
  end
  m:consolidate { rest = { ratio = 1e-5 } }
  return m
end

-- A smooth rotation by `angle` in two seconds.
local function turning(angle)
  local samples = {}
  for k = 0, 200 do samples[k + 1] = angle*0.5*(math.pi/2)^2*math.cos(math.pi/2*k*0.01) end
  return trilith.motion { acceleration = samples, dt = 0.01 }
end

local function at_end(angle)
  local _, _, displacement = turning(angle):at(2)
  return displacement
end

-- About y as about the plane's axis, with the opposite sign: the post rocks in the same way.
local flat, deep = model(2), model(3)
flat:shake { body = "ground", rotation = turning(4*deg), duration = 2 }
deep:shake { body = "ground", rotation_y = turning(-4*deg), duration = 2 }
local wanted = at_end(4*deg)
assert(math.abs(flat:body "ground".rotation - wanted) < 1e-9)
assert(math.abs(deep:body "ground".rotation_y + wanted) < 1e-9)
assert(math.abs(deep:body "ground".rotation_x) + math.abs(deep:body "ground".rotation_z) < 1e-12)
assert(math.abs(deep:body "post".rotation_y + flat:body "post".rotation) < 2e-4)
assert(math.abs(deep:body "post".ux - flat:body "post".ux) < 2e-3*math.abs(wanted))

-- About z a body on the ground follows the rotation; beyond thickness over height it topples.
local round = model(3)
round:shake { body = "ground", rotation_z = turning(20*deg), duration = 2 }
assert(math.abs(round:body "post".rotation_z - at_end(20*deg)) < 1e-3)
local over = model(3)
over:shake { body = "ground", rotation_y = turning(20*deg), duration = 2 }
over:run { duration = 1.5 }
assert(over:body "post".uz < -0.3, "a post of .2 x .8 m does not stand on a slope of more than 14 degrees")

-- Implicit steps follow it too.
local long = model(3)
long:shake { body = "ground", rotation_x = turning(1*deg), duration = 2, integrator = "implicit", dt = 0.01 }
assert(math.abs(long:body "ground".rotation_x - at_end(1*deg)) < 1e-9)

local ok, message = pcall(deep.shake, deep, { body = "ground", rotation = turning(1*deg) })
assert(not ok and tostring(message):find "rotation", message)
