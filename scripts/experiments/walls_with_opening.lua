-- Brick walls with an opening and a locked top: Raijmakers and Vermeltfoort (1992), walls J2G and J3G.
local wall = require "shared.wall"
local mortar = require "shared.mortar_wall"
local setting = ... or {}

-- Assumptions of the series, fixed before the first run.
local series = { courses = 16, unit_width = 0.22, unit_height = 0.0625, thickness = 0.1, beam_height = 0.2,
  length = 0.99, vertical = 29.7e3, density = 1900, mu = 0.75, cohesion = 0.35e6, tension = 0.25e6,
  energy_tension = 18, energy_shear = 125, compression = 10.5e6, crushing_depth = 0.010,
  crush_energy = 5000, unit_tension = 2e6, unit_energy = 80, kn = 1.1e11, ks = 5e10,
  mass_factor = mortar.mass_factor, beta = 1e-5, top = "locked", displacement = 0.02,
  openings = { { from = 0.33, to = 0.66, first_course = 6, last_course = 11 } },
  rate = mortar.rate(setting.coarse), file = setting.file, frames = 1 }

local peaks = { 43, 50 }
local result

return {
  title = "Brick walls with an opening and a locked top",
  source = "Raijmakers and Vermeltfoort (1992); Lourenco (1996), doctoral thesis, Delft University of Technology",
  text = "The walls J2G and J3G are equal. After 0.30 MPa the top is locked: it keeps its level and its height, so " ..
    "that the vertical load grows while the wall is pushed.",
  assumptions = {
    { "wall", "990 mm x 1000 mm x 100 mm; 16 free courses of bricks of 210 mm x 52 mm with joints of 10 mm, as " ..
      "blocks of 220 mm x 62.5 mm", "Raijmakers and Vermeltfoort 1992; the outer two of 18 courses are clamped" },
    { "opening", "0.33 m wide and 6 courses high, in the middle", "literature, not checked in the source" },
    { "top", "0.30 MPa, then locked", "Lourenco 1996" },
    { "density", "1900 kg/m3", "assumed, not decisive" },
    { "kn, ks", "110 GPa/m, 50 GPa/m", "Lourenco 1996" },
    { "joints", "tension 0.25 MPa and 18 J/m2; cohesion 0.35 MPa and 125 J/m2; friction 0.75; no dilatancy",
      "Lourenco 1996" },
    { "compression", "10.5 MPa, softens with 5 N/mm to a tenth", "Lourenco 1996; the residual strength is assumed" },
    { "bricks", "tension 2.0 MPa, 80 J/m2", "Lourenco 1996" },
    mortar.assumptions[1], mortar.assumptions[2], mortar.assumptions[3],
    mortar.assumptions[4],
  },
  moves = { -- at 1 mm/s (coarse)
    { "peak", "rate of the push", "1 mm/s (as in the rows below)", "0.25 mm/s (as in the table above)", 1.24, 1.24 },
    { "peak", "crushing", "softens with 5 N/mm", "constant strength", 1.24, 1.37 },
    { "peak", "compressive strength, with its energy", "10.5 MPa", "5.25 MPa", 1.24, 0.73 },
    { "peak", "top", "locked", "level, N constant", 1.24, 0.46 },
    { "peak", "opening, not checked in the source", "6 courses", "8 courses: within the band", 1.24, 1.17 },
    { "peak", "kn and ks", "110 and 50 GPa/m", "82 and 36 GPa/m, of wall J4D: within the band", 1.24, 1.20 },
    { "peak", "planes of cracks in bricks", "one at mid length", "three, at the quarters: within the band", 1.24,
      1.23 },
    { "peak", "planes of cracks in bricks", "one at mid length", "the two diagonals", 1.24, 1.32 },
    { "peak", "tension of bricks, with its energy", "2.0 MPa", "1.0 MPa: within the band", 1.24, 1.14 },
    { "peak", "dilatancy", "none", "0.3 up to a slip of 1 mm", 1.24, 1.35 },
    { "peak", "friction", "0.75", "0.60", 1.24, 1.24 },
  },
  cases = { {
    name = "opening_j2g", title = "walls J2G and J3G",
    checks = {
      { "peak", unit = "kN", measured = peaks, between = { 0.85*43, 1.15*50 } },
      { "mechanism", measured = "diagonal cracks of the piers", one_of = { "diagonal through units",
        "stepped rocking" } },
      mortar.inertia_check,
    },
    known = "the peak is 0.2 kN above the band. The compressive strength and the load of the locked top decide. The " ..
      "stiffness of joints, a larger opening and weaker bricks move it into the band; see the table below",
    run = function()
      result = mortar.push(series, {}, setting.over)
      return { peak = result.peak/1e3, mechanism = result.mechanism, ["inertia at the peak"] =
        mortar.inertia(result), notes = mortar.notes(result) }
    end,
    plot = function()
      return wall.plot(result, { { 0, 46.5 }, { 20, 46.5 } }, "Walls J2G and J3G", "measured peak")
    end,
  } },
}
