-- Bilinear idealisation of curves whose idealisation is known, target displacements, drift limits.
local trilith = require "trilith"

local function near(a, b, share)
  assert(math.abs(a - b) <= (share or 1e-12)*math.abs(b), ("%.15g is not %.15g"):format(a, b))
end
local function refused(text, f, options)
  local ok, message = pcall(f, options)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end
local function curve(...)
  local out = { displacement = {}, force = {} }
  for i, p in ipairs { ... } do out.displacement[i], out.force[i] = p[1], p[2] end
  return out
end

-- A curve that is bilinear is its own idealisation by both codes. Force at the peak rises by a part in 1e12, so that
-- the peak is the last point.
local own = curve({ 0.01, 1e5 }, { 0.06, 1e5*(1 + 1e-12) })
for _, code in ipairs { "eurocode8", "ntc2018" } do
  local b = trilith.bilinear { curve = own, code = code }
  near(b.yield_force, 1e5, 1e-10) near(b.yield_displacement, 0.01, 1e-10) near(b.stiffness, 1e7, 1e-10)
  near(b.ductility, 6, 1e-10) near(b.near_collapse, 0.06) near(b.significant_damage, 0.045)
  near(b.energy, 0.5*0.01*1e5 + 0.05*1e5, 1e-10)
  assert(b.reached_drop == false and b.damage_limitation == b.yield_displacement)
end

-- A parabola F = F0 (2 s - s^2), s = d/d0: area to the peak 2/3 F0 d0, so that dy = 2 (1 - 2/3) d0 = 2/3 d0.
local d0, F0, points = 0.03, 2e5, {}
for i = 1, 3000 do points[i] = { d0*i/3000, F0*(2*i/3000 - (i/3000)^2) } end
local parabola = trilith.bilinear { curve = curve(table.unpack(points)), code = "eurocode8" }
near(parabola.yield_displacement, 2/3*d0, 1e-6) near(parabola.yield_force, F0)
-- ntc2018: F = 0.6 F0 at s = 1 - sqrt(0.4); k d0/F0 = 0.6/s; F/F0 = q (1 - sqrt(1 - 4/(3 q))) with q = k d0/F0.
local q = 0.6/(1 - math.sqrt(0.4))
local italian = trilith.bilinear { curve = curve(table.unpack(points)), code = "ntc2018" }
near(italian.stiffness, q*F0/d0, 1e-6) near(italian.yield_force, F0*q*(1 - math.sqrt(1 - 4/(3*q))), 1e-6)
-- Equal areas by construction.
for _, b in ipairs { parabola, italian } do
  near(b.yield_force*(d0 - b.yield_displacement/2), 2/3*F0*d0, 1e-6)
end

-- The drop: the force falls from 100 kN at 40 mm to 50 kN at 90 mm, so that 80 % are at 60 mm and 85 % at 55 mm.
local falling = curve({ 0.02, 8e4 }, { 0.04, 1e5 }, { 0.09, 5e4 })
near(trilith.bilinear { curve = falling }.ultimate_displacement, 0.06)
near(trilith.bilinear { curve = falling, code = "ntc2018" }.ultimate_displacement, 0.055)
near(trilith.bilinear { curve = falling, drop = 0.5 }.ultimate_displacement, 0.09)
assert(trilith.bilinear { curve = falling }.reached_drop == true)
-- A path by arc length that turns back counts up to its furthest displacement.
local back = curve({ 0.02, 8e4 }, { 0.04, 1e5 }, { 0.035, 9e4 }, { 0.09, 5e4 })
near(trilith.bilinear { curve = back }.ultimate_displacement, 0.06)

-- EN 1998-1 annex B.5. T = 2 pi sqrt(m/k) = 1 s is beyond TC = 0.6 s: equal displacement.
local spectrum = trilith.spectrum { code = "eurocode8", ground = "C", ag = 3 }
local mass = 1e7/(2*math.pi)^2
local long = trilith.bilinear { curve = own, mass = mass, spectrum = spectrum }
near(long.period, 1, 1e-9) near(long.target, spectrum.at(1)/(2*math.pi)^2, 1e-9)
near(long.demand_to_capacity, long.target/0.06, 1e-9)
-- A short period T = 0.3 s, with the ratio q = Se m/Fy = 2: target = Se (T/2 pi)^2/q (1 + (q - 1) TC/T).
local short = spectrum.at(0.3)*(0.3/(2*math.pi))^2
local light = curve({ short/2, 1 }, { 0.06, 1 + 1e-12 })
local m = (0.3/(2*math.pi))^2/(short/2)
near(trilith.bilinear { curve = light, mass = m, spectrum = spectrum }.target, short/2*(1 + 0.6/0.3), 1e-6)
-- A strong oscillator stays elastic; the participation factor leads back to the displacement of the structure.
local strong = curve({ 2*short, 4 }, { 0.2, 4 + 1e-11 })
near(trilith.bilinear { curve = strong, mass = m, spectrum = spectrum }.target, short, 1e-6)
near(trilith.bilinear { curve = strong, mass = m, spectrum = spectrum, participation = 1.3 }.target, 1.3*short, 1e-6)

near(trilith.drift_limit { mode = "shear" }, 0.004)
near(trilith.drift_limit { mode = "shear", state = "near collapse" }, 0.004*4/3)
near(trilith.drift_limit { mode = "flexure", height = 3, depth = 1.5 }, 0.016)
near(trilith.drift_limit { mode = "flexure", height = 3, depth = 1.5, secondary = true }, 0.024)

-- The report of a pushover is taken as it is: a block that slides at mu times its weight.
local model = trilith.model { name = "slider" }
model:material { name = "stone", density = 2000 }
model:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e8, mu = 0.5, beta = 1e-4 } }
model:block { name = "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
model:block { name = "block", width = 1, height = 0.5, at = { -0.5, 0 }, material = "stone" }
model:consolidate {}
local push = model:pushover { body = "block", displacement = 0.002 }
local slider = trilith.bilinear { curve = push, code = "ntc2018" }
near(slider.yield_force, 0.5*2000*0.5*9.80665, 0.03)
model:close()

refused("'curve' is missing, must be the report of m:pushover", trilith.bilinear, {})
refused("'curve' is 3", trilith.bilinear, { curve = 3 })
refused("has 1 points with increasing displacement", trilith.bilinear, { curve = curve { 0.01, 1 } })
refused("point 2 of 'curve' must be two numbers", trilith.bilinear, { curve = curve({ 0.01, 1 }, { 0.02, 0/0 }) })
refused("the largest force of 'curve' is not above 0", trilith.bilinear, { curve = curve({ 0.01, -1 }, { 0.02, -2 }) })
refused("lies below a straight line to its peak", trilith.bilinear, { curve = curve({ 0.01, 0.1 }, { 0.02, 1 }) })
refused("'drop' is 20, must be a share between 0 and 1", trilith.bilinear, { curve = own, drop = 20 })
refused("'spectrum' needs 'mass'", trilith.bilinear, { curve = own, spectrum = spectrum })
refused("must come from trilith.spectrum", trilith.bilinear, { curve = own, mass = 1, spectrum = { { 1, 2 } } })
refused("there is no 'euro' for the key 'code'", trilith.bilinear, { curve = own, code = "euro" })
refused("'mode' is missing, must be one of: flexure, shear", trilith.drift_limit, {})
refused("'height' is missing", trilith.drift_limit, { mode = "flexure" })
