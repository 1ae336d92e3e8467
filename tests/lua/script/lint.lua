-- Allowed but implausible numbers get a note; m:lint() lists these notes, all errors, and contacts with almost no
-- damping.
local trilith = require "trilith"
local deg = trilith.units "deg"

local function count(list, text)
  local n = 0
  for _, line in ipairs(list) do if line:find(text, 1, true) then n = n + 1 end end
  return n
end
local function told(list, text, times)
  assert(count(list, text) == times, ("not %d times '%s':\n%s"):format(times, text, table.concat(list, "\n")))
end
local function has(list, text) told(list, text, 1) end
local function lacks(list, text) told(list, text, 0) end

-- Two blocks on a base; `odd` sets the implausible value.
local function model(odd)
  local m = trilith.model { name = "lint" }
  m:material { name = "stone", density = odd.density or 2400 }
  m:contact { between = { "*", "*" }, name = "joint",
              law = trilith.frictional { kn = 1e9, ks = 5e8, mu = odd.mu or 0.6, beta = odd.beta or 1e-3 } }
  m:block { name = "base", width = 4, height = 1, at = { -1, -1 }, material = "stone", support = "fixed" }
  m:block { name = "low", width = 1, height = 0.5, material = "stone" }
  m:block { name = "top", width = 1, height = 0.5, at = { 0, 0.5 }, material = "stone", density = odd.own }
  return m
end

