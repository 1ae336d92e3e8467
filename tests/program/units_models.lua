-- One of three models in chosen units: trilith run units_models.lua case=wall units="N mm" out=wall.h5
-- Prints its readings in SI, so that runs in different units can be compared.
local trilith = require "trilith"
local p = trilith.params { case = "wall", units = "SI", out = "out/units.h5" }
local m = trilith.model { name = "units", units = p.units, mass_damping = p.case == "portal" and 1 or 0,
  dim = p.case == "tower" and 3 or 2 }

-- SI values of the units of force and length.
local sizes = { SI = { 1, 1 }, ["kN m"] = { 1e3, 1 }, ["N mm"] = { 1, 1e-3 }, ["kip ft"] = { 4448.2216152605, 0.3048 } }
local F, L = table.unpack(sizes[p.units])
local M = F/L
local factors = { m = L, m2 = L^2, N = F, ["N m"] = F*L, ["N/m"] = F/L, ["N s/m"] = F/L, Pa = F/L^2, ["Pa/m"] = F/L^3,
  ["kg/m3"] = M/L^3, ["m/s"] = L, ["m/s2"] = L, kg = M, ["kg m2"] = M*L^2, ["N/m3"] = F/L^3, J = F*L,
  ["J/m2"] = F/L, ["1/m"] = 1/L, ["m3"] = L^3, ["m3/s"] = L^3, ["W/(m K)"] = F, ["W/(m2 K)"] = F/L,
  ["J/(kg K)"] = L^2, ["Pa s"] = F/L^2 }
-- A number as one would write it: with the same digits where the units differ by a power of ten.
local function q(value, unit)
  if p.units == "kip ft" then return value/factors[unit] end
  local digits, exponent = ("%.14e"):format(value):match "^(.-)e(.+)$"
  return tonumber(("%se%.0f"):format(digits, tonumber(exponent) - math.log(factors[unit], 10)))
end
local function report(name, value, unit)
  print(("%s %.17g"):format(name, value*(unit and factors[unit] or 1)))
end

local cases = {}

