-- Joints that creep: a pile under constant load, the same pile held, and a leaning column.
local trilith = require "trilith"
local day = 86400

-- Concrete C30/37 of 0.3 m in air of 70 %, loaded at 28 days; EN 1992-1-1, annex B.1, by hand.
local concrete = { strength = 38e6, humidity = 0.7, size = 0.3, age = 28*day }
local function by_hand(years)
  local fcm, h, t = 38, 300, years*365.25
  local humidity = (1 + 0.3/(0.1*h^(1/3))*(35/fcm)^0.7)*(35/fcm)^0.2
  local scale = 1.5*(1 + (0.012*70)^18)*h + 250*(35/fcm)^0.5
  return humidity*16.8/math.sqrt(fcm)/(0.1 + 28^0.2)*(t/(scale + t))^0.3
end

local function pile(p)
  local m = trilith.model { name = "pile", dim = p.dim, gravity = 0 }
  m:material { name = "stone", density = 2500 }
  m:contact { between = { "*", "*" }, law = "none" }
  local blocks, up = {}, p.dim == 2 and "uy" or "uz"
  for i = 0, 5 do
    local t = { name = "b" .. i, material = "stone", floating = true }
    if p.dim == 2 then
      t.width, t.height, t.at = 1, 0.2, { -0.5, 0.2*i }
      t.support = i == 0 and "fixed" or { x = "fixed", rotation = "fixed" }
    else
      t.size, t.at = { 1, 1, 0.2 }, { -0.5, -0.5, 0.2*i }
      t.support = i == 0 and "fixed" or { x = "fixed", y = "fixed", rotation_x = "fixed", rotation_y = "fixed",
        rotation_z = "fixed" }
    end
    blocks[i] = m:block(t)
  end
  local zero = p.dim == 3 and 0 or nil
  for i = 1, 5 do
    m:bearing { name = "j" .. i, between = { blocks[i - 1], blocks[i] }, at = p.dim == 2 and { 0, 0.2*i }
      or { 0, 0, 0.2*i }, axial = trilith.linear { stiffness = 2e10 } }
    local single = not p.chain
    m:creep { bearing = "j" .. i, direction = "axial", stiffness = 2e10, factor = single and 2 or nil,
      time = single and 30*day or nil, chain = p.chain }
  end
  m:point_load { name = "load", body = blocks[5], force = zero and { 0, 0, -5e5 } or { 0, -5e5 } }
  m:consolidate { integrator = "static" }
  return m, blocks[5], up
end

local function creeps(p)
  local m, top, up = pile(p)
  local out = { ["shortening at once"] = -top[up] }
  m:creep_process { duration = 30*day, step = 3*day }
  out["shortening after 30 d"] = -top[up]
  m:creep_process { duration = 335*day, step = 10*day }
  out["shortening after 365 d"] = -top[up]
  out["residual of the energy balance"] = m.residual/m.energy.load
  return out
end

local function relaxes(p)
  local m, top = pile(p)
  m:fix(top)
  local out, before = {}, m.bearings.j1.force_axial
  for days = 10, 30, 10 do
    m:creep_process { duration = 10*day, step = p.step }
    out[("force after %d d"):format(days)] = m.bearings.j1.force_axial/before
  end
  return out
end

-- The shortening over the elastic one, less 1.
local function creeps_as_concrete(p)
  local m, top, up = pile { dim = p.dim, chain = trilith.concrete_creep(concrete).chain }
  local out, elastic, last = {}, -top[up], 0
  for _, years in ipairs { 0.1, 1, 10, 50 } do
    m:creep_process { duration = (years - last)*365.25*day, step = 100*day }
    out[("creep coefficient after %g years"):format(years)], last = -top[up]/elastic - 1, years
  end
  return out
end

-- Weight W at height h on a rotational joint k, leaning by 1e-3: the tilt grows or settles.
local function leans(p)
  local m = trilith.model { name = "tower", gravity = 0 }
  m:material { name = "stone", density = 2500 }
  m:contact { between = { "*", "*" }, law = "none" }
  local base = m:block { name = "base", width = 1, height = 0.2, at = { -0.5, -0.2 }, material = "stone",
    support = "fixed" }
  local column = m:block { name = "column", width = 0.5, height = 4, at = { -0.25, 0 }, material = "stone",
    floating = true }
  local stiff = trilith.linear { stiffness = 1e12 }
  m:bearing { name = "foot", between = { base, column }, at = { 0, 0 }, along = stiff, axial = stiff,
    turning = trilith.linear { stiffness = p.stiffness } }
  m:creep { bearing = "foot", direction = "turning", stiffness = p.stiffness, factor = 2, time = 30*day }
  m:point_load { name = "weight", body = column, at = { 0, 2 }, force = { 0, -50e3 } }
  m:point_load { name = "lean", body = column, moment = -50e3*2*1e-3 }
  m:consolidate { integrator = "static" }
  local function tilt() return 1e-3 - column.rotation end
  local out, last = { ["tilt at once"] = tilt() }, 0
  for _, days in ipairs(p.days) do
    m:creep_process { duration = (days - last)*day, step = 0.5*day }
    out[("tilt after %d d"):format(days)], last = tilt(), days
  end
  return out
