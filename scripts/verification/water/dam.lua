-- A gravity dam with uplift in its joint: linear, full, with a drain, with tail water, and with a crack at the heel.
local trilith = require "trilith"
local g = 9.80665
local w, kn = 1000*g, 1e11

local function dam(p)
  local m = trilith.model { name = "dam" }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn, mu = p.mu or 0.75, beta = 1e-4 } }
  m:block { name = "rock", width = 40, height = 2, at = { -16, -2 }, material = "concrete", support = "fixed" }
  local body = m:polygon { name = "dam", outline = { { 0, 0 }, { p.B, 0 }, { 2, 12 }, { 0, 12 } },
    material = "concrete" }
  m:water { name = "lake", body = body, level = p.level, side = "left" }
  if p.tail then m:water { name = "tail", body = body, level = p.tail, side = "right" } end
  local drain = p.drain and { at = p.drain, efficiency = p.efficiency } or nil
  m:uplift { name = "uplift", upper = "dam", lower = "rock", upstream = "lake", downstream = p.tail and "tail" or nil,
    head = p.head, drain = drain }
  return m, body
end

-- Weight, forces and moments about the toe, positive where they hold the dam. Uplift as a list of { from, to, p, q }.
local function expected(B, level, parts, tail)
  local area = 12*2 + 6*(B - 2)
  local W = 2400*g*area
  local x = (24*1 + 6*(B - 2)*(2 + (B - 2)/3))/area
  local M = W*(B - x) - w*level^3/6
  local P, N = w*level^2/2, W
  if tail then
    local slope = (B - 2)/12 -- water on the inclined face: pushes upstream and downwards
    P, N, M = P - w*tail^2/2, N + w*tail^2/2*slope, M + w*tail^3/6 + w*tail^2/2*slope*(slope*tail/3)
  end
  for _, u in ipairs(parts) do
    local from, to, p, q = u[1], u[2], w*u[3], w*u[4]
    local U = (p + q)/2*(to - from)
    local centre = from + (to - from)*(p + 2*q)/(3*(p + q))
    N, M = N - U, M - U*(B - centre)
  end
  local r = M/N
  local e = B/2 - r
  return { ["normal force"] = N, thrust = P, ["resultant from the toe"] = r,
    ["stress at the heel"] = N/B*(1 - 6*e/B), ["stress at the toe"] = N/B*(1 + 6*e/B) }
end

local units = { ["normal force"] = "N", thrust = "N", ["resultant from the toe"] = "m",
  ["stress at the heel"] = "Pa", ["stress at the toe"] = "Pa" }
local order = { "normal force", "thrust", "resultant from the toe", "stress at the heel", "stress at the toe" }

local function read(m, body, p)
  local n, t, moment = 0, 0, 0
  local rock = m:body "rock"
  for _, r in ipairs(rock:reactions()) do
    n, t, moment = n + r.fy, t + r.fx, moment + r.m + (r.x - p.B)*r.fy - r.y*r.fx
  end
  -- The uplift on the rock is not a contact force.
  local up = m:water_state "uplift"
  local N = n - rock.mass*g - up.force[2]
  local heel, toe = -kn*select(2, body:point { 0, 0 }), -kn*select(2, body:point { p.B, 0 })
  local e = (toe - heel)/(toe + heel)*p.B/6
  return { ["normal force"] = N, thrust = math.abs(t), ["resultant from the toe"] = p.B/2 - e,
    ["stress at the heel"] = heel, ["stress at the toe"] = toe }
end