function cases.wall()
  m:material { name = "brick", density = q(1900, "kg/m3") }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = q(5e9, "Pa/m"), ks = q(2e9, "Pa/m"), mu = 0.6,
    beta = 1e-4, tension = q(1e5, "Pa"), cohesion = q(2e5, "Pa"), energy_tension = q(10, "J/m2"),
    energy_shear = q(50, "J/m2") } }
  local wall = m:wall { name = "wall", length = q(0.8, "m"), courses = 4, at = { q(1, "m"), 0 }, material = "brick",
    fixed = "course 1" }
  local top = wall[#wall]
  local history = m:history { name = "top", body = top, what = "ux" }
  local fastest = m:history { name = "fastest", unit = "m/s",
    of = function(model) return model.speed*factors["m/s"] end }
  local broken, sampled = 0, 0
  m:on("bond.broken", function(e) broken = broken + e.value*e.x end)
  m:consolidate { rest = { ratio = 1e-5, speed = q(1e-3, "m/s") } }
  local push = m:pushover { body = top, displacement = q(4e-4, "m"), rate = q(0.02, "m/s"), samples = 20,
    on_sample = function(_, sample) sampled = sampled + sample.force end }
  report("mass", wall.mass, "kg")
  report("peak", push.peak_force, "N")
  report("at", push.displacement_at_peak, "m")
  report("sampled", sampled, "N")
  report("broken", broken*F*L)
  report("moved", history.max, "m")
  report("fastest", fastest.max)
  report("kinetic", m.energy.kinetic, "J")
  report("corner", top.outline[1][1], "m")
  report("contact", m:contacts()[1].normal, "N")
end

function cases.bearing()
  m:material { name = "concrete", unit_weight = q(25e3, "N/m3") }
  m:contact { between = { "*", "*" }, law = "none" }
  m:block { name = "pier", width = q(2, "m"), height = q(3, "m"), at = { 0, 0 }, material = "concrete",
    support = "fixed" }
  local deck = m:block { name = "deck", width = q(6, "m"), height = q(1.2, "m"), at = { q(-2, "m"), q(3.1, "m") },
    material = "concrete" }
  local bearing = m:bearing { name = "pad", between = { "pier", "deck" }, at = { q(1, "m"), q(3, "m") },
    arm = q(1, "m"),
    along = trilith.lead_rubber { strength = q(2e4, "N"), post_stiffness = q(8e5, "N/m") },
    axial = trilith.linear { stiffness = q(2e8, "N/m"), damping = q(1e5, "N s/m") },
    turning = trilith.linear { stiffness = q(5e8, "N m"), damping = q(1e6, "N m") }, limit = { along = q(0.5, "m"),
    turning = 0.2 } }
  local samples = {}
  for i = 1, 40 do samples[i] = q(3*trilith.math.sin(i*0.3141592653589793), "m/s2") end
  local pulse = trilith.motion { acceleration = samples, dt = 0.01, allow_drift = true }
  local turn = trilith.ramp { by = 0.001, duration = 1 }
  m:drive { body = "pier", rotation = turn }
  m:shake { body = "pier", x = pulse, duration = 0.5, until_collapse = { drop = q(1, "m") } }
  report("pga", pulse.pga, "m/s2")
  report("along", bearing.force.along, "N")
  report("turning", bearing.force.turning, "N m")
  report("slid", bearing.displacement_along, "m")
  report("turned", bearing.displacement.turning)
  report("moved", deck.ux, "m")
  report("speed", deck.vx, "m/s")
  report("inertia", deck.inertia, "kg m2")
  report("work", m.energy.support, "J")
end

function cases.portal()
  local bars = trilith.menegotto_pinto { E = q(2e11, "Pa"), yield = q(420e6, "Pa"), hardening = 0.005 }
  local concrete = trilith.kent_park { strength = q(30e6, "Pa"), confinement = 1.2, ultimate = 0.02 }
  local function section(width, depth, area)
    return trilith.fibre_section { shape = trilith.rectangle_section { width = q(width, "m"), depth = q(depth, "m") },
      law = concrete, bars = { { area = q(area, "m2"), height = q(0.05, "m") },
        { area = q(area, "m2"), height = q(depth - 0.05, "m") } }, bar_law = bars }
  end
  local column = section(0.35, 0.35, 8e-4)
  m:material { name = "concrete", density = q(2500, "kg/m3"), E = q(3e10, "Pa"), nu = 0.2 }
  local portal = m:frame { name = "portal", material = "concrete",
    joints = { a = { at = { 0, 0 }, support = "fixed" }, b = { 0, q(3, "m") }, c = { q(5, "m"), q(3, "m") },
      d = { at = { q(5, "m"), 0 }, support = "fixed" } },
    members = { { name = "left", from = "a", to = "b", section = column, divisions = 4 },
      { name = "beam", from = "b", to = "c", section = section(0.3, 0.5, 15e-4), divisions = 4 },
      { name = "right", from = "d", to = "c", section = column, divisions = 4 } } }
  m:point_load { body = portal, at = { 0, q(3, "m") }, force = { 0, q(-1e5, "N") } }
  m:point_load { body = portal, at = "c", force = { 0, q(-1e5, "N") } }
  m:consolidate { integrator = "static" }
  local push = m:pushover { body = portal, at = "b", control = "arc", displacement = q(0.02, "m") }
  local row = portal:forces "left"[1]
  report("peak", push.peak_force, "N")
  report("moment", row.moment, "N m")
  report("normal", row.normal, "N")
  report("place", row.along, "m")
  report("curve", push.curve.displacement[3], "m")
  report("base", portal:reactions()[1].m, "N m")
  report("yield", column:moment_curvature { normal = q(-1e5, "N") }.yield_curvature, "1/m")
end

function cases.tower()
  m:material { name = "stone", density = q(2400, "kg/m3"), E = q(2e8, "Pa"), nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = q(2e8, "Pa/m"), ks = q(1e8, "Pa/m"), mu = 0.6,
    beta = 1e-3 } }
  m:block { name = "foot", size = { q(2, "m"), q(2, "m"), q(0.5, "m") }, at = { 0, 0, 0 }, material = "stone",
    support = "fixed" }
  m:block { name = "soft", size = { q(0.6, "m"), q(0.5, "m"), q(1, "m") },
    at = { q(0.5, "m"), q(0.5, "m"), q(0.5, "m") }, material = "stone", body = { mesh = { 1, 1, 2 } } }
  m:sphere { name = "ball", radius = q(0.1, "m"), at = { q(0.2, "m"), q(0.2, "m"), q(0.62, "m") }, material = "stone",
    floating = true, velocity = { q(0.5, "m/s"), 0, 0 } }
  m:pressure { body = "soft", face = "left", value = q(500, "Pa") }
  m:run { duration = 0.15, until_true = function(model) return model:body("ball").x*L > 0.26 end }
  report("time", m.time)
  report("ball", m:body("ball").x, "m")
  report("place", select(3, m:body("soft"):point { q(0.5, "m"), q(0.5, "m"), q(1.5, "m") }), "m")
  report("stress", m:body("soft").szz, "Pa")
  report("reaction", m:body("foot").reaction_z, "N")
  report("area", m:contacts { between = { "soft", "foot" } }[1].area, "m2")
