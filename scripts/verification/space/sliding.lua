-- Blocks that slide in space: friction acts against the slip, whatever its direction.
local trilith = require "trilith"
local deg = trilith.units "deg"
local g, pi = 9.80665, math.pi

local function slab(size, mu, gravity, options)
  options = options or {}
  local m = trilith.model { name = "sliding", dim = 3, gravity = gravity }
  m:material { name = "stone", density = 2400 }
  local mass = 2400*size[1]*size[2]*size[3]
  local kn = options.kn or 2e7*mass/(size[1]*size[2])
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn, mu = mu, beta = options.beta
    or 1e-4 } }
  m:block { name = "ground", size = { 10, 10, 1 }, at = { -5, -5, -1 }, material = "stone", support = "fixed" }
  local block = m:block { name = "slab", size = size, anchor = "centre", at = { 0, 0, size[3]/2 }, material = "stone",
    velocity = options.velocity, spin = options.spin, support = options.support }
  return m, block
end

local cases = {}

for _, row in ipairs { { "tan30", math.tan(30*deg), 1, .53886, .84706 }, { "40", 0.4, 1, .86198, 1.40453 } } do
  cases[#cases + 1] = {
    name = "kick_across_" .. row[1], title = "kicked across a slope of 30 deg with 2 m/s",
    parameters = { { "mu", row[2] }, { "time", row[3], "s" } },
    checks = { { "distance across", unit = "m", exact = row[4], tolerance = 0.005 },
      { "distance down", unit = "m", exact = row[5], tolerance = 0.005 } },
    run = function(p)
      local m, block = slab({ 0.1, 0.1, 0.01 }, p.mu, { g*math.sin(30*deg), 0, -g*math.cos(30*deg) },
        { velocity = { 0, 2, 0 }, support = { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" } })
      m:run { duration = p.time }
      return { ["distance across"] = block.uy, ["distance down"] = block.ux }
    end,
  }
end
cases[#cases + 1] = {
  name = "kick_across_stops", title = "kicked across a slope of 30 deg with 2 m/s, stops",
  parameters = { { "mu", 0.7 } },
  checks = { { "distance across", unit = "m", exact = .40536, tolerance = 0.005 },
    { "distance down", unit = "m", exact = .43392, tolerance = 0.005 } },
  run = function(p)
    local m, block = slab({ 0.1, 0.1, 0.01 }, p.mu, { g*math.sin(30*deg), 0, -g*math.cos(30*deg) },
      { velocity = { 0, 2, 0 }, support = { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" } })
    m:run { duration = 1.5 }
    return { ["distance across"] = block.uy, ["distance down"] = block.ux }
  end,
}

-- A base that moves on a circle: the block follows on a circle of its own.
for _, row in ipairs { { 0.5, 0.3, .099362 }, { 0.6, 0.5, .082387 } } do
  cases[#cases + 1] = {
    name = ("circular_base_%.0f"):format(100*row[1]), title = "base on a circle, once a second",
    parameters = { { "A", row[1], "g" }, { "mu", row[2] } },
    checks = { { "radius of the slip", unit = "m", exact = row[3], tolerance = 0.005 } },
    run = function(p)
      local m, block = slab({ 0.4, 0.4, 0.02 }, p.mu, g, { support = { rotation_x = "fixed", rotation_y = "fixed",
        rotation_z = "fixed" } })
      local ground, w, x, y, dt = m:body "ground", 2*pi, {}, {}, 1e-3
      for i = 0, 12000 do
        x[i + 1], y[i + 1] = p.A*g*trilith.math.cos(w*i*dt), p.A*g*trilith.math.sin(w*i*dt)
      end
      -- Largest distance between two points of a turn, which no drift changes by much.
      local low_x, high_x, low_y, high_y = math.huge, -math.huge, math.huge, -math.huge
      m:shake { body = "ground", x = trilith.motion { acceleration = x, dt = dt, allow_drift = true },
        y = trilith.motion { acceleration = y, dt = dt, v0 = -p.A*g/w, allow_drift = true }, duration = 12,
        until_true = function()
          if m.time > 11 then
            local u, v = block.x - ground.x, block.y - ground.y
            low_x, high_x = math.min(low_x, u), math.max(high_x, u)
            low_y, high_y = math.min(low_y, v), math.max(high_y, v)
          end
          return false
        end }
      return (high_x - low_x + high_y - low_y)/4
    end,
  }
end

-- A pulse of the base in two directions at once.
cases[#cases + 1] = {
  name = "two_way_pulse", title = "base moved along x and y by sines of 1 Hz and 2 Hz for 1 s",
  parameters = { { "ax", 0.4, "g" }, { "ay", 0.3, "g" }, { "mu", 0.25 } },
  checks = { { "largest slip", unit = "m", exact = .12284, tolerance = 0.01 },
    { "slip along x at the end", unit = "m", exact = .0041, within = 0.002 },
    { "slip along y at the end", unit = "m", exact = .0585, within = 0.002 } },
  run = function(p)
    local m, block = slab({ 0.1, 0.1, 0.01 }, p.mu, g, { support = { rotation_x = "fixed", rotation_y = "fixed",
      rotation_z = "fixed" } })
    local ground, x, y, dt = m:body "ground", {}, {}, 1e-3
    for i = 0, 2500 do
      local t = i*dt
      x[i + 1] = t < 1 and p.ax*g*trilith.math.sin(2*pi*t) or 0
      y[i + 1] = t < 1 and p.ay*g*trilith.math.sin(4*pi*t) or 0
    end
    local most = 0
    m:shake { body = "ground", x = trilith.motion { acceleration = x, dt = dt, allow_drift = true },
      y = trilith.motion { acceleration = y, dt = dt, allow_drift = true }, duration = 2.5, until_true = function()
        most = math.max(most, math.sqrt((block.x - ground.x)^2 + (block.y - ground.y)^2))
        return false
      end }
    return { ["largest slip"] = most, ["slip along x at the end"] = math.abs(block.x - ground.x),
      ["slip along y at the end"] = math.abs(block.y - ground.y) }
  end,
}

-- A thin plate that slides and spins.
for _, row in ipairs { { 0, 10, nil, .59228, 0, 2.9614 }, { 1, 5, nil, .4808, .2301, 1.2685 },
  { 1, 10, nil, .7142, .3714, 3.511 } } do
  cases[#cases + 1] = {
    name = ("plate_%.0f_%.0f"):format(row[1], row[2]), title = "plate of 0.4 m x 0.4 m x 0.01 m that slides and spins",
    parameters = { { "speed", row[1], "m/s" }, { "spin", row[2], "rad/s" }, { "mu", 0.3 } },
    checks = { { "stops after", unit = "s", exact = row[4], tolerance = 0.02 },
      row[5] > 0 and { "distance", unit = "m", exact = row[5], tolerance = 0.02 }
        or { "distance", unit = "m", exact = 0, within = 0.001 },
      { "rotation", unit = "rad", exact = row[6], tolerance = 0.02 } },
    run = function(p)
      local m, block = slab({ 0.4, 0.4, 0.01 }, p.mu, g, { velocity = { p.speed, 0, 0 }, spin = { 0, 0, p.spin } })
      local stops = 0
      m:run { duration = 1, until_true = function()
        if math.abs(block.spin_z) > 0.01 or block.speed > 0.002 then stops = m.time end
        return false
      end }
      return { ["stops after"] = stops, distance = block.ux, ["rotation"] = block.rotation_z }
    end,
  }
end

return {
  title = "Sliding in space",
  source = "Derived: Coulomb friction against the velocity of each point, integrated over the face; the orbit on " ..
    "a base that " ..
    "moves on a circle by equilibrium in the turning frame",
  formula = [[\dot v_\parallel = g\sin\theta - \mu g\cos\theta\,\frac{v_\parallel}{v}, \qquad
r = \frac{g\sqrt{A^2 - \mu^2}}{\omega^2}]],
  cases = cases,
}
