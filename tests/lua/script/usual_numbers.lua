-- Numbers off by a factor of a thousand, small gaps and missing fields: each gets a note or message, and usual values
-- get none.
local trilith = require "trilith"

local function model(dim)
  local m = trilith.model { name = "usual", dim = dim }
  m:material { name = "stone", density = 2400, E = 1e10, nu = 0.2 }
  return m
end
local function noted(m, text)
  for _, note in ipairs(m.notes) do
    if note:find(text, 1, true) then return true end
  end
  return false
end
local function expect(m, text, told, what)
  if noted(m, text) ~= told then
    error(("%s: '%s' is%s told\n%s"):format(what, text, told and " not" or "", table.concat(m.notes, "\n")), 2)
  end
end

-- Contact laws: { maker, numbers, the key that is off by a million or 1e9, its factor }.
local laws = {
  { trilith.frictional, { kn = 10e9, ks = 5e9, mu = 0.6, beta = 1e-5 }, "kn", 1e-9 },
  { trilith.frictional, { kn = 10e9, ks = 5e9, mu = 0.6, beta = 1e-5 }, "ks", 1e-9 },
  { trilith.bonded, { kn = 1e9, ks = 5e8, mu = 0.6, tension = 0.2e6, cohesion = 0.3e6, beta = 1e-4 }, "tension", 1e-6 },
  { trilith.bonded, { kn = 1e9, ks = 5e8, mu = 0.6, tension = 0.2e6, cohesion = 0.3e6, beta = 1e-4 },
    "cohesion", 1e-6 },
}
for _, dim in ipairs { 2, 3 } do
  for _, row in ipairs(laws) do
    for _, factor in ipairs { 1, row[4] } do
      local m, numbers = model(dim), {}
      for key, value in pairs(row[2]) do numbers[key] = value*(key == row[3] and factor or 1) end
      m:contact { between = { "*", "*" }, law = row[1](numbers) }
      expect(m, row[3] .. " = ", factor ~= 1, row[3])
    end
  end
end
for _, off in ipairs { 30e3, 210e3 } do
  local m = trilith.model {}
  m:material { name = "one", density = 2400, E = off, nu = 0.2 }
  expect(m, "E = ", true, "E in MPa")
end

-- Members: section, fibres, bars and hinges, in the plane and in space.
local function frame(dim, section, more)
  local m = model(dim)
  local from, to = { 0, 0 }, { 0, 3 }
  if dim == 3 then from, to = { 0, 0, 0 }, { 0, 0, 3 } end
  local member = { from = "A", to = "B", section = section }
  for key, value in pairs(more or {}) do member[key] = value end
  m:frame { name = "f", material = "stone", joints = { A = { at = from, support = "fixed" }, B = to },
    members = { member } }
  return m
end
local function fibres(strength, young, yield)
  return trilith.fibre_section { shape = trilith.rectangle_section { width = 0.4, depth = 0.4 },
    law = trilith.kent_park { strength = strength }, layers = 4, bars = { { area = 1e-3, height = 0.05 } },
    bar_law = trilith.menegotto_pinto { E = young, yield = yield } }
