-- What breaks gives off what it held and the half step that its last force still works: a block of 2 t at 1 m/s tears
-- itself off, by tension or by shear, in both dimensions and by both kinds of steps.
local trilith = require "trilith"

local laws = {
  bonded = { kn = 1e8, ks = 5e7, mu = 0.5, tension = 1e5, cohesion = 2e5, beta = 1e-4 },
  cohesive = { kn = 1e8, ks = 5e7, mu = 0.5, tension = 1e5, cohesion = 2e5, beta = 1e-4, energy_tension = 200,
               energy_shear = 800 },
}

-- The block's energy was 1 kJ. Returns how far the ledger was out at most, as a share of it, from the second step on.
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
    -- A block that shears turns besides, and its faces part from one end on.
    local out = tear(dim, "bonded", integrator, "shear")
    assert(out < 5e-4, ("bonded, shear, %d dimensions, %s: out by %.3g"):format(dim, integrator, out))
  end
end
