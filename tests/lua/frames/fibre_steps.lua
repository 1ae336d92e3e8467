-- Implicit steps of a shaken portal of fibres follow its motion and not the vibrations of its light nodes: displacement
-- against short steps of equal length, closed energy, number of steps.
local trilith = require "trilith"

--- A frame's member of reinforced concrete, with few layers so that the test is short.
local function section_of(depth)
  return trilith.fibre_section {
    shape = trilith.rectangle_section { width = 0.4, depth = depth }, cover = 0.04, layers = 5,
    law = trilith.kent_park { strength = 30e6, confinement = 1.2, ultimate = 0.02 },
    cover_law = trilith.kent_park { strength = 30e6 },
    bars = { { area = 1.2e-3, height = 0.05 }, { area = 1.2e-3, height = depth - 0.05 } },
    bar_law = trilith.menegotto_pinto { E = 2e11, yield = 420e6, hardening = 0.01 },
  }
end

local pulses = {}
for i = 0, 80 do pulses[i + 1] = 4*math.sin(2*math.pi*i/40)*math.sin(math.pi*i/80) end

--- Shakes a portal with 15 t on each joint for 0.8 s; returns the largest drift of its girder [m], the number of steps,
--- the energies and the hash at the end.
local function shaken(options)
  local m = trilith.model { name = "portal", mass_damping = 0.3 }
  m:material { name = "concrete", density = 2500, E = 30e9, nu = 0.2, beta = options.beta }
  local column, girder = section_of(0.4), section_of(0.5)
  local f = m:frame { name = "portal", material = "concrete",
    joints = { a = { at = { 0, 0 }, support = "fixed" }, b = { at = { 0, 3 }, mass = 15e3 },
               c = { at = { 5, 3 }, mass = 15e3 }, d = { at = { 5, 0 }, support = "fixed" } },
    members = { { name = "left", from = "a", to = "b", section = column, divisions = 12 },
                { name = "girder", from = "b", to = "c", section = girder, divisions = 16 },
                { name = "right", from = "d", to = "c", section = column, divisions = 12 } } }
  m:consolidate { integrator = "static" }
  local largest, start = 0, f:point "b"
  m:on_step(function()
    local x, foot = f:point "b", f:point "a"
    largest = math.max(largest, math.abs(x - start - foot))
  end)
  local before = m.steps
  m:shake { body = f, x = trilith.motion { acceleration = pulses, dt = 0.01 }, integrator = "implicit", duration = 0.8,
            accuracy = options.accuracy, dt = options.dt }
  return largest, m.steps - before, m.energy, m.hash
end

-- 0.25 ms, at which the step no longer matters: half of it changes the drift by less than 0.1 %
local exact, all_steps = shaken { accuracy = 0, dt = 2.5e-4 }
assert(all_steps == 3200)

--- Error of the drift and number of steps at an accuracy; the energy closes to 1e-5 of the work of the ground.
local function error_at(accuracy)
  local drift, steps, energy, hash = shaken { accuracy = accuracy }
  assert(math.abs(energy.residual) < 1e-5*energy.support, ("%g J of %g J"):format(energy.residual, energy.support))
  return math.abs(drift/exact - 1), steps, hash
end
local coarse = error_at(1e-2)
local usual, steps, hash = error_at(1e-3)
local fine, more_steps = error_at(3e-4)
assert(coarse < 1e-2 and usual < 3e-3 and fine < 1e-3, ("drift off by %g, %g, %g"):format(coarse, usual, fine))
assert(fine < coarse/3, ("drift off by %g, and by %g with a larger error limit"):format(fine, coarse))
assert(more_steps > 1.5*steps, ("%d and %d steps"):format(steps, more_steps))
-- Steps that followed the vibrations of light nodes were 1,310.
assert(steps < 900, ("%d steps"):format(steps))
local _, _, again = error_at(1e-3)
assert(hash == again, "the same run has other bits")

-- The damping of fibres is linear within a step. Where its matrix changed between two iterations, whenever a fibre
-- cracked or yielded, steps did not converge and were halved: there were 667.
local damped_exact = shaken { accuracy = 0, dt = 5e-4, beta = 2e-4 }
local damped, damped_steps, energy = shaken { accuracy = 1e-3, beta = 2e-4 }
assert(math.abs(damped/damped_exact - 1) < 2e-3, ("damped drift %g and %g m"):format(damped, damped_exact))
assert(damped_steps < 550, ("%d damped steps"):format(damped_steps))
assert(math.abs(energy.residual) < 1e-5*energy.support, ("%g J of %g J"):format(energy.residual, energy.support))
