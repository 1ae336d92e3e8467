-- Rigid bodies in space: free rotation, pendulums, impacts of edges and corners.
local trilith = require "trilith"
local deg = trilith.units "deg"
local g, pi = 9.80665, math.pi

local function space(gravity)
  local m = trilith.model { name = "flight", dim = 3, gravity = gravity or g }
  m:material { name = "stone", density = 1000 }
  return m
end

local cases = {}

cases[#cases + 1] = {
  name = "unstable_axis", title = "free body with moments 1, 2, 3 kg m2, spinning about the middle one",
  checks = { { "first sign change of the spin", unit = "s", exact = 4.058, tolerance = 0.005 },
    { "second", unit = "s", exact = 11.035, tolerance = 0.005 }, { "third", unit = "s", exact = 18.011,
      tolerance = 0.005 },
    { "energy at 20 s", unit = "J", exact = 4.02, tolerance = 0.001 } },
  run = function()
    local m = space { 0, 0, 0 }
    local body = m:block { name = "body", size = { 1, 1, 1 }, at = { 0, 0, 0 }, mass = 1, inertia = { 1, 2, 3 },
      spin = { 0.1, 2, 0.1 }, material = "stone", floating = true }
    local changes, before = {}, 2
    -- The angular momentum (0.1, 4, 0.3) stays; the spin along the body's own y axis changes its sign.
    m:run { duration = 20, dt = 1e-3, until_true = function()
      local x0, y0, z0 = body:point { 0.5, 0, 0.5 }
      local x1, y1, z1 = body:point { 0.5, 1, 0.5 }
      local along = body.spin_x*(x1 - x0) + body.spin_y*(y1 - y0) + body.spin_z*(z1 - z0)
      if along*before < 0 then changes[#changes + 1] = m.time - m.dt*along/(along - before) end
      before = along
      return false
    end }
    return { ["first sign change of the spin"] = changes[1], second = changes[2], third = changes[3],
      ["energy at 20 s"] = m.energy.kinetic }
  end,
}

cases[#cases + 1] = {
  name = "free_precession", title = "free plate 0.4 m x 0.4 m x 0.1 m with spin (1, 0, 10) rad/s",
  checks = { { "rate of the axis about the momentum", unit = "rad/s", exact = 18.8501, tolerance = 0.002 },
    { "angle of the axis", unit = "deg", exact = 3.04098, tolerance = 0.002 } },
  run = function()
    local m = space { 0, 0, 0 }
    local body = m:block { name = "plate", size = { 0.4, 0.4, 0.1 }, at = { 0, 0, 0 }, anchor = "centre", spin = { 1,
      0, 10 },
      material = "stone", floating = true }
    -- Moments in proportion to 0.17 and 0.32; the momentum points along (0.17, 0, 3.2).
    local L = { 0.17, 0, 3.2 }
    local size = math.sqrt(L[1]^2 + L[3]^2)
    local crossings, before, sum, count = {}, nil, 0, 0
    m:run { duration = 20, dt = 5e-4, until_true = function()
      local x, y, z = body:point { 0, 0, 0.05 }
      x, y, z = (x - body.x)/0.05, (y - body.y)/0.05, (z - body.z)/0.05
      local cosine = (x*L[1] + z*L[3])/size
      sum, count = sum + math.acos(cosine), count + 1
      if before and before < 0 and y >= 0 then crossings[#crossings + 1] = m.time - m.dt*y/(y - before) end
      before = y
      return false
    end }
    return { ["rate of the axis about the momentum"] = 2*pi*(#crossings - 1)/(crossings[#crossings] - crossings[1]),
      ["angle of the axis"] = sum/count/deg }
  end,
}

cases[#cases + 1] = {
  name = "edge_on_edge", title = "two bars of 10 kg that meet edge on edge at 1 m/s",
  checks = { { "first bar, vz", unit = "m/s", exact = -.56425, tolerance = 0.01 },
    { "first bar, spin about y", unit = "rad/s", exact = 2.01117, tolerance = 0.01 },
    { "second bar, vz", unit = "m/s", exact = -.43575, tolerance = 0.01 },
    { "second bar, spin about x", unit = "rad/s", exact = -1.34078, tolerance = 0.01 },
    { "energy", unit = "J", exact = 5, tolerance = 0.01 } },
  run = function()
    local m = space { 0, 0, 0 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5e13, ks = 0, mu = 0 } }
    local diagonal = 0.1/math.sqrt(2)
    local a = m:block { name = "a", size = { 1, 0.1, 0.1 }, anchor = "centre", at = { 0, 0, 0 },
      turn = { axis = { 1, 0, 0 }, angle = 45*deg }, material = "stone", floating = true }
    local b = m:block { name = "b", size = { 0.1, 1, 0.1 }, anchor = "centre", at = { 0.3, 0.2, 2*diagonal + 0.001 },
      turn = { axis = { 0, 1, 0 }, angle = 45*deg }, material = "stone", velocity = { 0, 0, -1 }, floating = true }
    m:run { duration = 9e-4 }
    m:run { duration = 3e-3, dt = 1e-7, until_true = function() return a.vz ~= 0 and #m:contacts() == 0 end }
    return { ["first bar, vz"] = a.vz, ["first bar, spin about y"] = a.spin_y, ["second bar, vz"] = b.vz,
      ["second bar, spin about x"] = b.spin_x, energy = m.energy.kinetic }
  end,
}

cases[#cases + 1] = {
  name = "dropped_bar", title = "bar of 1 m x 0.3 m x 0.2 m, rotated by 20 deg, dropped on its edge without damping",
  checks = { { "first touch", unit = "s", exact = 0.50187, tolerance = 0.001 },
    { "vz after it", unit = "m/s", exact = -1.83583, tolerance = 0.01 },
    { "spin after it", unit = "rad/s", exact = 15.5115, tolerance = 0.01 } },
  run = function()
    local m = space()
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e12, ks = 0, mu = 0 } }
    m:block { name = "floor", size = { 6, 6, 0.5 }, at = { -3, -3, -0.5 }, material = "stone", support = "fixed" }
    local bar = m:block { name = "bar", size = { 1, 0.3, 0.2 }, anchor = "centre", at = { 0, 0, 1.5 },
      turn = { axis = { 0, 1, 0 }, angle = 20*deg }, material = "stone", floating = true }
    m:run { duration = 0.5 }
    local touched
    m:run { duration = 0.05, dt = 1e-6, until_true = function()
      local touching = #m:contacts() > 0
      if touching then touched = touched or m.time end
      return touched ~= nil and not touching
    end }
    return { ["first touch"] = touched, ["vz after it"] = bar.vz,
      ["spin after it"] = math.sqrt(bar.spin_x^2 + bar.spin_y^2 + bar.spin_z^2) }
  end,
}

cases[#cases + 1] = {
  name = "falling_cube", title = "cube of 0.5 m that spins with (3, 2, 1) rad/s as it falls from 3 m",
  checks = { { "first touch", unit = "s", exact = 0.729214, tolerance = 0.001 },
    { "corner x", unit = "m", exact = -.10110, tolerance = 0.001 },
    { "corner y", unit = "m", exact = -.15203, tolerance = 0.001 } },
  run = function()
    local m = space()
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 0, mu = 0 } }
    m:block { name = "floor", size = { 6, 6, 0.5 }, at = { -3, -3, -0.5 }, material = "stone", support = "fixed" }
    local cube = m:block { name = "cube", size = { 0.5, 0.5, 0.5 }, anchor = "centre", at = { 0, 0, 3 },
      spin = { 3, 2, 1 }, material = "stone", floating = true }
    m:run { duration = 1, dt = 1e-5, until_true = function() return #m:contacts() > 0 end }
    local x, y = cube:point { -0.25, -0.25, 3.25 }
    return { ["first touch"] = m.time, ["corner x"] = x, ["corner y"] = y }
  end,
}

