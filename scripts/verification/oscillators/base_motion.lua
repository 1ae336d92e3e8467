-- A mass on a spring whose support moves.
local trilith = require "trilith"
local pi = math.pi
local mass = 1000

-- Ground and mass, joined by a law along x; the mass moves along x alone.
local function oscillator(law, options)
  options = options or {}
  local m = trilith.model { name = "oscillator", gravity = 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "ground", width = 1, height = 1, at = { -1, 0 }, material = "steel", support = "fixed" }
  local body = m:block { name = "mass", width = 1, height = 1, at = { 0, 0 }, mass = mass, material = "steel",
    velocity = { options.speed or 0, 0 }, support = { y = "fixed", rotation = "fixed" }, floating = true }
  m:bearing { name = "spring", between = { "ground", "mass" }, at = { 0, 0.5 }, along = law }
  return m, body
end

local function spring(period, ratio)
  local w = 2*pi/period
  return trilith.linear { stiffness = mass*w^2, damping = 2*ratio*w*mass }
end

local function sampled(duration, dt, f)
  local samples = {}
  for i = 0, math.floor(duration/dt + 0.5) do samples[i + 1] = f(i*dt) end
  return trilith.motion { acceleration = samples, dt = dt, allow_drift = true }
end

-- Response spectrum: the oscillator in the model against the same one integrated exactly between the samples.
local cases = {}
for _, row in ipairs { { 0.2, 0.05 }, { 0.5, 0.02 }, { 1, 0.02 }, { 2, 0.05 } } do
  local record = trilith.motion "elcentro_1940_rest_ns.csv"
  local period, ratio = row[1], row[2]
  cases[#cases + 1] = {
    name = ("spectrum_%.0f_%.0f"):format(100*period, 100*ratio),
    title = "El Centro 1940 NS",
    parameters = { { "period", period, "s" }, { "ratio", ratio } },
    checks = { { "peak displacement", unit = "m", exact = record:sa(period, ratio)*(period/2/pi)^2,
      tolerance = 0.01 } },
    run = function(p)
      local m, body = oscillator(spring(p.period, p.ratio))
      local most, ground = 0, m:body "ground"
      m:shake { body = "ground", x = record, dt = 5e-4, duration = record.duration, until_true = function()
        most = math.max(most, math.abs(body.ux - ground.ux))
        return false
      end }
      return most
    end,
  }
end

-- Steady motion under a sine: transmissibility of the relative displacement.
for _, beta in ipairs { 0.5, 1, 2 } do
  local ratio, period, accel = 0.05, 1, 1
  local w = 2*pi/period
  local function amplitude() return accel/w^2/math.sqrt((1 - beta^2)^2 + (2*ratio*beta)^2) end
  cases[#cases + 1] = {
    name = ("harmonic_%.0f"):format(100*beta),
    title = "sine at the base",
    parameters = { { "frequency_ratio", beta }, { "ratio", ratio }, { "period", period, "s" } },
    checks = { { "steady amplitude", unit = "m", exact = amplitude(), tolerance = 0.005 } },
    run = function(p)
      local m, body = oscillator(spring(p.period, p.ratio))
      local most, ground, last = 0, m:body "ground", 30
      local motion = sampled(last, 0.002, function(t) return accel*trilith.math.sin(p.frequency_ratio*w*t) end)
      m:shake { body = "ground", x = motion, dt = 1e-3, duration = last, until_true = function()
        if m.time > 25 then most = math.max(most, math.abs(body.ux - ground.ux)) end
        return false
      end }
      return most
    end,
  }
end

-- Half a sine: the largest displacement, also after the pulse.
for _, length in ipairs { 0.25, 0.5, 1 } do
  local period, accel = 1, 2
  local w, W = 2*pi/period, pi/length
  local function peak()
    local most, r = 0, W/w
    for i = 0, 20000 do
      local t, x = i*1e-4
      if math.abs(r - 1) < 1e-9 then
        x = t <= length and (trilith.math.sin(w*t) - w*t*trilith.math.cos(w*t))/2
          or pi/2*trilith.math.cos(w*(t - length))
      elseif t <= length then
        x = (trilith.math.sin(W*t) - r*trilith.math.sin(w*t))/(1 - r^2)
      else
        x = r/(1 - r^2)*(-trilith.math.sin(w*t) - trilith.math.sin(w*(t - length)))
      end
      most = math.max(most, math.abs(x))
    end
    return accel/w^2*most
  end
  cases[#cases + 1] = {
    name = ("half_sine_%.0f"):format(100*length),
    title = "half a sine at the base",
    parameters = { { "length", length, "s" }, { "period", period, "s" } },
    checks = { { "peak displacement", unit = "m", exact = peak(), tolerance = 0.005 } },
    run = function(p)
      local m, body = oscillator(spring(p.period, 0))
      local most, ground = 0, m:body "ground"
      local motion = sampled(2, 0.001, function(t)
        return t < p.length and accel*trilith.math.sin(pi*t/p.length) or 0
      end)
      m:shake { body = "ground", x = motion, dt = 5e-4, duration = 2, until_true = function()
        most = math.max(most, math.abs(body.ux - ground.ux))
        return false
      end }
      return most
    end,
  }
