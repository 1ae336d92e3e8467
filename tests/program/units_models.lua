-- One of three models in chosen units: trilith run units_models.lua case=wall units="N mm" out=wall.h5
-- Prints its readings in SI, so that runs in different units can be compared.
local trilith = require "trilith"
local p = trilith.params { case = "wall", units = "SI", out = "out/units.h5" }
local m = trilith.model { name = "units", units = p.units, mass_damping = p.case == "portal" and 1 or 0,
  dim = ({ tower = 3, skew = 3, builders = 3 })[p.case] or 2 }

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
  local waited, later = 0, 0
  m:story(function()
    local event = m:wait { "bond.broken", above = q(1, "N"), within = 5 }
    waited = event and event.value or -1
    m:wait(0.001)
    later = top.ux
  end)
  m:consolidate { rest = { ratio = 1e-5, speed = q(1e-3, "m/s") } }
  local push = m:pushover { body = top, displacement = q(4e-4, "m"), rate = q(0.02, "m/s"), samples = 20,
    on_sample = function(_, sample) sampled = sampled + sample.force end }
  report("mass", wall.mass, "kg")
  report("peak", push.peak_force, "N")
  report("at", push.displacement_at_peak, "m")
  report("sampled", sampled, "N")
  report("broken", broken*F*L)
  report("waited", waited, "N")
  report("later", later, "m")
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

-- Calls whose tables have units of their own: changes, breaks, comparisons, fits, openings and storeys.
function cases.calls()
  m:material { name = "brick", density = q(1900, "kg/m3") }
  m:contact { between = { "*", "*" }, name = "mortar", law = trilith.cohesive { kn = q(5e9, "Pa/m"),
    ks = q(2e9, "Pa/m"), mu = 0.6, beta = 1e-4, tension = q(1e5, "Pa"), cohesion = q(2e5, "Pa"),
    energy_tension = q(10, "J/m2"), energy_shear = q(50, "J/m2") } }
  m:wall { name = "wall", length = q(1.6, "m"), unit_height = q(0.2, "m"), material = "brick",
    base_height = q(0.2, "m"), fixed = "base", cracks = "mid", crack_law = "mortar",
    storeys = { { courses = 5, slab_height = q(0.2, "m") }, { height = q(0.8, "m") } },
    openings = { { storey = 1, x = q(0.6, "m"), sill = q(0.2, "m"), width = q(0.4, "m"), height = q(0.4, "m"),
      lintel_height = q(0.2, "m"), lintel_bearing = q(0.2, "m") } } }
  local panel = m:running_bond { name = "panel", columns = 4, at = { q(4, "m"), 0 }, material = "brick",
    base_height = q(0.2, "m"), fixed = "base",
    openings = { { from = q(0.4, "m"), to = q(0.8, "m"), first_course = 2 } } }
  m:pier { name = "post", station = q(8, "m"), height = q(2, "m"), seat = q(0.3, "m"), gap = q(0.1, "m"),
    ground_level = 0, material = "brick", support = "fixed" }
  local deck = m:block { name = "deck", width = q(2, "m"), height = q(0.5, "m"), at = { q(7, "m"), q(2.1, "m") },
    material = "brick" }
  m:block { name = "lintel", width = q(1.6, "m"), height = q(0.3, "m"), at = { q(4, "m"), q(1.2, "m") },
    material = "brick", cracks = { { point = { q(4.5, "m"), q(1.3, "m") }, normal = { 1, 0 } } },
    crack_law = "mortar" }
  local pad = m:bearing { name = "pad", between = { "post", "deck" }, at = { q(8, "m"), q(2.05, "m") }, arm = q(1, "m"),
    along = trilith.linear { stiffness = q(1e6, "N/m"), damping = q(1e4, "N s/m") },
    axial = trilith.linear { stiffness = q(1e8, "N/m"), damping = q(1e5, "N s/m") },
    turning = trilith.linear { stiffness = q(1e8, "N m"), damping = q(1e5, "N m") }, limit = { along = q(0.2, "m") } }
  local number = m:break_on { "impact", above = q(1e6, "m/s") }
  local top = m:history { name = "top", body = deck, what = "ux" }
  report("slip", #m:lint { slip = q(0.02, "m") } > 0 and 1 or 0)
  report("limit", tonumber((m:breaks()[number]:match "above ([%d.e+]+) ")), "m/s")
  m:consolidate { integrator = "static" }
  local fit = m:calibrate { frequency = 26, mode = 2, vary = { "mortar.kn", "mortar.ks" },
    between = { q(2e9, "Pa/m"), q(6e9, "Pa/m") }, tolerance = 1e-3 }
  report("fitted", fit.values["mortar.kn"], "Pa/m")
  report("value", fit.value, "Pa/m")
  report("try", fit.tries[2].value, "Pa/m")
  report("rows", #tostring(fit) > 100 and 1 or 0)
  m:change { law = "mortar", kn = q(4e9, "Pa/m"), tension = q(0.9e5, "Pa") }
  m:change { bearing = "pad", limit = { along = q(0.1, "m") },
    turning = trilith.linear { stiffness = q(2e8, "N m"), damping = q(1e5, "N m") } }
  m:checkpoints { every = 0.02, count = 20 }
  local push = m:point_load { body = deck, at = { q(8, "m"), q(2.35, "m") }, force = { q(2e3, "N"), 0 } }
  m:run { duration = 0.1 }
  report("back", m:rewind(0.05))
  m:change { bearing = "pad", along = trilith.linear { stiffness = q(5e5, "N/m"), damping = q(1e4, "N s/m") } }
  m:continue()
  local found = m:compare()
  report("apart", found.moved[1].distance, "m")
  report("history", found.histories.top.difference, "m")
  report("separated", found.from)
  report("moved", top.last, "m")
  report("turning", pad.force.turning, "N m")
  report("panel", panel.mass, "kg")
  report("push", push and 1 or 0)
end

-- A bridge of the plane by its tables, and a fit of a number of the script.
function cases.spans()
  m:material { name = "concrete", density = q(2400, "kg/m3") }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = q(1e9, "Pa/m"), ks = q(5e8, "Pa/m"), mu = 0.6,
    beta = 2e-4 } }
  m:bearing_type { name = "fixed", height = q(0.1, "m"), along = trilith.linear { stiffness = q(5e7, "N/m") },
    axial = trilith.linear { stiffness = q(2e9, "N/m"), damping = q(4e6, "N s/m") }, limit = { along = q(0.05, "m") } }
  local bridge = m:bridge { x = q(10, "m"), soffit_level = q(5, "m"), gap = q(0.1, "m"), seat = q(0.5, "m"),
    material = "concrete",
    abutment = { height = q(5, "m"), width = q(4, "m"), back_wall_height = q(1.5, "m"), support = "fixed" },
    pier = { height = q(5, "m"), stem_width = q(1, "m"), support = "fixed" },
    span = { depth = q(1.5, "m"), left = "fixed", right = "fixed", weight_per_length = q(1e5, "N/m") },
    supports = { { name = "A0" }, { name = "P1", height = q(6, "m") }, { name = "A2" } },
    spans = { { name = "S1", length = q(20, "m") }, { name = "S2", length = q(25, "m") } } }
  m:consolidate { rest = { ratio = 1e-3 } }
  report("mass", bridge.spans.S2.mass, "kg")
  report("level", bridge.supports.P1.y, "m")
  report("seat", bridge.spans[1].seats.right.length, "m")
  report("force", bridge.spans.S1.bearings.left.force.axial, "N")
  local found = trilith.calibrate { frequencies = { 36 }, vary = { E = q(2e11, "Pa") }, build = function(v)
    local mast = trilith.model { name = "mast", thickness = q(1, "m"), gravity = 0, units = p.units }
    mast:material { name = "steel", density = q(7850, "kg/m3"), E = v.E }
    mast:frame { name = "mast", material = "steel", floating = true,
      joints = { foot = { at = { 0, 0 }, support = "fixed" }, head = { 0, q(3, "m") } },
      members = { { from = "foot", to = "head",
        section = trilith.rectangle_section { width = q(0.1, "m"), depth = q(0.2, "m") } } } }
    return mast
  end }
  report("E", found.values.E, "Pa")
