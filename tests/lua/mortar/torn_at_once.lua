-- A motion that begins with a speed tears a bond from its support. The bond spends its energy by all integrators, and
-- the block keeps the speed that the energy leaves. Below that energy the bond holds.
local trilith = require "trilith"
local near = dofile "near_expected.lua"

local mass, energy <const> = 50, 1 -- [kg], [J]: 100 J/m2 on 0.01 m2

local function tear(dim, speed, how, form, way)
  local m = trilith.model { name = "tear", dim = dim, thickness = dim == 2 and 0.1 or nil, gravity = 0 }
  m:material { name = "stone", density = 2400, E = 3e10, nu = 0 }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = 1e12, ks = 4e11, mu = 0.5, cohesion = 1e8,
    tension = 3e6, energy_tension = 100, energy_shear = 1e6 } }
  local function block(name, z, options)
    options.name, options.material = name, "stone"
    if dim == 2 then
      options.width, options.height, options.at = 0.1, 0.1, { 0, z }
    else
      options.size, options.at = { 0.1, 0.1, 0.1 }, { 0, 0, z }
    end
    return m:block(options)
  end
  local top = block("top", 0, { support = "fixed" })
  local b = block("b", -0.1, { mass = mass, body = form, floating = true })
  local motion, along = trilith.motion { velocity = speed, duration = 0.05 }, dim == 2 and "y" or "z"
  if way == "drive" then
    m:drive { body = top, [along] = motion }
    m:run { integrator = how, duration = 0.01 }
  else
    m:shake { body = top, [along] = motion, integrator = how, duration = 0.01 }
  end
  local out = { speed = dim == 2 and b.vy or b.vz, spent = m.energy.contact_fracture, sound = m.verdict.sound }
  m:close()
  return out
end

for _, dim in ipairs { 2, 3 } do
  for _, form in ipairs { "rigid", dim == 2 and "quad" or "brick" } do
    for _, how in ipairs { "explicit", "implicit", "auto" } do
      for _, way in ipairs { "drive", "shake" } do
        local where = ("dim %d, %s, %s, %s"):format(dim, form, how, way)
        local held = tear(dim, 0.1, how, form, way) -- 0.25 J of 1 J
        assert(held.sound and held.spent < 0.5*energy, where .. (": spent %g J"):format(held.spent))
        for _, speed in ipairs { 0.25, 1, 5 } do
          local r = tear(dim, speed, how, form, way)
          local at = where .. (", %g m/s"):format(speed)
          assert(r.sound, at)
          near(at .. ": energy", r.spent, energy, 0.01)
          if form == "rigid" then near(at .. ": speed", r.speed, speed - math.sqrt(speed^2 - 2*energy/mass), 0.01) end
        end
      end
    end
  end
end
