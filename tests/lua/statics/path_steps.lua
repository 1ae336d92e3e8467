-- The curve of a load path does not depend on the length of its steps: dry walls under a beam, blocks that rock and
-- slide, in the plane and in space, rigid and deformable. Friction depends on the way. So a step that is too long, or a
-- search for rest whose steps the joints remember, ends on another branch.
local trilith = require "trilith"
local near = dofile "near_expected.lua"
local g = 9.80665

local function box(m, name, x0, z0, x1, z1, more)
  local t = { name = name, material = "stone" }
  for key, value in pairs(more or {}) do t[key] = value end
  if m.dim == 2 then
    t.width, t.height, t.at = x1 - x0, z1 - z0, { x0, z0 }
    return m:block(t)
  end
  t.size, t.at = { x1 - x0, 0.2, z1 - z0 }, { x0, -0.1, z0 }
  return m:block(t)
end

local function model(dim, law)
  local m = trilith.model { name = "steps", dim = dim, thickness = dim == 2 and 0.2 or nil, threads = 1 }
  m:material { name = "stone", density = 2400, E = 5e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional(law) }
  return m
end

-- Courses of two stones of 0.4 m in running bond, a beam on top with 40 kN, pushed at the beam.
local function wall(dim, arc, courses, displacement, form)
  local m = model(dim, { kn = 5e9, ks = 2e9, mu = 0.6, beta = 1e-6 })
  box(m, "base", -0.2, -0.2, 1, 0, { support = "fixed" })
  for j = 1, courses do
    local cuts = j % 2 == 1 and { 0, 0.4, 0.8 } or { 0, 0.2, 0.6, 0.8 }
    for i = 1, #cuts - 1 do
      box(m, ("c%d.%d"):format(j, i), cuts[i], 0.2*(j - 1), cuts[i + 1], 0.2*j, { body = form })
    end
  end
  local beam = box(m, "beam", 0, 0.2*courses, 0.8, 0.2*courses + 0.2)
  m:point_load { body = beam, force = dim == 2 and { 0, -40e3 } or { 0, 0, -40e3 } }
  m:consolidate { integrator = "static" }
  local r = m:pushover { body = beam, control = "arc", arc = arc, displacement = displacement, samples = 2000 }
  local notes = table.concat(m.notes, "\n")
  m:close()
  return r, notes
end

local function force_at(curve, displacement)
  local d, f = curve.displacement, curve.force
  for i = 2, #d do
    if d[i] >= displacement then
      return f[i - 1] + (f[i] - f[i - 1])*(displacement - d[i - 1])/math.max(d[i] - d[i - 1], 1e-15)
    end
  end
end

-- 2 % of the largest force between any two lengths of the first step; the finest is a hundredth of the usual one.
for _, case in ipairs { { 2, 4, 0.01 }, { 2, 3, 0.02 }, { 3, 4, 0.01 }, { 2, 3, 0.01, "quad" } } do
  local dim, courses, most, form = case[1], case[2], case[3], case[4]
  local fine = wall(dim, 1e-4*most, courses, 0.3*most, form)
  for _, share in ipairs { 0.01, 0.005, 0.0025 } do
    local r, notes = wall(dim, share*most, courses, most, form)
    assert(r.limit == "displacement", notes)
    for _, at in ipairs { 0.01, 0.02, 0.05, 0.1, 0.2, 0.29 } do
      local expected, got = force_at(fine.curve, at*most), force_at(r.curve, at*most)
      if expected and got then
        local where = ("dim %d, %d courses, arc %g of %g m"):format(dim, courses, share, most)
        assert(math.abs(got - expected) < 0.02*r.peak_force,
          ("%s: %.1f N at %g m, with short steps %.1f N"):format(where, got, at*most, expected))
      end
    end
    assert(#r.curve.force > 5 and force_at(r.curve, 0.1*most), "too few points")
  end
end

-- A block of 0.5 m by 1 m pushed at its top slides at mu W or rocks at W b/(2 h), less the toe of its elastic joint. An
-- upper block slides along the joint below it. The peak is the same for each halving of the step.
local function block(dim, arc, mu, form, stacked)
  local m = model(dim, { kn = 1e11, ks = 5e10, mu = mu, beta = 1e-6 })
  box(m, "base", -1, -0.2, 2, 0, { support = "fixed" })
  if stacked then box(m, "low", -0.5, 0, 1, 0.5, { body = form }) end
  local z = stacked and 0.5 or 0
  local b = box(m, "block", 0, z, 0.5, z + 1, { body = form })
  m:consolidate { integrator = "static" }
  local r = m:pushover { body = b, at = dim == 2 and { 0.25, z + 1 } or { 0.25, 0, z + 1 }, control = "arc", arc = arc,
    displacement = 0.01, samples = 500 }
  local weight = b.mass*g
  m:close()
  return r.peak_force/weight
end
for _, dim in ipairs { 2, 3 } do
  for _, form in ipairs { "rigid", dim == 2 and "quad" or "brick" } do
    for _, stacked in ipairs { false, true } do
      for _, mu in ipairs { 0.15, 0.6 } do
        local first
        for _, arc in ipairs { 1e-4, 5e-5, 2.5e-5 } do
          local found = block(dim, arc, mu, form, stacked)
          local where = ("dim %d, %s, mu %g, arc %g"):format(dim, form, mu, arc)
          first = first or found
          near(where .. ", against the first arc", found, first, 2e-3)
          near(where, found, math.min(mu, 0.25), 0.03)
          assert(found < math.min(mu, 0.25)*(1 + 1e-6), where)
        end
      end
    end
  end
end
