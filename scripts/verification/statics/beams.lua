-- Beams under loads, by static equilibrium: small and large displacements.
local trilith = require "trilith"
local pi = math.pi

local function beam(options)
  local m = trilith.model { name = "beam", gravity = options.gravity or 0 }
  m:material { name = "m", density = options.density or 2400, E = options.E, nu = options.nu or 0 }
  local body = m:beam { name = "beam", from = { 0, 0 }, to = { options.length, 0 }, material = "m",
    section = options.section, divisions = options.divisions, shear = options.shear, from_support = options.from,
    to_support = options.to, floating = true }
  return m, body
end
local pinned, roller = { x = "fixed", y = "fixed" }, { y = "fixed" }

local cases = {
  {
    name = "deep_cantilever", title = "deep cantilever under a force at its tip",
    parameters = { { "length", 1.2, "m" }, { "P", 1e5, "N" }, { "nu", 0.3 } },
    checks = { { "bending", unit = "m", exact = 0.51429e-3, tolerance = 0.001 },
      { "bending and shear", unit = "m", exact = 0.55886e-3, tolerance = 0.001 } },
    run = function(p)
      local found = {}
      for name, shear in pairs { bending = false, ["bending and shear"] = true } do
        local m, body = beam { E = 2.1e11, nu = 0.3, length = 1.2, divisions = 8, from = "fixed", shear = shear,
          section = trilith.rectangle_section { width = 0.1, depth = 0.4 } }
        m:point_load { body = body, at = { 1.2, 0 }, force = { 0, -p.P } }
        m:consolidate { integrator = "static" }
        local _, y = body:point "to"
        found[name] = -y
      end
      return found
    end,
  },
}

-- Mattiasson's cantilever under a dead force; the section is so slender that its axis keeps its length.
for _, row in ipairs { { 1, 0.30172, 0.05643, 0.29371 }, { 2, 0.49346, 0.16064, 0.49768 },
  { 5, 0.71379, 0.38763, 0.77373 }, { 10, 0.81061, 0.55500, 0.91055 } } do
  cases[#cases + 1] = {
    name = ("elastica_%.0f"):format(row[1]), title = "cantilever that bends far under a dead force",
    parameters = { { "load", row[1] }, { "elements", 10 } },
    checks = { { "deflection over length", exact = row[2], tolerance = 0.01 },
      { "shortening over length", exact = row[3], tolerance = 0.01 } },
    run = function(p)
      local section = trilith.rectangle_section { width = 0.1, depth = 0.005 }
      local m, body = beam { E = 2.1e11, length = 1, divisions = p.elements, from = "fixed", section = section }
      m:point_load { body = body, at = { 1, 0 }, force = { 0, -p.load*2.1e11*section.inertia } }
      m:consolidate { integrator = "static", shares = 20, within = 10 }
      local x, y = body:point "to"
      return { ["deflection over length"] = -y, ["shortening over length"] = 1 - x }
    end,
  }
end

cases[#cases + 1] = {
  name = "rolled_up", title = "end moment 2 pi E I/L rolls a cantilever into a circle",
  parameters = { { "elements", 20 } },
  checks = { { "tip x over length", exact = 0, within = 0.01 }, { "tip y over length", exact = 0, within = 0.01 } },
  run = function(p)
    local section = trilith.rectangle_section { width = 0.1, depth = 0.005 }
    local m, body = beam { E = 2.1e11, length = 1, divisions = p.elements, from = "fixed", section = section }
    m:point_load { body = body, at = { 1, 0 }, moment = 2*pi*2.1e11*section.inertia }
    m:consolidate { integrator = "static", shares = 80, within = 10 }
    local x, y = body:point "to"
    return { ["tip x over length"] = x, ["tip y over length"] = y }
  end,
}

