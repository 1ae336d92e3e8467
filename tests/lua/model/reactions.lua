-- Reactions of supports: of members, of standing or moving rigid bodies, of elements, in the plane and in space.
local trilith = require "trilith"
local g = 9.80665

local function near(value, expected, share)
  assert(math.abs(value - expected) <= share*math.max(math.abs(expected), 1e-9),
    ("%.9g is not %.9g"):format(value, expected))
end

-- A clamped cantilever of weight W with a force P down at its tip: W + P, and W L/2 + P L, for any division.
for _, divisions in ipairs { 1, 2, 8 } do
  local m = trilith.model { name = "cantilever" }
  m:material { name = "steel", density = 7850, E = 2e11, nu = 0.3 }
  m:beam { name = "b", from = { 0, 0 }, to = { 4, 0 }, material = "steel", divisions = divisions,
    section = trilith.rectangle_section { width = 0.05, depth = 0.2 }, from_support = "fixed" }
  m:point_load { name = "P", body = "b", at = { 4, 0 }, force = { 0, -500 } }
  m:consolidate { integrator = "static" }
  local b = m:body "b"
  local list = b:reactions()
  assert(#list == 1 and math.abs(list[1].x) < 1e-9)
  near(list[1].fy, b.mass*g + 500, 1e-9)
  near(list[1].m, b.mass*g*2 + 500*4, 1e-3) -- the tip has deflected
  near(b.reaction_y, list[1].fy, 1e-12)
  assert(math.abs(b.reaction_x) < 1e-6)
  m:close()
end

-- The support carries the full pressure on a cantilever for any inclination and division, with its moment; the shear of
-- the first element is the value at its middle.
for _, case in ipairs { { dim = 2, width = 1 }, { dim = 3, width = 0.1 } } do
  for _, divisions in ipairs { 1, 8, 40 } do
    for _, tip in ipairs { { 2, 0 }, { 1.6, 1.2 } } do
      local m = trilith.model { name = "pressed", dim = case.dim, gravity = 0 }
      m:material { name = "wood", density = 500, E = 1e10, nu = 0.3 }
      local function at(p) return case.dim == 2 and p or { p[1], 0, p[2] } end
      local b = m:beam { name = "b", from = at { 0, 0 }, to = at(tip), material = "wood", divisions = divisions,
        section = trilith.rectangle_section { width = 0.1, depth = 0.2 }, from_support = "fixed" }
      m:pressure { body = b, face = "top", value = 1000, follow = false }
      m:consolidate { integrator = "static" }
      local r, load = b:reactions()[1], 1000*case.width*2
      -- 12 EI/l^3 of the shortest elements is 6e10 N/m: rounding of positions by 1e-15 m gives 1e-4 N.
      assert(math.abs(r.fx + load*tip[2]/2) < 1e-5*load)
      near(case.dim == 2 and r.fy or r.fz, load*tip[1]/2, 1e-5)
      near(math.abs(r.m or r.my), load*1, 5e-4) -- the top rotates by about 2e-3 rad about the axis, 0.1 m below it
      local first = b:forces()[1]
      near(math.abs(first.shear or first.shear_y), load*(1 - 0.5/divisions), 1e-5)
      m:close()
    end
  end
end

-- A fixed base transmits the load above it and its own weight; a moving base also the inertia of all bodies on it.
for _, dim in ipairs { 2, 3 } do
  local m = trilith.model { name = "stand", dim = dim }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.7, beta = 1e-3 } }
  local function block(name, wide, from, support)
    if dim == 3 then
      return m:block { name = name, size = { wide, wide, 1 }, at = { -wide/2, -wide/2, from }, material = "stone",
        support = support }
    end
    return m:block { name = name, width = wide, height = 1, at = { -wide/2, from }, material = "stone",
      support = support }
  end
  local base, stone = block("base", 4, -1, "fixed"), block("stone", 2, 0)
  m:consolidate { rest = { ratio = 1e-6 } }
  local up = dim == 3 and "reaction_z" or "reaction_y"
  near(base[up], (base.mass + stone.mass)*g, 1e-5)
  local list = base:reactions()
  assert(#list == 1 and math.abs(dim == 3 and list[1].mx or list[1].m) < 1e-3*base.mass*g)
  assert(#stone:reactions() == 0 and stone.reaction_x == 0)
  -- At 0.2 g the stone does not slide: both follow the ground, except for the oscillation of the stone on its bed.
  m:history { name = "reaction", body = base, what = "reaction_x" }
  local a = 0.2*g
  m:shake { body = base, x = trilith.motion { acceleration = { 0, a, a, a, a }, dt = 0.1, allow_drift = true },
    duration = 0.35, name = "shake" }
  near(base.reaction_x, (base.mass + stone.mass)*a, 0.02)
  -- The current motion counts, not an earlier one.
  m:shake { body = base, x = trilith.motion { acceleration = { a, -a, -a, -a, -a }, dt = 0.1, allow_drift = true,
    v0 = 0 }, duration = 0.35, name = "back" }
  near(base.reaction_x, -(base.mass + stone.mass)*a, 0.02)
  m:close()
end

-- A block of elements fixed at its foot, in the plane and in space: the sum over its nodes is its weight.
for _, dim in ipairs { 2, 3 } do
  local m = trilith.model { name = "pier", dim = dim }
  m:material { name = "stone", density = 2000, E = 1e9, nu = 0.2 }
  local pier
  if dim == 3 then
    pier = m:block { name = "pier", size = { 1, 1, 2 }, material = "stone", floating = true,
      body = { mesh = { 2, 2, 3 } }, hold = { { from = { 0, 0, 0 }, to = { 1, 1, 0 } } } }
  else
    pier = m:block { name = "pier", width = 1, height = 2, material = "stone", floating = true,
      body = { mesh = { 2, 3 } }, hold = { { from = { 0, 0 }, to = { 1, 0 } } } }
  end
  m:consolidate { integrator = "static" }
  assert(#pier:reactions() == (dim == 3 and 9 or 3))
  near(dim == 3 and pier.reaction_z or pier.reaction_y, pier.mass*g, 1e-9)
  m:close()
end

-- A point of elements follows the field of their nodes: exactly under a uniform strain, at any position.
for _, element in ipairs { "hex8", "tet4", "tet10" } do
  for _, n in ipairs { 1, 2, 3 } do
    local m = trilith.model { name = "bar", dim = 3, gravity = 0 }
    m:material { name = "stone", density = 2000, E = 1e9, nu = 0 }
    local bar = m:block { name = "bar", size = { 2, 2, 2 }, material = "stone", floating = true,
      body = { mesh = { n, n, n }, element = element ~= "hex8" and element or nil },
      hold = { { from = { 0, 0, 0 }, to = { 0, 2, 2 }, x = "fixed", y = "fixed", z = "fixed" } } }
    m:pressure { body = bar, face = "right", value = -1e6 }
    m:consolidate { integrator = "static" }
    for _, p in ipairs { { 2, 2, 2 }, { 2, 0, 2 }, { 2, 1, 2 }, { 2, 1, 1 }, { 1, 2, 2 }, { 1, 1, 1 },
      { 0.3, 1.7, 0.9 } } do
      local x, y, z = bar:point(p)
      near(x - p[1], 1e-3*p[1], 1e-3) -- 0.001 due to large strain
      assert(math.abs(y - p[2]) < 1e-6 and math.abs(z - p[3]) < 1e-6)
    end
    m:close()
  end
end