end

-- T dc/dt + c = factor M/k with M = W h (e + theta): c grows by r = (factor W h/(k - W h) - 1)/T.
local function tilt_at(k, days)
  local wh, factor, time = 50e3*2, 2, 30
  local rate = (factor*wh/(k - wh) - 1)/time
  local first = k/(k - wh)*1e-3
  local goal = k/(k - (1 + factor)*wh)*1e-3
  return goal + (first - goal)*math.exp(rate*days)
end

local cases = {}
for _, dim in ipairs { 2, 3 } do
  local place = dim == 2 and "plane" or "space"
  cases[#cases + 1] = { name = "creep_" .. place, title = "five joints under 0.5 MPa, in " .. place,
    parameters = { { "dim", dim } },
    checks = { { "shortening at once", unit = "m", exact = 0.125e-3, tolerance = 0.002 },
      { "shortening after 30 d", unit = "m", exact = 0.125e-3*(3 - 2*math.exp(-1)), tolerance = 0.002 },
      { "shortening after 365 d", unit = "m", exact = 0.125e-3*(3 - 2*math.exp(-365/30)), tolerance = 0.002 },
      { "residual of the energy balance", unit = "of the work of the load", exact = 0, within = 1e-9 } },
    run = creeps }
end
local coefficients = {}
for _, years in ipairs { 0.1, 1, 10, 50 } do
  coefficients[#coefficients + 1] = { ("creep coefficient after %g years"):format(years),
    unit = "of the elastic displacement", exact = by_hand(years), tolerance = 0.004 }
end
cases[#cases + 1] = { name = "concrete", title = "the same joints creep as concrete of EN 1992-1-1, in steps of 100 d",
  parameters = { { "dim", 2 } }, checks = coefficients, run = creeps_as_concrete }
local checks = {}
for days = 10, 30, 10 do
  checks[#checks + 1] = { ("force after %d d"):format(days), unit = "of the first", tolerance = 0.002,
    exact = 1/3 + 2/3*math.exp(-days/10) }
end
cases[#cases + 1] = { name = "relaxation", title = "the same joints, held", parameters = { { "dim", 2 },
    { "step", 0.5*day, "s" } }, checks = checks, run = relaxes }
for _, row in ipairs { { 2.5e5, "falls", { 5, 10, 20 } }, { 4e5, "stands", { 20, 60, 180 } } } do
  local list = { { "tilt at once", unit = "rad", exact = tilt_at(row[1], 0), tolerance = 0.01 } }
  for _, days in ipairs(row[3]) do
    list[#list + 1] = { ("tilt after %d d"):format(days), unit = "rad", exact = tilt_at(row[1], days),
      tolerance = 0.01 }
  end
  cases[#cases + 1] = { name = "tower_" .. row[2], title = "leaning column that " .. row[2],
    parameters = { { "stiffness", row[1], "N m/rad" } }, checks = list,
    run = function(p) return leans { stiffness = p.stiffness, days = row[3] } end }
end

return {
  title = "Joints that creep",
  source = "Findley, Lai and Onaran (1976), Creep and Relaxation of Nonlinear Viscoelastic Materials, chapter 5; " ..
    "EN 1992-1-1:2004, annex B.1",
  formula = [[T \dot c + c = \varphi f/k, \qquad d = f/k\,(1 + \varphi(1 - e^{-t/T})), \qquad
W h (1 + \varphi) < k \text{ stands}]],
  text = "Five joints with a Kelvin element each shorten under a constant load and relax when they are held. A " ..
    "column that leans on a creeping joint falls by creep alone where its weight times its height times (1 + " ..
    "factor) exceeds the stiffness, and settles where it does not. With a chain of elements the joints follow the " ..
    "creep coefficient of concrete over 50 years, in steps much longer than the shortest time of the chain.",
  cases = cases,
}
