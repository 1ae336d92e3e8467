-- Damping by two ratios and over a band, stiffness from a frequency, pushover by arc length, removed beams.
local trilith = require "trilith"

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

local function near(a, b, share)
  assert(math.abs(a - b) <= share*math.abs(b), ("%.10g is not near %.10g"):format(a, b))
end

-- Rayleigh damping: both ratios at both frequencies, by the closed form and by the model's modes.
local r = trilith.rayleigh { ratios = { 0.02, 0.05 }, frequencies = { 3, 30 } }
for f, ratio in pairs { [3] = 0.02, [30] = 0.05 } do
  near(r.mass_damping/(4*math.pi*f) + math.pi*f*r.beta, ratio, 1e-12)
end
local swapped = trilith.rayleigh { ratios = { 0.05, 0.02 }, frequencies = { 30, 3 } }
assert(swapped.beta == r.beta and swapped.mass_damping == r.mass_damping)
refused("both frequencies are 3 Hz", trilith.rayleigh, { ratios = { 0.02, 0.05 }, frequencies = { 3, 3 } })
refused("need a mass part below 0", trilith.rayleigh, { ratios = { 0.001, 0.05 }, frequencies = { 3, 30 } })
refused("need a stiffness part below 0", trilith.rayleigh, { ratios = { 0.05, 0.001 }, frequencies = { 3, 30 } })
refused("'ratios' is missing", trilith.rayleigh, { frequencies = { 3, 30 } })
refused("unknown key 'frequency'", trilith.rayleigh, { ratios = { 0.02, 0.05 }, frequency = { 3, 30 } })

-- Stiffness of joints from a wall: units and joints in series; a power of the stress between two moduli.
local joint = trilith.joint_stiffness { wall_modulus = 566e6, unit_modulus = 15.5e9, course_height = 0.1 }
near(0.1/566e6, 0.1/15.5e9 + 1/joint.kn, 1e-12)
near(joint.ks, 0.4*joint.kn, 1e-12)
near(trilith.joint_stiffness { wall_modulus = 1e9, course_height = 0.2 }.kn, 5e9, 1e-12)
local rows = { { 5e5, 8e8 }, { 2e5, 4e8 } }
local function modulus(stress)
  return trilith.joint_stiffness { wall_modulus = rows, stress = stress, course_height = 0.1, shear_ratio = 1 }
    .wall_modulus
end
near(modulus(2e5), 4e8, 1e-12)
near(modulus(5e5), 8e8, 1e-12)
near(modulus(math.sqrt(2e5*5e5)), math.sqrt(4e8*8e8), 1e-12)
near(modulus(12.5e5), 16e8, 1e-12) -- beyond the rows the same power
refused("'unit_modulus' is 1e+09 Pa, must be above the modulus of the wall, 2e+09 Pa", trilith.joint_stiffness,
  { wall_modulus = 2e9, unit_modulus = 1e9, course_height = 0.1 })
refused("'course_height' is missing", trilith.joint_stiffness, { wall_modulus = 2e9 })
refused("'stress' needs rows", trilith.joint_stiffness, { wall_modulus = 2e9, course_height = 0.1, stress = 1e5 })
refused("needs at least two rows", trilith.joint_stiffness,
  { wall_modulus = { { 1e5, 1e9 } }, course_height = 0.1, stress = 1e5 })
refused("two rows of 'wall_modulus' have the stress 100000 Pa", trilith.joint_stiffness,
  { wall_modulus = { { 1e5, 1e9 }, { 1e5, 2e9 } }, course_height = 0.1, stress = 1e5 })
refused("row 2 of 'wall_modulus'", trilith.joint_stiffness,
  { wall_modulus = { { 1e5, 1e9 }, 2e9 }, course_height = 0.1, stress = 1e5 })

