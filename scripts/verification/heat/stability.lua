-- A bar between fixed ends that buckles as it is heated.
local trilith = require "trilith"

local function column(p, rise, push)
  local m = trilith.model { name = "column", gravity = 0 }
  m:material { name = "steel", density = 7850, E = 2.1e11 }
  local hold = p.clamped and "fixed" or { x = "fixed", y = "fixed" }
  local body = m:beam { name = "bar", from = { 0, 0 }, to = { 3, 0 }, material = "steel", divisions = 12,
    section = trilith.rectangle_section { width = 0.05, depth = 0.05 }, from_support = hold, to_support = hold,
    floating = true }
  m:heat { body = body, conductivity = 50, heat_capacity = 450, expansion = 1.2e-5, depth = 0.05 }
  if push then m:point_load { name = "push", body = body, at = { 1.5, 0 }, force = { 0, push } } end
  m:set_temperature { body = body, temperature = rise }
  m:consolidate { integrator = "static" }
  return m, body
end
-- The square of the lowest frequency decreases linearly with the normal force; where it is 0 the bar buckles.
local function critical(p)
  local function square(rise) return column(p, rise):modes { count = 1 }[1].square end
  local low, high = 0.3*p.about, 0.9*p.about
  local a, b = square(low), square(high)
  return high + b*(high - low)/(a - b)
end

local cases = {}
for _, row in ipairs { { "pinned", false, 19.0386 }, { "clamped", true, 76.154 } } do
  cases[#cases + 1] = { name = "thermal_buckling_" .. row[1], title = "heated bar with " .. row[1] .. " ends",
    parameters = { { "length", 3, "m" }, { "depth", 0.05, "m" }, { "clamped", row[2] }, { "about", row[3], "K" } },
    checks = { { "critical rise", unit = "K", exact = row[3], tolerance = 0.005 } },
    run = critical }
end
-- A push across the bar, which is removed at the end, decides to which side it buckles.
cases[#cases + 1] = { name = "thermal_bow", title = "bow at twice the critical rise",
  parameters = { { "rise", 2*19.0386, "K" }, { "push", 200, "N" } },
  checks = { { "bow", unit = "mm", exact = 28.868, tolerance = 0.03 } },
  run = function(p)
    local m, body = column(p, 0.5*p.rise/2, p.push)
    for i = 3, 20 do
      m:set_temperature { body = body, temperature = p.rise*i/20 }
      m:consolidate { integrator = "static" }
    end
    m:set_load { name = "push", factor = 0 }
    m:consolidate { integrator = "static" }
    return 1e3*select(2, body:point { 1.5, 0 })
  end }

return {
  title = "Thermal buckling",
  source = "Euler; the bow follows from the length of a sine wave",
  formula = [[\Delta T_c = \frac{\pi^2 r^2}{\alpha L^2}, \qquad
w = 2 r\sqrt{\frac{\Delta T}{\Delta T_c} - 1}]],
  text = "A bar between fixed ends is heated. With clamped ends the critical rise is four times larger.",
  cases = cases,
}