end

-- A skewed bridge in space, on springs, with a shear key, and the motions of its supports.
function cases.skew()
  m:material { name = "concrete", density = q(2400, "kg/m3") }
  m:contact { between = { "*", "*" }, name = "rubbing", law = trilith.frictional { kn = q(5e8, "Pa/m"),
    ks = q(2e8, "Pa/m"), mu = 0.6, beta = 2e-4 } }
  m:bearing_type { name = "fixed", height = q(0.1, "m"), along = trilith.linear { stiffness = q(5e7, "N/m") },
    axial = trilith.linear { stiffness = q(2e9, "N/m"), damping = q(4e6, "N s/m") }, limit = { along = q(0.5, "m") } }
  local rock = trilith.linear { stiffness = q(5e9, "N m"), damping = q(1e7, "N m") }
  local bridge = m:bridge { gap = q(0.1, "m"), seat = q(0.6, "m"), breadth = q(10, "m"), skew = 0.3,
    material = "concrete", ground = { margin = q(1, "m") },
    girders = { count = 2, spacing = q(5, "m"), breadth = q(0.6, "m") },
    abutment = { height = q(8, "m"), width = q(4, "m"), back_wall_height = q(1.5, "m"), breadth = q(12, "m"),
      shear_key = { gap = q(0.1, "m"), height = q(0.6, "m"), breadth = q(0.5, "m") } },
    pier = { height = q(8, "m"), stem_width = q(1.2, "m"), footing_width = q(5, "m"), footing_breadth = q(9, "m"),
      footing_thickness = q(1, "m"), foundation = { along = trilith.linear { stiffness = q(1e9, "N/m"),
        damping = q(1e7, "N s/m") }, across = trilith.linear { stiffness = q(1e9, "N/m"), damping = q(1e7, "N s/m") },
        axial = trilith.linear { stiffness = q(3e9, "N/m"), damping = q(3e7, "N s/m") }, turning_along = rock,
        turning_across = rock, turning_axial = rock } },
    span = { length = q(25, "m"), depth = q(1.5, "m"), weight_per_length = q(1.5e5, "N/m"), left = "fixed",
      right = "fixed" },
    supports = { { name = "A0" }, { name = "P1" }, { name = "A2" } }, spans = { { name = "S1" }, { name = "S2" } } }
  local samples = {}
  for i = 1, 20 do samples[i] = q(2*trilith.math.sin(i*0.3141592653589793), "m/s2") end
  local pulse = trilith.motion { acceleration = samples, dt = 0.01, allow_drift = true }
  m:shake { duration = 0.03, motions = bridge:motions { x = pulse, velocity = q(800, "m/s") } }
  report("axis", bridge.axes.P1, "m")
  report("place", bridge.places.S1.left[1][1], "m")
  report("seat", bridge.seats.S1.left.g2.length, "m")
  report("mass", bridge.spans.S1.mass, "kg")
  report("moment", bridge.foundations.P1[1].force.turning_across, "N m")
  report("speed", bridge.supports.P1.vx, "m/s")
