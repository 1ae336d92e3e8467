-- Dry panels in running bond on a table that tilts until they fall.
local trilith = require "trilith"
local deg = trilith.units "deg"

-- Horizontal load factor at which a panel falls: tilted fast to 0.9 of `least`, then by 0.5 deg/s.
local function falls_at(p, halves, least)
  local m = trilith.model { name = "panel", thickness = 1 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 4e11, ks = 2e11, mu = p.mu, beta = 5e-6 } }
  m:running_bond { name = "wall", columns = p.columns, courses = p.courses, unit_width = 0.4, unit_height = p.height,
    half_courses = halves, base_height = 0.2, base_margin = 0.6, material = "stone", fixed = "base" }
  m:consolidate { duration = 2, rest = { speed = 1e-6 } }
  local fast = 0.9*math.atan(least)
  m:tilt { rate = 4*deg, by = fast }
  m:run { duration = fast/(4*deg) }
  local from, fallen = m.time, false
  m:every(0.002, function()
    if m.speed > 0.02 then fallen = true; m:stop() end
  end)
  m:tilt { rate = 0.5*deg, by = 12*deg }
  m:run { duration = 24 }
  return fallen and math.tan(fast + 0.5*deg*(m.time - from)) or 0/0
end

local cases = {}
for _, row in ipairs {
  { "panel_6", 5, 6, 0.175, "odd", 0.65, 0.64286, 0.63982 },
  { "panel_10", 5, 10, 0.175, "odd", 0.65, 0.58000, 0.56262 },
  { "panel_high_40", 5, 10, 0.2, "even", 0.40, 0.4000, 0.4000 },
  { "panel_high_65", 5, 10, 0.2, "even", 0.65, 0.5383, 0.537 },
  { "panel_slender_65", 3, 12, 0.2, "even", 0.65, 0.4280, 0.4214 },
} do
  local halves, most, least = row[5], row[7], row[8]
  cases[#cases + 1] = {
    name = row[1], title = "dry panel on a tilting table", slow = true,
    parameters = { { "columns", row[2] }, { "courses", row[3] }, { "height", row[4], "m" }, { "mu", row[6] } },
    checks = { { "factor at collapse", between = { 0.98*least, 1.001*most } } },
    known = row[4] == 0.2 and row[6] > 0.5 and "head joints of a panel that was settled upright carry no " ..
      "friction, and the published limit counts on it (Theory, Dry panels)" or nil,
    run = function(p) return falls_at(p, halves, least) end,
  }
end

return {
  title = "Dry panels on a tilting table",
  source = "Ferris and Tin-Loi (2001), International Journal of Mechanical Sciences 43, and Gilbert, Casapulla and " ..
    "Ahmed (2006), Computers and Structures 84; the high panels by linear programming",
  formula = [[\lambda = \tan\theta_\text{fail}]],
  text = "Blocks are 0.4 m long. The upper bound of the range is the limit of joints that dilate as they slide, " ..
    "and the lower bound the least value that a search without dilatancy has found, less 2 %.",
  cases = cases,
}