local function mast(material, model)
  local options = { name = "mast", thickness = 1, gravity = 0 }
  for k, v in pairs(model or {}) do options[k] = v end
  local m = trilith.model(options)
  local steel = { name = "steel", density = 7850, E = 2.1e11 }
  for k, v in pairs(material) do steel[k] = v end
  m:material(steel)
  m:frame { name = "mast", material = "steel", floating = true,
            joints = { foot = { at = { 0, 0 }, support = "fixed" }, head = { 0, 3 } },
            members = { { from = "foot", to = "head",
                          section = trilith.rectangle_section { width = 0.1, depth = 0.2 } } } }
  return m
end

local m = mast({ beta = r.beta }, { mass_damping = r.mass_damping })
for _, d in ipairs(m:damping { count = 3 }) do
  near(d.ratio, r.mass_damping/(4*math.pi*d.frequency) + math.pi*d.frequency*r.beta, 2e-3)
end
m:close()

-- Band damping: constant for the modes within the band, less outside; the step is reported with and without it.
m = mast { band_damping = { ratio = 0.03, from = 10, to = 400 } }
local damping = m:damping { count = 4 }
for i = 1, 3 do near(damping[i].bands, 0.03, 0.1) end
near(damping[1].ratio, damping[1].bands, 1e-6)
assert(damping.step < damping.unbanded_step and damping.step > 0.85*damping.unbanded_step)
assert(tostring(damping):find("band of 3 %% from 10 to 400 Hz: %d branches"), tostring(damping))
m:close()
refused("its end must be above its beginning", mast, { band_damping = { ratio = 0.03, from = 10, to = 4 } })
refused("'ratio' is 0.5", mast, { band_damping = { ratio = 0.5, from = 1, to = 4 } })
refused("band_damping", mast, { band_damping = 0.03 })

-- A rigid block on its joint, case M4 without weight: the rocking frequency determines the joint's stiffness.
local function block()
  local b = trilith.model { name = "block", thickness = 0.4, gravity = 0 }
  b:material { name = "stone", density = 2400 }
  b:contact { between = { "*", "*" }, name = "mortar", law = trilith.bonded {
    kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4, tension = 1e9, cohesion = 1e9 } }
  b:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
  b:block { name = "block", width = 0.4, height = 1.2, at = { -0.2, 0 }, material = "stone" }
  return b
end
m = block()
near(m:modes()[1].frequency, 15.0450, 5e-4)
refused("there is no stiffness 'mortar.kx'; it may vary mortar.kn, mortar.ks", m.calibrate, m,
  { frequency = 20, vary = "mortar.kx" })
refused("never 200 Hz", m.calibrate, m, { frequency = 200, vary = "mortar.kn", between = { 1e8, 1e10 } })
refused("it would have to be softer", m.calibrate, m, { frequency = 1, vary = "mortar.kn", between = { 1e9, 1e10 } })
refused("'frequency' is missing", m.calibrate, m, { vary = "mortar.kn" })
refused("'vary' is missing", m.calibrate, m, { frequency = 20 })
refused("unknown key 'varies'", m.calibrate, m, { frequency = 20, varies = "mortar.kn" })
refused("'scatter' is for a fit to several 'frequencies'", m.calibrate, m,
  { frequency = 20, vary = "mortar.kn", scatter = 0.01 })
refused("there are 3 modes, none is number 4", m.calibrate, m, { frequency = 20, vary = "mortar.kn", mode = 4 })
near(m:modes()[1].frequency, 15.0450, 5e-4) -- rejected calls do not change it
-- Four times all stiffnesses: twice all frequencies.
local found = m:calibrate { frequency = 2*15.0450, vary = { "mortar.kn", "mortar.ks" } }
near(found.value, 4e9, 1e-3)
near(found.values["mortar.ks"], 1.6e9, 1e-3)
near(m:modes()[1].frequency, 30.09, 2e-4)
assert(tostring(found):find "mortar.kn", tostring(found))
-- The vertical mode depends on kn alone: w^2 = kn A/m. It is identified by its shape although its number changes.
local heave = m:modes()[2].shape
found = m:calibrate { frequency = 93.7829, vary = "mortar.kn", shape = heave }
near(found.value, 1e9, 1e-3)
m:close()

