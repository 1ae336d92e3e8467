-- Bodies with heat and water crack while stages and a process run.
local trilith = require "trilith"
local p = trilith.params { out = { "out/crack_fields.h5", "results" },
  duration = { 0.05, unit = "s", "of the stage" }, steps = { 400, "steps of each process" } }
local strength = 2e4
local m = trilith.model { name = "fields of cracks" }
m:material { name = "stone", density = 2400, E = 3e10, nu = 0.2 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 5e10, mu = 0.4, beta = 1e-6 } }
m:contact { between = { "stone", "stone" }, name = "plane", law = trilith.cohesive { kn = 1e12, ks = 5e11, mu = 0.7,
  tension = strength, cohesion = 2*strength, energy_tension = 1, energy_shear = 4, beta = 1e-6 } }
m:contact { between = { "rock", "*" }, law = trilith.frictional { kn = 1e11, ks = 5e10, mu = 0.4, beta = 1e-6 } }
m:block { name = "rock", width = 12, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
m:block { name = "dam", width = 4, height = 2, at = { 0, 0 }, material = "stone", cracks = "mid", crack_law = "plane" }
m:block { name = "sill", width = 4, height = 1, at = { 5, 0 }, material = "stone", body = { mesh = { 8, 2 } },
  cracks = "mid", crack_law = "plane" }
for _, name in ipairs { "dam", "sill" } do
  m:seepage { name = "joint of " .. name, upper = name, lower = "rock", aperture = 1e-3, divisions = 8,
    from = name .. " heel", to = name .. " toe" }
  m:seepage_head { node = name .. " heel", head = 3 }
  m:seepage_head { node = name .. " toe", head = 1 }
  m:heat { body = name, conductivity = 2, heat_capacity = 900, temperature = 12,
    expansion = name == "sill" and 1e-5 or 0 }
end
m:heat { body = "rock", conductivity = 2, heat_capacity = 900, temperature = 8 }
m:heat_exchange { body = { "dam", "sill" }, side = "top", temperature = { { 0, 12 }, { 1e5, -10 } }, exchange = 20 }
m:heat_contact { conductance = 20, friction = true }
m:results { file = p.out, frames = 0.01, histories = 1e-3, energy = 0.01 }
m:history { name = "temperature", body = "dam", what = "temperature" }
m:history { name = "inflow", seepage = "joint of dam", what = "inflow" }
m:seepage_motion { flows = true }
m:consolidate { integrator = "static" }
m:process { name = "before", duration = 10*p.steps, step = 10 }
for x, sign in pairs { [0] = -1, [4] = 1 } do
  m:point_load { name = "pull " .. x, body = "dam", at = { x, 1 }, force = { sign*3*strength*2, 0 },
    load_curve = { { 0, 0 }, { 2e-3, 1 }, { 2.2e-3, 0 } } }
end
local state = m:keep { cracks = 0 }
m:on("unit.cracked", function() state.cracks = state.cracks + 1 end)
m:run { name = "pulled", duration = p.duration }
m:process { name = "after", duration = 10*p.steps, step = 10 }
print("hash " .. m.hash, state.cracks, m:temperature "dam.a", m:seepage_state("joint of dam").inflow)
return { cracks = state.cracks, temperature = m:temperature "dam.a", inflow = m:seepage_state("joint of dam").inflow }
