-- Yielding members in space: a column of reinforced concrete pushed along one axis, as in the plane, and obliquely;
-- readings of its fibres; messages for wrong input.
local trilith = require "trilith"

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end
local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed*math.abs(expected), ("%.9g instead of %.9g"):format(value, expected))
end

-- 0.4 m x 0.4 m, 30 MPa, four bars of 20 mm on either side, distributed over 0.3 m
local core = trilith.kent_park { strength = 30e6, ultimate = 0.02 }
local bar = 4*math.pi/4*0.02^2
local function column_section(change)
  local t = { shape = trilith.rectangle_section { width = 0.4, depth = 0.4 }, law = core, layers = 4, cover = 0.04,
              cover_law = trilith.kent_park { strength = 30e6 },
              bar_law = trilith.bilinear_steel { E = 2e11, yield = 420e6 },
              bars = { { area = bar, height = 0.05, count = 4, spread = 0.3 },
                       { area = bar, height = 0.35, count = 4, spread = 0.3 } } }
  for k, v in pairs(change or {}) do t[k] = v or nil end
  return trilith.fibre_section(t)
end

local weight = 500e3
local function column(options)
  local m = trilith.model { name = "column", dim = 3, mass_damping = 2 }
  m:material { name = "concrete", density = 2500, E = 30e9, nu = 0.2 }
  local t = { name = "column", from = { 0, 0, 0 }, to = { 0, 0, 3 }, section = column_section(), material = "concrete",
              divisions = 10, from_support = "fixed" }
  for k, v in pairs(options or {}) do t[k] = v end
  return m, m:beam(t)
end

--- The column under its weight, pushed along x with the top of its section towards `orientation`: final moments of its
--- foot about y and z of the section.
local function pushed(orientation)
  local m, body = column { orientation = orientation }
  local seen = {}
  m:on("member.yielded", function(e) seen[#seen + 1] = e end)
  m:point_load { body = body, at = { 0, 0, 3 }, force = { 0, 0, -weight }, load_curve = { smooth = 0.2 } }
  m:consolidate { integrator = "static" }
  assert(#seen == 0)
  m:pushover { body = body, at = { 0, 0, 3 }, direction = "x", rate = 0.4, displacement = 0.05, local_damping = 0.5 }
  assert(seen[1] and seen[1].text:find("at from yielded under", 1, true), seen[1] and seen[1].text)
  assert(seen[1].body == body and seen[1].z < 0.01 and m.energy.plastic > 0)
  assert(math.abs(m.energy.residual) < 0.01*m.energy.plastic)
  local foot = body:forces()[1]
  return m, body, foot.moment_y, foot.moment_z
end

-- Along x: as in the plane, by the bars at yield and the concrete that carries the weight.
local m, body, across, along = pushed { 1, 0, 0 }
local concrete = weight*0.2*(1 - weight/(0.85*30e6*0.16))
near(math.abs(along), bar*420e6*0.3 + concrete, 0.06)
assert(math.abs(across) < 1e-3*math.abs(along))

-- Fibres: sections stay plane, and their stresses sum to the section forces.
for _, at in ipairs(body:fibres()) do
  local normal, about_y, about_z = 0, 0, 0
  for _, f in ipairs(at.fibres) do
    assert(math.abs(f.strain - (at.axial - at.curvature_z*f.up + at.curvature_y*f.across)) < 1e-12)
    normal, about_y, about_z = normal + f.stress*f.area, about_y + f.stress*f.area*f.across,
      about_z - f.stress*f.area*f.up
  end
  near(normal, at.normal, 1e-9)
  assert(math.abs(about_y - at.moment_y) < 1e-6*weight and math.abs(about_z - at.moment_z) < 1e-6*weight)
end
m:close()

-- At an oblique push of 45 degrees the moments about both axes are equal, and the moment about the diagonal is below
-- the sum of the bars of both sides.
local _
m, _, across, along = pushed { 1, 1, 0 }
near(math.abs(across), math.abs(along), 0.1)
local askew = math.sqrt(across^2 + along^2)
assert(askew > 0.75*(bar*420e6*0.3 + concrete) and askew < 1.1*(bar*420e6*0.3 + concrete), askew)
m:close()

refused("it has both a hinge and a section of fibres; keep one", column,
  { hinge = trilith.end_hinge { sagging = 1e5, across = 1e5 } })
refused("'stations' is 9, must be 3 to 6", column, { stations = 9 })
refused("'rule' is 'simpson'", column, { rule = "simpson" })
refused("bars at 0 m across, spread over 0.5 m, stand outside of the section, which is 0.4 m wide", column,
  { section = column_section { bars = { { area = bar, height = 0.05, count = 4, spread = 0.5 } } } })
refused("count is 0 and spread 0 m, must be 1 to 1000 and not below 0", column_section,
  { bars = { { area = bar, height = 0.05, count = 0 } } })
refused("'layers_across' is 0, must be at least 1", column_section, { layers_across = 0 })
refused("500 layers over the depth or the width, must be 1 to 100 in space", column,
  { section = column_section { layers = 500 } })
local angle = { { 0, 0 }, { 0.4, 0 }, { 0.4, 0.1 }, { 0.1, 0.1 }, { 0.1, 0.6 }, { 0, 0.6 } }
refused("up and across are not its principal axes", column,
  { section = trilith.fibre_section { law = core, shape = trilith.polygon_section { outline = angle } } })
refused("nothing has run yet", function()
  local _, one = column()
  one:fibres()
end)

-- A hinge at the foot, pushed obliquely: it yields on its surface, its dissipation is in the ledger, and it loses its
-- moment at the ultimate rotation.
local strong, weak, contour = 2e5, 1.2e5, 1.7
local law = trilith.end_hinge { sagging = strong, across = weak, contour = contour, ultimate = 0.02 }
m, body = column { section = trilith.rectangle_section { width = 0.3, depth = 0.4 }, orientation = { 1, 0.6, 0 },
                   from_hinge = law, divisions = 2, mass_matrix = "consistent" }
refused("nothing has run yet", function() body:hinges() end)
local seen = {}
m:on("member.yielded", function(e) seen[#seen + 1] = e.type end)
m:on("member.failed", function(e) seen[#seen + 1] = e.type end)
m:pushover { body = body, at = { 0, 0, 3 }, direction = "x", rate = 0.05, displacement = 0.045, local_damping = 0.5 }
local foot = body:hinges()[1]
assert(foot.joint == "from" and foot.state == "yielded" and seen[1] == "member.yielded", foot.state)
-- On the surface, or slightly inside if the push oscillates at its end; never outside.
local out = (math.abs(foot.moment_y)/weak)^contour + (math.abs(foot.moment_z)/strong)^contour
assert(out < 1 + 1e-9 and out > 0.95, out)
assert(foot.rotation_y ~= 0 and foot.rotation_z ~= 0 and foot.z == 0)
near(m.energy.plastic, foot.given_off, 1e-6)
m:release { push = "pushover" }
m:pushover { name = "on", body = body, at = { 0, 0, 3 }, direction = "x", rate = 0.05, displacement = 0.12,
             local_damping = 0.5 }
foot = body:hinges()[1]
assert(foot.state == "failed" and seen[2] == "member.failed", foot.state)
assert(math.abs(foot.moment_z) < 1 and math.abs(foot.moment_y) < 1)
-- After the hinge has broken the column swings: its peak is carried by masses, and not by a part of the structure.
local last = m.notes[#m.notes]
assert(last:find("the structure carries none of it", 1, true) and not last:find("−", 1, true), last)
m:close()
