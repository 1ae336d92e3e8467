-- Load paths of dry masonry by arc length, past the peak: a block, a semicircular arch of 24 voussoirs and a wall, in
-- the plane and in space. Rigid joints give the limits; joints of finite stiffness stay below and converge to them.
local trilith = require "trilith"
local near = dofile "near_expected.lua"
local g = 9.80665

local function model(dim, kn, mu)
  local m = trilith.model { name = "dry", dim = dim }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = mu, beta = 1e-6 } }
  return m
end
-- A convex outline {x, z}; in space 0.5 m deep.
local function stone(m, name, outline, support)
  if m.dim == 2 then return m:polygon { name = name, outline = outline, material = "stone", support = support } end
  local corners = {}
  for _, at in ipairs(outline) do
    corners[#corners + 1] = { at[1], -0.25, at[2] }
    corners[#corners + 1] = { at[1], 0.25, at[2] }
  end
  return m:body { name = name, material = "stone", support = support, pieces = { { hull = corners } } }
end
local function box(m, name, x0, z0, x1, z1, support)
  return stone(m, name, { { x0, z0 }, { x1, z0 }, { x1, z1 }, { x0, z1 } }, support)
end
local function weight(bodies)
  local sum = 0
  for _, b in ipairs(bodies) do sum = sum + b.mass*g end
  return sum
end
-- The limit of rigid joints from two stiffnesses 100 apart: a hinge reduces the factor by K^(-1/3).
local part = 100^(1/3)
local function rigid(soft, stiff) return (part*stiff - soft)/(part - 1) end

-- A block of 0.5 by 2 m pushed at its top, and at its middle against x: W b/(2 a).
for _, dim in ipairs { 2, 3 } do
  for _, case in ipairs { { direction = "x", at = 2 }, { direction = "-x", at = 1 } } do
    local found = {}
    for _, kn in ipairs { 1e9, 1e11 } do
      local m = model(dim, kn, 0.9)
      box(m, "ground", -3, -1, 4, 0, "fixed")
      local b = box(m, "block", 0, 0, 0.5, 2)
      m:consolidate { integrator = "static" }
      local r = m:pushover { body = b, at = dim == 2 and { 0.25, case.at } or { 0.25, 0, case.at },
        direction = case.direction, control = "arc", displacement = 0.05*case.at, samples = 400 }
      assert(r.limit == "displacement" and r.force < r.peak_force, r.limit)
      found[#found + 1] = r.peak_force/(b.mass*g*0.25/case.at)
      m:close()
    end
    assert(found[1] < found[2] and found[2] < 1)
    near(("block, dim %d"):format(dim), rigid(found[1], found[2]), 1, 0.005)
  end
end

-- Limit analysis of an arch whose joints have no tension and do not slide. Four hinges at edges of joints give four
-- equations for the reaction at the left springing (M, Rx, Ry) and the factor; the mechanism is the one for which the
-- thrust stays within every joint.
local function det3(a, b, c)
  return a[1]*(b[2]*c[3] - b[3]*c[2]) - a[2]*(b[1]*c[3] - b[3]*c[1]) + a[3]*(b[1]*c[2] - b[2]*c[1])
end
local function limit_factor(joints, weights, centres)
  -- Moment about P of all forces on the part left of joint i is M + y Rx - x Ry + c + d factor.
  local function row(i, P)
    local c, d = 0, 0
    for k = 1, i - 1 do
      c = c - (centres[k][1] - P[1])*weights[k]
      d = d - (centres[k][2] - P[2])*weights[k]
    end
    return { P[2], -P[1], d, c }
  end
  local rows = {}
  for i, joint in ipairs(joints) do rows[i] = { row(i, joint[1]), row(i, joint[2]) } end
  local n = #joints
  for i = 1, n - 3 do for j = i + 1, n - 2 do for k = j + 1, n - 1 do for l = k + 1, n do
    for side = 1, 2 do
      local a, b, c, d = rows[i][side], rows[j][3 - side], rows[k][side], rows[l][3 - side]
      local function less(p, q) return { p[1] - q[1], p[2] - q[2], p[3] - q[3], p[4] - q[4] } end
      local p, q, r = less(b, a), less(c, a), less(d, a)
      local det = det3(p, q, r)
      if math.abs(det) > 1e-12 then
        local function column(m) -- Cramer's rule
          local P, Q, R = { p[1], p[2], p[3] }, { q[1], q[2], q[3] }, { r[1], r[2], r[3] }
          P[m], Q[m], R[m] = -p[4], -q[4], -r[4]
          return det3(P, Q, R)/det
        end
        local Rx, Ry, f = column(1), column(2), column(3)
        local M = -(a[1]*Rx + a[2]*Ry + a[3]*f + a[4])
        local good = f > 0 and Ry > 0
        for m = 1, n do
          if not good then break end
          local function moment(of) return M + of[1]*Rx + of[2]*Ry + of[3]*f + of[4] end
          good = moment(rows[m][1])*moment(rows[m][2]) <= 1e-12
        end
        if good then return f end
      end
    end
  end end end end
end

local n = 24
for _, case in ipairs { { dim = 2, t = 0.15 }, { dim = 2, t = 0.2 }, { dim = 3, t = 0.15 } } do
  local t, found, expected = case.t, {}, nil
  for _, kn in ipairs { 4e10, 4e12 } do
    local m = model(case.dim, kn, 0.7)
    box(m, "floor", -3, -0.5, 3, 0, "fixed")
    local ring, joints, weights, centres = {}, {}, {}, {}
    local function at(r, c) return { r*math.cos(c), math.max(0, r*math.sin(c)) } end
    for i = 1, n do
      local a, b = math.pi*(n - i + 1)/n, math.pi*(n - i)/n
      ring[i] = stone(m, "v" .. i, { at(1 - t/2, a), at(1 - t/2, b), at(1 + t/2, b), at(1 + t/2, a) })
      joints[i] = { at(1 - t/2, a), at(1 + t/2, a) }
      if i == n then joints[i + 1] = { at(1 - t/2, b), at(1 + t/2, b) } end
      -- Alike stones: their weight is 1, and their centre lies on the bisector.
      local half, inner, outer = math.pi/(2*n), 1 - t/2, 1 + t/2
      local height = outer - inner
      local r = (inner + height/3*(inner + 2*outer)/(inner + outer))*math.cos(half)
      weights[i], centres[i] = 1, at(r, (a + b)/2)
    end
    expected = expected or limit_factor(joints, weights, centres)
    m:consolidate { integrator = "static" }
    local r = m:pushover { body = ring, direction = "x", control = "arc", displacement = 4e-3, samples = 1000 }
    assert(r.limit == "displacement" and r.force < 0.98*r.peak_force, r.limit .. " " .. r.force/r.peak_force)
    found[#found + 1] = r.peak_force/weight(ring)
    m:close()
  end
  assert(found[1] < found[2] and found[2] < expected)
  near(("arch, dim %d, t/R %g"):format(case.dim, t), rigid(found[1], found[2]), expected, 0.01)
end

-- A wall in running bond. Sliding on its bed limits the force to mu W, and friction does not lower it. With more
-- friction it tips over, with the same peak for any step length, in the plane and in space. The limit with dilatant
-- friction (0.79636 W by linear programming) is an upper bound.
local function wall(dim, mu, displacement)
  local m, all = model(dim, 4e10, mu), {}
  box(m, "ground", -1, -0.5, 3, 0, "fixed")
  for j = 0, 4 do
    local x = 0
    while x < 1.2 - 1e-9 do
      local wide = (x == 0 and j % 2 == 1) and 0.2 or math.min(0.4, 1.2 - x)
      all[#all + 1] = box(m, ("c%d.%d"):format(j, #all), x, 0.2*j, x + wide, 0.2*(j + 1))
      x = x + wide
    end
  end
  m:consolidate { integrator = "static" }
  local r = m:pushover { body = all, control = "arc", displacement = displacement, samples = 1000 }
  -- A path that ends before the displacement has a note.
  assert(r.limit == "displacement" or table.concat(m.notes):find("the load path ends at", 1, true), r.limit)
  local W = weight(all)
  m:close()
  return r.peak_force/W, r.force/W
end
for _, dim in ipairs { 2, 3 } do
  local peak = wall(dim, 0.3, 5e-3)
  assert(peak < 0.3*(1 + 1e-6), peak)
  near("wall that slides", peak, 0.3, 0.03)
end
local first
for _, case in ipairs { { 2, 5e-3 }, { 2, 0.02 }, { 3, 4e-3 } } do
  local peak, last = wall(case[1], 0.9, case[2])
  first = first or peak
  near(("wall that tips over, dim %d, %g m"):format(case[1], case[2]), peak, first, 2e-3)
  assert(peak < 0.79636 and last < 0.99*peak, last/peak)
end
