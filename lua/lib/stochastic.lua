-- trilith.stochastic_motion{...}: artificial ground motions of a stationary process under an envelope. White noise is
-- filtered by the ground (Kanai 1957, Tajimi 1960) and by a high-pass filter (Clough and Penzien 1975):
--
--     S(w) = S0 (wg^4 + 4 zg^2 wg^2 w^2)/((wg^2 - w^2)^2 + 4 zg^2 wg^2 w^2) w^4/((wf^2 - w^2)^2 + 4 zf^2 wf^2 w^2)
--
-- The samples are the sum of cosines with amplitudes from S and random phases (Shinozuka and Deodatis 1991).
local trilith, core = ...

local owner = "stochastic_motion"
local cos, sin, exp = trilith.math.cos, trilith.math.sin, trilith.math.exp
local keys = { "seed", "duration", "dt", "rms", "pga", "ground_frequency", "ground_damping", "filter_frequency",
  "filter_damping", "envelope", "highest_frequency" }
-- Every sample is a sum of cosines. This product of their numbers takes a few seconds.
local most_terms = 2e8
local envelope_keys = { "rise", "strong", "decay" }

local function number(options, key, unit, preset)
  local value = options[key]
  if value == nil and preset then return preset end
  return core.positive(owner, key, value, unit)
end

-- Uniform random numbers in [0, 1) by splitmix64 (Steele, Lea and Flood 2014).
local function random_numbers(seed)
  local state = seed
  return function()
    state = state + 0x9E3779B97F4A7C15
    local z = state
    z = (z ~ (z >> 30))*0xBF58476D1CE4E5B9
    z = (z ~ (z >> 27))*0x94D049BB133111EB
    z = z ~ (z >> 31)
    return (z >> 11)*2.0^-53
  end
end

-- Spectral density at a frequency [Hz], for S0 = 1.
local function density(f, s)
  local g2, f2, w2 = s.ground_frequency^2, s.filter_frequency^2, f^2
  local ground = 4*s.ground_damping^2*g2*w2
  local filter = 4*s.filter_damping^2*f2*w2
  return (g2^2 + ground)/((g2 - w2)^2 + ground)*w2^2/((f2 - w2)^2 + filter)
end

-- Adds amplitude cos(2 pi f t + phase) at all samples, by rotation.
local function add_cosine(values, amplitude, f, phase, dt)
  local c, s = cos(2*math.pi*f*dt), sin(2*math.pi*f*dt)
  local x, y = amplitude*cos(phase), amplitude*sin(phase)
  for i = 1, #values do
    values[i] = values[i] + x
    x, y = c*x - s*y, s*x + c*y
  end
end

-- Samples with a standard deviation of 1 over the period of the sum, which is twice the duration.
local function stationary(s, count)
  local step, random, values, sum = 0.5/s.duration, random_numbers(s.seed), {}, 0
  for i = 1, count do values[i] = 0.0 end
  local bands = math.floor(s.highest_frequency/step)
  for k = 1, bands do sum = sum + density(k*step, s) end
  for k = 1, bands do
    add_cosine(values, math.sqrt(2*density(k*step, s)/sum), k*step, 2*math.pi*random(), s.dt)
  end
  return values
end

-- Parabola, one, exponential decay.
local function envelope(e, t)
  if t < e.rise then return (t/e.rise)^2 end
  return t <= e.rise + e.strong and 1 or exp(-e.decay*(t - e.rise - e.strong))
end

