-- Yielding members from scripts: a column of reinforced concrete in a pushover, hinges, messages for wrong input.
local trilith = require "trilith"

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed*math.abs(expected), ("%.9g instead of %.9g"):format(value, expected))
end

-- 0.4 m x 0.4 m, 30 MPa, four bars of 20 mm on either side
local square = trilith.rectangle_section { width = 0.4, depth = 0.4 }
local core = trilith.kent_park { strength = 30e6, ultimate = 0.02 }
local steel = trilith.bilinear_steel { E = 2e11, yield = 420e6 }
local bar = 4*math.pi/4*0.02^2
local function column_section(change)
  local t = { shape = square, law = core, layers = 10, cover = 0.04, cover_law = trilith.kent_park { strength = 30e6 },
              bars = { { area = bar, height = 0.05 }, { area = bar, height = 0.35 } }, bar_law = steel }
  for k, v in pairs(change or {}) do t[k] = v or nil end
  return trilith.fibre_section(t)
end
local section = column_section()
near(section.area, 0.16, 1e-12)
assert(tostring(section):find("fibre_section of %d+ fibres of kent_park{"), tostring(section))
assert(tostring(core):find("kent_park", 1, true) and core.ultimate == 0.02)

refused("'shape' is missing", trilith.fibre_section, { law = core })
refused("'law' is missing", trilith.fibre_section, { shape = square })
local one_bar = { { area = 1e-3, height = 0.1 } }
refused("'bar_law' is missing", trilith.fibre_section, { shape = square, law = core, bars = one_bar })
local bare = trilith.section { area = 1, inertia = 1, depth = 1 }
refused("no shape to cut", trilith.fibre_section, { shape = bare, law = core })
refused("made of fibres already", trilith.fibre_section, { shape = section, law = core })
refused("at a height of 0.5 m", column_section, { bars = { { area = 1e-3, height = 0.5 } } })
refused("cover", column_section, { cover = 0.3 })
local solid = trilith.j2 { E = 2e11, nu = 0.3, yield = 1e8 }
refused("must be a fibre law", trilith.fibre_section, { shape = square, law = solid })
refused("ultimate is", trilith.kent_park, { strength = 30e6, strain = 0.01 })
refused("compression", trilith.end_hinge, { sagging = 1e5, compression = 1e6 })
refused("concave", trilith.end_hinge, { sagging = 1e5, axial = { { -1e6, 0 }, { 0, 0.2 }, { 5e5, 1 }, { 1e6, 0 } } })
refused("'saging'", trilith.end_hinge, { saging = 1e5 })

-- pushed under 500 kN: the foot's moment is the sum of the bars at yield and of the concrete that carries N
local weight = 500e3
local function column(options)
  local m = trilith.model { name = "column", mass_damping = 2 }
  m:material { name = "concrete", density = 2500, E = 30e9, nu = 0.2 }
  local t = { name = "column", from = { 0, 0 }, to = { 0, 3 }, section = square, material = "concrete", divisions = 12,
              from_support = "fixed" }
  for k, v in pairs(options) do t[k] = v end
  return m, m:beam(t)
end
local m, body = column { section = section }
local seen = {}
m:on("member.yielded", function(e) seen[#seen + 1] = e end)
m:point_load { body = body, at = { 0, 3 }, force = { 0, -weight }, load_curve = { smooth = 0.2 } }
m:consolidate { rest = { ratio = 1e-6 } }
assert(#seen == 0)
m:pushover { body = body, at = { 0, 3 }, rate = 0.2, displacement = 0.06, local_damping = 0.5 }
local concrete = weight*0.2*(1 - weight/(0.85*30e6*0.16))
near(math.abs(body:forces()[1].moment), bar*420e6*0.3 + concrete, 0.06)
assert(seen[1] and seen[1].text:find("at from yielded under", 1, true), seen[1] and seen[1].text)
assert(seen[1].body == body and seen[1].y < 0.01 and m.energy.plastic > 0)
assert(math.abs(m.energy.residual) < 0.01*m.energy.plastic)
refused("has no hinges", body.hinges, body)

-- fibre readings: sections stay plane, their stresses sum to the section forces, bars in tension yield at the foot
local sections = body:fibres()
assert(sections[1].along < 0.2 and sections[#sections].along > 2.8)
for _, at in ipairs(sections) do
  local normal, moment, middle = 0, 0, nil
  for _, f in ipairs(at.fibres) do
    middle = middle or f.height + (f.strain - at.axial)/at.curvature
    assert(math.abs(f.strain - (at.axial - at.curvature*(f.height - middle))) < 1e-12)
    normal, moment = normal + f.stress*f.area, moment - f.stress*f.area*(f.height - middle)
  end
  near(normal, at.normal, 1e-9)
  near(moment, at.moment, 1e-9)
end
-- a beam carries the weight in the mean of its four stations (Lobatto's rule), as its axis has a single strain
near((sections[1].normal + 5*sections[2].normal + 5*sections[3].normal + sections[4].normal)/12,
  -weight - 2500*0.16*3*9.80665, 0.01)
local most = -math.huge
for _, f in ipairs(sections[1].fibres) do most = math.max(most, f.stress) end
near(most, 420e6, 1e-3)
m:close()

-- the same with a hinge at its foot, which finally loses its moment
local lost
local function hinged()
  m, body = column { from_hinge = trilith.end_hinge { sagging = 1e5, hardening = 1e5, ultimate = 0.01 } }
  refused("nothing has run yet", body.hinges, body)
  m:on("member.failed", function(e) lost = e end)
  m:consolidate { rest = { ratio = 1e-6 } }
end
hinged()
local hinge = body:hinges()[1]
assert(#body:hinges() == 1 and hinge.state == "elastic" and hinge.joint == "from" and hinge.rotation == 0)
m:pushover { body = body, at = { 0, 3 }, rate = 0.1, displacement = 0.02, local_damping = 0.5 }
hinge = body:hinges()[1]
assert(hinge.state == "yielded" and not lost)
near(math.abs(hinge.moment), 1e5 + 1e5*math.abs(hinge.rotation), 1e-6)
near(hinge.given_off, m.energy.plastic, 1e-9)
m:close()
hinged()
m:pushover { body = body, at = { 0, 3 }, rate = 0.1, displacement = 0.05, local_damping = 0.5 }
assert(body:hinges()[1].state == "failed" and math.abs(body:hinges()[1].moment) < 1e-6 and lost.value >= 0.01)
assert(lost.text:find("column: at from lost its moment", 1, true), lost.text)
m:close()

m = trilith.model { name = "m" }
m:material { name = "concrete", density = 2500, E = 30e9, nu = 0.2 }
local function beam(options)
  local t = { name = "b", from = { 0, 0 }, to = { 3, 0 }, section = square, material = "concrete" }
  for k, v in pairs(options) do t[k] = v end
  return m:beam(t)
end
local law = trilith.end_hinge { sagging = 1e5 }
refused("both a hinge and a section of fibres", beam, { section = section, hinge = law })
refused("its start is pinned already", beam, { hinge = law, pinned = "from" })
refused("'rule' is 'simpson'", beam, { section = section, rule = "simpson" })
refused("'stations' is 9, must be 3 to 6", beam, { section = section, stations = 9 })
refused("must be a hinge law", beam, { hinge = core })
refused("softens by", beam, { hinge = trilith.end_hinge { sagging = 1e5, capping = 0.01, softening = 1e-9 } })
m:close()
