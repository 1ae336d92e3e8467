-- Several numbers from several measured frequencies: blocks on joints with closed forms, in the plane and in space.
local trilith = require "trilith"

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(text, 1, true), ("expected '%s', got '%s'"):format(text, tostring(message)))
end

local function near(a, b, share)
  assert(math.abs(a - b) <= share*math.abs(b), ("%.10g is not near %.10g"):format(a, b))
end

-- A rigid block of width b, height h and thickness t on its joint: heave w^2 = kn A/m. Sway and rotation are coupled
-- by the distance h/2 of the joint from the centroid: (ks A - w^2 m)(kn I + ks A h^2/4 - w^2 J) = (ks A h/2)^2.
local density = 2400
local function closed_form(kn, ks, b, h, t)
  local A, I, m = b*t, t*b^3/12, density*b*h*t
  local J = m*(b^2 + h^2)/12
  local p = m*J
  local q = m*(kn*I + ks*A*h^2/4) + J*ks*A
  local r = ks*A*(kn*I + ks*A*h^2/4) - (ks*A*h/2)^2
  local root = math.sqrt(q^2 - 4*p*r)
  local function hertz(square) return math.sqrt(square)/(2*math.pi) end
  return { heave = hertz(kn*A/m), low = hertz((q - root)/(2*p)), high = hertz((q + root)/(2*p)) }
end

local function law(kn, ks)
  return trilith.bonded { kn = kn, ks = ks, mu = 0.6, beta = 1e-4, tension = 1e9, cohesion = 1e9 }
end

-- Plane: kn and ks from three frequencies, from starts that are off by factors of 3 and 5. The engine's joint has two
-- points per face half; its frequencies agree with the closed form within 0.05 %, and the squares of that with kn.
local kn, ks = 1.7e9, 2.4e8
local function block(n, s)
  local m = trilith.model { name = "block", thickness = 0.4, gravity = 0 }
  m:material { name = "stone", density = density }
  m:contact { between = { "*", "*" }, name = "mortar", law = law(n or 3*kn, s or 5*ks) }
  m:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
  m:block { name = "block", width = 0.4, height = 1.2, at = { -0.2, 0 }, material = "stone" }
  return m
end
local exact = closed_form(kn, ks, 0.4, 1.2, 0.4)
assert(exact.low < exact.heave)
local m = block()
local sorted = { exact.low, exact.heave, exact.high }
table.sort(sorted)
local found = m:calibrate { frequencies = sorted, vary = { "mortar.kn", "mortar.ks" } }
near(found.values["mortar.kn"], kn, 2e-3)
near(found.values["mortar.ks"], ks, 2e-3)
assert(found.rms < 1e-3 and found.rounds < 20)
for i, mode in ipairs(m:modes()) do near(mode.frequency, sorted[i], 1e-3) end -- the model keeps the result
-- Sensitivities of one mode over all stiffnesses add to 1/2, because f^2 is proportional to all of them together.
for _, row in ipairs(found.sensitivity) do near(row[1] + row[2], 0.5, 1e-4) end
assert(tostring(found):find "mortar.kn: ", tostring(found))

-- One number for contradicting frequencies: all are proportional to its root, so the factor is the geometric mean of
-- the squares of their ratios. Its deviation is twice the scatter over the root of three.
local before = {}
for i, mode in ipairs(m:modes()) do before[i] = mode.frequency end
local start, heave = found.values["mortar.kn"], { block = { x = 0, y = 1 } }
found = m:calibrate { frequencies = { 1.1*before[1], 1.2*before[2], 0.95*before[3] }, scatter = 0.02,
  vary = { { "mortar.kn", "mortar.ks" } } }
local factor = (1.1*1.2*0.95)^(2/3)
near(found.factors[1], factor, 1e-3)
near(found.values["mortar.kn"], factor*start, 1e-3)
near(found.values["mortar.ks"]/found.values["mortar.kn"], ks/kn, 5e-3) -- their ratio remains
near(found.deviations[1], 2*0.02/math.sqrt(3), 1e-3)
assert(found.rms > 0.05)

-- Wrong input, after which the model has its numbers from before.
local kept = m:modes()[1].frequency
local both = { "mortar.kn", "mortar.ks" }
local function wrong(text, options) refused(text, m.calibrate, m, options) end
wrong("'frequency' and 'frequencies' are given", { frequency = 10, frequencies = { 10 }, vary = both })
wrong("'frequencies' is a table, must be a list of numbers", { frequencies = {}, vary = both })
wrong("frequencies[2]", { frequencies = { 10, -3 }, vary = both })
wrong("2 numbers vary and 1 frequencies are given", { frequencies = { 10 }, vary = both })
wrong("'modes' and 'shapes' are given", { frequencies = { 10 }, modes = { 1 }, shapes = { heave }, vary = "mortar.kn" })
wrong("'modes' is a list of 1, must be a list with one entry for each of the 2", { frequencies = { 10, 20 },
  modes = { 1 }, vary = both })