-- Removes velocity and displacement at the end, of samples joined by straight lines, by smooth additions
-- sin^2(pi t/T) (a + b (t/T - 1/2)).
local function correct_drift(values, dt)
  local n = #values
  local duration = (n - 1)*dt
  local function sums(value)
    local first_value, last = value(1)*dt, value(n)*dt
    local velocity = (first_value + last)/2
    local displacement = first_value*(duration/2 - dt/6) + last*dt/6
    for i = 2, n - 1 do
      local v = value(i)*dt
      velocity, displacement = velocity + v, displacement + v*(duration - (i - 1)*dt)
    end
    return velocity, displacement
  end
  local function first(i) return sin(math.pi*(i - 1)/(n - 1))^2 end
  local function second(i) return first(i)*((i - 1)/(n - 1) - 0.5) end
  local v, u = sums(function(i) return values[i] end)
  local v1, u1 = sums(first)
  local v2, u2 = sums(second)
  local det = v1*u2 - v2*u1
  local a, b = (v*u2 - v2*u)/det, (v1*u - v*u1)/det
  for i = 1, n do values[i] = values[i] - a*first(i) - b*second(i) end
end

local function checked(options)
  core.check_keys(owner, options, keys)
  local s = { seed = options.seed == nil and 1 or options.seed, duration = number(options, "duration", " s", 20),
    dt = number(options, "dt", " s", 0.01), ground_frequency = number(options, "ground_frequency", " Hz", 2.5),
    ground_damping = number(options, "ground_damping", "", 0.6),
    filter_frequency = number(options, "filter_frequency", " Hz", 0.25),
    filter_damping = number(options, "filter_damping", "", 0.6) }
  if math.type(s.seed) ~= "integer" then
    core.fail(("%s: 'seed' is %s, must be an integer"):format(owner, core.what_is(s.seed)))
  end
  if s.duration < 20*s.dt then
    core.fail(("%s: 'duration' is %g s, must be at least 20 steps dt of %g s"):format(owner, s.duration, s.dt))
  end
  s.highest_frequency = number(options, "highest_frequency", " Hz", math.min(25, 0.25/s.dt))
  if s.highest_frequency > 0.5/s.dt or s.highest_frequency*s.duration < 10 then
    core.fail(("%s: 'highest_frequency' is %g Hz, must be from 10/duration = %g Hz to 0.5/dt = %g Hz"):format(owner,
      s.highest_frequency, 10/s.duration, 0.5/s.dt))
  end
  if s.duration/s.dt*2*s.highest_frequency*s.duration > most_terms then
    local longest = math.sqrt(most_terms*s.dt/(2*s.highest_frequency))
    core.fail(("%s: 'duration' is %g s, must be at most %.4g s with steps of %g s and frequencies up to %g Hz; "
      .. "a longer dt or a smaller highest_frequency allows more"):format(owner, s.duration, longest, s.dt,
      s.highest_frequency))
  end
  if (options.rms == nil) == (options.pga == nil) then
    core.fail(owner .. ": give one of 'rms' (standard deviation of the strong part, m/s2) and 'pga' (m/s2)")
  end
  return s
end

local function checked_envelope(options, duration)
  local e = options.envelope
  if e == false then return nil end
  if e == nil then return { rise = 0.1*duration, strong = 0.4*duration, decay = 6/duration } end
  core.check_keys(owner .. ": envelope", e, envelope_keys)
  return { rise = number(e, "rise", " s"), strong = number(e, "strong", " s"), decay = number(e, "decay", " 1/s") }
end

function trilith.stochastic_motion(options)
  local s = checked(options)
  local e = checked_envelope(options, s.duration)
  local count = math.floor(s.duration/s.dt + 0.5) + 1
  local values = stationary(s, count)
  if e then
    for i = 1, count do values[i] = values[i]*envelope(e, (i - 1)*s.dt) end
  end
  correct_drift(values, s.dt)
  local factor = options.rms and number(options, "rms", " m/s2")
  if not factor then
    local most = 0
    for i = 1, count do most = math.max(most, math.abs(values[i])) end
    local pga = number(options, "pga", " m/s2")
    core.note_small_peak(owner, pga)
    factor = pga/most
  end
  for i = 1, count do values[i] = factor*values[i] end
  return trilith.motion { acceleration = values, dt = s.dt, allow_drift = not e or nil }
end
