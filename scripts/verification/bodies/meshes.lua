-- Bodies of finite elements: patch test, waves and impact of bars.
local trilith = require "trilith"
local mesh_nodes = { { 0, 0 }, { 0.24, 0 }, { 0.24, 0.12 }, { 0, 0.12 }, { 0.04, 0.02 }, { 0.18, 0.03 }, { 0.16, 0.08 },
  { 0.08, 0.08 } }

local c = math.sqrt(30e9/2400)

-- A bar along x of 1 m2, moving at a speed; it may not move across.
local function bar(m, name, x, length, speed, n)
  return m:block { name = name, width = length, height = 1, at = { x, 0 }, material = "concrete",
    velocity = { speed, 0 }, body = { mesh = { n, 1 } }, floating = true }
end
local function model(kn)
  local m = trilith.model { name = "bars", gravity = 0 }
  m:material { name = "concrete", density = 2400, E = 30e9, nu = 0 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn or 3e13, ks = 0, mu = 0 } }
  return m
end

-- One bar at 1 m/s hits another at rest: time in contact, speeds after it.
local function impact(p)
  local m = model()
  local left = bar(m, "left", -p.left, p.left, 1, math.floor(20*p.left))
  local right = bar(m, "right", 1e-4, p.right, 0, math.floor(20*p.right))
  local begun, ended
  m:run { duration = 1e-4 + 2.6*math.min(p.left, p.right)/c, until_true = function()
    local touching = #m:contacts() > 0
    if touching then begun, ended = begun or m.time, m.time end
    return false
  end }
  return { ["time in contact"] = ended - begun, ["speed of the left bar"] = left.vx,
    ["speed of the right bar"] = right.vx }
end

-- First frequency of a rod along x that is held at one end.
local function rod_frequency(p)
  local m = model()
  m:block { name = "rod", width = 10, height = 1, at = { 0, 0 }, material = "concrete", floating = true,
    body = { mesh = { p.elements, 1 } },
    hold = { { from = { -0.01, -0.01 }, to = { 0.01, 1.01 }, x = "fixed", y = "fixed" } } }
  local best
  for _, mode in ipairs(m:modes { count = 8 }) do
    -- Modes of bending move no mass along x.
    if not best and mode.mass_x > mode.mass_y then best = mode.frequency end
  end
  return best
end

return {
  title = "Meshes: patch test and waves in bars",
  source = "Irons and Razzaque (1972) for the patch test, with the mesh of MacNeal and Harder (1985), Finite " ..
    "Elements in " ..
    "Analysis and Design 1; Goldsmith (1960), Impact, chapter 3, for the bars",
  formula = [[c = \sqrt{\frac{E}{\rho}}, \qquad \sigma = \tfrac{1}{2}\rho c v, \qquad T = \frac{2 L}{c}]],
  text = "Two equal elastic bars that collide stay in contact for the time in which a wave goes to the free end " ..
    "and back, " ..
    "and exchange their speeds. A short bar stops when it strikes a bar of twice its length. The patch test loads a " ..
    "share of the stress, so that the change of " ..
    "the geometry has no effect.",
  cases = {
    {
      name = "patch_test", title = "irregular mesh of five elements under a linear displacement",
      parameters = { { "E", 1e6, "Pa" }, { "nu", 0.25 }, { "share", 1e-5 } },
      checks = { { "sxx over share", unit = "Pa", exact = 4000/3, tolerance = 1e-6 },
        { "syy over share", unit = "Pa", exact = 4000/3, tolerance = 1e-6 },
        { "sxy over share", unit = "Pa", exact = 400, tolerance = 1e-6 } },
      run = function(p)
        -- The edges carry the tractions of the uniform stress; the body is held at three points without reaction.
        local m = trilith.model { name = "patch", gravity = 0, thickness = 1 }
        m:material { name = "m", density = 1000, E = p.E, nu = p.nu }
        local body = m:body { name = "patch", material = "m", floating = true,
          mesh = { nodes = mesh_nodes, elements = { { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 4, 8, 7 }, { 4, 1, 5, 8 },
            { 5, 6, 7, 8 } } },
          hold = { { from = { -0.01, -0.01 }, to = { 0.01, 0.01 }, x = "fixed", y = "fixed" },
            { from = { 0.23, -0.01 }, to = { 0.25, 0.01 }, x = "free", y = "fixed" } } }
        for face, traction in pairs { left = { -4000/3, -400 }, right = { 4000/3, 400 }, bottom = { -400, -4000/3 },
          top = { 400, 4000/3 } } do
          local size = math.sqrt(traction[1]^2 + traction[2]^2)
          m:pressure { body = body, face = face, value = p.share*size, direction = traction }
        end
        m:consolidate { integrator = "static" }
        return { ["sxx over share"] = body.sxx/p.share, ["syy over share"] = body.syy/p.share,
          ["sxy over share"] = body.sxy/p.share }
      end,
    },
    {
      name = "equal_bars", title = "two equal bars",
      parameters = { { "left", 10, "m" }, { "right", 10, "m" } },
      checks = { { "time in contact", unit = "s", exact = 20/c, tolerance = 0.03 },
        { "speed of the left bar", unit = "m/s", exact = 0, within = 0.03 },
        { "speed of the right bar", unit = "m/s", exact = 1, tolerance = 0.03 } },
      run = impact,
    },
    {
      name = "short_on_long", title = "a bar on one of twice its length",
      parameters = { { "left", 5, "m" }, { "right", 10, "m" } },
      checks = { { "time in contact", unit = "s", exact = 10/c, tolerance = 0.03 },
        { "speed of the left bar", unit = "m/s", exact = 0, within = 0.03 },
        { "speed of the right bar", unit = "m/s", exact = 0.5, tolerance = 0.03 } },
      run = impact,
    },
    {
      name = "rod_convergence", title = "rod of 10 m held at one end",
      convergence = { parameter = "elements", values = { 4, 8, 16 }, order = 2, tolerance = 0.05, exact = c/40,
        quantity = "first frequency along it", quantity_unit = "Hz" },
      run = rod_frequency,
    },
  },
}
