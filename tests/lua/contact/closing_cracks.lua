-- A softened crack with a stiff joint slams shut: the ledger closes within the accuracy of impacts, at any instant of
-- the closing within a step, in the plane and in space.
local trilith = require "trilith"

-- A rigid bar, bonded to a wall, is pulled until its plane has softened in part, and then pushed back by `back`.
-- Returns the missing work over the work of the load.
local function missed(t)
  local flat = t.dim == 2
  local m = trilith.model { name = "closing crack", dim = t.dim, gravity = 0, thickness = flat and 0.1 or nil }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, name = "crack", law = trilith.cohesive { kn = t.kn, ks = t.kn/2, mu = 0.6,
    tension = 3e6, cohesion = 6e6, energy_tension = 3000, energy_shear = 12000 } }
  m:contact { between = { "wall", "bar" }, name = "glue", law = trilith.bonded { kn = t.glue, ks = t.glue/2, mu = 0.6,
    tension = 1e8, cohesion = 1e8 } }
  local function block(x, width, more)
    more.material, more.at = "stone", flat and { x, 0 } or { x, 0, 0 }
    if flat then more.width, more.height = width, 0.1 else more.size = { width, 0.1, 0.1 } end
    m:block(more)
  end
  block(-0.1, 0.1, { name = "wall", support = "fixed" })
  block(0, 0.5, { name = "bar", cracks = "mid", crack_law = "crack", floating = true })
  m:point_load { body = "bar", at = flat and { 0.5, 0.05 } or { 0.5, 0.05, 0.05 },
    force = flat and { 1, 0 } or { 1, 0, 0 },
    load_curve = { { 0, 0 }, { 0.01, 33000 }, { 0.0105, 33000 }, { 0.0106, -t.back }, { 0.03, -t.back } } }
  m:run { duration = 0.0134, accuracy = t.accuracy }
  local softened = m.energy.contact_fracture
  assert(softened > 3 and softened < 25, softened)  -- of 30 J
  local share = math.abs(m.residual)/m.energy.load
  m:close()
  return share
end

-- An impact misses at most `accuracy` of the energy supplied. The crack closes and opens up to five times.
for _, t in ipairs { { dim = 2, kn = 1e12, glue = 1e11 }, { dim = 2, kn = 1e12, glue = 1e10 },
  { dim = 3, kn = 1e12, glue = 1e11 }, { dim = 3, kn = 2e11, glue = 1e11 } } do
  t.accuracy = 1e-3
  for i = 0, 11 do
    t.back = 4000 + 700*i
    local share = missed(t)
    assert(share < 5*t.accuracy, ("in %d dimensions, with kn = %g and %g N: %g of the work is missing"):format(t.dim,
      t.kn, t.back, share))
  end
end