wrong("'modes[2]'", { frequencies = { 10, 20 }, modes = { 1, 1 }, vary = both })
wrong("'shapes[1]'", { frequencies = { 10 }, shapes = { { block = { x = 0, y = 0 } } }, vary = "mortar.kn" })
wrong("frequency 2 needs mode 9, and there are 3 modes", { frequencies = { 10, 20 }, modes = { 1, 9 }, vary = both })
wrong("'mortar.kn' occurs twice", { frequencies = { 10, 20 }, vary = { "mortar.kn", "mortar.kn" } })
wrong("there is no stiffness 'mortar.kx'; it may vary mortar.kn, mortar.ks", { frequencies = { 10 },
  vary = "mortar.kx" })
wrong("'vary' is missing", { frequencies = { 10 } })
wrong("beyond the factor 2", { frequencies = { 5*kept }, vary = { both }, range = 2 })
wrong("unknown key 'between'", { frequencies = { 10 }, vary = "mortar.kn", between = { 1e8, 1e9 } })
near(m:modes()[1].frequency, kept, 1e-12)
-- Heave does not depend on ks at all; a mode that it does not move cannot give it.
wrong("no frequency depends on mortar.ks", { frequencies = { exact.heave, exact.heave }, vary = both,
  shapes = { heave, heave } })
m:close()

-- Two blocks on each other, whose numbers in the list of modes change while the stiffnesses do: by shapes. Masses M on
-- springs k1 and k2 in series: w^2 = (k1 + 2 k2 -+ sqrt(k1^2 + 4 k2^2))/(2 M), and y1/y2 = 1 - M w^2/k2.
local k1, k2, M1 = 3e9, 8e8, 2000
m = trilith.model { name = "two blocks", thickness = 1, gravity = 0 }
for i = 0, 2 do m:material { name = "stone " .. i, density = 2000 } end
m:contact { between = { "stone 0", "stone 1" }, name = "lower", law = law(0.1*k1, 1e9) }
m:contact { between = { "stone 1", "stone 2" }, name = "upper", law = law(4*k2, 1e9) }
m:block { name = "base", width = 3, height = 0.2, at = { -1, -0.2 }, material = "stone 0", support = "fixed" }
for i = 1, 2 do
  m:block { name = "block " .. i, width = 1, height = 1, at = { 0, i - 1 }, material = "stone " .. i }
end
local squares, measured, shapes = {}, {}, {}
for i, sign in ipairs { 1, -1 } do -- the higher mode first
  squares[i] = (k1 + 2*k2 + sign*math.sqrt(k1^2 + 4*k2^2))/(2*M1)
  measured[i] = math.sqrt(squares[i])/(2*math.pi)
  shapes[i] = { ["block 1"] = { x = 0, y = 1 - M1*squares[i]/k2 }, ["block 2"] = { x = 0, y = 1 } }
