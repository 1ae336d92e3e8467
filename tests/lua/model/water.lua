-- Water in the plane and in space: buoyancy, joints, uplift, drag, added mass, ledger, bits, and rejected input.
local trilith = require "trilith"
local g = 9.80665
local w = 1000*g
local function near(a, b, share) assert(math.abs(a - b) <= share*math.abs(b), a .. " is not " .. b) end
local function small(a, most) assert(math.abs(a) <= most, a .. " is not 0") end

local function model(dim, name, threads)
  local m = trilith.model { name = name, dim = dim, threads = threads }
  m:material { name = "stone", density = 2400 }
  m:material { name = "light", density = 600 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = 0.6, beta = 1e-4 } }
  return m
end

-- A block of 1 m by 0.6 m on a bed, 3 m under the surface; in space 1 m wide. `body`: kind of the block.
local function block_on_bed(dim, joints, body, threads)
  local m = model(dim, "block", threads)
  if dim == 2 then
    m:block { name = "bed", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", width = 1, height = 0.6, at = { -0.5, 0 }, material = "stone", body = body }
  else
    m:block { name = "bed", size = { 6, 6, 1 }, at = { -3, -3, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", size = { 1, 1, 0.6 }, at = { -0.5, -0.5, 0 }, material = "stone", body = body }
  end
  m:water { name = "lake", body = "block", level = 3, side = "all", joints = joints }
  return m, m:body "block", m:body "bed"
end
local function pressed(m, bed)
  local sum = 0
  for _, r in ipairs(bed:reactions()) do sum = sum + (m.dim == 3 and r.fz or r.fy) end
  return math.abs(sum) - bed.mass*g
end

for _, dim in ipairs { 2, 3 } do
  local wet, sealed = 0.6*(2400*g - w), 0.6*2400*g + 2.4*w
  for joints, force in pairs { wet = wet, sealed = sealed } do
    local m, block, bed = block_on_bed(dim, joints)
    m:consolidate { integrator = "static" }
    near(pressed(m, bed), force, 1e-3)
    local state = m:water_state "lake"
    local sunk = dim == 2 and block.uy or block.uz
    -- In space the edge of the closed part is known to within the compression of the joint, 4e-6 m.
    near(state.force[dim], joints == "wet" and 0.6*w or -(2.4 - sunk)*w, dim == 2 and 1e-9 or 2e-6)
    -- The closed joint keeps the water out in explicit and implicit steps too.
    local hash
    for _, threads in ipairs { 1, 3 } do
      local n = block_on_bed(dim, joints, nil, threads)
      n:run { duration = 0.02 }
      hash = hash or n.hash
      assert(n.hash == hash)
    end
  end
end

-- A block of elements, in the plane.
do
  local m = trilith.model { name = "mesh" }
  m:material { name = "stone", density = 2400, solid = trilith.linear_elastic { E = 3e10, nu = 0.2 } }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = 0.6, beta = 1e-4 } }
  m:block { name = "bed", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
  m:block { name = "block", width = 1, height = 0.6, at = { -0.5, 0 }, material = "stone", body = { mesh = { 4, 3 } } }
  m:water { name = "lake", body = "block", level = 3, side = "all" }
  m:consolidate { integrator = "static" }
  near(pressed(m, m:body "bed"), 0.6*2400*g + 2.4*w, 1e-3)
  near(m:water_state "lake".force[2], -2.4*w, 1e-4)
end

-- A box floats at its draught in space, and a ball of water in the ledger closes: heave without loss.
for _, integrator in ipairs { "explicit", "implicit" } do
  for _, dim in ipairs { 2, 3 } do
    local m = model(dim, "float")
    local box = dim == 2
      and m:block { name = "box", width = 1, height = 0.5, at = { -0.5, -0.35 }, material = "light", floating = true }
      or m:block { name = "box", size = { 1, 1, 0.5 }, at = { -0.5, -0.5, -0.35 }, material = "light", floating = true }
    m:water { name = "lake", body = box, level = 0, side = "all" }
    local low, high = math.huge, -math.huge
    local dt = integrator == "implicit" and 1e-3 or nil
    m:run { duration = 1.1, dt = dt, integrator = integrator, until_true = function()
      local u = dim == 2 and box.uy or box.uz
      low, high = math.min(low, u), math.max(high, u)
      return false
    end }
    assert(low > -1e-9 and low < 1e-5)
    near(high, 0.1, 5e-3) -- from 0.05 m too deep to 0.05 m too high
    assert(m.energy.water ~= 0)
    small(m.residual, 1e-9*box.mass*g*0.1 + 2e-5*math.abs(m.energy.water))
    small(m.energy.load, 1e-9*math.abs(m.energy.water))
  end
end

-- A gravity dam in space has the uplift and the crack of the plane, per metre.
local function dam(dim, level, width)
  local m = trilith.model { name = "dam", dim = dim }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e11, mu = 10, beta = 1e-4 } }
  local outline = { { 0, 0 }, { 8, 0 }, { 2, 12 }, { 0, 12 } }
  if dim == 2 then
    m:block { name = "rock", width = 40, height = 2, at = { -16, -2 }, material = "concrete", support = "fixed" }
    m:polygon { name = "dam", outline = outline, material = "concrete" }
  else
    m:block { name = "rock", size = { 40, 10, 2 }, at = { -16, -4, -2 }, material = "concrete", support = "fixed" }
    m:hull { name = "dam", material = "concrete", points = {
      { 0, 0, 0 }, { 8, 0, 0 }, { 2, 0, 12 }, { 0, 0, 12 }, { 0, width, 0 }, { 8, width, 0 },
      { 2, width, 12 }, { 0, width, 12 } } }
  end
  m:water { name = "lake", body = "dam", level = level, side = "left" }
  m:uplift { name = "uplift", upper = "dam", lower = "rock", upstream = "lake" }
  return m
