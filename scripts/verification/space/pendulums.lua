-- Pendulums in the plane and in space, hung on bearings that hold a point.
local trilith = require "trilith"
local deg = trilith.units "deg"
local stiff = trilith.linear { stiffness = 1e9 }

local cases = {}

cases[#cases + 1] = {
  name = "compound_pendulum", title = "rod of 2 m hinged at its end, released at 60 deg, in the plane",
  checks = { { "period", unit = "s", exact = 2.48635, tolerance = 0.005 } },
  run = function()
    local m = trilith.model { name = "rod" }
    m:material { name = "steel", density = 7850 }
    m:contact { between = { "*", "*" }, law = "none" }
    m:block { name = "pivot", width = 0.2, height = 0.2, at = { 0, 0 }, anchor = "centre", material = "steel",
      support = "fixed" }
    local s, c = math.sin(60*deg), math.cos(60*deg)
    local rod = m:block { name = "rod", width = 0.02, height = 2, at = { s, -c }, anchor = "centre", angle = 60*deg,
      mass = 10, inertia = 10*4/12, material = "steel", floating = true }
    m:bearing { name = "pin", between = { "pivot", "rod" }, at = { 0, 0 }, along = stiff, axial = stiff }
    local crossings, before = {}, 60*deg
    m:run { duration = 6, until_true = function()
      local angle = 60*deg + rod.rotation
      if before < 0 and angle >= 0 then crossings[#crossings + 1] = m.time - m.dt*angle/(angle - before) end
      before = angle
      return false
    end }
    return crossings[2] - crossings[1]
  end,
}

local function space(name)
  local m = trilith.model { name = name, dim = 3 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "pivot", size = { 0.2, 0.2, 0.2 }, anchor = "centre", at = { 0, 0, 0 }, material = "steel",
    support = "fixed" }
  return m
end

-- A bar hung at the centre of an end face, started so that it circles at a constant angle.
cases[#cases + 1] = {
  name = "conical_pendulum", title = "bar of 1 m x 0.1 m x 0.1 m that circles at 30 deg from the vertical",
  checks = { { "period", unit = "s", exact = 1.52263, tolerance = 0.002 },
    { "largest change of the angle in 10 turns", unit = "deg", exact = 0, within = 0.05 } },
  run = function()
    local m, rate = space "cone", 4.12652
    local s, c = math.sin(30*deg), math.cos(30*deg)
    -- The bar's long axis is z; turned about y by -30 deg its lower end points to +x.
    local bar = m:block { name = "bar", size = { 0.1, 0.1, 1 }, anchor = "centre", at = { 0.5*s, 0, -0.5*c },
      turn = { axis = { 0, 1, 0 }, angle = -30*deg }, material = "steel", spin = { 0, 0, rate },
      velocity = { 0, rate*0.5*s, 0 }, floating = true }
    m:bearing { name = "pin", between = { "pivot", "bar" }, at = { 0, 0, 0 }, along = stiff, across = stiff,
      axial = stiff }
    local off, crossings, before = 0, {}, 0
    m:run { duration = 15.3, until_true = function()
      local angle = math.atan(math.sqrt(bar.x^2 + bar.y^2), -bar.z)/deg
      off = math.max(off, math.abs(angle - 30))
      if before < 0 and bar.y >= 0 and bar.x > 0 then
        crossings[#crossings + 1] = m.time - m.dt*bar.y/(bar.y - before)
      end
      before = bar.y
      return false
    end }
    return { period = (crossings[#crossings] - crossings[1])/(#crossings - 1),
      ["largest change of the angle in 10 turns"] = off }
  end,
}

return {
  title = "Pendulums",
  source = "Landau and Lifshitz (1976), Mechanics, sections 11 and 14; Goldstein, Poole and Safko (2002), " ..
    "Classical Mechanics, " ..
    "section 5.7",
  formula = [[T = 4\sqrt{\frac{I_p}{m g d}}\;K\!\left(\sin\tfrac{\theta_0}{2}\right), \qquad
\omega^2 = \frac{m g d}{(I_1 - I_3)\cos\theta}]],
  cases = cases,
}
