-- Joints of rigid blocks in space: eccentric force, torsion of a face, friction in every direction.
local trilith = require "trilith"
local deg = trilith.units "deg"
local g, kn = 9.80665, 1e8

local function on_ground(size, options)
  options = options or {}
  local m = trilith.model { name = "joint", dim = 3, gravity = options.gravity or 0 }
  m:material { name = "stone", density = options.density or 2400 }
  m:contact { between = { "*", "*" }, law = options.law or trilith.frictional { kn = options.kn or kn,
    ks = options.ks or (options.kn or kn)/2, mu = options.mu or 0.8, beta = options.beta or 1e-3 } }
  m:block { name = "ground", size = { 6, 6, 1 }, at = { -3, -3, -1 }, material = "stone", support = "fixed" }
  local block = m:block { name = "block", size = size, at = { -size[1]/2, -size[2]/2, 0 }, material = "stone",
    support = options.support, mass = options.mass }
  return m, block
end

local cases = {}

-- No-tension joint B x H under N at (ex, ey).
for i, row in ipairs { { 1, 1, .05, .05, 16000, 6e-5, 6e-5, 1 }, { 1, 1, .1, .1, 22045, 1.2055e-4, 1.2055e-4, .98532 },
  { 1, 1, .2, .1, 29933, 2.6872e-4, 1.4202e-4, .83738 }, { 1.2, .8, .35, .05, 40118, 4.6025e-4, 1.5996e-4, .58610 },
  { 1, 1, .3, .3, 93750, 1.1719e-3, 1.1719e-3, .32 } } do
  local tolerance = i == 1 and 0.001 or 0.005
  cases[#cases + 1] = {
    name = "two_way_eccentric_" .. i, title = "eccentric force in both directions",
    parameters = { { "B", row[1], "m" }, { "H", row[2], "m" }, { "ex", row[3], "m" }, { "ey", row[4], "m" },
      { "N", 1e4, "N" }, { "kn", kn, "Pa/m" } },
    checks = { { "peak stress", unit = "Pa", exact = row[5], tolerance = tolerance },
      { "slope along x", unit = "rad", exact = row[6], tolerance = tolerance },
      { "slope along y", unit = "rad", exact = row[7], tolerance = tolerance },
      { "contact area", unit = "m2", exact = row[8], tolerance = 0.005 } },
    run = function(p)
      local m, block = on_ground { p.B, p.H, 0.5 }
      m:point_load { body = block, at = { p.ex, p.ey, 0.25 }, force = { 0, 0, -p.N } }
      m:consolidate { integrator = "static", shares = 20 }
      local function depth(x, y) return -select(3, block:point { x, y, 0 }) end
      local x, y = p.B/2, p.H/2
      local area = 0
      for _, c in ipairs(m:contacts()) do area = area + c.area end
      return { ["peak stress"] = p.kn*depth(x, y), ["slope along x"] = (depth(x, y) - depth(-x, y))/p.B,
        ["slope along y"] = (depth(x, y) - depth(x, -y))/p.H, ["contact area"] = area }
    end,
  }
end

-- Torsion of a square face under uniform pressure: torque at multiples of the rotation of the first slip.
local function torques(p, shares, law)
  local m, block = on_ground({ 1, 1, 0.02 }, { mu = p.mu, ks = p.ks, mass = 100, law = law,
    support = { x = "fixed", y = "fixed", rotation_x = "fixed", rotation_y = "fixed" } })
  m:point_load { body = block, force = { 0, 0, -p.N } }
  m:consolidate { integrator = "static" }
  local first = math.sqrt(2)*p.mu*p.N/p.ks
  m:drive { body = block, rotation_z = trilith.ramp { by = 10*first, duration = 4 } }
  local found = {}
  m:run { duration = 4, until_true = function()
    for _, share in ipairs(shares) do
      local name = ("torque at %s times"):format(share)
      if not found[name] and math.abs(block.rotation_z) >= share*first then
        local sum = 0
        for _, r in ipairs(block:reactions()) do sum = sum + r.mz end
        found[name] = math.abs(sum)
      end
    end
    return false
  end }
  return found