local cases = {}
local function stress_case(name, title, p, parts)
  local want, checks, list = expected(p.B, p.level, parts, p.tail), {}, {}
  for i, key in ipairs(order) do checks[i] = { key, unit = units[key], exact = want[key], tolerance = 0.005 } end
  for _, key in ipairs { "B", "level", "tail", "drain", "efficiency", "head" } do
    local unit = type(p[key]) == "number" and key ~= "efficiency" and "m" or nil
    if p[key] then list[#list + 1] = { key, p[key], unit } end
  end
  cases[#cases + 1] = { name = name, title = title, parameters = list, checks = checks,
    run = function(q)
      q.mu = 10 -- stresses alone
      local m, body = dam(q)
      m:consolidate { integrator = "static" }
      return read(m, body, q)
    end }
end
stress_case("water_dam_linear", "uplift that falls linearly to the toe", { B = 9, level = 11 }, { { 0, 9, 11, 0 } })
stress_case("water_dam_full", "full uplift", { B = 9, level = 11, head = "full" }, { { 0, 9, 11, 11 } })
stress_case("water_dam_drain", "drain 1.5 m from the heel that takes two thirds", { B = 9, level = 11, drain = 1.5,
  efficiency = 2/3 }, { { 0, 1.5, 11, 11*7.5/9/3 }, { 1.5, 9, 11*7.5/9/3, 0 } })
stress_case("water_dam_tail", "tail water of 2 m", { B = 9, level = 11, tail = 2 }, { { 0, 9, 11, 2 } })

local function slide_case(name, title, head, mu, expect)
  cases[#cases + 1] = { name = name, title = title, parameters = { { "head", head }, { "mu", mu } },
    checks = { { "dam", exact = expect } },
    run = function(q)
      local m, body = dam { B = 9, level = 11, head = q.head, mu = q.mu }
      m:consolidate { duration = 3, grow = 0.5, rest = { ratio = 1e-5 }, or_go_on = true }
      local x = body.ux
      m:run { duration = 0.5 }
      return body.ux - x > 1e-3 and "slides" or "stands"
    end }
end
slide_case("water_dam_stands", "friction of 0.75 with linear uplift (needed: 0.5556)", "linear", 0.75, "stands")
slide_case("water_dam_slides", "friction of 0.75 with full uplift (needed: 1.0185)", "full", 0.75, "slides")

for _, row in ipairs { { 11, 0 }, { 11.5, 0.6546 }, { 11.7, 1.6033 }, { 12, 3.2 } } do
  local level, crack = row[1], row[2]
  cases[#cases + 1] = { name = ("water_dam_crack_%d"):format(level*10), title = ("crack under %g m"):format(level),
    parameters = { { "B", 8, "m" }, { "level", level, "m" } },
    checks = { { "crack", unit = "m", exact = crack, within = 0.01*8 } },
    run = function(p)
      local m = dam { B = p.B, level = 10, mu = 10 }
      m:consolidate { integrator = "static" }
      m:set_level { name = "lake", level = p.level }
      m:consolidate { integrator = "static" }
      return m:water_state "uplift".crack
    end }
end
cases[#cases + 1] = { name = "water_dam_closes", title = "level raised to 11.7 m and lowered to 11 m again",
  parameters = { { "B", 8, "m" } },
  checks = { { "crack at 11.7 m", unit = "m", exact = 1.6033, within = 0.08 },
    { "crack at 11 m", unit = "m", exact = 0, within = 1e-5 },
    { "stress at the heel", unit = "Pa", exact = 23567, tolerance = 0.005 },
    { "stress at the toe", unit = "Pa", exact = 221600, tolerance = 0.005 } },
  run = function(p)
    local m, body = dam { B = p.B, level = 10, mu = 10 }
    m:consolidate { integrator = "static" }
    m:set_level { name = "lake", level = 11.7 }
    m:consolidate { integrator = "static" }
    local crack = m:water_state "uplift".crack
    m:set_level { name = "lake", level = 11 }
    m:consolidate { integrator = "static" }
    local after = read(m, body, { B = p.B })
    return { ["crack at 11.7 m"] = crack, ["crack at 11 m"] = m:water_state "uplift".crack,
      ["stress at the heel"] = after["stress at the heel"], ["stress at the toe"] = after["stress at the toe"] }
  end }

return {
  title = "Gravity dam with water in its joint",
  source = "U.S. Army Corps of Engineers, Gravity dam design, EM 1110-2-2200, 1995; statics of a joint without tension",
  formula = [[\sigma = \frac{W - U}{B}\left(1 \pm \frac{6 e}{B}\right), \qquad
h(s) = h_\text{up} \text{ for } s \le c, \qquad h(s) = h_\text{up}\,\frac{B - s}{B - c} \text{ for } s > c]],
  text = "A dam 12 m high with an upright upstream face, 2 m wide at its crest. $c$ is the length of the crack, " ..
    "where the effective contact stress would be tension. Tail water also loads the inclined face. A closed joint " ..
    "begins where the faces overlap, and the dam moves by about a micrometre.",
  cases = cases,
}