end

-- A span on two springs, each of its own support.
cases[#cases + 1] = {
  name = "two_supports",
  title = "two supports that come to rest at 0.3 m and 0.1 m",
  checks = { { "displacement at rest", unit = "m", exact = 0.2, tolerance = 0.005 } },
  run = function()
    local m = trilith.model { name = "two supports", gravity = 0 }
    m:material { name = "steel", density = 7850 }
    m:contact { between = { "*", "*" }, law = "none" }
    local body = m:block { name = "span", width = 10, height = 1, at = { 0, 0 }, mass = mass, material = "steel",
      support = { y = "fixed", rotation = "fixed" }, floating = true }
    local law = trilith.linear { stiffness = 2e4, damping = 3e3 }
    for i, x in ipairs { 0, 10 } do
      m:block { name = "support " .. i, width = 1, height = 1, at = { x - 0.5, -1.5 }, material = "steel",
        support = "fixed" }
      m:bearing { name = "spring " .. i, between = { "support " .. i, "span" }, from = { x, -0.5 }, to = { x, 0 },
        along = law }
    end
    m:drive { body = "support 1", x = trilith.ramp { by = 0.3, duration = 2 } }
    m:drive { body = "support 2", x = trilith.ramp { by = 0.1, duration = 3 } }
    m:run { duration = 20, dt = 1e-3 }
    return body.ux
  end,
}

-- Elastic and perfectly plastic, after a blow.
cases[#cases + 1] = {
  name = "plastic_blow",
  title = "an elastic and perfectly plastic spring after a blow of 0.8 m/s",
  parameters = { { "stiffness", 1e6, "N/m" }, { "yield", 1e4, "N" }, { "speed", 0.8, "m/s" } },
  checks = {
    { "peak", unit = "m", exact = 0.037, tolerance = 0.002 },
    { "time of the peak", unit = "s", exact = 0.086335, tolerance = 0.002 },
    { "lowest point after it", unit = "m", exact = 0.017, tolerance = 0.002 },
    { "dissipated energy", unit = "J", exact = 270, tolerance = 0.002 },
  },
  run = function(p)
    local m, body = oscillator(trilith.elastic_plastic { stiffness = p.stiffness, yield = p.yield },
      { speed = p.speed })
    local most, at, least = 0, 0, 1
    m:run { duration = 0.25, dt = 1e-4, until_true = function()
      if body.ux > most and m.time < 0.15 then most, at = body.ux, m.time end
      if m.time > at then least = math.min(least, body.ux) end
      return false
    end }
    return { peak = most, ["time of the peak"] = at, ["lowest point after it"] = least,
      ["dissipated energy"] = 320 - (m.energy.kinetic + p.stiffness*(body.ux - 0.027)^2/2) }
  end,
}

-- Free vibration: frequency and logarithmic decrement.
for _, ratio in ipairs { 0.02, 0.1, 0.3 } do
  cases[#cases + 1] = {
    name = ("decay_%.0f"):format(100*ratio),
    title = "free vibration after a blow",
    parameters = { { "ratio", ratio }, { "period", 1, "s" } },
    checks = {
      { "period", unit = "s", exact = 1/math.sqrt(1 - ratio^2), tolerance = 0.001 },
      { "ratio of successive peaks", exact = math.exp(-2*pi*ratio/math.sqrt(1 - ratio^2)), tolerance = 0.001 },
    },
    run = function(p)
      local m, body = oscillator(spring(p.period, p.ratio), { speed = 1 })
      local peaks, times, before, before_x, lowest, highest = {}, {}, nil, 0, 0, 0
      m:run { duration = 2.6, dt = 2e-4, until_true = function()
        local x = body.ux
        if before and before_x < 0 and x >= 0 then times[#times + 1] = m.time - m.dt*x/(x - before_x) end
        if m.time < 0.5 then highest = math.max(highest, x) end
        if m.time > 1 and m.time < 1.6 then lowest = math.max(lowest, x) end
        before, before_x = true, x
        return false
      end }
      peaks[1], peaks[2] = highest, lowest
      return { period = times[2] - times[1], ["ratio of successive peaks"] = peaks[2]/peaks[1] }
    end,
  }
end

return {
  title = "A mass on a spring whose support moves",
  source = "Chopra (2012), Dynamics of Structures, 4th edition, equations 3.2.11, 4.7.3, 4.8.3 and 2.2.12; " ..
    "Nigam and Jennings (1969), Bulletin of the Seismological Society of America 59(2), for the spectrum",
  formula = [[m\ddot u + c\dot u + k u = -m\ddot u_g(t), \qquad
\frac{u_0}{\ddot u_{g0}/\omega_n^2} = \frac{1}{\sqrt{(1 - \beta^2)^2 + (2\zeta\beta)^2}}]],
  text = "The support is driven by a ground motion; $u$ is the displacement of the mass relative to it.",
  cases = cases,
}