end
local limit = 0.38260*0.5*1e4
cases[#cases + 1] = {
  name = "torsion_limit", title = "a square face of 1 m that is turned far",
  parameters = { { "N", 1e4, "N" }, { "mu", 0.5 }, { "ks", 1e8, "Pa/m" } },
  checks = { { "torque at 9 times", unit = "N m", exact = limit, tolerance = 0.01 } },
  run = function(p) return torques(p, { 9 }) end,
}
local function partial_slip()
  local rows = {}
  for i, row in ipairs { { 1.5, .8566 }, { 2, .9395 }, { 3, .9821 }, { 5, .9961 } } do
    rows[i] = { ("torque at %s times"):format(row[1]), unit = "N m", exact = row[2]*limit, tolerance = 0.01 }
  end
  return rows
end
cases[#cases + 1] = {
  name = "torsion_partial_slip", title = "a square face of 1 m that is turned, rotation as a multiple of first slip",
  parameters = { { "N", 1e4, "N" }, { "mu", 0.5 }, { "ks", 1e8, "Pa/m" } },
  known = "a turned face slips everywhere at once, without partial slip at its corners (limit of validity in the " ..
    "theory)",
  checks = partial_slip(),
  run = function(p) return torques(p, { 1.5, 2, 3, 5 }) end,
}
-- A bonded law slips by patches once its bonds are lost; here they are weak.
cases[#cases + 1] = {
  name = "torsion_of_patches", title = "a square joint of mortar that has lost its bonds and is turned",
  parameters = { { "N", 1e4, "N" }, { "mu", 0.5 }, { "ks", 1e8, "Pa/m" } },
  checks = partial_slip(),
  run = function(p)
    return torques(p, { 1.5, 2, 3, 5 }, trilith.bonded { kn = kn, ks = p.ks, mu = p.mu, beta = 1e-3, tension = 100,
      cohesion = 1 })
  end,
}

-- A square face that turns about a point away from its middle: shear force and torque once all of it slips.
for _, row in ipairs { { 0.1, .1758, .9771 }, { 0.3, .5142, .8014 }, { 0.5, .7902, .5178 }, { 1, .9534, .2352 } } do
  cases[#cases + 1] = {
    name = ("turned_about_%.0f"):format(10*row[1]),
    title = "a square face of 1 m that turns about a point away from its middle",
    known = "the limit is right to 1.3 % along its rays; force and couple by themselves are right to 0.016 of their " ..
      "largest value (Theory, Contact in space)",
    parameters = { { "N", 1e4, "N" }, { "mu", 0.5 }, { "distance", row[1], "m" } },
    checks = { { "shear force over mu N", exact = row[2], tolerance = 0.015 },
      { "torque over its limit", exact = row[3], tolerance = 0.015 } },
    run = function(p)
      local m, block = on_ground({ 1, 1, 0.02 }, { mu = p.mu, ks = 1e9, mass = 100,
        support = { y = "fixed", rotation_x = "fixed", rotation_y = "fixed" } })
      m:point_load { body = block, force = { 0, 0, -p.N } }
      m:consolidate { integrator = "static" }
      local turn = 4e-4/p.distance
      m:drive { body = block, x = trilith.ramp { by = turn*p.distance, duration = 2 },
        rotation_z = trilith.ramp { by = turn, duration = 2 } }
      m:run { duration = 1.5 }
      local fx, mz = 0, 0
      for _, r in ipairs(block:reactions()) do fx, mz = fx + r.fx, mz + r.mz end
      return { ["shear force over mu N"] = math.abs(fx)/(p.mu*p.N), ["torque over its limit"] = math.abs(mz)/limit }
    end,
  }
