-- Statics after bodies were added whose contacts did not exist before. Each joint carries the weight above it, rigid
-- and deformable, in the plane and in space. The bodies stay at rest when time goes on.
local trilith = require "trilith"
local near = dofile "near_expected.lua"

local g, kn, E, density <const> = 9.80665, 1e9, 1e9, 2400

local function box(m, name, x, z, form, support)
  local t = { name = name, material = "stone", support = support, body = form }
  if m.dim == 2 then
    t.width, t.height, t.at = 1, 1, { x, z }
  else
    t.size, t.at = { 1, 1, 1 }, { x, -0.5, z }
  end
  return m:block(t)
end

for _, dim in ipairs { 2, 3 } do
  for _, form in ipairs { "rigid", dim == 2 and "quad" or "brick" } do
    local m = trilith.model { name = "later", dim = dim, thickness = dim == 2 and 1 or nil }
    m:material { name = "stone", density = density, E = E, nu = 0 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = 5e8, mu = 0.6, beta = 1e-4 } }
    for i, x in ipairs { -2, -1, 0, 1 } do box(m, "floor" .. i, x, -1, nil, "fixed") end
    box(m, "a", 0, 0, form)
    m:consolidate { integrator = "static" }
    local b, c = box(m, "b", 0, 1, form), box(m, "c", -1.5, 0)
    assert(m:consolidate { integrator = "static" }.ending == "rest")
    local where = ("dim %d, %s"):format(dim, form)
    local stress = density*g -- of one block, on 1 m2
    local function height(body) return dim == 2 and body.y or body.z end
    near(where .. ": beside", 0.5 - height(c), stress/kn, 1e-6)
    -- Joints below a and b, and the strain of a below b and by its own weight, and of the lower half of b.
    local short = form == "rigid" and 0 or (1.5*stress + 0.5*0.75*stress)/E
    near(where .. ": on top", 1.5 - height(b), 3*stress/kn + short, form == "rigid" and 1e-5 or 0.05)
    m:run { duration = 0.05 }
    assert(m.verdict.sound and math.abs(dim == 2 and b.vy or b.vz) < 1e-9, where)
    m:close()
  end
end
