-- Critical loads of columns and portals: where the lowest frequency under a compressive force goes to zero.
local trilith = require "trilith"
local steel = { E = 2.1e11, density = 7850 }

-- Square of the lowest frequency under a force; 0 where the structure has lost its stiffness.
local function square(make, force)
  local m = make(force)
  m:consolidate { integrator = "static", shares = 4 }
  local lowest = m:modes { count = 1 }[1].square
  m:close()
  return lowest
end

-- The square of the frequency falls in a nearly straight line with the force: a secant near its end finds the root.
local function critical(make, expected)
  local low, high = 0.9*expected, 0.98*expected
  local a, b = square(make, low), square(make, high)
  return high + b*(high - low)/(a - b)
end

local ends = {
  cantilever = { "fixed", nil, 0.25 },
  pinned = { { x = "fixed", y = "fixed" }, { x = "fixed" }, 1 },
  ["fixed and pinned"] = { "fixed", { x = "fixed" }, 2.045748 },
  fixed = { "fixed", { x = "fixed", rotation = "fixed" }, 4 },
}

local function column(support)
  return function(force)
    local m = trilith.model { name = "column", gravity = 0 }
    m:material { name = "steel", density = steel.density, E = steel.E }
    local body = m:beam { name = "column", from = { 0, 0 }, to = { 0, 3 }, material = "steel", divisions = 12,
      section = trilith.rectangle_section { width = 0.05, depth = 0.05 }, from_support = support[1],
      to_support = support[2], floating = true }
    m:point_load { body = body, at = { 0, 3 }, force = { 0, -force } }
    return m
  end
end

local cases = {}
for _, name in ipairs { "cantilever", "pinned", "fixed and pinned", "fixed" } do
  local exact = ends[name][3]*math.pi^2*steel.E*0.05^4/12/9
  cases[#cases + 1] = {
    name = "euler_" .. name:gsub(" ", "_"),
    title = "column, " .. name,
    parameters = { { "length", 3, "m" }, { "side", 0.05, "m" }, { "E", steel.E, "Pa" } },
    checks = { { "critical load", unit = "N", exact = exact, tolerance = 0.005 } },
    run = function() return critical(column(ends[name]), exact) end,
  }
end

local function portal(foot)
  return function(force)
    local m = trilith.model { name = "portal", gravity = 0 }
    m:material { name = "steel", density = steel.density, E = steel.E }
    local section, members = trilith.rectangle_section { width = 0.1, depth = 0.1 }, {}
    for i, ends_of in ipairs { { "A", "B" }, { "B", "C" }, { "C", "D" } } do
      members[i] = { from = ends_of[1], to = ends_of[2], section = section, divisions = 8 }
    end
    local body = m:frame { name = "portal", material = "steel", members = members, floating = true,
      joints = { A = { at = { 0, 0 }, support = foot }, B = { 0, 4 }, C = { 4, 4 }, D = { at = { 4, 0 },
        support = foot } } }
    for _, joint in ipairs { "B", "C" } do m:point_load { body = body, at = joint, force = { 0, -force } } end
    return m
  end
end
for _, row in ipairs { { "fixed", "fixed", 7.37915 }, { "pinned", { x = "fixed", y = "fixed" }, 1.82129 } } do
  local exact = row[3]*steel.E*0.1^4/12/16
  cases[#cases + 1] = {
    name = "euler_portal_" .. row[1],
    title = "portal that sways, feet " .. row[1],
    parameters = { { "height", 4, "m" }, { "side", 0.1, "m" }, { "E", steel.E, "Pa" } },
    checks = { { "critical load of a column", unit = "N", exact = exact, tolerance = 0.005 } },
    run = function() return critical(portal(row[2]), exact) end,
  }
end

return {
  title = "Buckling of columns and portals",
  source = "Euler (1744); Timoshenko and Gere (1961), Theory of Elastic Stability, articles 2.1, 2.2 and 2.4; for " ..
    "the " ..
    "portals the roots of u tan u = 6 (pinned) and of -u cot u = 6 (fixed)",
  formula = [[P_\text{cr} = \frac{\pi^2 E I}{(K L)^2}, \qquad P_\text{portal} = u^2\,\frac{E I}{h^2}]],
  text = "The frame is brought to equilibrium under the force by statics. The square of its lowest frequency " ..
    "falls to " ..
    "zero at the critical load.",
  cases = cases,
}
