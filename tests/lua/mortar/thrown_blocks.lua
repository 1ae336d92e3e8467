-- A bonded block is thrown off at 1 to 10 m/s, away from its joint or along it. It dissipates its fracture energy,
-- however large the kinetic energy is: in the plane and in space, by each integrator, brittle and softening, rigid or
-- with elements. The energy balance gives its speed.
local trilith = require "trilith"

local area, mass, kn, ft, gf <const> = 0.01, 50, 1e12, 3e6, 100
local laws = {
  cohesive = trilith.cohesive { kn = kn, ks = 4e11, mu = 0.5, cohesion = 3e6, tension = ft, energy_tension = gf,
                                energy_shear = 150 },
  bonded = trilith.bonded { kn = kn, ks = 4e11, mu = 0.5, cohesion = 3e6, tension = ft },
}
local energy = { pulled = { cohesive = gf*area, bonded = ft^2/(2*kn)*area },
                 sheared = { cohesive = 150*area, bonded = 3e6^2/(2*4e11)*area } }
local supports = { { y = "fixed", rotation = "fixed" },
                   { z = "fixed", rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" } }
local velocities = { pulled = { { 0, -1 }, { 0, 0, -1 } }, sheared = { { 1, 0 }, { 0.6, 0.8, 0 } } }
local allowed <const> = 0.02 -- implicit steps miss up to 2 % of the fracture energy, explicit ones 1/64

local function throw(direction, dim, law, form, integrator, speed)
  local m = trilith.model { name = "thrown", dim = dim, thickness = dim == 2 and 0.1 or nil, gravity = 0 }
  m:material { name = "stone", density = 2400, E = 3e10, nu = 0 }
  m:contact { between = { "*", "*" }, law = laws[law] }
  local function block(name, z, options)
    options.name, options.material, options.floating = name, "stone", true
    if dim == 2 then
      options.width, options.height, options.at = 0.1, 0.1, { 0, z }
    else
      options.size, options.at = { 0.1, 0.1, 0.1 }, { 0, 0, z }
    end
    return m:block(options)
  end
  block("top", 0.1, { support = "fixed" })
  local velocity = {}
  for i, v in ipairs(velocities[direction][dim - 1]) do velocity[i] = v*speed end
  -- Along the joint, only this motion is free: the centroid is not on the joint.
  block("block", 0, { mass = mass, velocity = velocity, support = direction == "sheared" and supports[dim - 1] or nil,
                      body = form == "mesh" and { mesh = dim == 2 and { 1, 1 } or { 1, 1, 1 } } or nil })
  m:run { duration = 4e-4*(direction == "sheared" and 10 or 4)/speed, integrator = integrator }
  local e, sound = m.energy, m.verdict.sound
  local lost = e.contact_fracture + e.contact_friction
  m:close()
  return lost/energy[direction][law], 0.5*mass*speed^2 - e.kinetic - e.strain - lost, sound
end

local show = os.getenv "TRILITH_SHOW"
local function check(direction, dim, law, form, integrator)
  for _, speed in ipairs { 1, 2, 5, 7, 10 } do
    local share, rest, sound = throw(direction, dim, law, form, integrator, speed)
    local where = ("%s in %d dimensions, %s, %s, %s, %g m/s: %.4f of the energy, %.3g J left, %s"):format(direction,
      dim, law, form, integrator, speed, share, rest, sound and "sound" or "not sound")
    local good = sound and math.abs(share - 1) < allowed and math.abs(rest) < 0.02*energy[direction][law]
    if show then print(good and "ok " or "BAD", where) else assert(good, where) end
  end
end

for _, dim in ipairs { 2, 3 } do
  for law in pairs(laws) do
    for _, integrator in ipairs { "explicit", "implicit", "auto" } do
      check("pulled", dim, law, "rigid", integrator)
      check("pulled", dim, law, "mesh", integrator)
      check("sheared", dim, law, "rigid", integrator)
    end
  end
end
