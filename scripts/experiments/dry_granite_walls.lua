-- Dry granite walls pushed in their plane: Vasconcelos (2005).
local trilith = require "trilith"
local wall = require "shared.wall"
local setting = ... or {}

-- Assumptions of the series. None is fitted to a wall.
local series = {
  length = 1, courses = 8, unit_width = 0.2, unit_height = 0.15, thickness = 0.2, beam_height = 0.25,
  density = 2650, mu = 0.62,
  wall_modulus = { { 0.5e6, 3287e6 }, { 0.875e6, 4068e6 } }, unit_modulus = 20.2e9, -- { stress, modulus }
  ks_over_kn = 0.4,
}

for key, value in pairs(setting.over or {}) do series[key] = value end
local assumptions = {
  { "wall", "1.00 m x 1.20 m x 0.20 m, 8 courses of 0.20 m x 0.15 m, half units at the ends of every second course",
    "Vasconcelos 2005" },
  { "boundary", "cantilever: the beam turns freely, N stays constant; push at 1.325 m", "Vasconcelos 2005" },
  { "density", "2650 kg/m3", "granite, assumed" },
  { "friction", "0.62 in all joints, no cohesion, no tension; joints to the beam and the base do not slide",
    "sawn granite 0.60 to 0.65, not decisive" },
  { "kn", "26.2 GPa/m under 100 kN, 34.0 GPa/m under 175 kN",
    "`trilith.joint_stiffness`: moduli of the walls under vertical load, 3287 MPa at 0.5 MPa and 4068 MPa at 0.875 " ..
      "MPa, less the stone" },
  { "ks", "0.4 kn", "elastic ratio for a Poisson's ratio of 0.2" },
}

-- N [kN], measured: peak, band of the peak, forces at displacements [mm].
local specimens = {
  { name = "ws100", N = 100, peak = { 37, 39, 37.8, 38, 36 }, band = { 34, 40 },
    at = { { 1, 12.5 }, { 2, 21.4 }, { 3, 25.6 }, { 5, 29.8 }, { 10, 33.1 }, { 20, 36.5 } } },
  { name = "ws175", N = 175, peak = { 63.2, 61.8, 64.5, 64.3 }, band = { 58, 69 },
    at = { { 1, 16.4 }, { 2, 29.9 }, { 3, 39.5 }, { 5, 52 }, { 10, 59.3 }, { 20, 62.7 } } },
}

local results = {}

local function push(specimen)
  local s = {}
  for key, value in pairs(series) do s[key] = value end
  local stress = specimen.N*1e3/(s.length*s.thickness)
  local joint = trilith.joint_stiffness { wall_modulus = s.wall_modulus, unit_modulus = s.unit_modulus,
    stress = stress, course_height = s.unit_height, shear_ratio = s.ks_over_kn }
  local kn, ks = (s.stiffer or 1)*joint.kn, (s.stiffer or 1)*joint.ks
  local function law(mu) return trilith.frictional { kn = kn, ks = ks, mu = mu, beta = 2e-6 } end
  s.joint, s.ends, s.vertical, s.top = law(s.mu), law(2), (s.more_load or 1)*specimen.N*1e3, s.top or "cantilever"
  s.displacement, s.rate, s.file, s.frames = 0.035, setting.coarse and 5e-3 or 1e-3, setting.file, 5
  return wall.push(s)
end

local cases = {}
for _, specimen in ipairs(specimens) do
  local at_2, at_10 = specimen.at[2][2], specimen.at[5][2]
  cases[#cases + 1] = {
    name = "granite_" .. specimen.name, title = "wall " .. specimen.name:upper(),
    parameters = { { "N", specimen.N, "kN" } },
    checks = {
      { "peak", unit = "kN", measured = specimen.peak, between = specimen.band },
      { "force at 2 mm", unit = "kN", measured = at_2, between = { 0.7*at_2, 1.3*at_2 } },
      { "force at 10 mm", unit = "kN", measured = at_10, between = { 0.88*at_10, 1.12*at_10 } },
      { "force at 2.5 % drift over peak", measured = "above 0.85", between = { 0.85, 1 } },
      { "mechanism", measured = "rocking", one_of = { "rocking", "stepped rocking" } },
    },
    known = "joints of a rocking wall are softer than joints of the same wall under vertical load. With a quarter " ..
      "of kn the force at 2 mm is met",
    run = function()
      local r = push(specimen)
      results[specimen.name] = r
      return { peak = r.peak/1e3, ["force at 2 mm"] = wall.force_at(r.curve, 2e-3)/1e3,
        ["force at 10 mm"] = wall.force_at(r.curve, 10e-3)/1e3,
        ["force at 2.5 % drift over peak"] = wall.force_at(r.curve, 0.025*1.325)/r.peak, mechanism = r.mechanism }
    end,
    plot = function()
      return wall.plot(results[specimen.name], specimen.at, ("Granite wall %s"):format(specimen.name:upper()))
    end,
  }
end

return {
  title = "Dry granite walls",
  source = "Vasconcelos (2005), doctoral thesis, University of Minho; Vasconcelos and Lourenco (2009)",
  text = "Sawn granite blocks without mortar, pushed at constant vertical load. The walls rock to 3 % drift almost " ..
    "without loss of force.",
  assumptions = assumptions,
  moves = {
    { "WS100, force at 2 mm", "kn", "26 GPa/m", "6 GPa/m", 1.53, 0.87 },
    { "WS100, peak", "kn", "26 GPa/m", "6 GPa/m", 0.95, 0.90 },
    { "WS100, force at 2 mm", "ks, with kn 6 GPa/m", "0.4 kn", "0.1 kn", 0.87, 0.57 },
    { "WS100, force at 2 mm", "method", "steady push in time", "statics by arc length, steps of 0.025 mm", 1.53, 1.53 },
  },
  cases = cases,
}
