-- Artificial ground motions: variance and spectrum of the process, seeds, envelope, end at rest, wrong input.
local trilith = require "trilith"
local function near(value, expected, relative, what)
  if math.abs(value/expected - 1) > relative then
    error(("%s: %.6g, expected %.6g"):format(what, value, expected), 2)
  end
end
local function refused(text, ...)
  local good, message = pcall(trilith.stochastic_motion, ...)
  if good or not message:find(text, 1, true) then error(("not refused with '%s': %s"):format(text, message), 2) end
end

-- Mean square of the samples of stationary motions over many seeds.
local function mean_square(options, seeds)
  local sum, count = 0, 0
  for seed = 1, seeds do
    options.seed = seed
    local motion = trilith.stochastic_motion(options)
    for i = 0, motion.npts - 1 do sum, count = sum + motion:at(i*motion.dt)^2, count + 1 end
  end
  return sum/count
end

-- Stationary, over a band that covers the process: the standard deviation is rms.
near(math.sqrt(mean_square({ rms = 1.5, duration = 20, dt = 0.02, envelope = false }, 30)), 1.5, 0.03, "rms")

-- The spectrum of Kanai and Tajimi: two-sided S0 k(f), with the variance S0 pi wg (1 + 4 z^2)/(2 z) over all
-- frequencies.
local fg, z, rms, highest = 2.5, 0.6, 1, 25
local variance_over_S0 = math.pi*2*math.pi*fg*(1 + 4*z^2)/(2*z)
local function kanai_tajimi(f)
  local r = (f/fg)^2
  return (1 + 4*z^2*r)/((1 - r)^2 + 4*z^2*r)
end

-- One-sided periodograms [m2/s3] at some frequencies, mean over seeds, with the window of Hann.
local function periodograms(frequencies, options, seeds)
  local sums = {}
  for seed = 1, seeds do
    options.seed = seed
    local motion = trilith.stochastic_motion(options)
    local n = motion.npts
    for k, f in ipairs(frequencies) do
      local c, s = 0, 0
      for i = 0, n - 1 do
        local value = (1 - trilith.math.cos(2*math.pi*i/(n - 1)))*motion:at(i*motion.dt)
        local angle = 2*math.pi*f*i*motion.dt
        c, s = c + value*trilith.math.cos(angle), s + value*trilith.math.sin(angle)
      end
      sums[k] = (sums[k] or 0) + 2*(c^2 + s^2)*motion.dt/(1.5*n*seeds)
    end
  end
  return sums
end

-- A filter at 0.02 Hz leaves the spectrum of the ground. It ends at `highest`; a share of the variance lies beyond.
local beyond = 0
for f = highest, 2000, 0.01 do beyond = beyond + 0.01*4*math.pi*kanai_tajimi(f)/variance_over_S0 end
assert(beyond > 0.02 and beyond < 0.1)
local frequencies = { 1, 2.5, 5, 10 }
local found = periodograms(frequencies, { rms = rms, duration = 10, dt = 0.02, highest_frequency = highest,
  filter_frequency = 0.02, envelope = false }, 120)
for k, f in ipairs(frequencies) do
  near(found[k], 4*math.pi*kanai_tajimi(f)/(variance_over_S0*(1 - beyond))*rms^2, 0.3, ("spectrum at %g Hz"):format(f))
end

-- Seeds: the same bits, and others.
local a = trilith.stochastic_motion { seed = 7, pga = 3, duration = 10 }
local b = trilith.stochastic_motion { seed = 7, pga = 3, duration = 10 }
local c = trilith.stochastic_motion { seed = 8, pga = 3, duration = 10 }
local differs = false
for i = 0, a.npts - 1 do
  assert(a:at(i*a.dt) == b:at(i*a.dt))
  differs = differs or a:at(i*a.dt) ~= c:at(i*a.dt)
end
assert(differs)
near(a.pga, 3, 1e-12, "pga")

-- The ground ends at rest where it began.
local velocity, displacement, most = 0, 0, 0
for i = 1, a.npts - 1 do
  local before, after = a:at((i - 1)*a.dt), a:at(i*a.dt)
  displacement = displacement + velocity*a.dt + (2*before + after)/6*a.dt^2
  velocity = velocity + (before + after)/2*a.dt
  most = math.max(most, math.abs(velocity))
end
assert(math.abs(velocity) < 1e-9*most)
assert(math.abs(displacement) < 1e-8*most)

-- The envelope: a quarter of the strong part in the middle of the rise.
local rise = mean_square({ rms = 1, duration = 20, dt = 0.02, envelope = { rise = 10, strong = 5, decay = 1 } }, 30)
local exact = (10/5 + 5 + (1 - trilith.math.exp(-10))/2)/20
near(rise, exact, 0.08, "mean square under the envelope")

refused("give one of 'rms'", {})
refused("give one of 'rms'", { rms = 1, pga = 1 })
refused("did you mean 'seed'", { pga = 1, sead = 2 })
refused("'seed' is", { pga = 1, seed = 1.5 })
refused("'pga' is", { pga = -1 })
refused("must be at least 20 steps", { pga = 1, duration = 0.1 })
refused("must be from 10/duration", { pga = 1, highest_frequency = 80 })
refused("'duration' is 1e+06 s, must be at most 200 s", { pga = 1, duration = 1e6 })
refused("must be at most 1000 s with steps of 0.05 s", { pga = 1, duration = 1100, dt = 0.05 })
