-- Every kind of stage and of change between stages, in the plane or in space, one after the other.
local trilith = require "trilith"
local p = trilith.params { out = { "out/all_stages.h5", "results" }, dim = { 2, "dimensions" },
  duration = { 0.6, unit = "s", "of each stage in time" } }
local m = trilith.model { name = "all stages", dim = p.dim }
m:material { name = "stone", density = 2400, E = 2e9, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 2e9, ks = 1e9, mu = 0.6, beta = 1e-5 } }
local function block(name, x, z, width, height, more)
  local keys = { name = name, material = "stone" }
  for key, value in pairs(more or {}) do keys[key] = value end
  if p.dim == 2 then
    keys.width, keys.height, keys.at = width, height, { x, z }
  else
    keys.size, keys.at = { width, 0.4, height }, { x, -0.2, z }
  end
  return m:block(keys)
end
local function vector(x, z) return p.dim == 2 and { x, z } or { x, 0, z } end
block("base", -2, -0.3, 5, 0.3, { support = "fixed" })
for i = 1, 4 do block("b" .. i, 0, 0.25*(i - 1), 0.5, 0.25) end
local deformable = p.dim == 2 and { mesh = { 3, 2 } } or { mesh = { 3, 1, 2 } }
block("mesh", 1.2, 0, 0.9, 0.4, { body = deformable })
local prop = block("prop", -1, 0, 0.2, 0.6)
local top = m:body "b4"

m:results { file = p.out, frames = 0.02, histories = 0.01, energy = 0.02 }
m:history { name = "top", body = top, what = "x" }
m:heat { body = "mesh", conductivity = 2, heat_capacity = 900, expansion = 1e-5, temperature = 10 }
m:heat_exchange { body = "mesh", side = "top", exchange = 15, temperature = { { 0, 10 }, { 3600, 30 } } }
m:consolidate { integrator = "static" }
local wave = {}
for i = 1, 200 do wave[i] = 0.4*trilith.math.sin(0.3*i) end
wave[201] = 0
m:drive { body = "base", x = trilith.motion { acceleration = wave, dt = 0.05, allow_drift = true } }
m:point_load { name = "wind", body = top, force = vector(30, 0), load_curve = { { 0, 0 }, { 1, 1 }, { 9, -1 } } }
m:run { name = "explicit", duration = p.duration }
m:process { name = "warm", duration = 3600, step = 600 }
m:run { name = "implicit", duration = p.duration, integrator = "implicit" }
local path = m:pushover { name = "path", body = top, control = "arc", displacement = 5e-4, samples = 50 }
m:release { load = "path", fade = 0.1 }
m:run { name = "after the path", duration = p.duration }
m:tilt { rate = 0.02, by = 0.01 }
m:remove(prop)
m:consolidate { name = "rest", duration = 2, or_go_on = true, mass_scaling = { step = 2e-4 } }
m:put_back(prop)
m:fix("mesh", p.dim == 2 and "xyr" or "xyz")
m:run { name = "auto", duration = p.duration, integrator = "auto" }
m:free "mesh"
m:modes { count = 2 }
local push = m:pushover { name = "push", body = top, displacement = 2e-3 }
m:release { push = "push", fade = 0.1 }
m:run { name = "last", duration = p.duration }
print("hash " .. m.hash, path.force, push.force)