-- Weight on beams with usual supports: sag in the middle and moment at the left end, over w L^4/(E I) and w L^2.
for _, row in ipairs { { "simple", pinned, roller, 5/384, 0 }, { "propped", "fixed", roller, 0.0052083, 1/8 },
  { "clamped", "fixed", "fixed", 1/384, 1/12 } } do
  local rows = { { "sag in the middle E I/(w L^4)", exact = row[1] == "propped" and 1/192 or row[4],
    tolerance = 0.01 } }
  if row[5] > 0 then rows[2] = { "clamping moment/(w L^2)", exact = row[5], tolerance = 0.02 } end
  cases[#cases + 1] = {
    name = "weight_" .. row[1], title = "beam under its weight, " .. row[1],
    parameters = { { "length", 6, "m" }, { "elements", 32 } },
    checks = rows,
    run = function(p)
      local section = trilith.rectangle_section { width = 0.3, depth = 0.5 }
      local m, body = beam { E = 30e9, length = p.length, divisions = p.elements, from = row[2], to = row[3],
        section = section, gravity = 9.80665 }
      m:consolidate { integrator = "static" }
      local _, y = body:point { p.length/2, 0 }
      local w = 2400*section.area*9.80665
      return { ["sag in the middle E I/(w L^4)"] = -y*30e9*section.inertia/(w*p.length^4),
        ["clamping moment/(w L^2)"] = math.abs(body:forces()[1].moment)/(w*p.length^2) }
    end,
  }
end

cases[#cases + 1] = {
  name = "weight_convergence", title = "sag of a simple beam under its lumped weight",
  convergence = { parameter = "elements", values = { 4, 8, 16 }, order = 2, tolerance = 0.05, exact = 5/384,
    quantity = "sag E I/(w L^4)" },
  run = function(p)
    local section = trilith.rectangle_section { width = 0.3, depth = 0.5 }
    local m, body = beam { E = 30e9, length = 6, divisions = p.elements, from = pinned, to = roller, section = section,
      gravity = 9.80665 }
    m:consolidate { integrator = "static" }
    local _, y = body:point { 3, 0 }
    return -y*30e9*section.inertia/(2400*section.area*9.80665*6^4)
  end,
}

-- A truss of two bars that snaps through: the apex follows a displacement, past the limit load.
cases[#cases + 1] = {
  name = "snap_through", title = "two pinned bars, apex pushed down by arc length",
  parameters = { { "half_span", 10, "m" }, { "rise", 0.5, "m" }, { "EA", 1e6, "N" } },
  checks = { { "limit load", unit = "N", exact = 47.9925, tolerance = 0.001 },
    { "drop at the limit", unit = "m", exact = 0.211445, tolerance = 0.02 } },
  run = function(p)
    local m = trilith.model { name = "truss", gravity = 0 }
    m:material { name = "m", density = 1000, E = p.EA/1e-3 }
    local section = trilith.section { area = 1e-3, inertia = 1e-9, depth = 0.01 }
    local body = m:frame { name = "truss", material = "m", floating = true,
      joints = { A = { at = { -p.half_span, 0 }, support = "fixed" }, C = { at = { p.half_span, 0 },
        support = "fixed" },
        B = { at = { 0, p.rise }, support = { x = "fixed", rotation = "fixed" } } },
      members = { { from = "A", to = "B", section = section, divisions = 2, pinned = { "from", "to" } },
        { from = "B", to = "C", section = section, divisions = 2, pinned = { "from", "to" } } } }
    local push = m:pushover { body = body, at = "B", direction = "-y", control = "arc", displacement = 0.4,
      samples = 400,
      arc = 0.002 }
    return { ["limit load"] = push.limits[1].force, ["drop at the limit"] = push.limits[1].displacement }
  end,
}

return {
  title = "Beams under loads",
  source = "Gere and Timoshenko (1997), Mechanics of Materials, appendix G; Mattiasson (1981), International " ..
    "Journal for " ..
    "Numerical Methods in Engineering 17, table 1, for the cantilever that bends far",
  formula = [[w_\text{simple} = \frac{5 w L^4}{384 E I}, \quad w_\text{clamped} = \frac{w L^4}{384 E I}, \quad
w_\text{tip} = \frac{P L^3}{3 E I} + \frac{P L}{\kappa G A}, \quad P_\text{limit} = E A\left(1 - \tfrac{l}{L}\right)
\frac{z}{l}]],
  text = "The weight of a beam acts at its nodes, so that the sag converges with the square of the length of an " ..
    "element.",
  cases = cases,
}
