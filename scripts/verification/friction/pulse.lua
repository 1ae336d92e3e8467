-- Sliding on a base that moves, and an oscillator that friction brakes.
local trilith = require "trilith"
local g = 9.80665

local function on_base(mu, options)
  options = options or {}
  local m = trilith.model { name = "sliding" }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = options.kn or 1e10, ks = options.kn or 1e10,
    mu = mu,
    beta = options.beta or 3e-5 } }
  local base = m:block { name = "base", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
  local block = m:block { name = "block", width = 1, height = 0.1, at = { -0.5, 0 }, mass = options.mass or 400,
    material = "stone", support = options.support }
  return m, block, base
end

-- Constant acceleration for `length`, then none.
local function pulse(acceleration, length, duration)
  local samples, dt = {}, 1e-4
  for i = 0, math.floor(duration/dt + 0.5) do
    local t = i*dt
    samples[i + 1] = math.abs(t - length) < dt/10 and acceleration/2 or t < length and acceleration or 0
  end
  return trilith.motion { acceleration = samples, dt = dt, allow_drift = true }
end

local cases = {}
for _, row in ipairs { { 0.5, 0.25, 0.2 }, { 0.8, 0.1, 0.3 } } do
  local a, length, mu = row[1], row[2], row[3]
  local v = a*g*length
  cases[#cases + 1] = {
    name = ("base_pulse_%.0f_%.0f"):format(100*a, 100*mu), title = "constant base acceleration for a time",
    parameters = { { "acceleration", a, "g" }, { "length", length, "s" }, { "mu", mu } },
    checks = { { "slip", unit = "m", exact = v^2/(2*g*mu)*(1 - mu/a), tolerance = 0.005 },
      { "end of the slip", unit = "s", exact = v/(mu*g), tolerance = 0.005 },
      { "speed of the base", unit = "m/s", exact = v, tolerance = 0.005 } },
    run = function(p)
      local m, block, base = on_base(p.mu)
      m:consolidate { integrator = "static" }
      local begun, from, ends, duration = m.time, base.x - block.x, 0, 2*v/(mu*g)
      m:shake { body = "base", x = pulse(p.acceleration*g, p.length, 2*duration), duration = duration,
        until_true = function()
          if base.vx - block.vx > 1e-3 then ends = m.time - begun end
          return false
        end }
      return { slip = base.x - block.x - from, ["end of the slip"] = ends, ["speed of the base"] = base.vx }
    end,
  }
end

-- A deck on two supports that are pushed together under it.
for _, length in ipairs { 0.20, 0.26 } do
  cases[#cases + 1] = {
    name = ("unseating_%.0f"):format(100*length), title = "deck on a seat under the pulse of 0.5 g (slip 0.2298 m)",
    parameters = { { "seat", length, "m" } },
    checks = { { "deck", exact = length < 0.2298 and "falls" or "stays" } },
    run = function(p)
      local m = trilith.model { name = "unseating" }
      m:material { name = "stone", density = 2400 }
      m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.2, beta = 1e-4 } }
      m:block { name = "left", width = 3, height = 3, at = { -2, -3 }, material = "stone", support = "fixed" }
      m:block { name = "right", width = 1 + p.seat, height = 3, at = { 10 - p.seat, -3 }, material = "stone",
        support = "fixed" }
      local deck = m:block { name = "deck", width = 10, height = 0.5, at = { 0, 0 }, mass = 1e4, material = "stone" }
      m:consolidate { integrator = "static" }
      local from = deck.y
      m:shake { body = { "left", "right" }, x = pulse(0.5*g, 0.25, 4), duration = 2 }
      return deck.y < from - 0.5 and "falls" or "stays"
    end,
  }
end

