-- The declarations of the laws are in engine/law; here are their examples.
return {
  name = "laws", title = "Laws of contacts, bearings, solids, fibres and hinges; sections of beams", has_laws = true,
  examples = {
    ["trilith.frictional"] = [[
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 2e-4 } }]],
    ["trilith.bonded"] = [[
m:contact { between = { "stone", "stone" },
  law = trilith.bonded { kn = 6e9, ks = 3e9, mu = 0.6, beta = 1e-4, tension = 1e5, cohesion = 2e5 } }]],
    ["trilith.cohesive"] = [[
m:contact { between = { "stone", "stone" },
  law = trilith.cohesive { kn = 6e9, ks = 3e9, mu = 0.7, beta = 1e-4, tension = 1e5, cohesion = 1.5e5,
    energy_tension = 10, energy_shear = 50 } }]],
    ["trilith.power"] = [[
m:contact { between = { "stone", "stone" },
  law = trilith.power { kn = 1e9, depth = 1e-4, exponent = 1.5, ks = 5e8, mu = 0.6 } }]],
    ["trilith.bouc_wen"] = [[
local damper = trilith.bouc_wen { stiffness = 2e7, yield = 1e5, hardening = 0.05, exponent = 2 }]],
    ["trilith.cable"] = [[
local restrainer = trilith.cable { stiffness = 3e7, slack = 0.02, strength = 5e5 }]],
    ["trilith.elastic_plastic"] = [[
local steel = trilith.elastic_plastic { stiffness = 1e7, yield = 5e4, hardening = 0.02 }]],
    ["trilith.friction"] = [[
m:bearing { name = "slider", between = { "ground", "block" }, at = { 0, 0 },
  axial = trilith.linear { stiffness = 2e8 }, along = trilith.friction { mu = 0.08, stiffness = 1e7 } }]],
    ["trilith.gap"] = [[
local stop = trilith.gap { stiffness = 1e8, opening = 0.05, damping = 1e5 }]],
    ["trilith.lead_rubber"] = [[
local isolator = trilith.lead_rubber { strength = 9e4, post_stiffness = 1e6, ratio = 10 }]],
    ["trilith.linear"] = [[
local pad = trilith.linear { stiffness = 1e6, damping = 1e3 }]],
    ["trilith.maxwell"] = [[
local damper_on_brace = trilith.maxwell { stiffness = 1e6, force = 1e5, exponent = 1 }]],
    ["trilith.pendulum"] = [[
m:bearing { name = "dish", between = { "ground", "block" }, at = { 0, 0 },
  axial = trilith.linear { stiffness = 2e8 }, along = trilith.pendulum { radius = 1, mu = 0.05, stiffness = 5e6 } }]],
    ["trilith.pounding"] = [[
local buffer = trilith.pounding { stiffness = 1e8, opening = 0.03, restitution = 0.65, mass = 2e5 }]],
    ["trilith.shear_key"] = [[
local dowel = trilith.shear_key { stiffness = 1e8, strength = 2e5, residual = 0.1 }]],
    ["trilith.table"] = [[
local soil = trilith.table { points = { { -0.1, -3e5 }, { -0.02, -2e5 }, { 0, 0 }, { 0.02, 2e5 }, { 0.1, 3e5 } } }]],
    ["trilith.viscous"] = [[
local damper = trilith.viscous { force = 2e5, exponent = 0.35 }]],
    ["trilith.linear_elastic"] = [[
m:material { name = "marble", density = 2700, solid = trilith.linear_elastic { E = 50e9, nu = 0.25 } }]],
    ["trilith.j2"] = [[
m:material { name = "steel", density = 7850, solid = trilith.j2 { E = 210e9, nu = 0.3, yield = 355e6 } }]],
    ["trilith.mohr_coulomb"] = [[
local deg = trilith.units "deg"
m:material { name = "masonry", density = 1900,
  solid = trilith.mohr_coulomb { E = 3e9, nu = 0.2, cohesion = 2e5, friction_angle = 30*deg, tension = 1e5 } }]],
    ["trilith.drucker_prager"] = [[
local deg = trilith.units "deg"
m:material { name = "soil", density = 1900,
  solid = trilith.drucker_prager { E = 5e7, nu = 0.3, cohesion = 1e4, friction_angle = 30*deg } }]],
    ["trilith.bilinear_steel"] = [[
local bars = trilith.bilinear_steel { E = 200e9, yield = 500e6, hardening = 0.01 }]],
    ["trilith.kent_park"] = [[
local concrete = trilith.kent_park { strength = 30e6, strain = 0.002, ultimate = 0.006 }]],
    ["trilith.mander"] = [[
local core = trilith.mander { strength = 30e6, E = 27e9, ultimate = 0.015, confinement = 1.3 }]],
    ["trilith.menegotto_pinto"] = [[
local bars = trilith.menegotto_pinto { E = 200e9, yield = 500e6, hardening = 0.01 }]],
    ["trilith.uniaxial_elastic"] = [[
local elastic = trilith.uniaxial_elastic { E = 200e9 }]],
    ["trilith.end_hinge"] = [[
local hinge = trilith.end_hinge { sagging = 2e5, hogging = 1.5e5, hardening = 1e5 }]],
    ["trilith.box_section"] = [[
local girder = trilith.box_section { width = 6, depth = 2.2, webs = 0.8, top = 0.25, bottom = 0.2 }
print(girder.area)]],
    ["trilith.circle_section"] = [[
local pile = trilith.circle_section { diameter = 1.2 }]],
    ["trilith.i_section"] = [[
local rolled = trilith.i_section { depth = 0.4, web = 0.009,
  top_width = 0.18, top_thickness = 0.014, bottom_width = 0.18, bottom_thickness = 0.014 }]],
    ["trilith.rectangle_section"] = [[
local beam = trilith.rectangle_section { width = 0.3, depth = 0.5 }]],
    ["trilith.section"] = [[
local rolled = trilith.section { area = 8.4e-3, inertia = 2.3e-4, depth = 0.4 }]],
    ["trilith.t_section"] = [[
local girder = trilith.t_section { depth = 1.5, web = 0.4, width = 2.5, thickness = 0.2 }]],
  },
}
