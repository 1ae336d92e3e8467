-- A given explicit step that skips the work of a bond is reported with the missing work, and the run is not sound. A
-- step that is short enough is not reported, and the bond takes its energy.
local trilith = require "trilith"

local kn, ks, ft, c, gf, gs <const> = 1e12, 4e11, 3e6, 3e6, 100, 150
local laws = {
  cohesive = trilith.cohesive { kn = kn, ks = ks, mu = 0.5, cohesion = c, tension = ft, energy_tension = gf,
                                energy_shear = gs },
  bonded = trilith.bonded { kn = kn, ks = ks, mu = 0.5, cohesion = c, tension = ft },
}

-- Last displacement and fracture energy by area.
local function curve(law, way)
  local strength, stiffness, energy = ft, kn, gf
  if way == "shear" then strength, stiffness, energy = c, ks, gs end
  local peak = strength/stiffness
  if law == "bonded" then return peak, strength*peak/2 end
  return 2*energy/strength, energy
end

-- A block of 5 kg below a fixed one, or between two of them, passes the last displacement in `steps` steps.
local function pull(dim, law, way, form, dt, steps)
  local m = trilith.model { name = "pull", dim = dim, thickness = dim == 2 and 0.1 or nil, gravity = 0 }
  m:material { name = "stone", density = 2400, E = 3e10, nu = 0 }
  m:contact { between = { "*", "*" }, law = laws[law] }
  local area = way == "shear" and 0.02 or 0.01
  local last, energy = curve(law, way)
  local speed = last/(steps*dt)
  local function block(name, x, z, options)
    options.name, options.material = name, "stone"
    if dim == 2 then
      options.width, options.height, options.at = 0.1, 0.1, { x, z }
    else
      options.size, options.at = { 0.1, 0.1, 0.1 }, { x, 0, z }
    end
    return m:block(options)
  end
  if way == "shear" then
    block("left", -0.1, 0, { support = "fixed" })
    block("right", 0.1, 0, { support = "fixed" })
  else
    block("top", 0, 0.1, { support = "fixed" })
  end
  local body = form == "mesh" and { mesh = dim == 2 and { 1, 1 } or { 1, 1, 1 } } or form
  local b = block("block", 0, 0, { mass = 5, velocity = dim == 2 and { 0, -speed } or { 0, 0, -speed }, floating = true,
                                   body = body })
  local told, missing = 0, 0
  m:on("bond.skipped", function(e)
    told, missing = told + 1, missing + e.value
    assert(e.bodies[1] and e.bodies[2] and e.text:find "leave dt out", e.text)
  end)
  m:run { duration = 8*last/speed, dt = dt }
  -- A step that skips a bond in shear books its fracture against friction. Only the sum is work of the body.
  local spent = m.energy.contact_fracture + m.energy.contact_friction
  local out = { told = told, missing = missing/area, energy = energy, spent = spent/area,
                sound = m.verdict.sound, text = m.verdict.text, speed = dim == 2 and b.vy or b.vz }
  m:close()
  return out
end

local show = os.getenv "TRILITH_SHOW"
for _, dim in ipairs { 2, 3 } do
  for law in pairs(laws) do
    for _, way in ipairs { "tension", "shear" } do
      for _, form in ipairs { "rigid", dim == 2 and "quad" or "brick", "mesh" } do
        for _, steps in ipairs { 0.6, 100 } do
          local dt = form == "rigid" and 1e-5 or 4e-6
          if steps > 1 then dt = dt/100 end
          local r = pull(dim, law, way, form, dt, steps)
          local where = ("%d dimensions, %s, %s, %s, last displacement in %g steps"):format(dim, law, way, form, steps)
          if show then print(where, r.told, r.missing/r.energy, r.spent/r.energy, r.text) end
          if not show then
            assert((r.told > 0) == (steps < 1) and r.sound == (steps > 1), where .. ": " .. r.text)
            if steps < 1 then assert(r.text:find "skipped" and r.text:find "block", r.text) end
            local sum = (r.spent + r.missing)/r.energy
            assert(math.abs(sum - 1) < (steps > 1 and 0.02 or 0.1), ("%s: %.4g"):format(where, sum))
          end
        end
      end
    end
  end
end

print "every assertion holds"
