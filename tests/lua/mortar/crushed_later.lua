-- A joint with a crushing energy spends it once, above its residual strength: G + fr z. A body added to a running model
-- does as one from the start, in the plane and in space, by all integrators.
local trilith = require "trilith"
local near = dofile "near_expected.lua"

local kn, strength, energy, residual <const> = 1e9, 1e6, 4e3, 0.2
local depth <const> = 0.015

local function box(m, name, x, z, width, height, support)
  local t = { name = name, material = "stone", support = support }
  if m.dim == 2 then
    t.width, t.height, t.at = width, height, { x, z }
  else
    t.size, t.at = { width, 1, height }, { x, -0.5, z }
  end
  return m:block(t)
end

local function crush(dim, how, later)
  local m = trilith.model { name = "crush", dim = dim, thickness = dim == 2 and 1 or nil, gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = kn, ks = 5e8, mu = 0.6, cohesion = 1e6,
    tension = 1e5, energy_tension = 100, energy_shear = 1e4, compression = strength,
    crush_energy = energy, crush_residual = residual,
    crushing_depth = 0.05 } }
  box(m, "floor", -2, -0.5, 4, 0.5, "fixed")
  box(m, "beside", -2, 0, 0.5, 0.5)
  if later then m:run { duration = 1e-3, integrator = how } end
  local crushed = 0
  m:on("joint.crushed", function() crushed = crushed + 1 end)
  local a = box(m, "a", 0, 0, 1, 1)
  m:drive { body = a, [dim == 2 and "y" or "z"] = trilith.ramp { by = -depth, duration = 0.5 } }
  m:run { duration = 0.5, integrator = how }
  assert(m.verdict.sound and crushed == 1, crushed .. " joints crushed")
  local spent = m.energy.contact_fracture
  m:close()
  return spent
end

-- The joint crushes by the whole path less the elastic shortening of its residual strength.
local expected = energy + residual*strength*(depth - residual*strength/kn)
for _, dim in ipairs { 2, 3 } do
  for _, how in ipairs { "explicit", "implicit", "auto" } do
    for _, later in ipairs { false, true } do
      near(("dim %d, %s, %s"):format(dim, how, later and "added later" or "from the start"), crush(dim, how, later),
        expected, 5e-4)
    end
  end
end
