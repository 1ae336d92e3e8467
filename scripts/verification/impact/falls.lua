-- Bodies that fall: bounces on a spring that only pushes, a bar that swings down, a cube dropped flat.
local trilith = require "trilith"
local g = 9.80665

local cases = {}

-- A block on a contact without damping, in implicit and in explicit steps.
for _, integrator in ipairs { "implicit", "explicit" } do
  cases[#cases + 1] = {
    name = "bounces_" .. integrator, title = "1 t dropped by 0.5 m on 4 MN/m, bounces for 13.8 s, " .. integrator,
    parameters = { { "mass", 1000, "kg" }, { "k", 4e6, "N/m" }, { "height", 0.5, "m" } },
    checks = { { "first touch", unit = "s", exact = 0.319330, tolerance = 0.005 },
      { "deepest", unit = "m", exact = 0.0520266, tolerance = 0.01 },
      { "period of the bounces", unit = "s", exact = 0.689897, tolerance = 0.005 },
      { "largest height after them", unit = "m", between = { 0.49, 0.5025 } } },
    run = function(p)
      local m = trilith.model { name = "bounces" }
      m:material { name = "stone", density = 1000 }
      m:contact { between = { "*", "*" }, law = trilith.frictional { kn = p.k, ks = p.k/2, mu = 0 } }
      m:block { name = "base", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
      local block = m:block { name = "block", width = 1, height = 1, at = { -0.5, p.height }, mass = p.mass,
        material = "stone", support = { rotation = "fixed" }, floating = true }
      local deepest, highest, last, touched = 0, 0, 1, {}
      m:run { duration = 20*0.689897, integrator = integrator, dt = integrator == "explicit" and 1e-3 or nil,
        alpha = integrator == "implicit" and 0 or nil,
        until_true = function()
          local y = block.y - 0.5
          deepest = math.min(deepest, y)
          if y < 0 and last >= 0 then touched[#touched + 1] = m.time - m.dt*y/(y - last) end
          if m.time > 0.35 then highest = math.max(highest, y) end
          last = y
          return false
        end }
      return { ["first touch"] = touched[1], deepest = -deepest, ["largest height after them"] = highest,
        ["period of the bounces"] = (touched[#touched] - touched[1])/(#touched - 1) }
    end,
  }
end

-- A span that hangs by one end: time in which its other end has fallen by a height.
local ft = 0.3048
for _, row in ipairs { { 20, .914 }, { 40, 1.322 }, { 50, 1.506 }, { 60, 1.696 } } do
  cases[#cases + 1] = {
    name = ("hanging_span_%.0f"):format(row[1]), title = "bar of 80 ft, hinged at one end, released level",
    parameters = { { "drop", row[1]*ft, "m" } },
    checks = { { "time", unit = "s", exact = row[2], tolerance = 0.01 } },
    run = function(p)
      local L = 80*ft
      local m = trilith.model { name = "span" }
      m:material { name = "concrete", density = 2400 }
      m:contact { between = { "*", "*" }, law = "none" }
      m:block { name = "pier", width = 1, height = 1, at = { 0, 0 }, anchor = "centre", material = "concrete",
        support = "fixed" }
      m:block { name = "span", width = L, height = 0.1, at = { L/2, 0 }, anchor = "centre", mass = 2e5,
        inertia = 2e5*L^2/12, material = "concrete", floating = true }
      local stiff = trilith.linear { stiffness = 1e10 }
      m:bearing { name = "hinge", between = { "pier", "span" }, at = { 0, 0 }, along = stiff, axial = stiff }
      local span = m:body "span"
      m:run { duration = 3, dt = 1e-4, until_true = function() return -select(2, span:point { L, 0 }) >= p.drop end }
      return m.time
    end,
  }
end

cases[#cases + 1] = {
  name = "dropped_cube", title = "cube of 1 m dropped flat from 1 m, until it rests",
  parameters = { { "kn", 1e8, "Pa/m" } },
  checks = { { "first touch", unit = "s", exact = .45160, tolerance = 0.005 },
    { "speed then", unit = "m/s", exact = 4.42869, tolerance = 0.005 },
    { "overlap at rest", unit = "m", exact = 1000*g/1e8, tolerance = 0.005 } },
  run = function(p)
    local m = trilith.model { name = "cube", dim = 3 }
    m:material { name = "stone", density = 1000 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = p.kn, ks = p.kn/2, mu = 0.5, beta = 2e-3 } }
    m:block { name = "base", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
    local cube = m:block { name = "cube", size = { 1, 1, 1 }, at = { -0.5, -0.5, 1 }, material = "stone",
      floating = true }
    local touched, speed
    m:run { duration = 8, until_true = function()
      if not touched and cube.z <= 0.5 then touched, speed = m.time, -cube.vz end
      return false
    end }
    return { ["first touch"] = touched, ["speed then"] = speed, ["overlap at rest"] = 0.5 - cube.z }
  end,
}

return {
  title = "Bodies that fall",
  source = "Derived: half a period of a mass on a spring about its rest, between two parabolas; the pendulum " ..
    "equation for the " ..
    "bar",
  formula = [[T = 2\sqrt{\frac{2h}{g}} + \frac{2}{\omega}\left(\pi - \arctan\frac{\omega v_0}{g}\right), \qquad
\dot\theta^2 = \frac{3 g \sin\theta}{L}]],
  cases = cases,
}
