-- Prestwood bridge, loaded to collapse at a quarter of its span: Page (1987).
local trilith = require "trilith"
local backfill = require "shared.backfill"
local setting = ... or {}

-- Assumptions, from sources and stated rules. Of a range that a source gives, the middle counts.
local series = { span = 6.55, rise = 1.428, thickness = 0.22, width = 3.80, cover = 0.165, voussoirs = 40,
  density = 2039, unit_weight = 20e3, friction_angle = 37*math.pi/180, cohesion = 5e3, passive = 0.4,
  mobilised = 0.0075, at_rest = true, wall_friction = 2/3*37*math.pi/180, strip = 0.3, dispersal = 0.5,
  mu = 0.7, strength = 4.5e6, rigid = 1000, displacement = 0.025 }
for key, value in pairs(setting.over or {}) do series[key] = value end
local radius = (series.span^2/4 + series.rise^2)/(2*series.rise)
local voussoir = 2*trilith.math.atan(series.span/2, radius - series.rise)*radius/series.voussoirs
local joint = trilith.joint_stiffness { wall_modulus = 1000*series.strength, course_height = voussoir,
  shear_ratio = 0.5 }
local assumptions = {
  { "arch", "span 6.55 m, rise 1.428 m, ring 0.22 m, width 3.80 m, 40 voussoirs; distortion and parapets left out",
    "Page 1987; dimensions from the literature" },
  { "weights", "20 kN/m3 for brick and fill; 0.165 m of fill at the crown", "literature" },
  { "joints", ("no tension, no crushing, friction 0.7; kn = %.1f GPa/m, ks half of it; ring alone: 1000 times as " ..
    "stiff"):format(joint.kn/1e9), "`trilith.joint_stiffness` with rigid voussoirs and E = 1000 times the strength " ..
      "of 4.5 MPa (EN 1996-1-1, 3.7.2). The ring alone then has the limit load of a rigid arch" },
  { "load", "at a quarter of the span, along y. Ring alone: on one voussoir. With soil: evenly on the voussoirs " ..
    "under a strip of 0.3 m that widens by half the depth of the fill on each side", "Page 1987; dispersal 2 to 1, " ..
    "assumed" },
  { "soil", "weight, and passive pressure against the back of the arch: 0.4 of Rankine's pressure for 37 degrees " ..
    "and 5 kPa, reached at a displacement of 0.75 % of the depth",
    "0.3 to 0.5 of the pressure is mobilised. Cohesion: 0 to 10 kPa. Displacement: " ..
    "0.5 to 1 % for half the passive pressure of dense soil (EN 1997-1, annex C); the middle of each" },
  { "soil at rest", "begins with the pressure at rest, 1 - sin(37 degrees) of the weight above (Jaky 1944); falls " ..
    "to Rankine's active pressure where the back recedes by a tenth of that displacement", "the tenth is assumed" },
  { "friction of soil on the back", "2/3 of 37 degrees: it resists the rise of a voussoir with its passive force, " ..
    "within the same displacement", "assumed; added after first runs, which had left it out" },
  { "method", "statics: equilibrium under weight, then a path by arc length", "no rate and no damping" },
}

