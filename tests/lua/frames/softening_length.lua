-- Fibres that soften by fracture energy: the answer of a column does not depend on the number of its beams. With a
-- strain at the end of softening it does.
local trilith = require "trilith"

local side, height, strength, energy, rest = 0.4, 2, 30e6, 80e3, 0.2
local square = trilith.rectangle_section { width = side, depth = side }

local function law(share, by_energy)
  return trilith.kent_park { strength = share*strength, residual = rest, ultimate = 0.01,
    crush_energy = by_energy and energy or nil }
end

--- A place on the axis of the column.
local function place(level, dim) return dim == 3 and { 0, 0, level } or { 0, level } end

--- A column of `count` beams of equal length, whose lowest one has the section `foot`.
local function column(count, section, foot, gravity, dim)
  local m = trilith.model { name = "column", gravity = gravity, dim = dim }
  m:material { name = "concrete", density = 2500, E = 30e9, nu = 0.2 }
  return m, m:frame { name = "column", material = "concrete",
    joints = { a = { at = place(0, dim), support = "fixed" }, b = place(height/count, dim), c = place(height, dim) },
    members = { { name = "foot", from = "a", to = "b", section = foot, divisions = 1 },
      { name = "rest", from = "b", to = "c", section = section, divisions = count - 1 } } }
end

local function force_at(curve, displacement)
  for i = 2, #curve.force do
    local a, b = curve.displacement[i - 1], curve.displacement[i]
    if b >= displacement then
      return curve.force[i - 1] + (displacement - a)/(b - a)*(curve.force[i] - curve.force[i - 1])
    end
  end
end

-- Compression: the weaker foot crushes, and the rest unloads. Force falls along a line.
local function slope(count, by_energy, dim)
  local function section(share)
    return trilith.fibre_section { shape = square, law = law(share, by_energy), layers = 8 }
  end
  local m, body = column(count, section(1), section(0.9), 0, dim)
  m:consolidate { integrator = "static" }
  local push = m:pushover { body = body, at = place(height, dim), direction = dim == 3 and "-z" or "-y",
    control = "arc", arc = 1e-5, displacement = 0.006, samples = 1000 }
  m:close()
  return (force_at(push.curve, 0.0045) - force_at(push.curve, 0.0055))/0.001
end
-- The foot of length h dissipates G on an inelastic displacement, and shortens less by its elastic strain. The rest
-- unloads along the line of Karsan and Jirsa from 90 % of its strength.
local top = 0.9*strength
local fall, inelastic = (1 - rest)*top, 2*energy/((1 + rest)*top)
local share = 1 - math.sqrt(0.1)                                 -- 2 x - x^2 = 0.9
local unloading = top/(0.002*(share - (0.145*share + 0.13)*share))
local function expected(count)
  local h = height/count
  return fall*side^2/(inelastic - h*fall/(2*top/0.002) - (height - h)*fall/unloading)
end
for _, case in ipairs { { 2 }, { 4 }, { 8 }, { 4, 3 } } do
  local found = slope(case[1], true, case[2])
  local wanted = expected(case[1])
  assert(math.abs(found - wanted) < 0.003*wanted, ("%d beams: %g N/m, not %g"):format(case[1], found, wanted))
end
assert(slope(2, false) < 0.6*expected(2))

-- A cantilever under a normal force of a fifth of its strength, pushed until its foot is crushed.
local steel = trilith.bilinear_steel { E = 2e11, yield = 420e6, hardening = 0.01 }
local function forces(count, by_energy)
  local section = trilith.fibre_section { shape = square, law = law(1, by_energy), layers = 40, bar_law = steel,
    bars = { { area = 8e-4, height = 0.05 }, { area = 8e-4, height = 0.35 } } }
  local m, body = column(count, section, section, 0)
  m:point_load { body = body, at = { 0, height }, force = { 0, -1e6 } }
  m:consolidate { integrator = "static" }
  local push = m:pushover { body = body, at = { 0, height }, direction = "x", control = "arc", displacement = 0.05,
    samples = 400 }
  m:close()
  return force_at(push.curve, 0.03), force_at(push.curve, 0.04), force_at(push.curve, 0.05)
end
local function apart(by_energy)
  local most = 0
  local four, eight = { forces(4, by_energy) }, { forces(8, by_energy) }
  for i = 1, 3 do most = math.max(most, math.abs(four[i] - eight[i])/eight[i]) end
  return most
end
assert(apart(true) < 0.06, apart(true))
assert(apart(false) > 0.3, apart(false))

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end
refused("beams must be shorter than 5.", function()
  local long = trilith.fibre_section { shape = square, law = law(1, true) }
  local m = trilith.model {}
  m:material { name = "concrete", density = 2500, E = 30e9, nu = 0.2 }
  m:beam { name = "long", from = { 0, 0 }, to = { 0, 12 }, section = long, material = "concrete", divisions = 2 }
end)
refused("energy_tension and tension_end are both given", trilith.kent_park, { strength = 30e6, tension = 2e6,
  tension_end = 1e-3, energy_tension = 100 })