end
local numbers = {}
for i, mode in ipairs(m:modes { count = 6 }) do
  if math.abs(mode.shape["block 2"].y) > 0.1 then numbers[#numbers + 1] = i end
end
-- Two frequencies have two solutions, k1 and k2 or 2 k2 and k1/2, and the start decides. Their shapes tell them apart.
local fit = { frequencies = measured, shapes = shapes, vary = { "lower.kn", "upper.kn" } }
found = m:calibrate(fit)
near(found.values["lower.kn"], 2*k2, 1e-3)
near(found.values["upper.kn"], k1/2, 1e-3)
assert(found.likeness[1] < 0.97 and found.likeness[2] < 0.97)
m:change { law = "lower", kn = 3*k1 }
m:change { law = "upper", kn = 0.7*k2 }
found = m:calibrate(fit)
near(found.values["lower.kn"], k1, 1e-3)
near(found.values["upper.kn"], k2, 1e-3)
for i = 1, 2 do near(found.likeness[i], 1, 1e-6) end
assert(found.modes[1] ~= numbers[2] or found.modes[2] ~= numbers[1], "the numbers of the modes have changed")
-- Equal parts of both modes along y and of modes along x resemble none of them.
refused("resembles no mode", m.calibrate, m, { frequencies = { measured[2] }, vary = { { "lower.kn", "lower.ks",
  "upper.kn", "upper.ks" } }, shapes = { { ["block 1"] = { x = 1, y = 1 }, ["block 2"] = { x = 0.5, y = 0.2 },
  ["no block"] = { x = 9, y = 9 } } } })
m:close()

-- In space: a block of width b along x and c along y on a joint of both. Heave w^2 = kn A/m; twist
-- w^2 = ks (b^3 c + b c^3)/12/J; sway in each direction as in the plane.
local b, c, h = 0.4, 0.3, 0.8
local function solid()
  local s = trilith.model { name = "solid", dim = 3, gravity = 0 }
  s:material { name = "stone", density = density }
  s:contact { between = { "*", "*" }, name = "mortar", law = law(0.4*kn, 6*ks) }
  s:block { name = "base", size = { 2, 2, 0.2 }, at = { -1, -1, -0.2 }, material = "stone", support = "fixed" }
  s:block { name = "block", size = { b, c, h }, at = { -b/2, -c/2, 0 }, material = "stone" }
  return s
end
local along, across = closed_form(kn, ks, b, h, c), closed_form(kn, ks, c, h, b)
local mass = density*b*c*h
local twist = math.sqrt(ks*b*c*(b^2 + c^2)/12/(mass*(b^2 + c^2)/12))/(2*math.pi)
near(twist, math.sqrt(ks*b*c/mass)/(2*math.pi), 1e-12)
local all = { along.heave, along.low, along.high, across.low, across.high, twist }
table.sort(all)
m = solid()
found = m:calibrate { frequencies = all, vary = { "mortar.kn", "mortar.ks" } }
near(found.values["mortar.kn"], kn, 5e-3)
near(found.values["mortar.ks"], ks, 5e-3)
for i, mode in ipairs(m:modes { count = 6 }) do near(mode.frequency, all[i], 3e-3) end
-- One frequency in space: heave by its shape gives kn alone.
local up
for _, mode in ipairs(m:modes { count = 6 }) do
  if math.abs(mode.shape.block.z) > 0.9 then up = mode.shape end
end
found = m:calibrate { frequency = 1.5*along.heave, vary = "mortar.kn", shape = up }
near(found.value, 2.25*kn, 5e-3)
m:close()

-- Any numbers, with a model that is built for each trial: E of a mast with a mass at its head on a foot that
-- turns. The lowest frequency of a mass M on a light mast: w^2 = 1/(M (L^3/(3 E I) + L^2/k)).
local E, k, L, M, inertia = 3e10, 4e6, 3, 5000, 0.2*0.2^3/12
local function mast(length, head)
  return function(v)
    local p = trilith.model { name = "mast", thickness = 1, gravity = 0 }
    p:material { name = "concrete", density = 1e-3, E = v.E }
    p:block { name = "ground", width = 1, height = 0.5, at = { -0.5, -2 }, material = "concrete", mass = 1,
      support = "fixed" }
    local frame = p:frame { name = "mast", material = "concrete", floating = true,
      joints = { foot = { at = { 0, 0 }, support = { x = "fixed", y = "fixed" } },
        head = { at = { 0, length }, mass = head, inertia = 1e-3 } },
      members = { { from = "foot", to = "head",
        section = trilith.rectangle_section { width = 0.2, depth = 0.2 } } } }
    p:bearing { name = "hinge", between = { "ground", frame }, from = { 0, -1.5 }, to = { 0, 0 },
      turning = trilith.linear { stiffness = v.k } }
    return p
  end
end
local function of_mast(length, head)
  return math.sqrt(1/(head*(length^3/(3*E*inertia) + length^2/k)))/(2*math.pi)
end
refused("'build' is missing", trilith.calibrate, { vary = { E = 1 }, frequencies = { 1 } })
refused("'build' returned 3, must be a model", trilith.calibrate, { vary = { E = 1 }, frequencies = { 1 },
  build = function() return 3 end })
refused("'vary' is missing", trilith.calibrate, { frequencies = { 1 }, build = mast(L, M) })
refused("vary.E", trilith.calibrate, { vary = { E = -1 }, frequencies = { 1 }, build = mast(L, M) })
refused("must be start values by name", trilith.calibrate, { vary = { 1e9 }, frequencies = { 1 }, build = mast(L, M) })
-- E with k known, by its closed form. Tension of the mast is far stiffer than bending.
found = trilith.calibrate { build = function(v) return mast(L, M) { E = v.E, k = k } end, vary = { E = 1e10 },
  frequencies = { of_mast(L, M) } }
near(found.values.E, E, 1e-3)
