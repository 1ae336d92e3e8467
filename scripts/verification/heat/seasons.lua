-- A span through a year, and waves of temperature in a thick wall.
local trilith = require "trilith"
local day = 86400
local year = 365*day

-- A wave of temperature with this amplitude [K] as a table of points.
local function wave(amplitude, period, points)
  local course = { period = period }
  for i = 0, points - 1 do
    course[#course + 1] = { i*period/points, amplitude*trilith.math.sin(2*math.pi*i/points) }
  end
  return course
end

local function span(left, right)
  local m = trilith.model { name = "span" }
  m:material { name = "concrete", density = 4e6/9.80665/160, E = 35e9 }
  m:material { name = "pier", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e11, mu = 0.6 } }
  local deck = m:beam { name = "deck", from = { 0, 0 }, to = { 40, 0 }, material = "concrete", divisions = 8,
    section = trilith.section { area = 4, inertia = 50, depth = 2 }, floating = true }
  local piers = {}
  for i, law in ipairs { left, right } do
    local x = i == 1 and 0 or 40
    piers[i] = m:block { name = "pier" .. i, width = 1, height = 1, at = { x - 0.5, -2.5 }, material = "pier",
      support = "fixed" }
    m:bearing { name = "bearing" .. i, between = { piers[i], deck }, from = { x, -1.5 }, to = { x, 0 }, along = law,
      axial = trilith.linear { stiffness = 1e11 } }
  end
  m:heat { body = deck, conductivity = 2, heat_capacity = 900, expansion = 1.1e-5, depth = 2 }
  m:heat_exchange { body = deck, side = "all", temperature = wave(30, year, 365) }
  m:consolidate { integrator = "static" }
  return m, deck, piers
end

-- Share of the amplitude, and lag, at a depth in a wall of elements under a wave, over the last of some periods.
local function wave_at(p)
  local m = trilith.model { name = "wall", gravity = 0 }
  m:material { name = "wall", density = 2000, E = 1e10 }
  local body = m:block { name = "wall", width = p.thickness, height = 0.1, at = { 0, 0 }, material = "wall",
    body = { mesh = { p.elements, 1 } }, floating = true }
  m:heat { body = body, conductivity = 8e-7*2000*900, heat_capacity = 900 }
  m:heat_exchange { body = body, side = "left", temperature = wave(1, p.period, 400) }
  local count = 100
  m:process { duration = (p.periods - 1)*p.period, step = p.period/count, mechanics = false }
  local a, b = 0, 0
  for i = 1, count do
    m:process { duration = p.period/count, step = p.period/count, mechanics = false }
    local t, angle = m:temperature(body, { p.depth, 0 }), 2*math.pi*i/count
    a, b = a + t*trilith.math.sin(angle)*2/count, b - t*trilith.math.cos(angle)*2/count
  end
  return (a*a + b*b)^0.5, trilith.math.atan(b, a)/(2*math.pi)*p.period
end

local cases = {
  { name = "sliding_year", title = "span fixed at one end, sliding at the other, through a year",
    parameters = { { "length", 40, "m" }, { "swing", 30, "K" }, { "mu", 0.03 }, { "weight", 4e6, "N" } },
    checks = { { "end at the warmest", unit = "mm", exact = 13.2, tolerance = 0.005 },
      { "end at the coldest", unit = "mm", exact = -13.2, tolerance = 0.005 },
      { "force on the pier", unit = "kN", exact = 60, tolerance = 0.005 },
      { "friction in the year", unit = "J", exact = 3168, tolerance = 0.005 } },
    run = function(p)
      local m, deck, piers = span(trilith.linear { stiffness = 1e12 },
        trilith.friction { stiffness = 1e10, mu = p.mu })
      local out = {}
      local function moved() return 1e3*(deck:point { 40, 0 } - 40) end
      local before = m.energy.bearing_inner
      m:process { duration = 91*day, step = day }
      out["end at the warmest"] = moved()
      out["force on the pier"] = math.abs(piers[2].reaction_x)/1e3
      m:process { duration = 183*day, step = day }
      out["end at the coldest"] = moved()
      m:process { duration = 91*day, step = day }
      out["friction in the year"] = m.energy.bearing_inner - before
      return out
    end },
  { name = "elastomer_year", title = "span on elastomers, at the warmest day",
    parameters = { { "left", 2e6, "N/m" }, { "right", 6e6, "N/m" } },
    checks = { { "force", unit = "kN", exact = 19.8, tolerance = 0.005 },
      { "left end", unit = "mm", exact = -9.9, tolerance = 0.005 },
      { "right end", unit = "mm", exact = 3.3, tolerance = 0.005 } },
    run = function(p)
      local m, deck, piers = span(trilith.linear { stiffness = p.left }, trilith.linear { stiffness = p.right })
      m:process { duration = 91*day, step = day }
      return { force = math.abs(piers[2].reaction_x)/1e3, ["left end"] = 1e3*(deck:point { 0, 0 }),
        ["right end"] = 1e3*(deck:point { 40, 0 } - 40) }
    end },
}
for _, row in ipairs {
  { "yearly_wave", "yearly wave", year, 2.8348, 28, 160, 4, 0.36788, 58.1*24 },
  { "daily_wave", "daily wave", day, 0.14833, 1.5, 160, 6, 0.36788, 3.82 },
  { "daily_wave_deep", "daily wave, deeper", day, 0.3, 1.5, 160, 6, 0.13232, 7.73 } } do
  cases[#cases + 1] = { name = row[1], title = row[2],
    parameters = { { "period", row[3], "s" }, { "depth", row[4], "m" }, { "thickness", row[5], "m" },
      { "elements", row[6] }, { "periods", row[7] } },
    checks = { { "share of the amplitude", exact = row[8], tolerance = 0.01 },
      { "lag", unit = "h", exact = row[9], tolerance = 0.01 } },
    run = function(p)
      local share, lag = wave_at(p)
      return { ["share of the amplitude"] = share, lag = lag/3600 }
    end }
end

return {
  title = "Seasons",
  source = "Carslaw and Jaeger (1959), section 2.6, for waves",
  formula = [[\frac{T(x)}{T_0} = e^{-x/d}, \qquad d = \sqrt{\frac{2 a}{\omega}}, \qquad
t_\text{lag} = \frac{x}{d\,\omega}]],
  text = "A span of 40 m whose mean temperature swings by 30 K moves its sliding end and loads its piers. A wave of " ..
    "temperature on a thick wall decays with the depth and lags behind.",
  cases = cases,
}
