-- Dry sandstone walls pushed in their plane: Lourenco, Oliveira, Roca and Orduna (2005).
local trilith = require "trilith"
local wall = require "shared.wall"
local setting = ... or {}

-- Assumptions of the series. None is fitted to a wall.
local series = {
  length = 1, courses = 9, unit_width = 0.2, unit_height = 0.1, thickness = 0.2, beam_height = 0.2,
  density = 2350, mu = 0.62,
  wall_modulus = { { 0.15e6, 566e6 }, { 0.5e6, 756e6 } }, unit_modulus = 15.5e9, -- { stress, modulus }
  ks_over_kn = 0.4,
}

for key, value in pairs(setting.over or {}) do series[key] = value end
local assumptions = {
  { "wall", "1.00 m x 0.90 m x 0.20 m, 9 courses of 0.20 m x 0.10 m, half blocks at the ends of every second course",
    "Lourenco, Oliveira, Roca and Orduna 2005" },
  { "boundary", "cantilever: the beam turns freely, N stays constant; push at 1.00 m",
    "Lourenco, Oliveira, Roca and Orduna 2005" },
  { "density", "2350 kg/m3", "sandstone, assumed" },
  { "friction", "0.62 in all joints, no cohesion, no tension; joints to the beam and the base do not slide",
    "published models of these walls" },
  { "kn", "5.87 GPa/m under 30 kN, 7.95 GPa/m under 100 kN",
    "`trilith.joint_stiffness`: moduli of the walls under vertical load, 566 MPa at 0.15 MPa and 756 MPa at 0.5 " ..
      "MPa, less the stone" },
  { "ks", "0.4 kn", "elastic ratio for a Poisson's ratio of 0.2" },
}

-- N [kN], measured: peaks, band, forces at displacements [mm] of both walls.
local specimens = {
  { name = "sw30", N = 30, peaks = { 21.9, 22.9 }, band = { 15, 21 },
    at = { { 1, 9.7 }, { 2, 12.6 }, { 3, 15 }, { 5, 15.8 }, { 7.5, 17.1 }, { 10, 15.7 }, { 1, 9.6 }, { 2, 14 },
      { 3, 17.3 }, { 5, 17.5 }, { 7.5, 20.7 }, { 10, 14.9 } } },
  { name = "sw100", N = 100, peaks = { 41.5, 48.2 }, band = { 38, 52 },
    at = { { 1, 20 }, { 2, 26.3 }, { 3, 27.1 }, { 5, 31 }, { 7.5, 37.3 }, { 10, 40.7 }, { 1, 12.3 }, { 2, 24.2 },
      { 3, 30.9 }, { 5, 40.3 }, { 7.5, 45.4 }, { 10, 45.8 } } },
}

local results = {}

local function push(specimen)
  local s = {}
  for key, value in pairs(series) do s[key] = value end
  local stress = specimen.N*1e3/(s.length*s.thickness)
  local joint = trilith.joint_stiffness { wall_modulus = s.wall_modulus, unit_modulus = s.unit_modulus,
    stress = stress, course_height = s.unit_height, shear_ratio = s.ks_over_kn }
  local kn, ks = (s.stiffer or 1)*joint.kn, (s.stiffer or 1)*joint.ks
  local function law(mu) return trilith.frictional { kn = kn, ks = ks, mu = mu, beta = 5e-6 } end
  s.joint, s.ends, s.vertical, s.top = law(s.mu), law(2), (s.more_load or 1)*specimen.N*1e3, s.top or "cantilever"
  s.displacement, s.rate, s.file, s.frames = 0.025, setting.coarse and 5e-3 or 1e-3, setting.file, 5
  return wall.push(s)
end

local function mean(r, from, to)
  local sum, count = 0, 0
  for d = from, to, 0.25e-3 do sum, count = sum + wall.force_at(r.curve, d), count + 1 end
  return sum/count
end

local cases = {}
for _, specimen in ipairs(specimens) do
  local plateau = specimen.name == "sw30"
  local quantity = plateau and "plateau, 3 to 7.5 mm" or "peak"
  cases[#cases + 1] = {
    name = "sandstone_" .. specimen.name, title = "wall " .. specimen.name:upper(),
    parameters = { { "N", specimen.N, "kN" } },
    checks = {
      { quantity, unit = "kN", measured = plateau and { 15, 15.8, 17.1, 17.3, 17.5, 20.7 } or specimen.peaks,
        between = specimen.band },
      { "mechanism", measured = "turning with stepped opening, sliding", one_of = { "stepped rocking", "sliding" } },
    },
    known = plateau and "the model ends at the limit of rigid blocks under 30 kN, 15.8 kN less the toe. The " ..
      "measured walls rise above mu N = 21 kN, so N did not stay at 30 kN; with 36 kN the plateau is met" or nil,
    run = function()
      local r = push(specimen)
      results[specimen.name] = r
      return { [quantity] = (plateau and mean(r, 3e-3, 7.5e-3) or r.peak)/1e3, mechanism = r.mechanism }
    end,
    plot = function()
      return wall.plot(results[specimen.name], specimen.at, ("Sandstone wall %s"):format(specimen.name:upper()))
    end,
  }
end

return {
  title = "Dry sandstone walls",
  source = "Lourenco, Oliveira, Roca and Orduna (2005), Journal of Structural Engineering 131(11); Oliveira (2003), " ..
    "doctoral thesis, University of Minho",
  text = "Sawn sandstone blocks without mortar, pushed at constant vertical load. Of SW30 the plateau counts, not " ..
    "the peak: the peak is above the friction of the whole base under the stated load.",
  assumptions = assumptions,
  moves = {
    { "SW30, plateau", "N", "30 kN", "36 kN", 0.83, 0.98 },
    { "SW30, plateau", "N", "30 kN", "39 kN", 0.83, 1.06 },
    { "SW30, plateau", "method", "steady push in time", "statics by arc length, steps of 0.025 mm", 0.83, 0.83 },
  },
  cases = cases,
}