-- Two stacked blocks on the mortar, and one next to them on a softer joint. The heave of all three resembles most the
-- mode of the two blocks; once the mortar is so stiff that the lower block stands still, it resembles the mode of the
-- single block.
local three = trilith.model { name = "three blocks", thickness = 1, gravity = 0 }
for i = 0, 3 do three:material { name = "stone " .. i, density = 2000 } end
for name, of in pairs { mortar = { 0, 1, 1e9 }, upper = { 1, 2, 1e9 }, other = { 0, 3, 1e8 } } do
  three:contact { between = { "stone " .. of[1], "stone " .. of[2] }, name = name, law = trilith.bonded {
    kn = of[3], ks = of[3], mu = 0.6, beta = 1e-6, tension = 1e9, cohesion = 1e9 } }
end
three:block { name = "base", width = 6, height = 0.2, at = { -1, -0.2 }, material = "stone 0", support = "fixed" }
for i, at in ipairs { { 0, 0 }, { 0, 1 }, { 3, 0 } } do
  three:block { name = "block " .. i, width = 1, height = 1, at = at, material = "stone " .. i }
end
local up = { ["block 1"] = { x = 0, y = 0.55 }, ["block 2"] = { x = 0, y = 0.55 }, ["block 3"] = { x = 0, y = 0.63 } }
local other = math.sqrt(1e8/2000)/(2*math.pi)
local function fit() return three:calibrate { frequency = 0.9*other, vary = "mortar.kn", shape = up } end
local ok, said = pcall(fit)
local from, to, soft, stiff = tostring(said):match(
  "calibrate: the frequency falls from ([%d.]+) to ([%d.]+) Hz while mortar.kn rises from ([%d.e+]+) Pa/m "
  .. "to ([%d.e+]+) Pa/m; give a mode by its number, or narrower bounds")
assert(not ok and from, tostring(said))
near(tonumber(to), other, 1e-4)
assert(tonumber(from) > other and tonumber(soft) < tonumber(stiff))
near(three:modes { count = 3 }[3].frequency, other, 1e-6) -- and the model is unchanged
assert(three:calibrate { frequency = 10, vary = "mortar.kn", mode = 1 }.value > 0)
three:close()

-- Two pinned bars, b = 10, h = 0.5, EA = 1e6: P = 2 EA (L - l)/L y/l, with the remaining height y. Past both limit
-- points.
m = trilith.model { name = "truss", thickness = 1, gravity = 0 }
m:material { name = "m", density = 1000, E = 1e9 }
local bar = trilith.section { area = 1e-3, inertia = 0.1, depth = 0.01 }
local truss = m:frame { name = "truss", material = "m", floating = true,
  joints = { a = { at = { -10, 0 }, support = "fixed" }, b = { at = { 0, 0.5 }, support = { rotation = "fixed" } },
             c = { at = { 10, 0 }, support = "fixed" } },
  members = { { from = "a", to = "b", section = bar, pinned = { "from", "to" }, divisions = 2 },
              { from = "b", to = "c", section = bar, pinned = { "from", "to" }, divisions = 2 } } }
refused("'rate' is given, which is for control = \"time\"", m.pushover, m,
  { body = truss, at = { 0, 0.5 }, direction = "-y", control = "arc", rate = 1, displacement = 1.2 })
refused("'arc' is given, which is for control = \"arc\"", m.pushover, m,
  { body = truss, at = { 0, 0.5 }, direction = "-y", rate = 1, arc = 1, displacement = 1.2 })
refused("'control' is 'force'", m.pushover, m, { body = truss, at = { 0, 0.5 }, control = "force", displacement = 1 })
local file = os.tmpname()
os.remove(file)
m:results { file = file .. ".h5", frames = 1, histories = 1 }
local sunk = m:history { name = "sunk", of = function() return select(2, truss:point { 0, 0.5 }) end }
local report = m:pushover { body = truss, at = { 0, 0.5 }, direction = "-y", control = "arc", displacement = 1.2,
                            arc = 0.003 }
