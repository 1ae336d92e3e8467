-- The ledger of a block that slides on mortar which dilates, crushes and damps: each alone and all together, in the
-- plane and in space. The joint stays pressed, so no other step is inexact.
local trilith = require "trilith"

local mass <const>, kn <const> = 2e4, 1e9

local function slide(dim, dilation, compression, beta)
  local m = trilith.model { name = "slide", dim = dim, thickness = dim == 2 and 1 or nil }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = kn, ks = 5e8, mu = 0.6, beta = beta,
    cohesion = 2e4, tension = 1e4, energy_tension = 1, energy_shear = 5, dilation = dilation,
    dilation_slip = dilation > 0 and 0.02 or nil, compression = compression, crushing_depth = 0.02 } }
  if dim == 2 then
    m:block { name = "base", width = 6, height = 0.5, at = { -2, -0.5 }, material = "stone", support = "fixed" }
    m:block { name = "block", width = 1, height = 0.1, at = { 0, 0 }, material = "stone", floating = true,
              mass = mass, velocity = { 0.1, 0 } }
  else
    m:block { name = "base", size = { 6, 3, 0.5 }, at = { -2, -1, -0.5 }, material = "stone", support = "fixed" }
    m:block { name = "block", size = { 1, 1, 0.1 }, at = { 0, 0, 0 }, material = "stone", floating = true,
              mass = mass, velocity = { 0.1, 0.02, 0 } }
  end
  m:run { duration = 0.012, dt = 2e-5 }
  local e = m.energy
  local lost = e.contact_friction + e.contact_fracture + e.contact_damping
  local share = m.residual/lost
  m:close()
  return share, lost
end

for _, dim in ipairs { 2, 3 } do
  for _, dilation in ipairs { 0, 0.3 } do
    for _, compression in ipairs { 0, 2.2e5 } do
      for _, beta in ipairs { 0, 1e-4 } do
        local share, lost = slide(dim, dilation, compression, beta)
        local where = ("%d dimensions, dilation %g, compression %g Pa, beta %g s"):format(dim, dilation, compression,
          beta)
        if os.getenv "TRILITH_SHOW" then print(where, share, lost)
        else assert(math.abs(share) < 1e-4 and lost > 20, ("%s: %.3g of %.4g J"):format(where, share, lost)) end
      end
    end
  end
end