-- A tall block on one corner that falls in the plane of its diagonal.
for _, row in ipairs { { 0.25, .23855 }, { 0.5, .39321 }, { 0.75, .61422 } } do
  cases[#cases + 1] = {
    name = ("corner_fall_%.0f"):format(100*row[1]), title = "block of 0.4 m x 0.4 m x 1.2 m released on one corner",
    parameters = { { "share of 25.2394 deg", row[1] } }, slow = true,
    checks = { { "flat after", unit = "s", exact = row[2], tolerance = 0.01 },
      { "distance from the plane of the diagonal", unit = "m", exact = 0, within = 1e-4 } },
    run = function()
      local angle = row[1]*math.atan(math.sqrt(0.08), 0.6)
      local s, c = math.sin(angle), math.cos(angle)
      -- The corner at (0.2, 0.2, 0) carries the block; positions in the diagonal plane, `u` from that corner.
      local function place(u, z)
        local along = u*c - z*s
        return { 0.2 - along/math.sqrt(2), 0.2 - along/math.sqrt(2), z*c + u*s }
      end
      local r = math.sqrt(0.08)
      local centre, far = place(r, 0.6), place(2*r, 0)
      local m = trilith.model { name = "corner", dim = 3, overlap_allowed = 1e-3 }
      m:material { name = "stone", density = 1000 }
      m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e14, ks = 1e14, mu = 2, beta = 1e-7 } }
      m:block { name = "floor", size = { 6, 6, 0.5 }, at = { -3, -3, -0.5 }, material = "stone", support = "fixed" }
      -- The corner is a pyramid: the block starts at the depth that carries its weight.
      centre[3], far[3] = centre[3] - 1e-4, far[3] - 1e-4
      local block = m:block { name = "block", size = { 0.4, 0.4, 1.2 }, anchor = "centre", at = centre,
        turn = { axis = { -1, 1, 0 }, angle = angle }, material = "stone", floating = true }
      local left, rate
      m:run { duration = 1, until_true = function()
        local h = select(3, block:point(far))
        if h < 2*r*0.002 then
          left, rate = h/(2*r), math.sqrt(block.spin_x^2 + block.spin_y^2)
        end
        return left ~= nil
      end }
      return { ["flat after"] = m.time + left/rate, ["distance from the plane of the diagonal"] =
        math.abs(block.x - block.y)/math.sqrt(2) }
    end,
  }
end

return {
  title = "Rigid bodies in flight and in impact",
  source = "Goldstein, Poole and Safko (2002), Classical Mechanics, sections 5.6 and 5.7; impulse and momentum of " ..
    "rigid bodies",
  formula = [[I\dot{\boldsymbol\omega} + \boldsymbol\omega\times I\boldsymbol\omega = 0, \qquad
\dot\varphi = \frac{L}{I_1}, \qquad J = \frac{2 v}{1/m_a + 1/m_b + x_a^2/I_a + y_b^2/I_b}]],
  cases = cases,
}