-- Voussoir i of n: ends of its back (extrados).
local function backs_of(bodies, cx, cy, outer)
  local list = {}
  for i, body in ipairs(bodies) do
    local far = {}
    for _, p in ipairs(body.outline) do
      local r = math.sqrt((p[1] - cx)^2 + (p[2] - cy)^2)
      if r > outer - 1e-6 then far[#far + 1] = p end
    end
    table.sort(far, function(a, b) return a[1] < b[1] end)
    list[i] = { far[1], far[#far] }
  end
  return list
end

-- Voussoirs within `reach` of a quarter of the span, or the nearest voussoir.
local function loaded_voussoirs(bodies, x, reach)
  local nearest, strip = bodies[1], {}
  for _, b in ipairs(bodies) do
    if math.abs(b.x - x) < math.abs(nearest.x - x) then nearest = b end
    if math.abs(b.x - x) <= reach(b) then strip[#strip + 1] = b end
  end
  return #strip > 1 and strip or nearest
end

-- The ring on its abutments, with the fill. Returns the model, its voussoirs, and the centre and top of its back.
local function build(s, soil)
  local stiffer = soil and 1 or s.rigid
  local m = trilith.model { name = "bridge", thickness = s.width, threads = 1 }
  m:material { name = "brick", density = s.density }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = stiffer*joint.kn, ks = stiffer*joint.ks,
    mu = s.mu, beta = 1e-6 } }
  m:arch { name = "arch", voussoirs = s.voussoirs, span = s.span, rise = s.rise, thickness = s.thickness,
    material = "brick", fixed = "abutments" }
  local bodies, crown, cx = {}, 0, 0
  for i = 1, s.voussoirs do
    bodies[i] = m:body(("arch.v%d"):format(i))
    cx = cx + bodies[i].x/s.voussoirs
    for _, p in ipairs(bodies[i].outline) do crown = math.max(crown, p[2]) end
  end
  local cy = crown - radius - s.thickness
  local outer = 0
  for _, p in ipairs(bodies[1].outline) do outer = math.max(outer, math.sqrt((p[1] - cx)^2 + (p[2] - cy)^2)) end
  backfill(m, bodies, { backs = backs_of(bodies, cx, cy, outer - 1e-3), top = crown + s.cover, middle = cx,
    unit_weight = s.unit_weight, width = s.width, friction_angle = s.friction_angle, cohesion = s.cohesion,
    passive = soil and s.passive or 0, mobilised = s.mobilised,
    at_rest = s.at_rest, wall_friction = s.wall_friction, material = "brick" })
  return m, bodies, cx, crown
end

local function collapse(soil)
  local s = series
  local m, bodies, cx, crown = build(s, soil)
  local loaded = loaded_voussoirs(bodies, cx - s.span/4, function(b)
    if not soil then return 0 end
    return s.strip/2 + s.dispersal*(crown + s.cover - b.y - s.thickness/2)
  end)
  if setting.file then m:results { file = setting.file, frames = 0.2 } end
  m:consolidate { integrator = "static" }
  local p = m:pushover { body = loaded, pattern = "uniform", direction = "-y", displacement = s.displacement,
    control = "arc", arc = series.arc, samples = 1000 }
  -- Hinges: joints whose opening is a local maximum and above a tenth of the largest.
  local openings, most, hinges = {}, 0, 0
  for _, j in ipairs(m:joints()) do
    openings[#openings + 1] = { x = j.x, opening = j.opening }
    most = math.max(most, j.opening)
  end
  table.sort(openings, function(a, b) return a.x < b.x end)
  for i, j in ipairs(openings) do
    local left, right = openings[i - 1], openings[i + 1]
    local peak = (not left or left.opening < j.opening) and (not right or right.opening <= j.opening)
    if peak and j.opening > 0.15*most then hinges = hinges + 1 end
  end
  return p, hinges
end

local curves, cases = {}, {}
for _, row in ipairs { { "ring", false, "rigid ring and weight of the fill alone", "104 to 118", { 105, 120 } },
  { "soil", true, "ring with soil", 228, { 180, 280 } } } do
  cases[#cases + 1] = {
    name = "bridge_" .. row[1], title = row[3],
    parameters = { { "passive", row[2] and series.passive or 0 } },
    checks = { { "collapse load", unit = "kN", measured = row[4], between = row[5] },
      { "hinges", measured = 4, between = { 4, 4 } } },
    known = row[2] and "cohesion and share of the passive pressure, friction of soil on the back and elastic joints " ..
      "decide; see the table below. Backing and parapets are left out" or nil,
    run = function()
      local p, hinges = collapse(row[2])
      curves[row[1]] = p.curve
      return { ["collapse load"] = p.peak_force/1e3, hinges = hinges,
        notes = { ("at %.1f mm"):format(1e3*p.displacement_at_peak) } }
    end,
    plot = function()
      local x, y = {}, {}
      for i, d in ipairs(curves[row[1]].displacement) do x[i], y[i] = 1e3*d, curves[row[1]].force[i]/1e3 end
      return { title = row[3], x_label = "displacement under the load", x_unit = "mm", y_label = "load", y_unit = "kN",
        { name = "model", x = x, y = y }, { name = "measured", kind = "dashed", x = { 0, x[#x] }, y = { 228, 228 } } }
    end,
  }
end

return {
  title = "Masonry arch bridge at collapse",
  source = "Page (1987), TRRL Research Report 110; dimensions of Prestwood bridge from the literature",
  text = "A load over the whole width at a quarter of the span. The ring alone, with the fill as weight, reaches " ..
    "half of the measured load of 228 kN: its exact limit as a rigid arch is between 104 and 118 kN. Its joints are " ..
    "therefore nearly rigid; with soil, the joints have the stiffness of the brickwork.",
  assumptions = assumptions,
  moves = {
    { "collapse load, with soil", "friction of soil on the back", "none", "2/3 of 37 degrees", 0.59, 0.71 },
    { "collapse load, with soil", "friction of soil on the back", "2/3 of 37 degrees", "37 degrees", 0.71, 0.79 },
    { "collapse load, with soil", "soil at rest", "no pressure, 3 hinges", "pressure at rest, 4 hinges", 0.71, 0.71 },
    { "collapse load, with soil", "share of Rankine's pressure", "0.4", "0.5", 0.71, 0.77 },
    { "collapse load, with soil", "share of Rankine's pressure", "0.4", "1", 0.71, 1.05 },
    { "collapse load, with soil", "cohesion of the fill", "5 kPa", "none", 0.71, 0.56 },
    { "collapse load, with soil", "cohesion of the fill", "5 kPa", "10 kPa", 0.71, 0.81 },
    { "collapse load, with soil", "stiffness of joints", "24.5 GPa/m", "ten times as stiff", 0.71, 0.83 },
    { "collapse load, with soil", "share and stiffness", "0.4, 24.5 GPa/m", "0.5, ten times as stiff", 0.71, 0.91 },
    { "collapse load, with soil", "weight of brick and fill", "20 kN/m3", "22 kN/m3", 0.71, 0.76 },
    { "collapse load, with soil", "dispersal of the load by the fill", "2 to 1", "none", 0.71, 0.62 },
    { "collapse load, with soil", "displacement at which the soil acts", "0.75 % of the depth", "0.2 %", 0.71, 0.74 },
    { "collapse load, with soil", "voussoirs", "40", "80", 0.71, 0.71 },
    { "collapse load, ring alone, over the mean of 104 to 118 kN", "stiffness of joints", "1000 times as stiff",
      "100 times", 0.95, 0.92 },
    { "the same", "stiffness of joints", "1000 times as stiff", "24.5 GPa/m", 0.95, 0.72 },
  },
  cases = cases,
}