end
for _, dim in ipairs { 2, 3 } do
  local square = trilith.rectangle_section { width = 0.4, depth = 0.4 }
  assert(#frame(dim, square).notes == 0)
  expect(frame(dim, trilith.rectangle_section { width = 400, depth = 400 }), "section area = 160000 m2", true,
    "section")
  assert(#frame(dim, fibres(30e6, 200e9, 420e6)).notes == 0)
  expect(frame(dim, fibres(30, 200e9, 420e6)), "strength = 30 Pa", true, "concrete in MPa")
  expect(frame(dim, fibres(30e6, 200e3, 420)), "E = 200000 Pa", true, "steel in MPa")
  expect(frame(dim, fibres(30e6, 200e9, 420)), "yield = 420 Pa", true, "yield in MPa")
  local hinged = { from_hinge = trilith.end_hinge { sagging = 1e5, across = 1e5, ultimate = 2 } }
  expect(frame(dim, square, hinged), "ultimate = 2 rad", true, "rotation in percent")
  for _, row in ipairs { { "sagging", 50, "N m" }, { "hogging", 50, "N m" }, { "across", 50, "N m" },
    { "tension", 500, "N" }, { "compression", 500, "N" }, { "softening", 5, "rad" } } do
    local numbers = { sagging = 1e5, hogging = 1e5, across = 1e5, tension = 1e6, compression = 1e6 }
    hinged.from_hinge = trilith.end_hinge(numbers)
    assert(#frame(dim, square, hinged).notes == 0)
    numbers[row[1]], numbers.capping = row[2], row[1] == "softening" and 0.02 or nil
    hinged.from_hinge = trilith.end_hinge(numbers)
    expect(frame(dim, square, hinged), ("%s = %g %s is"):format(table.unpack(row)), true, row[1])
  end
  hinged.from_hinge = trilith.end_hinge { sagging = 1e5, across = 1e5, ultimate = 0.02 }
  assert(#frame(dim, square, hinged).notes == 0)
end

-- Sizes: a wall in mm, whose bricks are 200 m high.
local function wall(size)
  local m = model(2)
  m:wall { name = "w", length = 3.2*size, unit_length = 0.4*size, unit_height = 0.2*size, courses = 2,
    material = "stone",
    base_height = 0.2*size, fixed = "base" }
  return m
end
expect(wall(1), "least side", false, "wall")
expect(wall(1000), "is it in mm?", true, "wall in mm")

-- A bearing's limits.
for _, dim in ipairs { 2, 3 } do
  for _, limit in ipairs { 0.1, 100 } do
    local m = model(dim)
    local at, size = dim == 3 and { 0, 0, 0 } or { 0, 0 }, { 1, 1, 1 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
    for name, level in pairs { a = -1, b = 0 } do
      local place = dim == 3 and { 0, 0, level } or { 0, level }
      local block = { name = name, at = place, material = "stone", support = name == "a" and "fixed" or nil }
      if dim == 3 then block.size = size else block.width, block.height = 1, 1 end
      m:block(block)
    end
    m:bearing { name = "link", between = { "a", "b" }, at = at, along = trilith.linear { stiffness = 1e6 },
      limit = { along = limit } }
    expect(m, "limit = 100 m", limit == 100, "limit")
  end
end

-- Laws of bearings in other units: { law, numbers, key, number in a wrong unit, text }.
for _, row in ipairs {
  { trilith.friction, { mu = 0.1, stiffness = 1e6, mu_fast = 0.2, rate = 50 }, "rate", 0.05,
    "rate = 0.05 s/m is below" },
  { trilith.friction, { mu = 0.1, stiffness = 1e6, load_exponent = 0.9, reference_load = 1e6 }, "reference_load", 1,
    "reference_load = 1 N is below" },
  { trilith.viscous, { force = 1e5, speed = 0.1 }, "speed", 100, "speed = 100 m/s is above" },
  { trilith.lead_rubber, { strength = 5e4, post_stiffness = 1e6 }, "strength", 0.05, "strength = 0.05 N is below" },
  { trilith.elastic_plastic, { stiffness = 1e6, yield = 5e4 }, "yield", 0.05, "yield = 0.05 N is below" } } do
  local law, numbers, key, wrong, text = table.unpack(row)
  for _, value in ipairs { numbers[key], wrong } do
    local m = model(2)
    m:contact { between = { "*", "*" }, law = "none" }
    m:block { name = "a", width = 1, height = 1, at = { 0, -1 }, material = "stone", support = "fixed" }
    m:block { name = "b", width = 1, height = 1, at = { 0, 0 }, material = "stone" }
    numbers[key] = value
    m:bearing { name = "link", between = { "a", "b" }, at = { 0.5, 0 }, along = law(numbers),
      axial = trilith.linear { stiffness = 1e7 } }
    expect(m, text, value == wrong, key)
  end
end

-- Gaps: a gap of 1 mm under a block gets a note with the pair; an intended gap and a block in contact get none.
local function over(dim, gap, more)
  local m = model(dim)
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  local ground = { name = "ground", material = "stone", support = "fixed" }
  local b = { name = "b", material = "stone" }
  for key, value in pairs(more or {}) do b[key] = value end
  if dim == 2 then
    ground.width, ground.height, ground.at = 4, 0.5, { -2, -0.5 }
    b.width, b.height, b.at = 0.5, 1, { 0, gap }
  else
    ground.size, ground.at = { 4, 4, 0.5 }, { -2, -2, -0.5 }
    b.size, b.at = { 0.5, 0.5, 1 }, { 0, 0, gap }
  end
  m:block(ground)
  m:block(b)
  m:run { duration = 1e-3 }
  return m
end
for _, dim in ipairs { 2, 3 } do
  expect(over(dim, 1e-3), "are 0.001 m apart", true, "gap")
  expect(over(dim, 2e-3), "close the gap", true, "gap")
  expect(over(dim, 1e-3, { floating = true }), "apart", false, "gap that is meant")
  expect(over(dim, 0), "apart", false, "no gap")
  expect(over(dim, 1e-7), "apart", false, "gap of rounding")
end

-- Missing fields.
local function refused(text, f, ...)
  local good, message = pcall(f, ...)
  assert(not good and tostring(message):find(text, 1, true), tostring(message))
end
for _, dim in ipairs { 2, 3 } do
  local m = over(dim, 0)
  local event = m.events[1]
  assert(event.type == "stage.begun" and event.bearing == nil and event.mode == nil and event.cause == nil)
  refused("event 'stage.begun' has no 'vallue'; did you mean 'value'?", function() return event.vallue end)
  refused("event 'stage.begun' has no 'nme'", function() return event.nme end)
  refused("has no '1'", function() return event[1] end)
  local seen = 0
  for _ in pairs(event) do seen = seen + 1 end
  assert(seen > 8)
  local report = m:run { duration = 1e-3 }
  assert(report.ending == "time" and report.mass_scaling == nil)
  refused("report has no 'endng'; did you mean 'ending'?", function() return report.endng end)
end