end

-- A square face that is pushed slowly off its middle, until it slides and turns.
for _, row in ipairs { { 0.5, .5747 }, { 0.25, .7910 } } do
  cases[#cases + 1] = {
    name = ("pushed_beside_%.0f"):format(100*row[1]), title = "a square face of 1 m that is pushed off its middle",
    parameters = { { "N", 1e4, "N" }, { "mu", 0.5 }, { "arm", row[1], "m" } },
    checks = { { "force that moves it over mu N", exact = row[2], tolerance = 0.015 } },
    run = function(p)
      local m, block = on_ground({ 1, 1, 0.02 }, { mu = p.mu, ks = 1e9, mass = 10,
        support = { rotation_x = "fixed", rotation_y = "fixed" } })
      m:point_load { body = block, force = { 0, 0, -p.N } }
      m:consolidate { integrator = "static" }
      local begun, from, to = m.time, 0.9*row[2], 1.1*row[2]
      m:point_load { body = block, at = { 0, p.arm, 0.01 }, force = { to*p.mu*p.N, 0, 0 },
        load_curve = { { 0, 0 }, { 0.5, from/to }, { 2.5, 1 } } }
      m:run { duration = 2.5, until_true = function() return block:point { 0, 0.5, 0.01 } > 2e-4 end }
      return m.time - begun < 2.499 and from + (to - from)*(m.time - begun - 0.5)/2 or 0/0
    end,
  }
end

-- A block on a plane that tilts towards an azimuth: slides or overturns, or neither up to `to`.
local function tilted(p, size, mu, from, to)
  local side, down = g*trilith.math.sin(from), g*trilith.math.cos(from)
  local azimuth = p.azimuth*deg
  local m, block = on_ground(size, { mu = mu, kn = 1e12, beta = 3e-6,
    gravity = { side*trilith.math.cos(azimuth), side*trilith.math.sin(azimuth), -down } })
  m:consolidate { rest = { ratio = 1e-5 }, duration = 2, grow = 0.2, or_go_on = true }
  local begun, rate, x, y = m.time, 0.25*deg, block.x, block.y
  m:tilt { rate = rate, by = to - from, towards = azimuth }
  local found
  m:run { duration = (to - from)/rate, until_true = function()
    if math.sqrt((block.x - x)^2 + (block.y - y)^2) > 2e-5 then found = from + rate*(m.time - begun) end
    return found ~= nil
  end }
  return found and found/deg or 0/0
end
for _, azimuth in ipairs { 0, 17, 22.5, 45 } do
  cases[#cases + 1] = {
    name = ("friction_circle_%.0f"):format(azimuth), title = "block of 0.4 m x 0.4 m x 0.2 m slides",
    parameters = { { "azimuth", azimuth, "deg" }, { "mu", 0.4 } },
    checks = { { "tilt", unit = "deg", exact = math.atan(0.4)/deg, within = 0.1 } },
    run = function(p) return tilted(p, { 0.4, 0.4, 0.2 }, p.mu, math.atan(p.mu) - 0.2*deg,
      math.atan(p.mu) + 0.3*deg) end,
  }
end
return {
  title = "Joints in space",
  source = "Derived: a stress in proportion to the overlap over the polygon in contact, and friction of constant " ..
    "direction " ..
    "against the slip of each point",
  formula = [[\frac{|e_x|}{B} + \frac{|e_y|}{H} \le \frac{1}{6} \;\text{(kern)}, \qquad
T_\text{limit} = \frac{\mu p a^3}{6}\left(\sqrt{2} + \ln(1 + \sqrt{2})\right)]],
  text = "First slip of the turned face is at $\\sqrt{2}\\,\\mu p/(k_s a)$. Forces at the four corners alone " ..
    "would give 14.0 kPa " ..
    "in place of 22.05 kPa, and a torque that is too high by 85 %.",
  cases = cases,
}
