-- Walls of brick in mortar, pushed by W.push. It has the laws of their joints and of cracks in their units, from a
-- table of the series. It pushes a specimen, and has rows of assumptions that all series share.
local trilith = require "trilith"
local wall = require "shared.wall"

local M = {}

--- Compressive fracture energy [J/m2] of masonry with the strength f [Pa], where none is measured: 1.6 mm times f.
--- This ductility index is an assumption.
function M.crush_energy(f) return 1.6e-3*f end

--- Law of the joints, and of a crack across a unit. The table s has the stiffnesses kn, ks [Pa/m] and the strengths of
--- the joints, and `unit_tension` [Pa] with `unit_energy` [J/m2].
function M.laws(s)
  local joint = trilith.cohesive { kn = s.kn, ks = s.ks, mu = s.mu, cohesion = s.cohesion, tension = s.tension,
    energy_tension = s.energy_tension, energy_shear = s.energy_shear, compression = s.compression,
    crushing_depth = s.crushing_depth, crush_energy = s.crush_energy, crush_residual = s.crush_residual,
    dilation = s.dilation, dilation_slip = s.dilation_slip, beta = s.beta }
  if not s.unit_tension then return joint, nil end
  local crack = trilith.cohesive { kn = 10*s.kn, ks = 10*s.ks, mu = s.mu, cohesion = 2*s.unit_tension,
    tension = s.unit_tension, energy_tension = s.unit_energy, energy_shear = 10*s.unit_energy, beta = s.beta }
  return joint, crack
end

--- Rate of the push [m/s], the same for all walls: at it inertia and damping carry less than 5 % of each peak, as the
--- checks show. The coarse rate is for tests and for the tables of assumptions that move a result.
function M.rate(coarse) return coarse and 1e-3 or 0.25e-3 end

--- Factor of all masses, the same for all walls. Weights stay, and the time step is ten times as long.
M.mass_factor = 100

--- Check of the share of inertia and damping in the peak, and its value [%].
M.inertia_check = { "inertia at the peak", unit = "%", measured = "below 5", between = { 0, 5 } }
function M.inertia(r) return math.max(r.shares.along, r.shares.across) end

--- Builds and pushes a specimen of a series; keys of the specimen and of `more` replace keys of the series. The force
--- is the mean over two samples, each of 1/200 of the displacement. A single step after a sudden crack is not a peak.
function M.push(series, specimen, more)
  local s = {}
  for _, source in ipairs { series, specimen, more or {} } do
    for key, value in pairs(source) do s[key] = value end
  end
  s.joint, s.crack = M.laws(s)
  s.samples, s.drop = 200, 0.8
  local r = wall.push(s)
  if s.cycles then -- its force is a mean over time
    r.shares = r.inertia(r.time)
    return r
  end
  local time = 0
  r.peak, r.at = 0, 0
  for i = 1, #r.curve.force - 1 do
    local force = (r.curve.force[i] + r.curve.force[i + 1])/2
    if force > r.peak then
      r.peak, r.at = force, (r.curve.displacement[i] + r.curve.displacement[i + 1])/2
      time = (r.curve.t[i] + r.curve.t[i + 1])/2
    end
  end
  r.shares = r.inertia(time)
  return r
end

--- Drift [%] at which the force has fallen to 0.8 of the peak; not a number where it has not.
function M.ultimate_drift(r, height) return r.limit == "until" and 100*r.displacement/height or 0/0 end

--- Lines for the log of a run.
function M.notes(r)
  local f = r.found
  local v = r.vertical
  return { ("inertia and damping at the peak: %.2f %% along, %.2f %% across"):format(r.shares.along, r.shares.across),
    ("at %.2f mm; at the end %.1f kN; %d joints crushed, %d halves of bonds broken, %d units cracked (%s)")
      :format(1e3*r.at, r.last/1e3, r.crushed, r.broken, r.cracked, r.modes),
    v and ("reaction of the locked top: %.1f kN to %.1f kN"):format(v[1]/1e3, v[2]/1e3) or "no locked top",
    ("share of the drift: bed joints %.2f, head joints %.2f, rotation of units %.2f, cracks %.2f"):format(f.bed_opening,
      f.head_opening, f.rotation, f.crack_opening) }
end

--- Rows of the table of assumptions on units and steps.
M.assumptions = {
  { "cracks of units", "one plane across the middle of each whole unit. Tension 0.065 of the unit's compressive " ..
    "strength, or as stated; cohesion twice the tension; fracture energy 40 µm times the tension, ten times that in " ..
    "shear", "middle of 0.03 to 0.10 (Schubert 1988); Mohr-Coulomb through both strengths; ratio of the series of " ..
    "TU/e; ratio of shear assumed" },
  { "mortar", "bonded before N is applied", "as built; changed after first runs, in which the mortar set under N " ..
    "and the bricks above an opening fell" },
  { "crushing", "softens along a line to a tenth of the compressive strength, in each half of a joint; at most " ..
    "10 mm deep", "10 mm is the thickness of the joints; the residual strength is assumed" },
  { "push", "0.25 mm/s in all series; masses 100 times the true ones, weights true. It ends where the force has " ..
    "fallen by 20 %", "COMP2_1 decides: inertia and damping carry 3.3 % of its peak at 0.5 mm/s and 27 % at " ..
    "2 mm/s, and less of the others" },
  { "crushing energy", "1.6 mm times the compressive strength, per area of joint", "assumed ductility index; " ..
    "none was measured" },
}

return M
