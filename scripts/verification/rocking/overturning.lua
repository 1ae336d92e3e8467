-- A rigid block on a base that accelerates or tilts: when it lifts, slides or overturns.
local trilith = require "trilith"
local deg = trilith.units "deg"
local g = 9.80665

local function stands_on(p, options)
  local lean = (options.lean or 0)*deg
  local m = trilith.model { name = "overturning", gravity = { g*trilith.math.sin(lean), -g*trilith.math.cos(lean) } }
  m:material { name = "stone", density = 1000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = options.kn or 1e12, ks = (options.kn or 1e12)/2,
    mu = p.mu or 2, beta = options.beta or 1e-5 } }
  m:block { name = "base", width = 12, height = 1, at = { -6, -1 }, material = "stone", support = "fixed" }
  local top
  for i = 1, options.blocks or 1 do
    top = m:block { name = "block " .. i, width = p.width, height = p.height, at = { 0, (i - 1)*p.height },
      material = "stone" }
  end
  return m, top
end

-- Whether the block overturns under `halves` half waves of a sine of 1 Hz.
local function under_pulse(p)
  local m, block = stands_on(p, {})
  local samples = {}
  for i = 0, 5000 do
    local t = i*1e-3
    samples[i + 1] = t < 0.5*p.halves and p.peak*g*trilith.math.sin(2*math.pi*t) or 0
  end
  local over = false
  m:shake { body = "base", x = trilith.motion { acceleration = samples, dt = 1e-3, allow_drift = true }, duration = 5,
    until_true = function()
      over = math.abs(block.rotation) > 1
      return over
    end }
  return over and "overturns" or "stands"
end

local cases = {}
for _, row in ipairs { { 0.55, 1, "stands" }, { 0.60, 1, "overturns" }, { 0.38, 2, "stands" }, { 0.46, 2, "overturns" },
  { 0.80, 2, "overturns" } } do
  cases[#cases + 1] = {
    name = ("overturning_%s_%.0f"):format(row[2] == 1 and "half_sine" or "full_sine", 100*row[1]),
    title = row[2] == 1 and "half a sine of 1 Hz" or "a full sine of 1 Hz",
    parameters = { { "width", 0.4, "m" }, { "height", 1.2, "m" }, { "peak", row[1], "g" }, { "halves", row[2] } },
    checks = { { "block", exact = row[3] } },
    run = under_pulse,
  }
end

-- Base acceleration at which the block begins to lift: fast to near the limit, then slowly through it.
local function uplift(p)
  local limit = g*p.width/p.height
  local m, block = stands_on(p, { kn = 2e13, beta = 1e-6 })
  local samples = {}
  local function acceleration(t) return limit*(t < 1 and 0.97*t or 0.97 + 0.02*(t - 1)) end
  for i = 0, 4000 do samples[i + 1] = acceleration(i*1e-3) end
  m:consolidate { rest = { ratio = 1e-6 } }
  local begun, turned, found = m.time, block.rotation, nil
  m:shake { body = "base", x = trilith.motion { acceleration = samples, dt = 1e-3, allow_drift = true }, duration = 3.5,
    until_true = function()
      if math.abs(block.rotation - turned) > 1e-4 then found = acceleration(m.time - begun) end
      return found ~= nil
    end }
  return found/g
end
for _, row in ipairs { { 0.4, 1.2 }, { 0.5, 2 } } do
  cases[#cases + 1] = {
    name = ("overturning_uplift_%.0fx%.0f"):format(10*row[1], 10*row[2]),
    title = "base acceleration grows slowly",
    parameters = { { "width", row[1], "m" }, { "height", row[2], "m" } },
    checks = { { "acceleration at uplift", unit = "g", exact = row[1]/row[2], tolerance = 0.01 } },
    run = uplift,
  }
end

-- Angle of a slowly tilting base at which the uppermost block has turned or slid [deg].
local function under_tilt(p)
  local from = p.limit - 0.25
  local m, top = stands_on(p, { lean = from, kn = 2e12, beta = 3e-6, blocks = p.blocks })
  m:consolidate { rest = { ratio = 1e-6 }, duration = 5 }
  local turned, x, y, begun, rate = top.rotation, top.x, top.y, m.time, 0.1*deg
  m:tilt { rate = rate, by = 0.5*deg }
  local found, how
  m:run { duration = 0.5*deg/rate, until_true = function()
    if math.abs(top.rotation - turned) > 1e-3 then
      how = "topples"
    elseif math.abs(top.rotation - turned) < 1e-4 and math.sqrt((top.x - x)^2 + (top.y - y)^2) > 3e-4 then
      how = "slides"
    end
    if how then found = from + 0.1*(m.time - begun) end
    return how ~= nil
  end }
  return { ["tilt at failure"] = found or 0/0, block = how or "stands" }
end
for _, row in ipairs { { 0.4, 1.2, 1, 1, "topples" }, { 0.4, 1.2, 0.2, 1, "slides" }, { 0.5, 2, 1, 1, "topples" },
  { 0.5, 2, 0.24, 1, "slides" }, { 0.4, 0.2, 0.65, 5, "topples" } } do
  local width, height, mu, blocks = row[1], row[2], row[3], row[4]
  local limit = math.atan(math.min(mu, width/(height*blocks)))/deg
  cases[#cases + 1] = {
    name = ("tilting_%.0fx%.0f_mu_%.0f"):format(10*width, 10*height, 100*mu),
    title = blocks > 1 and "a column of five blocks on a tilting base" or "a block on a tilting base",
    parameters = { { "width", width, "m" }, { "height", height, "m" }, { "mu", mu }, { "blocks", blocks },
      { "limit", limit, "deg" } },
    checks = { { "tilt at failure", unit = "deg", exact = limit, within = blocks > 1 and 0.2 or 0.1 },
      { "block", exact = row[5] } },
    run = under_tilt,
  }
end

return {
  title = "Uplift, sliding and overturning of a block",
  source = "Statics of a rigid block; Housner (1963), Bulletin of the Seismological Society of America 53(2), for " ..
    "the " ..
    "pulses, with the pendulum equation integrated without linearisation and without impact before overturning",
  formula = [[\frac{a_\text{uplift}}{g} = \frac{b}{h}, \qquad
\tan\theta_\text{fail} = \min\left(\mu, \frac{b}{h}\right)]],
  text = "The block of 0.4 m by 1.2 m overturns without an impact above 0.5748 g under half a sine of 1 Hz. Under a " ..
    "full sine it overturns after an impact above 0.4036 g, for every restitution from 0.75 to 0.90. Each limit is " ..
    "tested on both sides.",
  cases = cases,
}
