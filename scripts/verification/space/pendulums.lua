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

-- A mass on a massless link, started across: a bearing with an arm, and a small inertia.
cases[#cases + 1] = {
  name = "spherical_pendulum", title = "mass on a link of 1 m, released at 40 deg with 1 m/s across",
  checks = { { "time to the far point and back", unit = "s", exact = 1.03891, tolerance = 0.002 },
    { "rotation", unit = "deg", exact = 360 - 164.842, tolerance = 0.002 },
    { "radius there", unit = "m", exact = .64279, tolerance = 0.002 } },
  run = function()
    local m = space "link"
    local s, c = math.sin(40*deg), math.cos(40*deg)
    -- Angular velocity r x v for r = (s, 0, -c), v = (0, 1, 0) and a length of 1 m.
    local bob = m:block { name = "bob", size = { 0.02, 0.02, 0.02 }, anchor = "centre", at = { s, 0, -c }, mass = 10,
      inertia = 1e-3, material = "steel", velocity = { 0, 1, 0 }, spin = { c, 0, s }, floating = true }
    local law = trilith.linear { stiffness = 1e6 }
    m:bearing { name = "pin", between = { "pivot", "bob" }, at = { 0, 0, 0 }, arm = 1.1, along = law, across = law,
      axial = law }
    local times, angles, radii, r1, r2, t1, a1, turn = {}, {}, {}, nil, nil, nil, nil, 0
    m:run { duration = 2.5, until_true = function()
      local r, angle = math.sqrt(bob.x^2 + bob.y^2), math.atan(bob.y, bob.x)
      if a1 then
        local step = angle - a1
        turn = turn + (step > math.pi and step - 2*math.pi or step < -math.pi and step + 2*math.pi or step)
      end
      if r1 and r2 and r1 > r2 and r1 > r and m.time > 0.3 then
        -- The largest of the parabola through three values.
        local share = (r - r2)/(2*(2*r1 - r - r2))
        times[#times + 1] = t1 + share*m.dt
        radii[#radii + 1] = r1
        angles[#angles + 1] = turn
      end
      r2, r1, t1, a1 = r1, r, m.time, angle
      return #times == 2
    end }
    return { ["time to the far point and back"] = times[2]/2, ["rotation"] = angles[2]/2/deg,
      ["radius there"] = radii[2] }
  end,
}

-- A plate on four upright rods of little mass, pinned at both ends.
for _, row in ipairs { { "along", 2.83749 }, { "across", 2.83749 }, { "twist", 1.63823 } } do
  local way = row[1]
  cases[#cases + 1] = {
    name = "hung_plate_" .. way, title = "plate of 1 m x 0.6 m on four rods of 2 m, " ..
      (way == "twist" and "turned about its axis" or "swinging " .. way),
    checks = { { "period", unit = "s", exact = row[2], tolerance = 0.005 } },
    run = function()
      local m = trilith.model { name = "hung plate", dim = 3 }
      m:material { name = "steel", density = 7850 }
      m:contact { between = { "*", "*" }, law = "none" }
      m:block { name = "ceiling", size = { 1.2, 0.8, 0.1 }, at = { -0.6, -0.4, 0 }, material = "steel",
        support = "fixed" }
      local v = 0.04
      local plate = m:block { name = "plate", size = { 1, 0.6, 0.02 }, anchor = "centre", at = { 0, 0, -2 },
        mass = 100, material = "steel", inertia = { 100*0.36/12, 100/12, 100*1.36/12 }, floating = true,
        velocity = { way == "along" and v or 0, way == "across" and v or 0, 0 },
        spin = { 0, 0, way == "twist" and v or 0 } }
      local pin = trilith.linear { stiffness = 1e6, damping = 10 }
      for i, at in ipairs { { -0.5, -0.3 }, { -0.5, 0.3 }, { 0.5, -0.3 }, { 0.5, 0.3 } } do
        m:block { name = "rod " .. i, size = { 0.02, 0.02, 2 }, anchor = "centre", at = { at[1], at[2], -1 },
          mass = 0.05, inertia = { 0.05/3, 0.05/3, 1e-4 }, material = "steel", floating = true }
        for _, joint in ipairs { { "top", "ceiling", 0 }, { "foot", "plate", -2 } } do
          m:bearing { name = joint[1] .. " " .. i, between = { joint[2], "rod " .. i }, at = { at[1], at[2], joint[3] },
            along = pin, across = pin, axial = pin }
        end
      end
      local crossings, before = {}, 0
      m:run { duration = 6.5, until_true = function()
        local now = way == "along" and plate.ux or way == "across" and plate.uy or plate.rotation_z
        if before < 0 and now >= 0 then crossings[#crossings + 1] = m.time - m.dt*now/(now - before) end
        before = now
        return false
      end }
      return (crossings[#crossings] - crossings[1])/(#crossings - 1)
    end,
  }
end

return {
  title = "Pendulums",
  source = "Landau and Lifshitz (1976), Mechanics, sections 11 and 14; Goldstein, Poole and Safko (2002), " ..
    "Classical Mechanics, " ..
    "section 5.7",
  formula = [[T = 4\sqrt{\frac{I_p}{m g d}}\;K\!\left(\sin\tfrac{\theta_0}{2}\right), \qquad
\omega^2 = \frac{m g d}{(I_1 - I_3)\cos\theta}]],
  cases = cases,
}
