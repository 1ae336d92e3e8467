-- Explicit central differences: error of the period, and its order.
local trilith = require "trilith"
local pi = math.pi

local function crossings(step, count)
  local m = trilith.model { name = "explicit", gravity = 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "ground", width = 1, height = 1, at = { -1, 0 }, material = "steel", support = "fixed" }
  local body = m:block { name = "mass", width = 1, height = 1, at = { 0, 0 }, mass = 1, material = "steel",
    velocity = { 1, 0 }, support = { y = "fixed", rotation = "fixed" }, floating = true }
  m:bearing { name = "spring", between = { "ground", "mass" }, at = { 0, 0.5 },
    along = trilith.linear { stiffness = 4*pi^2 } }
  local x = {}
  m:run { duration = count, dt = step, until_true = function()
    x[#x + 1] = body.ux
    return false
  end }
  local xx, xz = 0, 0
  for j = 2, #x - 1 do xx, xz = xx + x[j]^2, xz + x[j]*(x[j + 1] + x[j - 1]) end
  return 2*pi/math.acos(xz/xx/2)*step -- x_(j+1) + x_(j-1) = 2 cos(w' h) x_j
end

local cases = {}
for _, row in ipairs { { 0.02, -0.0659 }, { 0.05, -0.4141 }, { 0.1, -1.6934 } } do
  cases[#cases + 1] = {
    name = ("central_%.0f"):format(100*row[1]), title = "period of central differences",
    parameters = { { "step", row[1], "s" } },
    checks = { { "elongation of the period", unit = "%", exact = 100*(pi*row[1]/math.asin(pi*row[1]) - 1),
      tolerance = 1e-3 } },
    run = function(p) return 100*(crossings(p.step, 50) - 1) end,
  }
end
cases[#cases + 1] = {
  name = "order_central", title = "order of central differences",
  convergence = { parameter = "step", unit = "s", values = { 0.08, 0.04, 0.02, 0.01 }, order = 2, tolerance = 0.02,
    exact = 1, quantity = "period", quantity_unit = "s" },
  run = function(p) return crossings(p.step, 20) end,
}

return {
  title = "Explicit time integration",
  source = "Bathe (1996), Finite Element Procedures, section 9.4.2",
  formula = [[\frac{T'}{T} = \frac{\omega h/2}{\arcsin(\omega h/2)}]],
  cases = cases,
}