-- Each note is reported once, when the value is set, and by lint; values just within the usual range get none.
local friction = "contact law 'joint': mu = 35 is above the usual 2: it is the tangent of the friction angle"
local damping = "contact law 'joint': beta = 1 s is above the usual 0.1 s: it is 2*zeta/omega"
local density = "material 'stone': density = 2.4 kg/m3 is below the usual 25 kg/m3: is it in t/m3 or g/cm3?"
for _, case in ipairs {
  { { mu = 35 }, friction }, { { beta = 1 }, damping }, { { density = 2.4 }, density },
  { { own = 2.4 }, "body 'top': density = 2.4 kg/m3 is below the usual 25 kg/m3" },
} do
  local m = model(case[1])
  has(m.notes, case[2])
  has(m:lint(), case[2])
  assert(#m.notes == 1)
end
local usual = model { mu = 2, beta = 0.1, density = 25, own = 25 }
assert(#usual.notes == 0)
lacks(usual:lint(), "usual")

-- A body of 5,000 m has a small side too; a fixed one may be ground.
for _, case in ipairs { { 2, 5000, 1 }, { 2, 900, 0 }, { 3, 5000, 1 }, { 3, 900, 0 }, { 2, 5000, 0, "fixed" } } do
  local dim, size, notes, support = table.unpack(case)
  local m = trilith.model { name = "long", dim = dim }
  m:block { name = "wall", width = dim == 2 and size or nil, height = dim == 2 and 0.3 or nil, density = 2000,
    size = dim == 3 and { 0.3, size, 0.3 } or nil, at = dim == 2 and { 0, 0 } or { 0, 0, 0 }, support = support,
    floating = not support or nil }
  assert(#m.notes == notes, table.concat(m.notes, "\n"))
  if notes == 1 then has(m.notes, "body 'wall': greatest side = 5000 m is above the usual 1000 m: is it in mm?") end
end

local sliding = model {}
sliding:bearing { name = "B", between = { "low", "top" }, at = { 0.5, 0.5 },
                  along = trilith.friction { mu = 35, stiffness = 1e6 }, axial = trilith.linear { stiffness = 1e6 } }
has(sliding.notes, "bearing 'B': mu = 35 is above the usual 2")
has(sliding:lint(), "bearing 'B': mu = 35 is above the usual 2")

local turned = model {}
turned:run { duration = 1e-3 }
turned:tilt { rate = 0.5, by = 30*deg }
lacks(turned.notes, "tilt")
lacks(turned:lint(), "tilt")
turned:tilt { rate = 4, by = 30 }
has(turned.notes, "tilt: rate = 4 rad/s is above the usual 0.5 rad/s: is it in degrees?")
has(turned.notes, "tilt: by = 30 rad is above the usual 3.2 rad: is it in degrees?")
has(turned:lint(), "tilt: rate = 4 rad/s is above the usual 0.5 rad/s")

-- A law changed later is checked with its current values.
local changed = model { mu = 35 }
changed:run { duration = 1e-3 }
changed:change { law = "joint", mu = 0.6 }
lacks(changed:lint(), "mu = ")
changed:change { law = "joint", mu = 40 }
has(changed:lint(), "contact law 'joint': mu = 40 is above the usual 2")

-- All errors are listed, and nothing is thrown; the model stays open and can be corrected.
local wrong = model { mu = 35 }
wrong:contact { between = { "stone", "qq" }, law = "joint" }
wrong:block { name = "in", width = 1, height = 0.5, at = { 0.5, 0.25 }, material = "stone" }
wrong:block { name = "up", width = 1, height = 0.5, at = { 0, 5 }, material = "stone" }
wrong:block { name = "higher", width = 1, height = 0.5, at = { 0, 7 }, material = "stone" }
wrong:bearing { name = "B", between = { "low", "top" }, at = { 0.5, 0.5 }, along = trilith.linear { stiffness = 1e6 },
                limit = { along = 0.1 }, becomes = "C" }
local found = wrong:lint()
has(found, "contact of 'stone' and 'qq': there is no material, group or body 'qq'")
has(found, "bodies 'low' and 'in' overlap by 0.25 m")
has(found, "bodies 'top' and 'in' overlap by 0.25 m")
has(found, "body 'up' has no support")
has(found, "body 'higher' has no support")
has(found, "bearing 'B': becomes bearing 'C', which does not exist")
has(found, friction)
assert(#found == 7 and found.text:find "^%- contact of", found.text)
local good, message = pcall(wrong.run, wrong, { duration = 1 })
assert(not good and message:find(found[1], 1, true), message)
wrong:block { name = "more", width = 1, height = 0.5, at = { 9, 9 }, material = "stone" }
has(wrong:lint(), "body 'more' has no support")

local empty = trilith.model {}
has(empty:lint(), "model: there is no body; add at least one")
for i = 1, 30 do empty:body { name = "b" .. i, outline = { { i, 0 }, { i + 0.5, 0 }, { i, 1 } }, mass = 1 } end
found = empty:lint()
has(found, "and 20 more errors that prevent building the model")
assert(#found == 11)

-- Contacts damped by less than 1 % of critical. A single moving block: omega = sqrt(kn b/m); both blocks move: m1
-- m2/(m1 + m2).
local omega = math.sqrt(1e9 / (2400 * 0.5))
lacks(model { beta = 2 * 0.0101 / omega }:lint(), "of critical")
local one = model { beta = 2 * 0.009 / omega }:lint()
has(one, "law 'joint' damps 1 of 2 contacts by less than 1 % of critical ('base' and 'low' by 0.9 %, with beta = ")
has(one, ("beta = %.2g s gives 10 %% of critical"):format(0.2 / omega))
has(model { beta = 2 * 0.009 / omega / math.sqrt(2) }:lint(), "law 'joint' damps 2 of 2 contacts by less than 1 %")
has(model { beta = 0 }:lint(),
    ("has no damping (beta = 0): bodies that strike it bounce for ever; beta = %.2g s gives 10 %%"):format(0.2 / omega))

-- Elastic slip of more than 0.001 of the expected slip: the blocks weigh 11.8 kN, which is 16.6 kPa on the side of a
-- square of their area. 0.6 times this pressure over 5e8 Pa/m is 2e-5 m. The base is fixed, and heavier.
lacks(model {}:lint(), "before it slides")
lacks(model {}:lint { slip = 0.021 }, "before it slides")
has(model {}:lint { slip = 0.019 }, "law 'joint' deforms by 2e-05 m before it slides ('low' under its own weight)")
has(model {}:lint { slip = 0.01 }, "more than 0.001 of a slip of 0.01 m")
local refused = { { { slip = 0 }, "'slip' is 0, must be a number in m, above 0" },
  { { slide = 1 }, "unknown key 'slide'" }, { 1, "takes a table" } }
for _, case in ipairs(refused) do
  local done, said = pcall(model {}.lint, model {}, case[1])
  assert(not done and said:find(case[2], 1, true), said)
end

-- The same in space for closed contacts: a cube on a plate, omega = sqrt(kn A/m).
do
  local function cube(beta)
    local m = trilith.model { name = "solid", dim = 3 }
    m:material { name = "stone", density = 2400 }
    m:contact { between = { "*", "*" }, name = "joint",
                law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = beta } }
    m:block { name = "plate", size = { 3, 3, 1 }, at = { -1, -1, -1 }, material = "stone", support = "fixed" }
    m:block { name = "cube", size = { 1, 1, 0.5 }, material = "stone" }
    m:consolidate { rest = { ratio = 1e-5 } }
    return m:lint()
  end
  lacks(cube(2 * 0.0101 / omega), "of critical")
  has(cube(2 * 0.009 / omega), "law 'joint' damps 1 of 1 contacts by less than 1 % of critical")
end

-- A gap that is too wide between faces of a bonding law gets a note, in the plane and in space; faces in contact, or
-- with the usual distance of other courses, get none.
for _, dim in ipairs { 2, 3 } do
  for gap, expected in pairs { [0] = 0, [1e-6] = 0, [1e-3] = 1, [0.3] = 0 } do
    local w = trilith.model { name = "gap", dim = dim, gravity = 0 }
    w:material { name = "stone", density = 2000 }
    w:contact { between = { "*", "*" }, name = "mortar", law = trilith.bonded { kn = 1e9, ks = 4e8, mu = 0.6,
      tension = 1e5, cohesion = 1e5 } }
    for i = 0, 2 do
      local row = { name = "b" .. i, at = { i*1 + (i == 2 and gap or 0), 0, dim == 3 and 0 or nil }, material = "stone",
        width = dim == 2 and 1 or nil, height = dim == 2 and 1 or nil, size = dim == 3 and { 1, 1, 1 } or nil,
        support = i == 0 and "fixed" or nil, floating = true }
      w:block(row)
    end
    w:run { duration = 1e-3 }
    assert(#w.notes == expected, ("dim %d, gap %g: %d notes"):format(dim, gap, #w.notes))
    if expected == 1 then
      assert(w.notes[1] == "law 'mortar' leaves a pair of faces without a bond, because 'b1' and 'b2' are 1 mm "
        .. "apart. Faces are bonded at a gap of at most 1e-5 of the smaller body's size, and 1e-3 for fresh mortar "
        .. "(m:consolidate{ fresh = true }); close the gap, or give another law there", w.notes[1])
    end
    w:close()
  end
end
