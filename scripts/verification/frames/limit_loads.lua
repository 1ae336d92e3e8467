-- Frames that snap through or form plastic hinges, followed by arc length or by displacement.
local trilith = require "trilith"

local function elastic(E)
  local m = trilith.model { name = "frame", gravity = 0 }
  m:material { name = "m", density = 2700, E = E }
  return m
end

-- The first limit point of a path and the lowest one after it: force, displacement, force.
local function extremes(push)
  local peak, low
  for _, point in ipairs(push.limits) do
    if not peak and point.highest then peak = point end
    if peak and not point.highest and (not low or point.force < low.force) then low = point end
  end
  return peak and peak.force, peak and peak.displacement, low and low.force
end

local cases = {}
for _, row in ipairs {
  { "williams_toggle", "Williams's toggle", .3287522, .0098044, .0191262, .0061722, 71.016e9, 150.66, 5.910e-3,
    139.15, 0.005 },
  { "steep_toggle", "a steeper toggle", .5, .03, .02, .01, 210e9, 3404.0, 10.964e-3, 196.6, 0.02 } } do
  local span, rise, width, depth, E = table.unpack(row, 3, 7)
  cases[#cases + 1] = {
    name = row[1], title = row[2] .. ", whole",
    parameters = { { "half_span", span, "m" }, { "rise", rise, "m" }, { "width", width, "m" }, { "depth", depth,
      "m" } },
    checks = { { "limit load", unit = "N", exact = row[8], tolerance = 0.005 },
      { "drop at the limit", unit = "m", exact = row[9], tolerance = 0.02 },
      { "least load after it", unit = "N", exact = row[10], tolerance = row[11] } },
    run = function()
      local m = elastic(E)
      local section = trilith.rectangle_section { width = width, depth = depth }
      local body = m:frame { name = "toggle", material = "m", floating = true,
        joints = { A = { at = { -span, 0 }, support = "fixed" }, B = { 0, rise },
          C = { at = { span, 0 }, support = "fixed" } },
        members = { { from = "A", to = "B", section = section, divisions = 10 },
          { from = "B", to = "C", section = section, divisions = 10 } } }
      local push = m:pushover { body = body, at = "B", direction = "-y", control = "arc", displacement = 1.5*rise,
        samples = 400, arc = rise/200 }
      local peak, at, low = extremes(push)
      return { ["limit load"] = peak, ["drop at the limit"] = at, ["least load after it"] = low }
    end,
  }
end

cases[#cases + 1] = {
  name = "lee_frame", title = "Lee's frame, snaps back",
  parameters = { { "side", 1.2, "m" }, { "E", 70.608e9, "Pa" }, { "width", 0.03, "m" }, { "depth", 0.02, "m" } },
  checks = { { "limit load", unit = "N", exact = 18198, tolerance = 0.005 },
    { "displacement at the limit", unit = "m", exact = 0.4873, tolerance = 0.01 },
    { "lowest load", unit = "N", exact = -9232.5, tolerance = 0.005 } },
  run = function(p)
    local m = elastic(p.E)
    local section = trilith.rectangle_section { width = p.width, depth = p.depth }
    local hinged = { x = "fixed", y = "fixed" }
    local body = m:frame { name = "lee", material = "m", floating = true,
      joints = { A = { at = { 0, 0 }, support = hinged }, B = { 0, 1.2 }, L = { 0.24, 1.2 },
        C = { at = { 1.2, 1.2 }, support = hinged } },
      members = { { from = "A", to = "B", section = section, divisions = 10 },
        { from = "B", to = "L", section = section, divisions = 2 },
        { from = "L", to = "C", section = section, divisions = 8 } } }
    local push = m:pushover { body = body, at = "L", direction = "-y", control = "arc", displacement = 0.8,
      samples = 800,
      arc = 0.005 }
    local peak, at, low = extremes(push)
    return { ["limit load"] = peak, ["displacement at the limit"] = at, ["lowest load"] = low }
  end,
}

-- Plastic collapse of a portal with hinges of 100 kN m, under forces in proportion.
local function portal(_, foot)
  local m = trilith.model { name = "portal", gravity = 0 }
  m:material { name = "m", density = 2700, E = 2.1e13 }
  local section, hinge = trilith.rectangle_section { width = 0.3, depth = 0.5 }, trilith.end_hinge { sagging = 1e5 }
  local function member(from, to) return { from = from, to = to, section = section, divisions = 2, hinge = hinge } end
  local body = m:frame { name = "portal", material = "m", floating = true,
    joints = { A = { at = { 0, 0 }, support = foot }, B = { 0, 4 }, M = { 3, 4 }, C = { 6, 4 },
      D = { at = { 6, 0 }, support = foot } },
    members = { member("A", "B"), member("B", "M"), member("M", "C"), member("C", "D") } }
  return m, body
end
for _, row in ipairs { { "combined", "fixed", 100, 50, 1.2 }, { "beam", "fixed", 100, 10, 4/3 },
  { "sway", "fixed", 20, 60, 5/3 }, { "pinned", { x = "fixed", y = "fixed" }, 100, 50, 0.8 } } do
  cases[#cases + 1] = {
    name = "plastic_portal_" .. row[1], title = "plastic collapse of a portal, " .. row[1],
    parameters = { { "V", 1e3*row[3], "N" }, { "H", 1e3*row[4], "N" }, { "Mp", 1e5, "N m" } },
    checks = { { "load factor", exact = row[5], tolerance = 0.01 } },
    run = function(p)
      -- Equilibrium is found below the collapse load and not above it.
      local low, high = 0.8*row[5], 1.2*row[5]
      for _ = 1, 10 do
        local factor = (low + high)/2
        local m, body = portal(p, row[2])
        m:point_load { body = body, at = "M", force = { 0, -factor*p.V } }
        m:point_load { body = body, at = "B", force = { factor*p.H, 0 } }
        local found = m:consolidate { integrator = "static", shares = 20, or_go_on = true, within = 0.05 }
        if found.rests then low = factor else high = factor end
        m:close()
      end
      return (low + high)/2
    end,
  }
end

return {
  title = "Limit loads of frames",
  source = "Williams (1964), Quarterly Journal of Mechanics and Applied Mathematics 17. Lee, Manuel and Rossow " ..
    "(1968), " ..
    "Journal of the Engineering Mechanics Division 94(2). Neal (1977), The Plastic Methods of Structural Analysis, " ..
    "section 2.4, for the portals",
  formula = [[\lambda_\text{beam} = \frac{8 M_p}{V L}, \qquad \lambda_\text{sway} = \frac{4 M_p}{H h}, \qquad
\lambda_\text{combined} = \frac{6 M_p}{H h + V L/2}]],
  text = "The toggles and Lee's frame are elastic and bend far; the references were computed again with exact " ..
    "elements. " ..
    "A mechanism of a portal needs as many plastic hinges that the frame moves without resistance.",
  cases = cases,
}