end

-- Waves that enter a column of soil, and a free field at its side.
function cases.waves()
  m:material { name = "soil", density = q(1800, "kg/m3"), E = q(1.8e8, "Pa"), nu = 0.25, plane = "strain" }
  m:contact { between = { "*", "*" }, law = "none" }
  local soil = m:block { name = "soil", width = q(4, "m"), height = q(8, "m"), at = { 0, 0 }, material = "soil",
    floating = true, body = { mesh = { 4, 8 } } }
  local medium = { density = q(1800, "kg/m3"), cs = q(200, "m/s"), cp = q(346, "m/s") }
  local function boundary(keys)
    for key, value in pairs(medium) do keys[key] = value end
    keys.body = soil
    return m:absorbing_boundary(keys)
  end
  local wave = { { 0, 0 }, { 0.05, q(0.1, "m/s") }, { 0.1, 0 } }
  local base = boundary { edge = "bottom", motion = { x = wave } }
  local function layer(top) return { top = top, density = medium.density, cs = medium.cs, cp = medium.cp } end
  boundary { edge = "left", free_field = { base = 0, surface = q(8, "m"), motion = wave, half_space = medium } }
  boundary { edge = "right", free_field = { base = 0, motion = wave, layers = { layer(q(3, "m")), layer(q(8, "m")) } } }
  m:run { duration = 0.15, dt = 2e-4 }
  report("area", base.area, "m2")
  report("moved", (soil:point { q(2, "m"), q(8, "m") }) - q(2, "m"), "m")
  report("work", m.energy.load, "J")
end

-- Builders in space with nested tables, and a mesh from a file in the unit of the model.
function cases.builders()
  m:material { name = "stone", density = q(2400, "kg/m3"), E = q(2e9, "Pa"), nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = q(2e9, "Pa/m"), ks = q(1e9, "Pa/m"), mu = 0.6,
    beta = 1e-4 } }
  local house = m:building { name = "house", material = "stone", fixed = "base", base_height = q(0.2, "m"),
    storeys = { { courses = 4 } },
    walls = { { name = "front", from = { 0, 0 }, to = { q(2.4, "m"), 0 }, thickness = q(0.2, "m"),
        openings = { { from = q(0.8, "m"), sill = q(0.2, "m"), width = q(0.4, "m"), height = q(0.4, "m") } } },
      { name = "back", from = { 0, q(2, "m") }, to = { q(2.4, "m"), q(2, "m") }, thickness = q(0.2, "m") } },
    beams = { along = "y", count = 1, width = q(0.2, "m"), from = { q(1.6, "m"), 0 },
      to = { q(2.2, "m"), q(2, "m") } } }
  local column = m:column { name = "column", drums = 2, height = q(2, "m"), radius = q(0.25, "m"), material = "stone",
    at = { q(6, "m"), 0, 0 }, base = { width = q(0.8, "m"), height = q(0.2, "m") },
    capital = { width = q(0.7, "m"), height = q(0.2, "m") }, fixed = "base" }
  local pair = m:clump { name = "pair", material = "stone", at = { q(9, "m"), 0, q(0.1, "m") }, floating = true,
    spheres = { { at = { 0, 0, 0 }, radius = q(0.1, "m") }, { at = { q(0.15, "m"), 0, 0 }, radius = q(0.08, "m") } } }
  local wedge = m:body { name = "wedge", material = "stone", floating = true,
    pieces = { { hull = { { q(12, "m"), 0, 0 }, { q(13, "m"), 0, 0 }, { q(12, "m"), q(1, "m"), 0 },
      { q(12, "m"), 0, q(1, "m") } } } } }
  m:run { duration = 0.002 }
  report("house", house.mass, "kg")
  report("units", #house)
  report("column", column.mass, "kg")
  report("top", column[#column].z, "m")
  report("pair", pair.mass, "kg")
  report("wedge", wedge.mass, "kg")
end

m:results { file = p.out, frames = 0.05, histories = 0.01 }
cases[p.case]()
report("gravity", -m.gravity[2], "m/s2")
