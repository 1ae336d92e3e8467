-- A bonded block is thrown off at 1 to 10 m/s. Its bond dissipates its fracture energy, however large the kinetic
-- energy is: in the plane and in space, by each integrator, brittle and softening, rigid or with elements. The energy
-- balance gives its speed.
local trilith = require "trilith"

local area, mass, kn, ft, gf <const> = 0.01, 50, 1e12, 3e6, 100
local laws = {
  cohesive = trilith.cohesive { kn = kn, ks = 4e11, mu = 0.5, cohesion = 3e6, tension = ft, energy_tension = gf,
                                energy_shear = 150 },
  bonded = trilith.bonded { kn = kn, ks = 4e11, mu = 0.5, cohesion = 3e6, tension = ft },
}
local energy = { cohesive = gf*area, bonded = ft^2/(2*kn)*area }
local allowed <const> = 0.02 -- implicit steps miss up to 2 % of the fracture energy, explicit ones 1/64

local function throw(dim, law, form, integrator, speed)
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
  block("block", 0, { mass = mass, velocity = dim == 2 and { 0, -speed } or { 0, 0, -speed },
                      body = form == "mesh" and { mesh = dim == 2 and { 1, 1 } or { 1, 1, 1 } } or nil })
  m:run { duration = 4e-4*4/speed, integrator = integrator }
  local e, sound = m.energy, m.verdict.sound
  m:close()
  return e.contact_fracture/energy[law], 0.5*mass*speed^2 - e.kinetic - e.strain - e.contact_fracture, sound
end

local show = os.getenv "TRILITH_SHOW"
for _, dim in ipairs { 2, 3 } do
  for law in pairs(laws) do
    for _, form in ipairs { "rigid", "mesh" } do
      for _, integrator in ipairs { "explicit", "implicit", "auto" } do
        for _, speed in ipairs { 1, 2, 5, 7, 10 } do
          local share, rest, sound = throw(dim, law, form, integrator, speed)
          local where = ("%d dimensions, %s, %s, %s, %g m/s: %.4f of the energy, %.3g J left over, %s"):format(dim, law,
            form, integrator, speed, share, rest, sound and "sound" or "not sound")
          local good = sound and math.abs(share - 1) < allowed and math.abs(rest) < 0.02*energy[law]
          if show then print(good and "ok " or "BAD", where) else assert(good, where) end
        end
      end
    end
  end
end
