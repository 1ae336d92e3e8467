-- Rigid bodies in space that stand: a table of four feet, blocks that tip over an edge or a corner, a wedge on two
-- planes.
local trilith = require "trilith"
local deg = trilith.units "deg"
local g, sin, cos = 9.80665, trilith.math.sin, trilith.math.cos

local cases = {}

-- A slab on four feet that are fixed to the ground; the load is a force off its middle.
for i, row in ipairs { { 0.2, 0.08, 4000, 3000, 2000, 1000 }, { 0.375, 0.2, 6250, 2500, 1250, 0 } } do
  local feet = { { "foot +,+", 1, 1 }, { "foot +,-", 1, -1 }, { "foot -,+", -1, 1 }, { "foot -,-", -1, -1 } }
  local checks = {}
  for k, foot in ipairs(feet) do
    local force = row[k + 2]
    checks[k] = { foot[1], unit = "N", exact = force, tolerance = force > 0 and 0.005 or nil,
      within = force == 0 and 1 or nil }
  end
  cases[#cases + 1] = {
    name = "table_" .. i, title = "rigid plate on feet at (0.5 m, 0.4 m) from its middle, 10 kN",
    parameters = { { "ex", row[1], "m" }, { "ey", row[2], "m" } },
    checks = checks,
    run = function(p)
      local m = trilith.model { name = "table", dim = 3, gravity = 0 }
      m:material { name = "stone", density = 1000 }
      m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e11, mu = 0.5, beta = 1e-4 } }
      for _, foot in ipairs(feet) do
        m:block { name = foot[1], size = { 0.04, 0.04, 0.5 }, material = "stone", support = "fixed",
          at = { 0.5*foot[2] - 0.02, 0.4*foot[3] - 0.02, -0.5 } }
      end
      local slab = m:block { name = "slab", size = { 1.2, 1, 0.1 }, at = { -0.6, -0.5, 0 }, material = "stone" }
      m:point_load { body = slab, at = { p.ex, p.ey, 0.05 }, force = { 0, 0, -1e4 } }
      m:consolidate { integrator = "static", shares = 10 }
      local found = {}
      for _, foot in ipairs(feet) do
        local sum = 0
        for _, r in ipairs(m:body(foot[1]):reactions()) do sum = sum + r.fz end
        found[foot[1]] = math.abs(sum)
      end
      return found
    end,
  }
end

-- A tall block under gravity that is turned towards an azimuth. Over a corner it stands on a small triangle, which
-- needs a stiffer joint.
for _, row in ipairs { { 0, 18.435 }, { 15, 19.04 }, { 30, 21.05 }, { 45, 25.24 } } do
  for _, side in ipairs { -0.3, 0.05 } do
    local corner = row[1] == 45
    cases[#cases + 1] = {
      name = ("tall_block_%.0f_%s"):format(row[1], side < 0 and "below" or "above"), slow = true,
      title = ("block of 0.4 m x 0.4 m x 1.2 m, %s %.3f deg"):format(side < 0 and "below" or "above", row[2]),
      parameters = { { "azimuth", row[1], "deg" }, { "tilt", row[2] + side, "deg" }, { "mu", 0.9 } },
      checks = { { "block", exact = side < 0 and "stands" or "overturns" } },
      run = function(p)
        local tilt, azimuth = p.tilt*deg, p.azimuth*deg
        local m = trilith.model { name = "block", dim = 3,
          gravity = { g*sin(tilt)*cos(azimuth), g*sin(tilt)*sin(azimuth), -g*cos(tilt) } }
        m:material { name = "stone", density = 2400 }
        m:contact { between = { "*", "*" }, law = trilith.frictional { kn = corner and 1e14 or 1e12,
          ks = corner and 1e14 or 1e12, mu = p.mu, beta = corner and 2e-6 or 3e-5 } }
        m:block { name = "ground", size = { 6, 6, 1 }, at = { -3, -3, -1 }, material = "stone", support = "fixed" }
        local block = m:block { name = "block", size = { 0.4, 0.4, 1.2 }, at = { -0.2, -0.2, 0 }, material = "stone" }
        local function over()
          return math.max(math.abs(block.rotation_x), math.abs(block.rotation_y)) > 0.1
        end
        m:consolidate { duration = 1, grow = 0.5, rest = { ratio = 1e-5 }, or_go_on = true, until_true = over }
        m:run { duration = 3, until_true = over }
        return over() and "overturns" or "stands"
      end,
    }
  end
