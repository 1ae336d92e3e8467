-- A steel-reinforced rubber bearing that slides on concrete: Steelman, Fahnestock, Filipov, LaFave, Hajjar and Foutch
-- (2013).
local trilith = require "trilith"
local setting = ... or {}

-- Assumptions of the series. mu falls with the pressure: mu = mu_ref (s_ref/s)^(1 - exponent).
local series = { plan = 0.178*0.305, rubber = 0.048, G = 0.75e6, mu_ref = 0.40, s_ref = 3.4e6, exponent = 0.80 }
for key, value in pairs(setting.over or {}) do series[key] = value end
local assumptions = {
  { "bearing", "0.178 m x 0.305 m, 48 mm of rubber, directly on concrete, top plate fixed to the deck",
    "Steelman et al. 2013; example of the programme's sizes" },
  { "G", "0.75 MPa", "middle of 0.6 to 0.9 MPa" },
  { "friction", "0.40 at 3.4 MPa, compression to the power 0.80: 0.48 at 1.4 MPa, 0.36 at 5.5 MPa",
    "range 0.25 to 0.50, falling with the pressure; the exponent is assumed" },
  { "rubber", "linear; no creep, no hardening at large strain", "nearly linear until it slides" },
}

-- Cyclic displacement at a pressure. Returns strain and friction at first slip, unloading stiffness over G A/h, and the
-- relative loss of force while held.
local function push(pressure)
  local s = series
  local normal, k = pressure*s.plan, s.G*s.plan/s.rubber
  local m = trilith.model { name = "bearing", gravity = 0 }
  m:material { name = "deck", density = 2400 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "pier", width = 1, height = 0.5, at = { -0.5, -0.5 }, material = "deck", support = "fixed" }
  local deck = m:block { name = "deck", width = 1, height = 0.5, at = { -0.5, 0 }, material = "deck",
    support = { rotation = "fixed" } }
  local bearing = m:bearing { name = "rubber", between = { "pier", "deck" }, at = { 0, 0 },
    axial = trilith.linear { stiffness = 5e8, damping = 1e5 },
    along = trilith.friction { mu = s.mu_ref, stiffness = k, load_exponent = s.exponent,
      reference_load = s.s_ref*s.plan } }
  m:point_load { body = deck, force = { 0, -normal } }
  m:consolidate { rest = { ratio = 1e-6 } }
  if setting.file then m:results { file = setting.file } end
  local u, f = {}, {}
  local function drive(by, duration)
    m:drive { body = deck, x = trilith.ramp { by = by, duration = duration } }
    m:run { duration = duration, dt = setting.coarse and 2e-4 or 5e-5, until_true = function()
      u[#u + 1], f[#f + 1] = deck.ux, math.abs(bearing.force[1] or bearing.force.along)
      return false
    end }
  end
  drive(4*s.rubber, 2)
  local peak, slip = math.max(table.unpack(f, #f - 100)), nil
  for i = 1, #f do
    if f[i] >= 0.999*peak then slip = u[i] break end
  end
  local held = #f
  m:run { duration = 0.5 }
  local creep = 1 - math.abs(bearing.force[1] or bearing.force.along)/f[held]
  drive(-0.5*s.rubber, 1)
  local unloading = (f[held] - f[#f])/(u[held] - u[#u])/k
  return { strain = slip/s.rubber, mu = peak/normal, unloading = unloading, creep = creep }
end

local cases = {}
for _, pressure in ipairs { 1.4, 2.5, 3.4, 5.5 } do
  local strain = 100*series.mu_ref*(series.s_ref/1e6/pressure)^(1 - series.exponent)*pressure*1e6/series.G
  cases[#cases + 1] = {
    name = ("rubber_%.0f"):format(10*pressure), title = "first slip", parameters = { { "pressure", pressure, "MPa" } },
    checks = {
      { "friction at first slip", measured = "0.25 to 0.50", between = { 0.25, 0.50 } },
      { "shear strain at first slip", unit = "%", measured = "125 to 250", between = { 125, 250 } },
      { "strain over mu s/G", measured = 1, between = { 0.99, 1.01 } },
      { "unloading stiffness over G A/h", measured = 1, between = { 0.99, 1.01 } },
      { "force lost while held", measured = "none", between = { -0.001, 0.001 } },
    },
    run = function()
      local r = push(pressure*1e6)
      return { ["friction at first slip"] = r.mu, ["shear strain at first slip"] = 100*r.strain,
        ["strain over mu s/G"] = 100*r.strain/strain, ["unloading stiffness over G A/h"] = r.unloading,
        ["force lost while held"] = r.creep }
    end,
  }
end
cases[1].known = "the strain at slip is mu s/G. No friction up to 0.50 with a G of at least 0.6 MPa reaches 125 % " ..
  "at this pressure: the published ranges do not agree here; see the table below"
cases[4].known = "the strain at slip is mu s/G. A G of 0.9 MPa, or friction that falls faster with the pressure, " ..
  "meets the range; see the table below"

return {
  title = "Rubber bearing that slides on concrete",
  source = "Steelman, Fahnestock, Filipov, LaFave, Hajjar and Foutch (2013), Journal of Structural Engineering 139",
  text = "The bearing is a spring in series with friction. It slips at mu N, at the shear strain mu s/G.",
  assumptions = assumptions,
  moves = {
    { "strain at 1.4 MPa, over 125 %", "G", "0.75 MPa", "0.6 MPa", 0.71, 0.89 },
    { "strain at 1.4 MPa, over 125 %", "exponent", "0.80", "0.60: friction 0.57, above its range", 0.71, 0.85 },
    { "strain at 1.4 MPa, over 125 %", "friction and G", "0.48, 0.75 MPa", "ends of both ranges: 0.50, 0.6 MPa", 0.71,
      0.93 },
    { "strain at 5.5 MPa, over 250 %", "G", "0.75 MPa", "0.9 MPa", 1.06, 0.89 },
    { "strain at 5.5 MPa, over 250 %", "exponent", "0.80", "0.60: friction 0.33", 1.06, 0.97 },
    { "strain at 5.5 MPa, over 250 %", "exponent", "0.80", "1: friction 0.40", 1.06, 1.17 },
  },
  cases = cases,
}