end
local flooded
for _, dim in ipairs { 2, 3 } do
  local width = dim == 3 and 2 or 1
  local m = dam(dim, 11, width)
  m:consolidate { integrator = "static" }
  local state = m:water_state "uplift"
  small(state.crack, 0.05)
  near(state.force[dim], w*11/2*8*width, 5e-3)
  near(m:water_state "lake".force[1], w*11^2/2*width, 1e-6)
  m:set_level { name = "lake", level = 11.7 }
  m:on("joint.flooded", function(e) flooded = e.value end)
  m:consolidate { integrator = "static" }
  small(m:water_state "uplift".crack - 1.6033, 0.08)
  assert(flooded and flooded > 0.08)
  flooded = nil
  m:set_level { name = "lake", level = 10 }
  m:consolidate { integrator = "static" }
  small(m:water_state "uplift".crack, 1e-5)
end

-- Explicit and implicit steps find the crack of statics; level and uplift change smoothly, and the ledger closes.
do
  local m = dam(2, 10)
  m:consolidate { integrator = "static" }
  m:set_level { name = "lake", level = 11.7, duration = 1 }
  m:run { duration = 1.2, local_damping = 0.5, rest = { ratio = 1e-6, from = 1.1 } }
  small(m:water_state "uplift".crack - 1.6033, 0.16)
  near(m:water_state "lake".level, 11.7, 1e-12)
end

-- Drag accelerates a body towards the velocity of the flow, and its work becomes kinetic energy.
for _, dim in ipairs { 2, 3 } do
  local m = model(dim, "drag")
  local box = dim == 2
    and m:block { name = "box", width = 1, height = 0.5, at = { 0, -0.3 }, material = "light", floating = true }
    or m:block { name = "box", size = { 1, 1, 0.5 }, at = { 0, 0, -0.3 }, material = "light", floating = true }
  m:water { body = box, level = 0, side = "all" }
  m:drag { body = box, velocity = dim == 2 and { 2, 0 } or { 2, 0, 0 }, coefficient = 1.2, area = 0.3 }
  m:run { duration = 2 }
  -- dv/dt = k (2 - v)^2, k = c rho A/(2 m): v = 2 - 2/(1 + 2 k t)
  local k = 1.2*1000*0.3/2/box.mass
  near(box.vx, 2 - 2/(1 + 2*k*2), 2e-3)
  small(m.residual, 1e-6*m.energy.kinetic)
end

-- Added mass in a free vibration, by explicit and implicit steps: the ledger closes, and damping acts on it.
for _, integrator in ipairs { "explicit", "implicit" } do
  local m = model(2, "mass")
  m:block { name = "support", width = 1, height = 1, at = { 4, 0 }, material = "stone", support = "fixed" }
  m:block { name = "wall", width = 2, height = 12, at = { 0, 0 }, mass = 80e3, material = "stone",
    support = { y = "fixed", rotation = "fixed" }, floating = true, velocity = { 0.1, 0 } }
  m:bearing { name = "spring", between = { "support", "wall" }, from = { 4, 0.5 }, to = { 2, 0.5 },
    along = trilith.linear { stiffness = 2e8 } }
  m:added_mass { body = "wall", side = "left", level = 9, bed = 0 }
  m:run { duration = 0.3, dt = 2e-4, integrator = integrator }
  local all = 0.5*(80e3 + 0.542755*81e3)*0.01
  near(m.energy.kinetic + m.energy.bearing_elastic, all, 1e-3)
  small(m.residual, 1e-6*all)
end

-- Rejected input.
local function refused(text, f, ...)
  local good, why = pcall(f, ...)
  assert(not good, "accepted: " .. text)
  assert(tostring(why):find(text, 1, true), tostring(why))
end
local m, block = block_on_bed(2, "sealed")
refused("a level needs the side", m.water, m, { body = block, level = 3 })
refused("'level' is missing", m.water, m, { body = block, side = "left" })
refused("'side' is 'west', must be one of all, left", m.water, m, { body = block, level = 1, side = "west" })
refused("density", m.water, m, { body = block, level = 1, side = "left", density = 0 })
refused("there is water of that name already", m.water, m, { name = "lake", body = block, level = 1, side = "left" })
refused("there is no water 'sea'", m.set_level, m, { name = "sea", level = 1 })
refused("has a level and no share; use m:set_level", m.set_load, m, { name = "lake", factor = 2 })
refused("upstream is 'sea'", m.uplift, m, { upper = "block", lower = "bed", upstream = "sea" })
refused("are the same body", m.uplift, m, { upper = "block", lower = "block", upstream = "lake" })
refused("the drain is 5 m from the heel", m.uplift, m, { upper = "block", lower = "bed", upstream = "lake",
  heel = { -0.5, 0 },
  drain = { at = 5, efficiency = 0.5 } })
refused("coefficient", m.drag, m, { body = block, velocity = { 1, 0 }, coefficient = 0, area = 1 })
refused("the level must be above the bed", m.added_mass, m, { body = block, side = "left", level = 0, bed = 1 })
refused("has no upright face on that side", m.added_mass, m, { body = block, side = "left", level = 5, bed = 0 })
refused("there is no water or uplift 'sea'", m.water_state, m, "sea")
local dry = trilith.model { name = "dry", gravity = 0 }
dry:material { name = "stone", density = 2400 }
dry:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = 0.6 } }
local alone = dry:block { name = "block", width = 1, height = 1, at = { 0, 0 }, material = "stone", floating = true }
refused("the model has no gravity downwards", dry.water, dry, { body = alone, level = 1, side = "all" })
m:remove "lake"
refused("there is no water or uplift 'lake'", m.water_state, m, "lake")
