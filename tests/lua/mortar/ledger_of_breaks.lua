-- A breaking bond dissipates its stored energy and the work of its last force over half a step. A block of 2 t at 1 m/s
-- tears itself off in tension or shear, in the plane and in space, by explicit and implicit steps.
local trilith = require "trilith"

local laws = {
  bonded = { kn = 1e8, ks = 5e7, mu = 0.5, tension = 1e5, cohesion = 2e5, beta = 1e-4 },
  cohesive = { kn = 1e8, ks = 5e7, mu = 0.5, tension = 1e5, cohesion = 2e5, beta = 1e-4, energy_tension = 200,
               energy_shear = 800 },
}

-- The block's energy is 1 kJ. Returns the largest ledger residual as a share of it, from the second step on.
local function tear(dim, law, integrator, way)
  local m = trilith.model { name = "tear", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith[law](laws[law]) }
  local across = way == "shear"
  if dim == 2 then
    m:block { name = "base", width = 1, height = 1, at = { 0, 0 }, material = "stone", support = "fixed" }
    m:block { name = "block", width = 1, height = 1, at = { 1, 0 }, material = "stone", floating = true,
              velocity = across and { 0, 1 } or { 1, 0 } }
  else
    m:block { name = "base", size = { 1, 1, 1 }, at = { 0, 0, 0 }, material = "stone", support = "fixed" }
    m:block { name = "block", size = { 1, 1, 1 }, at = { 1, 0, 0 }, material = "stone", floating = true,
              velocity = across and { 0, 1, 0 } or { 1, 0, 0 } }
  end
  local broken, steps, begun, out = false, 0, nil, 0
  m:on("bond.broken", function() broken = true end)
  m:on_step(function()
    steps = steps + 1
    if steps < 2 then return end
    begun = begun or m.energy.residual
    out = math.max(out, math.abs(m.energy.residual - begun))
  end)
  m:run { duration = 0.02, dt = 4e-4, integrator = integrator }
  assert(broken, "the bond has not broken")
  m:close()
  return out/1e3
end

for _, dim in ipairs { 2, 3 } do
  for _, integrator in ipairs { "explicit", "implicit" } do
    for law in pairs(laws) do
      local out = tear(dim, law, integrator, "tension")
      assert(out < 1e-9, ("%s, tension, %d dimensions, %s: out by %.3g"):format(law, dim, integrator, out))
    end
    -- A block under shear also rotates, and its faces separate from one end on.
    local out = tear(dim, "bonded", integrator, "shear")
    assert(out < 5e-4, ("bonded, shear, %d dimensions, %s: out by %.3g"):format(dim, integrator, out))
  end
end

-- With an accuracy, an impact on a block held by mortar conserves energy too: until the mortar breaks, the oscillation
-- on the mortar counts as an impact. A stone falls from 0.5 m onto the middle of the block or near its end.
local function drop_on_bonded(dim, law, accuracy, aside)
  local m = trilith.model { name = "struck", dim = dim }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = law }
  m:contact { between = { "ball", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6 } }
  local function block(name, x, z, width, height, options)
    options.name, options.material, options.floating = name, "stone", true
    if dim == 2 then
      options.width, options.height, options.at = width, height, { x, z }
    else
      options.size, options.at = { width, width, height }, { x, 0.5 - width/2, z }
    end
    return m:block(options)
  end
  block("base", 0, -0.5, 1, 0.5, { support = "fixed" })
  block("top", 0.2, 0, 0.6, 0.3, {})
  local ball = block("ball", 0.2 + aside, 0.8, 0.3, 0.3, {})
  local broken = 0
  m:on("bond.broken", function() broken = broken + 1 end)
  m:run { duration = 0.8, accuracy = accuracy }
  local out = math.abs(m.energy.residual)/(ball.mass*9.80665*0.5)
  assert(broken > 0)
  m:close()
  return out
end

-- With an accuracy of 0.001 the residual is 0.06 to 0.17 %, over an impact, a break and later impacts. With softening
-- mortar, whose error is of first order in the step, it is up to 0.8 %. If steps grow as the stone leaves it is 0.06 to
-- 10 %.
local limits = { bonded = { [1e-3] = 3e-3, [1e-4] = 5e-4 }, cohesive = { [1e-3] = 1e-2, [1e-4] = 4e-3 } }
local struck = {
  bonded = trilith.bonded { kn = 1e9, ks = 4e8, mu = 0.6, tension = 2e5, cohesion = 3e5 },
  cohesive = trilith.cohesive { kn = 1e9, ks = 4e8, mu = 0.6, tension = 2e5, cohesion = 3e5, energy_tension = 100,
                                energy_shear = 300 },
}
for _, dim in ipairs { 2, 3 } do
  for law, value in pairs(struck) do
    for _, aside in ipairs { -0.1, 0.15 } do
      for accuracy, limit in pairs(limits[law]) do
        local out = drop_on_bonded(dim, value, accuracy, aside)
        assert(out < limit, ("%s, %d dimensions, %g m aside, %g: out by %.3g"):format(law, dim, aside, accuracy, out))
      end
    end
  end
end

-- Pressed in at 1 m/s a block rebounds and goes from compression to a broken bond within one step of a quarter to a
-- third of the longest stable step. The residual of this step is reported, in space as in the plane. The dissipation of
-- the bond is at most its stored energy and never negative.
local function torn(dim, dt)
  local m = trilith.model { name = "torn", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 2000 }
  local law = trilith.bonded { kn = 1e8, ks = 5e7, mu = 0.5, tension = 1e3, cohesion = 1e6 }
  m:contact { between = { "*", "*" }, law = law }
  local space = dim == 3
  for name, x in pairs { base = 0, block = 1 } do
    local body = { name = name, material = "stone" }
    if space then
      body.size, body.at = { 1, 1, 1 }, { x, 0, 0 }
    else
      body.width, body.height, body.at = 1, 1, { x, 0 }
    end
    if name == "base" then
      body.support = "fixed"
    else
      body.floating, body.velocity = true, space and { -1, 0, 0 } or { -1, 0 }
    end
    m:block(body)
  end
  m:run { duration = 0.03, dt = dt }
  local fracture, residual = m.energy.contact_fracture, m.residual
  m:close()
  return fracture, residual
end
for _, dt in ipairs { 2.4e-3, 2.7e-3, 3e-3 } do
  local flat, missed = torn(2, dt)
  local deep, missed_too = torn(3, dt)
  assert(flat >= 0 and deep >= 0, ("a bond gave off %g and %g J"):format(flat, deep))
  assert(math.abs(missed - missed_too) < 1e-6 * math.abs(missed), ("%g and %g J are missed"):format(missed, missed_too))
  assert(math.abs(missed) > 10)
end
print "every assertion holds"