near(sunk.max, 0.5, 1e-9) -- the histories and the file contain the full displacement
near(sunk.min, 0.5 - report.displacement, 1e-9)
local length = math.sqrt(100.25)
local function force(y)
  local l = math.sqrt(100 + y^2)
  return 2e6*(length - l)/length*y/l
end
assert(report.limit == "displacement" and m.time == 1 and #report.curve.force > 20)
local signs = { up = 0, down = 0 }
for i, f in ipairs(report.curve.force) do
  assert(math.abs(f - force(0.5 - report.curve.displacement[i])) < 1e-4*96, i)
  signs[f >= 0 and "up" or "down"] = signs[f >= 0 and "up" or "down"] + 1
end
assert(signs.down > 3, "it has been held back while it snapped through")
-- y^3 (1 + ...) = ...: y = sqrt(l^2 - b^2) with l^3 = L b^2.
local l = (length*100)^(1/3)
local most = force(math.sqrt(l^2 - 100))
assert(#report.limits == 2 and report.limits[1].highest and not report.limits[2].highest)
near(report.limits[1].force, most, 2e-3)
near(report.limits[2].force, -most, 2e-3)
near(report.force, force(0.5 - report.displacement), 1e-4)
-- The load remains, and the state is in equilibrium under it.
report = m:consolidate { integrator = "static" }
assert(report.rests and report.ratio < 1e-7)
refused("there is a load or push 'pushover'", m.pushover, m,
  { body = truss, at = { 0, 0.5 }, direction = "-y", control = "arc", displacement = 1 })
m:close()

-- I10: a rigid block on a joint without tensile strength, pushed at half of its height; the falling branch.
m = trilith.model { name = "rocking", thickness = 0.5 }
m:material { name = "stone", density = 2000 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 1e8, mu = 2 } }
m:block { name = "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
local rocking = m:block { name = "block", width = 0.5, height = 2, at = { -0.25, 0 }, material = "stone" }
m:consolidate { integrator = "static" }
report = m:pushover { body = rocking, control = "arc", displacement = 0.12, arc = 1e-4 }
near(report.peak_force, 1791.3, 0.01)
near(report.drift_at_peak, 0.02157, 0.15)
assert(report.force < 0.8*report.peak_force, "it has gone down the falling branch")
-- Rotation about the edge: a displacement of the centroid of about 1 m times the rotation.
near(rocking.rotation, -0.12, 0.05)
m:close()

-- A rigid arch loaded off its crown: a mechanism from its peak load on, whose force falls as its hinges move.
m = trilith.model { name = "arch", thickness = 1 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 5e10, mu = 2 } }
m:arch { name = "arch", voussoirs = 13, radius = 1, thickness = 0.2, sub_edges = 2, abutments = true,
         material = "stone", fixed = "abutments" }
m:consolidate { integrator = "static" }
report = m:pushover { body = "arch.v4", direction = "-y", control = "arc", displacement = 0.1, drop = 0.8, arc = 5e-5 }
assert(report.limit == "drop" and report.limits[1].highest and report.displacement_at_peak < 0.1*report.displacement)
near(report.force, 0.8*report.peak_force, 0.02)
local curve, peak = report.curve, false
for i = 2, #curve.force do
  assert(curve.displacement[i] > curve.displacement[i - 1])
  assert(not peak or curve.force[i] < curve.force[i - 1], "the branch falls all the way")
  peak = peak or curve.force[i] == report.peak_force
end
assert(m:consolidate { integrator = "static" }.rests) -- an equilibrium, although unstable
m:close()

-- A beam is removed: its stored energy is dissipated, and its state reports the removal.
refused("never loses its moment", trilith.end_hinge, { sagging = 1e5, becomes = "removed" })
refused("'becomes' is 'gone'", trilith.end_hinge, { sagging = 1e5, ultimate = 0.01, becomes = "gone" })
