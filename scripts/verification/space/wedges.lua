-- Wedges in grooves, prisms on slopes, a corbel that turns a corner.
local trilith = require "trilith"
local deg = trilith.units "deg"
local g, sin, cos, tan = 9.80665, math.sin, math.cos, math.tan

local cases = {}

-- A wedge of a triangular section in a V groove; gravity is turned about y, so that the groove along x is level.
local function wedge(p, plunge)
  local a = p.half_angle*deg
  local m = trilith.model { name = "wedge", dim = 3, gravity = { g*sin(plunge), 0, -g*cos(plunge) } }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = p.mu, beta = 3e-5 } }
  local w, h = 0.5, 0.5/tan(a)
  local far, deep = 4*w, 4*h
  for i, side in ipairs { -1, 1 } do
    m:extrusion { name = "side " .. i, plane = "upright", outline = side > 0
      and { { 0, 0 }, { far, deep }, { far, -1 }, { 0, -1 } } or { { 0, 0 }, { 0, -1 }, { -far, -1 }, { -far, deep } },
      from = 0, depth = 12, material = "stone", support = "fixed", turn = { axis = { 0, 0, 1 }, angle = -90*deg } }
  end
  local block = m:extrusion { name = "wedge", plane = "upright", outline = { { 0, 0 }, { w, h }, { -w, h } }, from = 1,
    depth = 1, material = "stone", turn = { axis = { 0, 0, 1 }, angle = -90*deg } }
  return m, block
end
for _, half in ipairs { 45, 30, 60 } do
  local mu = 0.4
  local exact = g*(sin(40*deg) - mu/sin(half*deg)*cos(40*deg))
  cases[#cases + 1] = {
    name = ("wedge_slides_%.0f"):format(half), title = "wedge in a V groove that plunges by 40 deg",
    parameters = { { "half_angle", half, "deg" }, { "mu", mu } },
    checks = { { "acceleration", unit = "m/s2", exact = exact, tolerance = 0.005 } },
    run = function(p)
      local m, block = wedge(p, 40*deg)
      m:run { duration = 0.2 }
      local v, t = block.vx, m.time
      m:run { duration = 0.8 }
      return (block.vx - v)/(m.time - t)
    end,
  }
  local limit = math.atan(mu/sin(half*deg))/deg
  for _, side in ipairs { -0.5, 0.5 } do
    cases[#cases + 1] = {
      name = ("wedge_limit_%.0f_%s"):format(half, side < 0 and "below" or "above"),
      title = ("wedge in a V groove, %s %.3f deg"):format(side < 0 and "below" or "above", limit),
      parameters = { { "half_angle", half, "deg" }, { "mu", mu }, { "plunge", limit + side, "deg" } },
      checks = { { "wedge", exact = side < 0 and "stays" or "slides" } },
      run = function(p)
        local m, block = wedge(p, p.plunge*deg)
        m:run { duration = 0.3 }
        local x = block.x
        m:run { duration = 0.7 }
        return block.x - x > 1e-3 and "slides" or "stays"
      end,
    }
  end
end

-- A regular prism that lies on a slope begins to roll where its weight leaves the face it lies on.
for _, sides in ipairs { 6, 8, 12 } do
  for _, side in ipairs { -0.15, 0.15 } do
    local limit = 180/sides
    cases[#cases + 1] = {
      name = ("prism_%.0f_%s"):format(sides, side < 0 and "below" or "above"),
      title = ("prism of %.0f sides on a slope, %s %.1f deg"):format(sides, side < 0 and "below" or "above", limit),
      parameters = { { "sides", sides }, { "slope", limit + side, "deg" } }, slow = true,
      checks = { { "prism", exact = side < 0 and "stays" or "rolls" } },
      run = function(p)
        local angle = p.slope*deg
        local m = trilith.model { name = "prism", dim = 3, gravity = { g*sin(angle), 0, -g*cos(angle) } }
        m:material { name = "stone", density = 2400 }
        m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 4e13, ks = 4e13, mu = 1, beta = 5e-7 } }
        m:block { name = "ground", size = { 6, 4, 1 }, at = { -3, -2, -1 }, material = "stone", support = "fixed" }
        local outline, R = {}, 0.5
        for i = 1, p.sides do
          local a = -90*deg + (i - 0.5)*2*math.pi/p.sides
          outline[i] = { R*cos(a), R*sin(a) + R*cos(math.pi/p.sides) }
        end
        outline[1][2], outline[p.sides][2] = 0, 0
        local prism = m:extrusion { name = "prism", outline = outline, from = -0.25, depth = 0.5, material = "stone" }
        local function rolls() return math.abs(prism.rotation_y) > 0.02 end
        m:consolidate { duration = 2, grow = 0.2, rest = { ratio = 1e-5 }, or_go_on = true, until_true = rolls }
        m:run { duration = 3, until_true = rolls }
        return rolls() and "rolls" or "stays"
      end,
    }
  end
end

-- A corbel of five blocks, each shifted against the next in both directions by shares of the harmonic offsets.
for _, share in ipairs { 0.95, 1.05 } do
  cases[#cases + 1] = {
    name = ("two_way_corbel_%.0f"):format(100*share), title = "corbel of five blocks that turns a corner",
    parameters = { { "share", share }, { "blocks", 5 } }, slow = true,
    checks = { { "corbel", exact = share < 1 and "stands" or "falls" } },
    run = function(p)
      local m = trilith.model { name = "corbel", dim = 3 }
      m:material { name = "stone", density = 2000 }
      m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 4e12, ks = 2e12, mu = 0.7, beta = 2e-6 } }
      m:block { name = "ground", size = { 4, 4, 1 }, at = { -4, -4, -1 }, material = "stone", support = "fixed" }
      local x, y = -0.4, -0.2
      for i = p.blocks, 1, -1 do
        x, y = x + p.share*0.4/(2*i), y + p.share*0.2/(2*i)
        m:block { name = "block " .. i, size = { 0.4, 0.2, 0.1 }, at = { x, y, (p.blocks - i)*0.1 },
          material = "stone" }
      end
      local stones = m:bodies { name = "block *" }
      local function down() return stones.drift > 0.01 end
      m:consolidate { rest = { ratio = 1e-5, speed = 1e-5 }, duration = 1.5, grow = 0.001, or_go_on = true,
        until_true = down }
      if not down() then m:run { duration = 0.5, until_true = down } end
      return down() and "falls" or "stands"
    end,
  }
end

return {
  title = "Wedges, prisms and a corbel",
  source = "Hoek and Bray (1981), Rock Slope Engineering, chapter 8, for wedges; others by statics",
  formula = [[a = g\left(\sin\psi - \frac{\mu}{\sin w}\cos\psi\right), \qquad
\theta_\text{roll} = \frac{180^\circ}{n}]],
  cases = cases,
}
