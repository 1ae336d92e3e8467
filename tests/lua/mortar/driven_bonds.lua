-- A support whose prescribed velocity jumps tears off a bonded block. The bond takes its fracture energy: from motions
-- that begin or end at a speed, that replace each other, and from a moving support that is fixed.
local trilith = require "trilith"

local area, mass, kn, ft, gf <const> = 0.01, 50, 1e12, 3e6, 100
local laws = {
  cohesive = trilith.cohesive { kn = kn, ks = 4e11, mu = 0.5, cohesion = 3e6, tension = ft, energy_tension = gf,
                                energy_shear = 150 },
  bonded = trilith.bonded { kn = kn, ks = 4e11, mu = 0.5, cohesion = 3e6, tension = ft },
}
local energy = { cohesive = gf*area, bonded = ft^2/(2*kn)*area }

--- A block below a support that moves up or down as `case` says; the fracture energy of the run [J].
local function tear(dim, law, case, speed, form, integrator)
  local m = trilith.model { name = "tear", dim = dim, thickness = dim == 2 and 0.1 or nil, gravity = 0 }
  m:material { name = "stone", density = 2400, E = 3e10, nu = 0 }
  m:contact { between = { "*", "*" }, law = laws[law] }
  local up = dim == 2 and "y" or "z"
  local function block(name, z, options)
    options.name, options.material, options.floating = name, "stone", true
    if dim == 2 then
      options.width, options.height, options.at = 0.1, 0.1, { 0, z }
    else
      options.size, options.at = { 0.1, 0.1, 0.1 }, { 0, 0, z }
    end
    return m:block(options)
  end
  local body = form == "mesh" and { mesh = dim == 2 and { 1, 1 } or { 1, 1, 1 } } or nil
  local rides = case == "ends" or case == "fixed" or case == "reversed"  -- block and support move together at first
  local velocity = rides and -speed or 0
  block("top", 0.1, { support = "fixed", body = form == "mesh support" and { mesh = dim == 2 and { 1, 1 }
    or { 1, 1, 1 } } or nil })
  block("block", 0, { mass = mass, body = body,
                      velocity = dim == 2 and { 0, velocity } or { 0, 0, velocity } })
  local function steady(v, duration) return trilith.motion { velocity = v, duration = duration } end
  local began = 0
  if case == "begins" then
    m:drive { body = "top", [up] = steady(speed, 1) }
  elseif case == "begins late" then
    began = 1.03e-3
    m:drive { body = "top", [up] = steady(speed, 1):delay(began) }
  elseif case == "samples" then
    local motion = trilith.motion { acceleration = { 0, 0, 1e-3, 0 }, dt = 0.5, v0 = speed, allow_drift = true }
    m:drive { body = "top", [up] = motion }
  elseif case == "ends" then
    began = 1.234e-3
    m:drive { body = "top", [up] = steady(-speed, began) }
  elseif rides then
    m:drive { body = "top", [up] = steady(-speed, 1) }
    m:run { duration = 1e-3, integrator = integrator }
    if case == "fixed" then m:fix "top" else m:drive { body = "top", [up] = steady(speed, 1) } end
  end
  m:run { duration = began + 4e-4*4/speed, integrator = integrator }
  local spent, residual, sound = m.energy.contact_fracture, m.residual, m.verdict.sound
  m:close()
  return spent/energy[law], residual/energy[law], sound
end

local show = os.getenv "TRILITH_SHOW"
for _, dim in ipairs { 2, 3 } do
  for law in pairs(laws) do
    for _, integrator in ipairs { "explicit", "implicit", "auto" } do
      for _, case in ipairs { "begins", "begins late", "samples", "ends", "reversed", "fixed" } do
        for _, form in ipairs { "rigid", "mesh", "mesh support" } do
          for _, speed in ipairs { 0.5, 4 } do
            local share, residual, sound = tear(dim, law, case, speed, form, integrator)
            local where = ("%d dimensions, %s, %s, %s, %s, %g m/s: %.4f of the energy, residual %.3g, %s"):format(dim,
              law, integrator, case, form, speed, share, residual, sound and "sound" or "not sound")
            local good = sound and math.abs(share - 1) < 0.02
            if show then print(good and "ok " or "BAD", where) else assert(good, where) end
          end
        end
      end
    end
  end
end
