-- A gravity dam on its foundation: dead load, pressure of the water, uplift under the base.
local trilith = require "trilith"
local g = 9.80665

-- A triangle of height H and base B, upstream face upright at x = 0. Forces per metre; the toe is at x = B.
local function dam(p)
  local water, m = 1000*g, trilith.model { name = "dam" }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = p.mu, beta = 1e-4 } }
  m:block { name = "rock", width = 40, height = 2, at = { -16, -2 }, material = "concrete", support = "fixed" }
  local body = m:polygon { name = "dam", outline = { { 0, 0 }, { p.B, 0 }, { 0, p.H } }, material = "concrete" }
  local uplift = p.uplift*water*p.level*p.B
  local arm = p.uplift < 1 and p.B/3 or p.B/2 -- a triangle, or uniform
  m:point_load { body = body, at = { 0, p.level/3 }, force = { p.share*water*p.level^2/2, 0 } }
  m:point_load { body = body, at = { arm, 0.01 }, force = { 0, uplift } }
  return m, body
end

local parameters = { { "H", 10, "m" }, { "B", 8, "m" }, { "level", 9, "m" }, { "mu", 0.75 }, { "uplift", 0.5 } }
local function with(share, uplift)
  local list = {}
  for i, row in ipairs(parameters) do list[i] = row end
  list[5] = { "uplift", uplift or 0.5 }
  list[#list + 1] = { "share", share }
  return list
end
local function state(p)
  local m, body = dam(p)
  m:consolidate { duration = 4, grow = 0.5, rest = { ratio = 1e-5 }, or_go_on = true }
  local x = body.ux
  m:run { duration = 1 }
  return body.ux - x > 1e-3 and "slides" or "stands"
end

return {
  title = "Gravity dam",
  source = "Statics of a rigid body with a linear distribution of stress",
  formula = [[\frac{\mu\,(W - U)}{P} = 1.1111, \qquad \sigma_\text{toe} = \frac{N}{B}\left(1 + \frac{6 e}{B}\right)]],
  text = "The uplift decreases linearly to zero at the toe (0.5 of the full head as a mean), or acts over the whole " ..
    "base (1). `share` multiplies the thrust of the water.",
  cases = {
    {
      name = "dam_stress", title = "dam with linear uplift", parameters = with(1),
      checks = { { "normal force", unit = "N", exact = 588.40e3, tolerance = 0.005 },
        { "thrust", unit = "N", exact = 397.17e3, tolerance = 0.005 },
        { "stress at the toe", unit = "Pa", exact = 111.70e3, tolerance = 0.005 } },
      run = function(p)
        local m, body = dam(p)
        m:consolidate { integrator = "static", shares = 10 }
        local n, t = 0, 0
        for _, r in ipairs(m:body "rock":reactions()) do n, t = n + r.fy, t + r.fx end
        return { ["normal force"] = math.abs(n) - m:body "rock".mass*g, thrust = math.abs(t),
          ["stress at the toe"] = -1e10*select(2, body:point { p.B, 0 }) }
      end,
    },
    { name = "dam_stands", title = "dam with linear uplift, below its factor of sliding of 1.1111",
      parameters = with(1.09), checks = { { "dam", exact = "stands" } }, run = state },
    { name = "dam_slides", title = "dam with linear uplift, above its factor of sliding of 1.1111",
      parameters = with(1.13), checks = { { "dam", exact = "slides" } }, run = state },
    { name = "dam_full_uplift", title = "dam with full uplift (factor 0.4444)", parameters = with(1, 1),
      checks = { { "dam", exact = "slides" } }, run = state },
  },
}