end

-- Two planes that carry a wedge: unit vectors, x to the east, y to the north.
local function cross(a, b)
  return { a[2]*b[3] - a[3]*b[2], a[3]*b[1] - a[1]*b[3], a[1]*b[2] - a[2]*b[1] }
end
local function dot(a, b) return a[1]*b[1] + a[2]*b[2] + a[3]*b[3] end
local function scaled(a, by) return { by*a[1], by*a[2], by*a[3] } end
local function sum(...)
  local s = { 0, 0, 0 }
  for _, v in ipairs { ... } do s = { s[1] + v[1], s[2] + v[2], s[3] + v[3] } end
  return s
end
local function normal(dip, direction)
  local d, a = dip*deg, direction*deg
  return { sin(d)*sin(a), sin(d)*cos(a), cos(d) }
end
local first, second = normal(40, 165), normal(70, 285)
local line = cross(first, second)
line = scaled(line, (line[3] > 0 and -1 or 1)/math.sqrt(dot(line, line)))
-- In a plane, at a right angle to the line, upwards and away from the other plane.
local function up(of, other)
  local way = cross(of, line)
  return dot(way, other) > 0 and way or scaled(way, -1)
end

local function wedge(p)
  local m = trilith.model { name = "wedge", dim = 3 }
  m:material { name = "stone", density = 2400 }
  local ways = { up(first, second), up(second, first) }
  for i, plane in ipairs { { first, 35 }, { second, 20 } } do
    local name, points = "bank " .. i, {}
    for _, along in ipairs { -2, 3 } do
      for _, across in ipairs { 0, 0.6 } do
        for _, deep in ipairs { 0, -0.2 } do
          points[#points + 1] = sum(scaled(line, along), scaled(ways[i], across), scaled(plane[1], deep))
        end
      end
    end
    m:hull { name = name, points = points, material = "stone", support = "fixed" }
    m:contact { between = { name, "wedge" }, law = trilith.frictional { kn = 1e10, ks = 1e10,
      mu = math.tan(plane[2]*deg)/p.safety, beta = 1e-4 } }
  end
  m:contact { between = { "bank 1", "bank 2" }, law = "none" }
  local points = {}
  for _, along in ipairs { 0, 1 } do
    for _, at in ipairs { { 0, 0 }, { 0.3, 0 }, { 0, 0.3 } } do
      points[#points + 1] = sum(scaled(line, along), scaled(ways[1], at[1]), scaled(ways[2], at[2]))
    end
  end
  local block = m:hull { name = "wedge", points = points, material = "stone", velocity = scaled(line, 0.05),
    floating = true }
  local function speed() return dot({ block.vx, block.vy, block.vz }, line) end
  m:run { duration = 0.1 }
  local early, from = speed(), m.time
  m:run { duration = 0.2 }
  return (speed() - early)/(m.time - from)
end
for _, safety in ipairs { 1.29, 1.32, 2 } do
  local exact = g*0.52352*(1 - 1.3041/safety)
  cases[#cases + 1] = {
    name = ("two_planes_%.0f"):format(100*safety),
    title = "wedge on planes of 40 deg/165 deg and 70 deg/285 deg, friction angles of 35 deg and 20 deg",
    parameters = { { "safety", safety } },
    checks = { { "acceleration down the line", unit = "m/s2", exact = exact, within = 0.01*g*0.52352 } },
    run = wedge,
  }
end

return {
  title = "Bodies that stand",
  source = "Statics of a rigid plate and of a block; Hoek and Bray (1981), Rock Slope Engineering, chapter 8, for " ..
    "the wedge: plunge 31.569 deg, factor of safety 1.3041",
  formula = [[N_i = \frac{W}{4}\left(1 \pm \frac{e_x}{a} \pm \frac{e_y}{b}\right), \qquad
\tan\theta_\text{over} = \frac{b}{h\,\max(\cos\alpha, \sin\alpha)}]],
  text = "The fourth foot of the plate lifts where $e_x/a + e_y/b > 1$. The wedge slides down the line in which its " ..
    "planes meet, with both friction coefficients divided by a factor: at the factor of safety it does not accelerate.",
  cases = cases,
}
