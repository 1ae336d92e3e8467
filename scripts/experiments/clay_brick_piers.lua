-- Clay brick piers pushed in their plane with a level top: Graziotti et al. (2016), Groningen programme.
local trilith = require "trilith"
local wall = require "shared.wall"
local mortar = require "shared.mortar_wall"
local setting = ... or {}

-- Assumptions of the series, fixed before the first run.
local height = 2.71
local series = { courses = 22, unit_width = 0.436, unit_height = height/22, thickness = 0.208, beam_height = 0.3,
  density = 1886, mu = 0.55, cohesion = 0.15e6, tension = 0.6*0.15e6, energy_tension = 10, energy_shear = 50,
  compression = 11.2e6, crushing_depth = 0.010, crush_energy = mortar.crush_energy(11.2e6),
  unit_tension = 0.065*62.4e6, unit_energy = 40e-6*0.065*62.4e6,
  mass_factor = mortar.mass_factor, rate = mortar.rate(setting.coarse), beta = 1e-5, top = "double fixed",
  file = setting.file, frames = 1 }
local joint = trilith.joint_stiffness { wall_modulus = 9.83e9, unit_modulus = 17.5e9,
  course_height = series.unit_height, shear_ratio = 0.4 }
series.kn, series.ks = joint.kn, joint.ks

local assumptions = {
  { "piers", "2.71 m high, 0.208 m thick; blocks of 0.436 m x 0.123 m in running bond, twice the size of a brick " ..
    "with its joint", "Graziotti et al. 2016; larger blocks of the same proportions, for short runs" },
  { "boundary", "double fixed: the top is kept level, N stays constant", "Graziotti et al. 2016" },
  { "density", "1886 kg/m3", "18.5 kN/m3, assumed" },
  { "kn, ks", "182 GPa/m, 0.4 of it", "E of the masonry 9.83 GPa, measured; E of the brick 17.5 GPa, middle of 15 " ..
    "to 20 GPa" },
  { "shear", "cohesion 0.15 MPa, friction 0.55, fracture energy 50 J/m2", "Graziotti et al. 2016; energy from the " ..
    "literature" },
  { "tension", "0.6 of the cohesion, fracture energy 10 J/m2", "literature" },
  { "compression", "11.2 MPa, softens with 17.9 N/mm to a tenth", "strength of the masonry, Graziotti et al. 2016; " ..
    "energy by the rule below" },
  { "bricks", "compressive strength 62.4 MPa: tension 4.06 MPa", "Graziotti et al. 2016, and the rule below" },
  mortar.assumptions[1], mortar.assumptions[2], mortar.assumptions[3],
  mortar.assumptions[4], mortar.assumptions[5],
}

-- L [m], N [N], measured peaks [kN] and ultimate drift [%]; the slender pier is not pushed to its loss of force.
local specimens = {
  { name = "comp2_1", length = 1.20, vertical = 130e3, peaks = { 59.1, 58.4 }, band = { 54, 63 }, displacement = 0.012,
    mechanism = "rocking", allowed = { "rocking", "stepped rocking" } },
  { name = "comp2_4", length = 2.74, vertical = 171e3, peaks = { 126, 137 }, band = { 110, 160 }, ultimate = 0.24,
    displacement = 0.0068, mechanism = "diagonal shear",
    allowed = { "diagonal through units", "stepped rocking" },
    known = "joints and bricks of the diagonal break at once, at a small drift. The peak is 0.7 kN above the band. " ..
      "The tested pier was pushed in both directions; with cycles the peak is 154 kN, within the band. Cohesion " ..
      "moves the peak too, and the fracture energies of the joints move the drift; see the table below" },
}

