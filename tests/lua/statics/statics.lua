-- Equilibrium by statics from a script: the same joint forces as by consolidation, and the message if there is none.
local trilith = require "trilith"

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

local function wall(bonded)
  local m = trilith.model { name = "wall", thickness = 0.2 }
  m:material { name = "brick", density = 1800 }
  local law = bonded and trilith.bonded { kn = 1e10, ks = 4e9, mu = 0.6, cohesion = 2e5, tension = 1e5, beta = 2e-5 }
    or trilith.frictional { kn = 1e10, ks = 4e9, mu = 0.6, beta = 2e-5 }
  m:contact { between = { "*", "*" }, law = law }
  m:wall { name = "w", length = 1.6, unit_length = 0.4, unit_height = 0.2, storeys = 2, storey_height = 0.8,
           slab_height = 0.2, base_height = 0.5, material = "brick", fixed = "base" }
  return m
end

-- Joint forces by the names of the bodies.
local function joints(m)
  local list, most = {}, 0
  for _, c in ipairs(m:contacts()) do
    list[c.a.name .. "|" .. c.b.name] = c.force
    most = math.max(most, math.abs(c.force[2]))
  end
  return list, most
end

local a, b = wall(), wall()
local report = a:consolidate { integrator = "static" }
assert(report.rests and report.steps < 20 and report.ratio <= 1e-8 and a.time == 0 and a.speed == 0)
b:consolidate { rest = { ratio = 1e-7 }, grow = 0.2 }
local by_statics, most = joints(a)
local by_steps = joints(b)
for name in pairs(by_statics) do by_steps[name] = by_steps[name] or { 0, 0 } end -- units side by side have almost no
                                                                                 -- contact
for name, force in pairs(by_steps) do
  local found = by_statics[name] or { 0, 0 }
  for k = 1, 2 do assert(math.abs(force[k] - found[k]) < 0.005*most, name) end
end
a:run { duration = 0.05 }
assert(a.speed < 1e-6 and math.abs(a.energy.residual) < 1e-6*math.abs(a.energy.gravity))
a:close() b:close()

-- fresh mortar sets once the wall rests
local f = wall(true)
f:consolidate { integrator = "static", fresh = true }
f:run { duration = 0.02 }
assert(f.speed < 1e-6)
f:close()

local n = trilith.model { name = "air" }
n:material { name = "brick", density = 1800 }
n:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 4e9, mu = 0.6, beta = 2e-5 } }
n:block { name = "base", width = 1, height = 1, at = { 0, 0 }, material = "brick", support = "fixed" }
local low = n:block { name = "low", width = 1, height = 1, at = { 3, 3 }, material = "brick", floating = true }
local y = low.y
local none = n:consolidate { integrator = "static", or_go_on = true }
assert(not none.rests and none.reason:find("low has no support", 1, true), none.reason)
assert(low.y == y and low.vy == 0)
refused("'integrator' is 'statics', must be one of explicit, static", n.consolidate, n, { integrator = "statics" })
refused("0 shares, must be 1 to 1000", n.consolidate, n, { integrator = "static", shares = 0 })
n:close()

-- A clamped bar under an end moment is a circular arc of angle M L / (E I), found at any bend angle: each load
-- increment may displace it by its own length. An unsupported body is reported with any number of increments.
do
  local E, length, radius = 2e11, 4, 0.01
  local stiffness = E*math.pi*(2*radius)^4/64
  for _, turn in ipairs { 0.3, 0.5 } do
    local c = trilith.model { name = "rolled", dim = 3, gravity = 0 }
    c:material { name = "steel", density = 7850, E = E, nu = 0.3 }
    local bar = c:beam { name = "bar", material = "steel", from = { 0, 0, 0 }, to = { length, 0, 0 },
      section = trilith.circle_section { diameter = 2*radius }, from_support = "fixed", divisions = 20 }
    local angle = turn*math.pi
    c:point_load { body = bar, at = { length, 0, 0 }, moment = { 0, -angle*stiffness/length, 0 } }
    c:consolidate { integrator = "static", shares = 20 }
    local x, _, z = bar:point { length, 0, 0 }
    assert(math.abs(x - length*math.sin(angle)/angle) < 0.01*length, x)
    assert(math.abs(z - length*(1 - math.cos(angle))/angle) < 0.01*length, z)
    c:close()
  end
  local loose = trilith.model { name = "loose" }
  loose:contact { between = { "*", "*" }, law = "none" }
  loose:material { name = "brick", density = 1800 }
  loose:block { name = "base", width = 1, height = 1, at = { 0, 0 }, material = "brick", support = "fixed" }
  loose:block { name = "low", width = 1, height = 1, at = { 3, 3 }, material = "brick", floating = true }
  local found = loose:consolidate { integrator = "static", shares = 10, or_go_on = true }
  assert(not found.rests and found.reason:find("low has no support, or yields or bends", 1, true), found.reason)
  loose:close()
end

-- Statics takes no time: a load acts by the current factor of its load curve, and a factor of zero is reported.
for _, dim in ipairs { 2, 3 } do
  for course, share in pairs { [{ ramp = 0.1 }] = 0, [{ { 0, 0.25 }, { 0.1, 1 } }] = 0.25, [0.5] = 0.5 } do
    local flat = dim == 2
    local c = trilith.model { name = "pressed", dim = dim }
    c:material { name = "brick", density = 1000 }
    c:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4 } }
    local function cube(name, z, support)
      return c:block { name = name, material = "brick", support = support, width = flat and 1 or nil,
        height = flat and 1 or nil, size = not flat and { 1, 1, 1 } or nil, at = flat and { 0, z } or { 0, 0, z } }
    end
    cube("base", -1, "fixed")
    local top = cube("top", 0)
    c:point_load { name = "push", body = top, force = flat and { 0, -1e4 } or { 0, 0, -1e4 }, load_curve = course }
    local function carried()
      local sum = 0
      for _, joint in ipairs(c:contacts()) do sum = sum + joint.normal end
      return sum/(1000*9.80665 + 1e4)
    end
    c:consolidate { integrator = "static" }
    assert(math.abs(carried() - (9806.65 + share*1e4)/19806.65) < 1e-6, carried())
    local said = "consolidation: no share of 'push' acts at 0 s of its load curve, and statics takes no time"
    local notes = table.concat(c.notes, "\n")
    assert((notes:find(said, 1, true) ~= nil) == (share == 0), notes)
    if share < 0.5 then
      c:run { duration = 0.2, local_damping = 0.8 }
      c:consolidate { integrator = "static" }
      assert(math.abs(carried() - 1) < 1e-6, carried())
      assert(#c.notes == (share == 0 and 1 or 0), #c.notes)
    end
    c:close()
  end
end
