-- Capacity by a pushover in time: its largest force is the maximum over all steps, and the share of inertia is not a
-- capacity. A block that is pushed at its middle rocks at W b/h, and the force of a flexible post is k times its
-- displacement.
local trilith = require "trilith"
local near = dofile "near_expected.lua"
local g = 9.80665

local function rocking(dim)
  local m = trilith.model { name = "rocking", dim = dim }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.9, beta = 1e-5 } }
  local block
  if dim == 2 then
    m:block { name = "ground", width = 4, height = 0.5, at = { -2, -0.5 }, material = "stone", support = "fixed" }
    block = m:block { name = "b", width = 0.5, height = 1, at = { -0.25, 0 }, material = "stone" }
  else
    m:block { name = "ground", size = { 4, 4, 0.5 }, at = { -2, -2, -0.5 }, material = "stone", support = "fixed" }
    block = m:block { name = "b", size = { 0.5, 1, 1 }, at = { -0.25, -0.5, 0 }, material = "stone" }
  end
  m:consolidate { rest = { ratio = 1e-5 } }
  return m, block
end
-- On springs the toe's pressure is a triangle of length c = sqrt(2 W/(kn turn)); maximum over the rotation `turn`.
local function limit_of(weight)
  local most = 0
  for turn = 1e-5, 0.04, 1e-5 do
    most = math.max(most, weight*(0.25 - math.sqrt(2*weight/(1e10*turn))/3 - 0.5*turn)/0.5)
  end
  return most
end
local function said(m) return table.concat(m.notes, "; ") end

local function push(dim, rate, displacement)
  local m, block = rocking(dim)
  local most, way = 0, 0
  m:on_step(function()
    if m.push_force > most then most, way = m.push_force, m.push_displacement end
  end)
  local r = m:pushover { body = block, rate = rate, displacement = displacement, samples = 60 }
  -- The maximum over all steps, with its displacement, is a point of the curve; times grow.
  near("peak of all steps", r.peak_force, most, 1e-12)
  near("its place", r.displacement_at_peak, way, 1e-9)
  local largest = 0
  for i, force in ipairs(r.curve.force) do
    largest = math.max(largest, force)
    assert(i == 1 or r.curve.t[i] >= r.curve.t[i - 1])
  end
  assert(largest == r.peak_force)
  return m, r, limit_of(block.mass*g)
end

for _, dim in ipairs { 2, 3 } do
  local displacement = dim == 2 and 0.02 or 0.004
  for _, rate in ipairs(dim == 2 and { 0.02, 0.1, 1 } or { 0.1, 1 }) do
    local m, r, limit = push(dim, rate, displacement)
    assert(r.peak_force > 1.05*limit and not r.quasi_static and r.carried_at_peak < 0.95*r.peak_force)
    assert(said(m):find("is not a static capacity: the structure carries", 1, true), said(m))
    m:close()
  end
  -- The default rate is slow enough, and gives no note.
  local m, r, limit = push(dim, nil, displacement)
  near("capacity without a rate", r.peak_force, limit, 0.015)
  near("what the supports take up", r.carried_at_peak, r.peak_force, 0.02)
  assert(r.quasi_static and not said(m):find "capacity", said(m))
  m:close()
end

-- A soft post: the default duration of the push follows from its periods.
local length, mass = 3, 5000
local m = trilith.model { name = "post", gravity = 0 }
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
m:contact { between = { "*", "*" }, law = "none" }
local post = m:frame { name = "post", material = "steel", joints = {
    foot = { at = { 0, 0 }, support = "fixed" }, head = { at = { 0, length }, mass = mass } },
  members = { { from = "foot", to = "head", section = trilith.rectangle_section { width = 0.1, depth = 0.1 } } } }
local r = m:pushover { body = post, at = "head", displacement = 2e-3 }
near("force of a soft post", r.peak_force, 3*2.1e11*0.1^4/12/length^3*2e-3, 0.02)
assert(r.quasi_static and r.ended - r.begun > 5)
m:close()

-- A block that lands while its push begins is pressed by more than its weight and its load. The push is slow then, so
-- that its peak is the friction of both, and the part carried under them is reported.
local function landing(dim, gap, load)
  local w = trilith.model { name = "landing", dim = dim }
  w:material { name = "stone", density = 2400 }
  w:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.4, beta = 1e-5 } }
  local body
  if dim == 2 then
    w:block { name = "ground", width = 4, height = 0.5, at = { -2, -0.5 }, material = "stone", support = "fixed" }
    body = w:block { name = "b", width = 1, height = 0.2, at = { -0.5, gap }, material = "stone", floating = true }
  else
    w:block { name = "ground", size = { 4, 4, 0.5 }, at = { -2, -2, -0.5 }, material = "stone", support = "fixed" }
    body = w:block { name = "b", size = { 1, 1, 0.2 }, at = { -0.5, -0.5, gap }, material = "stone", floating = true }
  end
  local weight = body.mass*g
  if load > 0 then w:point_load { body = body, force = dim == 2 and { 0, -load*weight } or { 0, 0, -load*weight } } end
  local pushed = w:pushover { body = body, rate = 0.01, displacement = 5e-3 }
  local friction = 0.4*(1 + load)*weight
  near("peak", pushed.peak_force, friction, 0.1)
  near("friction of weight and load alone", pushed.carried_at_peak, friction, 0.03)
  assert(pushed.carried_at_peak < pushed.peak_force and not pushed.quasi_static)
  w:close()
end
for _, dim in ipairs { 2, 3 } do
  landing(dim, 1e-4, 0)
  landing(dim, 1e-3, 2)
end

-- A mortar joint that dilates lifts a light brick under a load 100 times its weight. The lifting force is a small
-- part of this load, so that the peak c A + mu N is a capacity.
for _, dim in ipairs { 2, 3 } do
  local w = trilith.model { name = "couplet", dim = dim, thickness = dim == 2 and 0.1 or nil }
  w:material { name = "brick", density = 1900 }
  w:contact { between = { "*", "*" }, law = trilith.cohesive { kn = 1e11, ks = 4e10, mu = 0.75, cohesion = 0.8e6,
    tension = 0.5e6, energy_tension = 12, energy_shear = 60, dilation = 0.45, dilation_slip = 1e-3, beta = 1e-5 } }
  local function brick(name, z, support)
    if dim == 2 then
      return w:block { name = name, width = 0.2, height = 0.052, at = { 0, z }, material = "brick", support = support }
    end
    return w:block { name = name, size = { 0.2, 0.1, 0.052 }, at = { 0, 0, z }, material = "brick", support = support }
  end
  brick("lower", 0, "fixed")
  local level = dim == 2 and { rotation = "fixed" }
    or { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" }
  local upper = brick("upper", 0.052, level)
  w:point_load { body = upper, force = dim == 2 and { 0, -2e3 } or { 0, 0, -2e3 } }
  w:consolidate { rest = { ratio = 1e-6 }, grow = 0.05 }
  local pushed = w:pushover { body = upper, rate = 2e-3, displacement = 2e-4, samples = 100 }
  near("c A + mu N", pushed.peak_force, 0.8e6*0.02 + 0.75*(2e3 + upper.mass*g), 0.005)
  near("all of it is static", pushed.carried_at_peak, pushed.peak_force, 0.02)
  assert(pushed.quasi_static and not said(w):find "capacity", said(w))
  w:close()
end