local results, cases = {}, {}
for _, specimen in ipairs(specimens) do
  cases[#cases + 1] = {
    name = "brick_" .. specimen.name, title = "pier " .. specimen.name:upper(),
    parameters = { { "L", specimen.length, "m" }, { "N", specimen.vertical/1e3, "kN" } },
    checks = {
      { "peak", unit = "kN", measured = specimen.peaks, between = specimen.band },
      { "mechanism", measured = specimen.mechanism, one_of = specimen.allowed },
      mortar.inertia_check,
      specimen.ultimate and { "drift at a loss of 20 %", unit = "%", measured = specimen.ultimate,
        between = { 0.9*specimen.ultimate, 1.1*specimen.ultimate } } or nil,
    },
    known = specimen.known,
    run = function()
      local r = mortar.push(series, specimen, setting.over)
      results[specimen.name] = r
      return { peak = r.peak/1e3, mechanism = r.mechanism, ["inertia at the peak"] = mortar.inertia(r),
        ["drift at a loss of 20 %"] = mortar.ultimate_drift(r, height), notes = mortar.notes(r) }
    end,
    plot = function()
      local mean = (specimen.peaks[1] + specimen.peaks[2])/2
      return wall.plot(results[specimen.name], { { 0, mean }, { specimen.displacement*1e3, mean } },
        ("Pier %s"):format(specimen.name:upper()), "measured peak")
    end,
  }
end

return {
  title = "Clay brick piers with a level top",
  source = "Graziotti, Tomassetti, Rossi et al. (2016), EUCENTRE, Pavia",
  text = "Two piers of one series: a slender one that rocks and a squat one that fails by diagonal shear. The push " ..
    "ends where the force has fallen by 20 %, for the slender pier at 12 mm at the latest, beyond the measured peak " ..
    "at 10 mm. In a first run its force had fallen by 20 % at 0.5 % drift, where 3.0 % was measured.",
  assumptions = assumptions,
  moves = { -- at 1 mm/s (coarse)
    { "COMP2_1, peak", "rate of the push", "2 mm/s: inertia 27 %", "0.5 mm/s: inertia 3.3 %", 1.27, 1.03 },
    { "COMP2_1, peak", "rate of the push", "0.5 mm/s", "0.25 mm/s (as in the table above): inertia 1.7 %", 1.03,
      1.01 },
    { "COMP2_4, peak", "rate of the push", "1 mm/s (as in the rows below)", "0.25 mm/s (as in the table above)", 1.24,
      1.22 },
    { "COMP2_4, peak", "crushing", "softens with 17.9 N/mm", "constant strength: no joint crushes", 1.24, 1.24 },
    { "COMP2_4, peak", "cohesion and tension of joints", "0.15 and 0.09 MPa", "half of them", 1.24, 1.02 },
    { "COMP2_4, drift at a loss of 20 %", "the same", "0.15 and 0.09 MPa", "half of them", 0.22, 0.27 },
    { "COMP2_4, peak", "fracture energies of joints", "50 and 10 J/m2", "500 and 100 J/m2", 1.24, 1.33 },
    { "COMP2_4, drift at a loss of 20 %", "the same", "50 and 10 J/m2", "500 and 100 J/m2: not lost at 0.25 %", 0.22,
      1.05 },
    { "COMP2_4, peak", "cracks of bricks", "possible", "not possible", 1.24, 1.24 },
    { "COMP2_4, peak", "planes of cracks in bricks", "one at mid length", "the two diagonals: none cracks", 1.24,
      1.24 },
    { "COMP2_4, peak, at 6 mm/s", "size of blocks", "0.436 m x 0.123 m", "one brick: 0.218 m x 0.060 m", 1.29, 1.29 },
    { "COMP2_4, drift at a loss of 20 %, at 6 mm/s", "the same", "0.436 m x 0.123 m", "0.218 m x 0.060 m", 0.24,
      0.35 },
    { "COMP2_4, peak", "protocol", "pushed in one direction",
      "two cycles each of 0.34, 0.68 and 1.36 mm: 154 kN, within the band", 1.24, 1.17 },
    { "COMP2_1, peak", "crushing", "softens with 17.9 N/mm", "constant strength", 1.08, 1.08 },
  },
  cases = cases,
}
