-- The low wall ISP1 of two-leaf brickwork, pushed in its plane with a level top: Anthoine, Magonette, Magenes (1995).
local trilith = require "trilith"
local wall = require "shared.wall"
local mortar = require "shared.mortar_wall"
local setting = ... or {}

-- Assumptions, fixed before the first run.
local height = 1.35
local series = { courses = 21, unit_width = 0.25, unit_height = height/21, thickness = 0.25, beam_height = 0.2,
  length = 1.0, vertical = 150e3, density = 1886, mu = 0.58, cohesion = 0.23e6, tension = 0.6*0.23e6,
  energy_tension = 10, energy_shear = 50, compression = 6.2e6, crushing_depth = 0.010, unit_tension = 0.065*26.9e6,
  unit_energy = 40e-6*0.065*26.9e6, mass_factor = 100, beta = 1e-5, top = "double fixed", displacement = 0.0075,
  rate = setting.coarse and 4e-3 or 1e-3, file = setting.file, frames = 1 }
local joint = trilith.joint_stiffness { wall_modulus = 1000*series.compression, unit_modulus = 17.5e9,
  course_height = series.unit_height, shear_ratio = 0.4 }
series.kn, series.ks = joint.kn, joint.ks

local peaks, ultimate = { 81.4, 84.2 }, { 0.38, 0.44 }
local result

return {
  title = "Low wall of two-leaf brickwork",
  source = "Anthoine, Magonette and Magenes (1995), 10th European Conference on Earthquake Engineering",
  text = "The wall ISP1 cracks along its diagonals, through joints and bricks. The push ends where the force has " ..
    "fallen by 20 %. Limits by hand: 102 kN for turning with crushed toes, 90.5 kN for friction alone, 144.5 kN for " ..
    "sliding with cohesion.",
  assumptions = {
    { "wall", "1.00 m x 1.35 m x 0.25 m; units of 0.25 m x 0.064 m with their joint in running bond, 21 courses",
      "Anthoine et al. 1995; the header bond as a plane wall" },
    { "boundary", "double fixed: the top is kept level, N stays constant at 150 kN", "Anthoine et al. 1995" },
    { "density", "1886 kg/m3", "as in the series of piers" },
    { "kn, ks", "149 GPa/m, 0.4 of it", "E of the masonry 1000 times its strength (EN 1996-1-1, 3.7.2); E of the " ..
      "brick 17.5 GPa, as in the series of piers" },
    { "shear", "cohesion 0.23 MPa, friction 0.58, fracture energy 50 J/m2", "Anthoine et al. 1995; energy as in the " ..
      "series of piers" },
    { "tension", "0.6 of the cohesion, fracture energy 10 J/m2", "as in the series of piers" },
    { "compression", "6.2 MPa", "strength of the masonry, Anthoine et al. 1995" },
    { "bricks", "compressive strength 26.9 MPa: tension 1.75 MPa", "Anthoine et al. 1995, and the rule below" },
    mortar.assumptions[1], mortar.assumptions[2], mortar.assumptions[3],
    { "push", "1 mm/s", "chosen for the time of the computation; raised after first runs" },
  },
  cases = { {
    name = "brick_isp1", title = "wall ISP1", parameters = { { "N", 150, "kN" } },
    checks = {
      { "peak", unit = "kN", measured = peaks, between = { 70, 95 } },
      { "mechanism", measured = "diagonal, through joints and bricks", one_of = { "diagonal through units" } },
      { "drift at a loss of 20 %", unit = "%", measured = ultimate, between = { 0.9*0.38, 1.1*0.44 } },
    },
    known = "the peak comes before the diagonal crack is complete, and the force falls to 66 kN at 1.5 mm. Bricks " ..
      "of 0.03 instead of 0.065 of their compressive strength give 97 kN, bricks that cannot crack 102 kN with " ..
      "sliding, joints that cannot crush 100 kN. The rate of the push changes the peak by 0.3 %",
    run = function()
      result = mortar.push(series, {}, setting.over)
      return { peak = result.peak/1e3, mechanism = result.mechanism,
        ["drift at a loss of 20 %"] = mortar.ultimate_drift(result, height), notes = mortar.notes(result) }
    end,
    plot = function()
      local mean = (peaks[1] + peaks[2])/2
      return wall.plot(result, { { 0, mean }, { 6, mean } }, "Wall ISP1", "measured peak")
    end,
  } },
}
