-- A wall whose units crack, and the same wall with joints alone: capacity in shear and pattern of cracks.
--
-- Physics: some 160 rigid units in running bond between a fixed base and a stiff beam that carries the load from above
-- and stays level. The beam is pushed sideways. Joints and planes in the middle of the units soften with their fracture
-- energies. Where a plane reaches the strength of the unit, the unit becomes two bodies.
local trilith = require "trilith"
local MPa, J, mm = 1e6, 1, 1e-3
local p = trilith.params {
  pressure = { 1*MPa, unit = "Pa", "vertical stress on the wall" },
  tension = { 0.4*MPa, unit = "Pa", "tensile strength of the units" },
  cohesion = { 0.8*MPa, unit = "Pa", "shear strength of the units without pressure" },
  energy = { 40*J, unit = "J/m2", "their fracture energy in tension" },
  length = { 2.5, unit = "m", "of the wall" },
  courses = { 15, "number of courses" },
  push = { 2.8*mm, unit = "m", "displacement at the end of the push" },
  rate = { 20*mm, unit = "m/s", "speed of the push" },
  wall = { "both", "both, joints or units: the walls that are pushed" },
  out = { "out/cracking_wall", "results, without .h5" } }
local thickness, unit_height = 0.25, 0.1

local function build(cracks)
  local m = trilith.model { name = cracks and "units may crack" or "joints alone", thickness = thickness }
  m:material { name = "brick", density = 1800 }
  local kn = 2e10
  m:contact { between = { "*", "*" }, name = "unit", law = trilith.cohesive { kn = 10*kn, ks = 4*kn, mu = 0.7,
    beta = 2e-6, tension = p.tension, cohesion = p.cohesion, energy_tension = p.energy, energy_shear = 10*p.energy } }
  m:contact { between = { "*", "*" }, name = "joint", law = trilith.cohesive { kn = kn, ks = 0.4*kn, mu = 0.7,
    beta = 1.4e-5, tension = 0.2*MPa, cohesion = 0.3*MPa, energy_tension = 15*J, energy_shear = 60*J } }
  m:wall { name = "wall", length = p.length, unit_length = 0.25, unit_height = unit_height, courses = p.courses,
    bond = "running", base_height = 0.2, base_margin = 0.3, slab_height = 0.2, material = "brick", fixed = "base",
    cracks = cracks and "mid", crack_law = cracks and "unit" or nil, by_group = { slabs = { cracks = false } } }
  return m
end

local function push(title, cracks, file)
  local m = build(cracks)
  local units, slab = m:bodies { group = "units" }, m:bodies { group = "slabs" }
  local count = { ["unit.cracked"] = 0, ["bond.broken"] = 0 }
  for event in pairs(count) do m:on(event, function() count[event] = count[event] + 1 end) end
  m:results { file = file, frames = 0.02, histories = 0.001 }
  m:history { name = "force", what = "push_force" }
  m:history { name = "displacement", what = "push_displacement" }
  local number = #units
  m:point_load { body = slab, force = { 0, -p.pressure*p.length*thickness } }
  m:consolidate { integrator = "static" }
  local r = m:pushover { body = slab, top = "level", rate = p.rate, displacement = p.push, samples = 400 }
  print(("%-16s %d units, peak %.0f kN at %.2f mm, at the end %.0f kN; %d units cracked, %d halves of bonds lost")
    :format(title, number, r.peak_force/1e3, r.displacement_at_peak/mm, r.force/1e3, count["unit.cracked"],
      count["bond.broken"]))
  print(("%-16s %.0f J spent in fracture and %.0f J in friction; the error of the energy balance is %.2g J"):format("",
    m.energy.contact_fracture, m.energy.contact_friction, math.abs(m.residual)))
  return r
end

local joints = p.wall ~= "units" and push("joints alone", false, p.out .. "_joints.h5")
local units = p.wall ~= "joints" and push("units may crack", true, p.out .. ".h5")
if joints and units then
  print(("units that crack leave %.0f %% of the capacity"):format(100*units.peak_force/joints.peak_force))
end