end

-- Functions whose tables have units of their own: heat, water in joints, modes, fibres, creep, bolts.
function cases.fields()
  m:material { name = "stone", density = q(2400, "kg/m3"), E = q(3e10, "Pa"), nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = q(1e9, "Pa/m"), ks = q(5e8, "Pa/m"), mu = 0.6,
    beta = 1e-4 } }
  m:block { name = "ground", width = q(4, "m"), height = q(1, "m"), at = { 0, q(-1, "m") }, material = "stone",
    support = "fixed" }
  local block = m:block { name = "block", width = q(2, "m"), height = q(1, "m"), at = { q(1, "m"), 0 },
    material = "stone" }
  m:heat { body = "block", conductivity = q(2, "W/(m K)"), heat_capacity = q(900, "J/(kg K)"), temperature = 10 }
  m:heat_exchange { name = "air", body = "block", side = "left", temperature = 30, exchange = q(10, "W/(m2 K)") }
  m:seepage { name = "fissure", length = q(2, "m"), width = q(1, "m"), aperture = q(2e-4, "m"), from = "lake",
    to = "drain", density = q(1000, "kg/m3"), viscosity = q(1e-3, "Pa s"), bulk_modulus = q(2.2e9, "Pa") }
  m:seepage_head { node = "lake", head = q(3, "m") }
  m:seepage_head { node = "drain", head = { { 0, q(0.5, "m") }, { 1e4, q(1, "m") } } }
  local shape = trilith.rectangle_section { width = q(0.1, "m"), depth = q(0.2, "m") }
  local section = trilith.fibre_section { shape = shape,
    law = trilith.bilinear_steel { E = q(2.1e11, "Pa"), yield = q(355e6, "Pa") } }
  local post = m:beam { name = "post", from = { q(6, "m"), 0 }, to = { q(6, "m"), q(2, "m") }, material = "stone",
    from_support = "fixed", section = section, divisions = 2 }
  m:point_load { body = post, at = { q(6, "m"), q(2, "m") }, force = { q(2e3, "N"), 0 } }
  local hit = 0
  m:on({ "contact.made", above = q(1e9, "N") }, function() hit = hit + 1 end)
  m:consolidate { integrator = "static" }
  m:process { duration = 3600, step = 600 }
  local mode, heat, water = m:modes { count = 2 }[1], m:heat_state(), m:seepage_state "fissure"
  report("hit", hit)
  report("warm", (m:temperature "block"))
  report("content", heat.content, "J")
  report("supplied", heat.surroundings.air.supplied, "J")
  report("head", water.head[1], "m")
  report("pressure", water.pressure[2], "Pa")
  report("inflow", water.inflow, "m3/s")
  report("volume", m:seepage_state().volume, "m3")
  report("frequency", mode.frequency)
  report("modal_mass", mode.mass_x, "kg")
  report("factor", math.abs(mode.factor_x)*math.sqrt(factors.kg))
  report("turn", math.abs(mode.shape.block.rotation/mode.shape.block.x), "1/m")
  local at = post:fibres()[1]
  report("curvature", at.curvature, "1/m")
  report("fibre", at.fibres[1].height, "m")
  report("stress", at.fibres[1].stress, "Pa")
  report("block", block.y, "m")
end

m:results { file = p.out, frames = 0.05, histories = 0.01 }
cases[p.case]()
report("gravity", -m.gravity[2], "m/s2")