-- Released at 0.1 m: each half swing loses 2 F/k.
cases[#cases + 1] = {
  name = "coulomb_oscillator", title = "oscillator braked by a friction of 0.5 N, released at 0.1 m",
  parameters = { { "mass", 1, "kg" }, { "k", 100, "N/m" }, { "F", 0.5, "N" } },
  checks = { { "first turn", unit = "m", exact = -0.09, tolerance = 0.01 },
    { "second turn", unit = "m", exact = 0.08, tolerance = 0.01 },
    { "third turn", unit = "m", exact = -0.07, tolerance = 0.01 },
    { "time of the third turn", unit = "s", exact = 0.3*math.pi, tolerance = 0.01 },
    { "at the end", unit = "m", between = { -0.00505, 0.00505 } } },
  run = function(p)
    local m, block = on_base(p.F/(p.mass*g), { mass = p.mass, kn = 1e6, beta = 1e-4, support = { rotation = "fixed" } })
    m:consolidate { integrator = "static" }
    m:bearing { name = "spring", between = { "base", "block" }, at = { 0, 0.05 },
      along = trilith.table { points = { { -1, -1*p.k + 10 }, { 1, p.k + 10 } } } }
    local turns, times, before, x0, begun = {}, {}, 0, block.x, m.time
    m:run { duration = 4, dt = 1e-4, until_true = function()
      local x = 0.1 + block.x - x0
      if before*block.vx < 0 and math.abs(x) > p.F/p.k then turns[#turns + 1], times[#times + 1] = x, m.time - begun end
      before = block.vx
      return false
    end }
    return { ["first turn"] = turns[1], ["second turn"] = turns[2], ["third turn"] = turns[3],
      ["time of the third turn"] = times[3], ["at the end"] = 0.1 + block.x - x0 }
  end,
}

-- Stick and slip: a block pulled through a spring at a steady speed.
cases[#cases + 1] = {
  name = "stick_slip", title = "block pulled through a spring at 0.1 m/s",
  parameters = { { "mass", 1, "kg" }, { "k", 100, "N/m" }, { "mu", 0.3 }, { "speed", 0.1, "m/s" } },
  checks = { { "first slip", unit = "s", exact = 0.2942, tolerance = 0.01 },
    { "distance 1 s later", unit = "m", exact = 0.10544, tolerance = 0.005 },
    { "largest speed", unit = "m/s", exact = 0.2, tolerance = 0.005 } },
  run = function(p)
    local m, block = on_base(p.mu, { mass = p.mass, kn = 1e7, beta = 1e-5, support = { rotation = "fixed" } })
    m:contact { between = { "cart", "*" }, law = "none" }
    m:block { name = "cart", width = 0.1, height = 0.1, at = { 1, 0.5 }, material = "stone", support = "fixed" }
    m:bearing { name = "spring", between = { "cart", "block" }, from = { 1, 0.55 }, to = { 0.5, 0.05 }, angle = 0,
      along = trilith.linear { stiffness = p.k } }
    m:consolidate { integrator = "static" }
    m:drive { body = "cart", x = trilith.motion { velocity = p.speed, duration = 3 } }
    local begun, x0, slips, later, fastest = m.time, block.x, nil, nil, 0
    m:run { duration = 2, dt = 1e-4, until_true = function()
      local t = m.time - begun
      if not slips and block.vx > 1e-5 then slips = t end
      if slips and not later and t >= 1.2942 then later = block.x - x0 end
      fastest = math.max(fastest, block.vx)
      return false
    end }
    return { ["first slip"] = slips, ["distance 1 s later"] = later, ["largest speed"] = fastest }
  end,
}

return {
  title = "Sliding on a base that moves",
  source = "Newmark (1965), Geotechnique 15, equations 5 to 7, for the pulse; Den Hartog (1956), Mechanical " ..
    "Vibrations, " ..
    "section 2.6, for the oscillator",
  formula = [[u_\text{slip} = \frac{V^2}{2 g \mu}\left(1 - \frac{\mu}{A}\right), \qquad
|u_{n+1}| = |u_n| - \frac{2F}{k}]],
  cases = cases,
}
