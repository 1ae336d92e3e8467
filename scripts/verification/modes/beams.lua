-- Natural frequencies of beams, portals and chains.
local trilith = require "trilith"
local pi = math.pi

local function model(options)
  local m = trilith.model { name = "modes", dim = options.dim, gravity = options.gravity or 0 }
  m:material { name = "m", density = options.density, E = options.E, nu = options.nu or 0 }
  return m
end

-- Frequencies of a model that bends, from mode number `from` on [Hz].
local function frequencies(m, from, count)
  if m.gravity[2] ~= 0 then m:consolidate { integrator = "static" } end
  local list, names = {}, {}
  for i, mode in ipairs(m:modes { count = from + count - 1 }) do
    if i >= from then list[#list + 1] = mode.frequency end
  end
  for i, f in ipairs(list) do names["mode " .. i] = f end
  return names
end

local function checks(list, tolerance)
  local rows = {}
  for i, f in ipairs(list) do rows[i] = { "mode " .. i, unit = "Hz", exact = f, tolerance = tolerance } end
  return rows
end

-- Euler's beam has no rotary inertia and does not stretch: a section of ten thousand times the area, of a
-- material of as much lower density, has next to none.
local much = 1e4
local function euler_section(width, depth)
  return trilith.section { area = much*width*depth, inertia = width*depth^3/12, depth = depth }
end

local function cantilever(tip)
  local m = model { E = 2.1e11, density = 7850/much }
  local section = euler_section(0.1, 0.2)
  local mass = 7850*0.1*0.2*3
  m:frame { name = "beam", material = "m", floating = true, mass_matrix = "consistent",
    joints = { A = { at = { 0, 0 }, support = "fixed" }, B = { at = { 3, 0 }, mass = tip*mass } },
    members = { { from = "A", to = "B", section = section, divisions = 20 } } }
  return m
end
local function bending(root, length, E, I, line) return (root/length)^2*math.sqrt(E*I/line)/(2*pi) end
local E, I, line = 2.1e11, 0.1*0.2^3/12, 7850*0.02

local cases = {
  {
    name = "cantilever_modes", title = "cantilever",
    parameters = { { "length", 3, "m" }, { "width", 0.1, "m" }, { "depth", 0.2, "m" }, { "E", E, "Pa" } },
    checks = checks({ bending(1.87510407, 3, E, I, line), bending(4.69409113, 3, E, I, line),
      bending(7.85475744, 3, E, I, line) }, 0.01),
    run = function() return frequencies(cantilever(0), 1, 3) end,
  },
}
for _, row in ipairs { { 0.5, 1.41996 }, { 1, 1.24792 }, { 2, 1.07620 } } do
  cases[#cases + 1] = {
    name = ("tip_mass_%.0f"):format(10*row[1]), title = "cantilever with a mass at its tip",
    parameters = { { "r", row[1] } },
    checks = checks({ bending(row[2], 3, E, I, line) }, 0.005),
    run = function(p) return frequencies(cantilever(p.r), 1, 1) end,
  }
end

-- Free in space: six motions without deformation, then bending about both axes, with shear and rotary inertia.
cases[#cases + 1] = {
  name = "free_beam", title = "free beam in space, with shear deformation and rotary inertia (Timoshenko)",
  parameters = { { "length", 2, "m" }, { "width", 0.05, "m" }, { "depth", 0.1, "m" }, { "E", 70e9, "Pa" },
    { "nu", 0.25 } },
  checks = { { "sixth frequency", unit = "Hz", exact = 0, within = 1e-3 },
    { "strong first", unit = "Hz", exact = 129.691, tolerance = 0.005 },
    { "strong second", unit = "Hz", exact = 351.825, tolerance = 0.005 } },
  run = function(p)
    local m = model { dim = 3, E = p.E, density = 2700, nu = p.nu, gravity = { 0, 0, 0 } }
    m:beam { name = "beam", from = { 0, 0, 0 }, to = { p.length, 0, 0 }, material = "m", divisions = 40, shear = true,
      section = trilith.rectangle_section { width = p.width, depth = p.depth }, floating = true }
    local modes = m:modes { count = 12 }
    local function nearest(f)
      local best = 0
      for i = 7, 12 do
        if math.abs(modes[i].frequency - f) < math.abs(best - f) then best = modes[i].frequency end
      end
      return best
    end
    return { ["sixth frequency"] = modes[6].frequency, ["strong first"] = nearest(129.691),
      ["strong second"] = nearest(351.825) }
  end,
}

-- A portal of concrete, exact by the dynamic stiffness of its members.
local function portal(foot)
  local m = model { E = 30e9, density = 2400/much }
  local column, beam = euler_section(0.2, 0.3), euler_section(0.2, 0.4)
  m:frame { name = "portal", material = "m", floating = true, mass_matrix = "consistent",
    joints = { A = { at = { 0, 0 }, support = foot }, B = { 0, 3 }, C = { 4, 3 }, D = { at = { 4, 0 },
      support = foot } },
    members = { { from = "A", to = "B", section = column, divisions = 8 },
      { from = "B", to = "C", section = beam, divisions = 8 }, { from = "C", to = "D", section = column,
        divisions = 8 } } }
  return m
end
for _, row in ipairs { { "fixed", "fixed", { 15.1215, 50.573, 110.828, 115.838 } },
  { "pinned", { x = "fixed", y = "fixed" }, { 7.1551, 44.967, 80.254 } } } do
  cases[#cases + 1] = {
    name = "portal_modes_" .. row[1], title = "portal of members that do not stretch, feet " .. row[1],
    checks = checks(row[3], 0.002),
    run = function() return frequencies(portal(row[2]), 1, #row[3]) end,
  }
end

-- A simply supported beam under an axial force.
local function strut(share)
  local m = model { E = 2.1e11, density = 7850 }
  local section = trilith.rectangle_section { width = 0.1, depth = 0.1 }
  local body = m:beam { name = "beam", from = { 0, 0 }, to = { 4, 0 }, section = section, material = "m",
    divisions = 24,
    from_support = { x = "fixed", y = "fixed" }, to_support = { y = "fixed" }, floating = true,
    mass_matrix = "consistent" }
  if share ~= 0 then
    m:point_load { body = body, at = { 4, 0 }, force = { -share*pi^2*2.1e11*section.inertia/16, 0 } }
    m:consolidate { integrator = "static" }
  end
  return m
end
for _, share in ipairs { 0.5, -0.3 } do
  local rows = {}
  for n = 1, 3 do rows[n] = { "mode " .. n, exact = math.sqrt(1 - share/n^2), tolerance = 0.002 } end
  cases[#cases + 1] = {
    name = share > 0 and "strut_modes" or "tie_modes",
    title = "simply supported beam under an axial force, over the frequency without it",
    parameters = { { "P_over_Pcr", share } },
    checks = rows,
    run = function(p)
      local with, without, found = strut(p.P_over_Pcr):modes { count = 3 }, strut(0):modes { count = 3 }, {}
      for n = 1, 3 do found["mode " .. n] = with[n].frequency/without[n].frequency end
      return found
    end,
  }
end

-- Convergence of the first frequency of a simply supported beam.
local exact = pi/2/16*math.sqrt(2.1e11*0.1^4/12/(7850*0.01))
for _, row in ipairs { { "lumped", 4 }, { "consistent", 4 } } do
  cases[#cases + 1] = {
    name = "mode_convergence_" .. row[1], title = "simply supported beam, " .. row[1] .. " mass",
    convergence = { parameter = "elements", values = { 2, 4, 8 }, order = row[2], tolerance = 0.15,
      exact = exact, quantity = "first frequency", quantity_unit = "Hz" },
    run = function(p)
      local m = model { E = 2.1e11, density = 7850/much }
      m:beam { name = "beam", from = { 0, 0 }, to = { 4, 0 }, material = "m", divisions = p.elements,
        section = euler_section(0.1, 0.1), mass_matrix = row[1], floating = true,
        from_support = { x = "fixed", y = "fixed" }, to_support = { y = "fixed" } }
      return m:modes { count = 1 }[1].frequency
    end,
  }
end

return {
  title = "Natural frequencies of beams and portals",
  source = "Blevins (1979), Formulas for Natural Frequency and Mode Shape, tables 8-1 and 8-8; Clough and Penzien " ..
    "(1975), " ..
    "Dynamics of Structures, chapter 20, for the dynamic stiffness of the portals",
  formula = [[f_n = \frac{(\beta_n L)^2}{2\pi L^2}\sqrt{\frac{E I}{\rho A}}, \qquad
\frac{f_n(P)}{f_n(0)} = \sqrt{1 - \frac{P}{n^2 P_\text{cr}}}]],
  cases = cases,
}
