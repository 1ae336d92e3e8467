-- A block on a bed under water: contact force with a wet and with a sealed joint, sliding, and free fall.
local trilith = require "trilith"
local g = 9.80665
local weight, own = 1000*g, 2400*g*0.6

local function model(p)
  local m = trilith.model { name = "block under water" }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.6, beta = 1e-3 } }
  m:block { name = "bed", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
  local block = m:block { name = "block", width = 1, height = 0.6, at = { -0.5, 0 }, material = "stone" }
  m:water { name = "water", body = "block", level = 3, side = "all", joints = p.joints }
  return m, block
end

-- Force of the contact on the bed.
local function pressed(p)
  local m = model(p)
  m:consolidate { integrator = "static" }
  local sum = 0
  for _, r in ipairs(m:body "bed":reactions()) do sum = sum + r.fy end
  return math.abs(sum) - m:body "bed".mass*g
end

-- State of the block one second after a load has grown.
local function state(m, block)
  m:run { duration = 1.5 }
  local x = block.ux
  m:run { duration = 1 }
  return block.ux - x > 1e-3 and "slides" or "stands"
end
local function pushed(p)
  local m, block = model { joints = "wet" }
  m:consolidate { duration = 2, grow = 0.2, rest = { ratio = 1e-5 }, or_go_on = true }
  m:point_load { body = block, at = { -0.5, 0.05 }, force = { p.force, 0 }, load_curve = { smooth = 1 } }
  return state(m, block)
end
local function in_flow(p)
  local m, block = model { joints = "wet" }
  m:consolidate { duration = 2, grow = 0.2, rest = { ratio = 1e-5 }, or_go_on = true }
  m:drag { body = block, velocity = { p.velocity, 0 }, coefficient = 1.2, area = 0.6, load_curve = { smooth = 1 } }
  return state(m, block)
end

local wet = own - weight*0.6
local slides, flow = 0.6*wet, (2*0.6*wet/(1000*1.2*0.6))^0.5
return {
  title = "Block on a bed under water",
  source = "Hydrostatics and Coulomb's law of friction",
  formula = [[N_\text{wet} = W - \rho g\, V, \qquad N_\text{sealed} = W + \rho g\, b\,(h - t), \qquad
u = \sqrt{\frac{2 \mu N_\text{wet}}{\rho\, c\, t}}]],
  text = "A block of width $b$ and height $t$ lies on a bed, $h$ under the surface. " ..
    "With `joints = \"wet\"` water acts " ..
    "below it; with `\"sealed\"` the closed joint is dry. A flow of velocity $u$ with the drag coefficient " ..
    "$c$ moves it.",
  cases = {
    { name = "water_block_wet", title = "water below the block", parameters = { { "joints", "wet" } },
      checks = { { "contact force", unit = "N", exact = wet, tolerance = 0.001 } }, run = pressed },
    { name = "water_block_sealed", title = "sealed joint", parameters = { { "joints", "sealed" } },
      checks = { { "contact force", unit = "N", exact = own + weight*2.4, tolerance = 0.001 } }, run = pressed },
    { name = "water_block_stands", title = "pushed below its friction of 4942.6 N",
      parameters = { { "force", 0.99*slides, "N" } },
      checks = { { "block", exact = "stands" } }, run = pushed },
    { name = "water_block_slides", title = "pushed above its friction of 4942.6 N",
      parameters = { { "force", 1.01*slides, "N" } },
      checks = { { "block", exact = "slides" } }, run = pushed },
    { name = "water_flow_stands", title = "in a flow below the limit of 3.7053 m/s",
      parameters = { { "velocity", 0.99*flow, "m/s" } },
      checks = { { "block", exact = "stands" } }, run = in_flow },
    { name = "water_flow_slides", title = "in a flow above the limit of 3.7053 m/s",
      parameters = { { "velocity", 1.01*flow, "m/s" } },
      checks = { { "block", exact = "slides" } }, run = in_flow },
    { name = "water_block_falls", title = "falls in water, without added mass",
      checks = { { "acceleration", unit = "m/s2", exact = g*(1 - 1/2.4), tolerance = 1e-3 } },
      run = function()
        local m = trilith.model { name = "fall" }
        m:material { name = "stone", density = 2400 }
        m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.6 } }
        local block = m:block { name = "block", width = 1, height = 0.6, at = { 0, 5 }, material = "stone",
          floating = true }
        m:water { body = block, level = 8, side = "all" }
        m:run { duration = 0.5, dt = 1e-3 }
        return -2*block.uy/0.5^2
      end },
  },
}
