-- Water in joints during stages of motion: a plate that settles on its film, a plate on a stiff joint, ledger, volume,
-- bits, and where pressures are held.
local trilith = require "trilith"
local weight = 1000*9.80665
local function near(a, b, share) assert(math.abs(a - b) <= share*math.abs(b), a .. " is not " .. b) end

-- A plate of 2 m on a joint full of water that is open at both ends.
local function plate(o)
  local m = trilith.model { name = "plate", threads = o.threads }
  m:material { name = "concrete", density = 2400, E = 2e10, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = o.kn, ks = o.kn, mu = 0.6 } }
  m:block { name = "rock", width = 6, height = 1, at = { -2, -1 }, material = "concrete", support = "fixed" }
  m:block { name = "plate", width = 2, height = 0.5, at = { 0, 0 }, material = "concrete", floating = true,
    body = o.body }
  m:seepage { name = "film", upper = "plate", lower = "rock", aperture = o.aperture, divisions = o.divisions or 32,
    from = "left", to = "right", bulk_modulus = o.bulk_modulus }
  m:seepage_head { node = "left", head = 0 }
  m:seepage_head { node = "right", head = 0 }
  if o.flows ~= nil then m:seepage_motion { flows = o.flows } end
  return m
end

-- Without contact the film alone carries the plate. Stefan (1874), Reynolds (1886):
-- 1/a^2 - 1/a0^2 = 2 p t/(viscosity L^2), with the pressure p of the weight.
for _, body in ipairs { "rigid", { mesh = { 4, 1 } } } do
  local a0, p = 3e-4, 2400*0.5*9.80665
  local m = plate { kn = 1e3, aperture = a0, flows = true, bulk_modulus = 2.2e7, body = body }
  local before = m:seepage_state().volume
  for _, t in ipairs { 0.1, 0.3, 0.6 } do
    m:run { to = t }
    near(a0 + m:body("plate").uy, 1/math.sqrt(1/a0^2 + 2*p*t/(1e-3*2^2)), 0.005)
  end
  local net = m:seepage_state()
  near(net.clock, 0.6, 1e-9)
  near(before - net.volume, -net.nodes.left.supplied - net.nodes.right.supplied, 1e-9)
  near(net.nodes.left.supplied, net.nodes.right.supplied, 1e-6)
  assert(net.nodes.left.supplied < 0)
  -- The weight does work on the water, and nothing else takes it.
  near(m.energy.water, -2*p*(a0 - (a0 + m:body("plate").uy)), 0.01)
  assert(math.abs(m.residual) < 2e-3*math.abs(m.energy.water), m.residual/m.energy.water)
end

-- On a joint with kn = 2e10 Pa/m a load of 100 kPa closes the film by the equation of the plate and the thin flow.
do
  local kn, load = 2e10, 1e5
  local m = plate { kn = kn, aperture = 2e-4, flows = true, bulk_modulus = 2.2e9, divisions = 50 }
  m:point_load { body = "plate", force = { 0, -(load - 2400*0.5*9.80665)*2 }, name = "load" }
  local begun = m.time
  for t, share in pairs { [0.0125] = 0.38868 } do
    m:run { to = begun + t }
    near(-m:body("plate").uy/(load/kn), share, 0.01)
  end
end

-- The same bits for any number of threads, and for a stage in two parts. Held pressures do not change, and the plate
-- moves otherwise.
local ends = {}
for run = 1, 3 do
  local m = plate { kn = 1e9, aperture = 3e-4, flows = true, bulk_modulus = 2.2e7, threads = run == 2 and 2 or 1 }
  m:run { duration = 0.05 }
  if run == 3 then m:seepage_motion { flows = true } end
  m:run { duration = 0.05 }
  ends[run] = { m.hash, m:seepage_state("film").pressure[7] }
end
assert(ends[1][1] == ends[2][1] and ends[1][2] == ends[3][2])
do
  local m = plate { kn = 1e9, aperture = 3e-4, flows = false }
  m:run { duration = 0.05 }
  local s = m:seepage_state "film"
  assert(m:seepage_state().clock == 0 and s.pressure[7] == 0)
  near(m:seepage_state().volume, 2*3e-4, 1e-12)
end

-- Where they are held, a note says why.
local function said(m, text)
  for _, note in ipairs(m.notes) do if note:find(text, 1, true) then return true end end
  return false
end
local function shaken(o, stage)
  local m = plate(o)
  stage.duration = 0.002
  m:run(stage)
  return m
end
local soft = { kn = 1e9, aperture = 3e-4, bulk_modulus = 2.2e7 }
assert(said(shaken(soft, {}), "m:seepage_motion { flows = true }"))
soft.flows = false
assert(not said(shaken(soft, {}), "held"))
soft.flows = true
assert(not said(shaken(soft, {}), "held"))
assert(said(shaken(soft, { integrator = "implicit", dt = 1e-3 }), "leave out integrator"))
assert(said(shaken(soft, { local_damping = 0.5 }), "leave out local_damping"))
assert(shaken(soft, { integrator = "implicit", dt = 1e-3 }):seepage_state().clock == 0)

-- Fissures have no bodies to move: they flow in implicit steps too, in the plane and in space.
for _, dim in ipairs { 2, 3 } do
  local m = trilith.model { name = "fissure", dim = dim }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.6 } }
  local plane = dim == 2
  m:block(plane and { name = "rock", width = 1, height = 1, at = { 0, 0 }, material = "stone", support = "fixed" }
    or { name = "rock", size = { 1, 1, 1 }, at = { 0, 0, 0 }, material = "stone", support = "fixed" })
  m:block(plane and { name = "stone", width = 1, height = 1, at = { 0, 1 }, material = "stone" }
    or { name = "stone", size = { 1, 1, 1 }, at = { 0, 0, 1 }, material = "stone" })
  m:seepage { name = "fissure", length = 5, aperture = 2e-4, stiffness = 1e10, divisions = 50, from = "open",
    to = "shut" }
  m:seepage_head { node = "open", head = 1000/weight }
  m:seepage_motion {}
  m:run { duration = 0.75068, integrator = "implicit", dt = 2e-3 }
  near(m:seepage_state("fissure").pressure[50], 227.69, 0.01)
end

local m = trilith.model { name = "empty" }
m:material { name = "stone", density = 2400 }
m:block { name = "rock", width = 1, height = 1, at = { 0, 0 }, material = "stone", support = "fixed" }
local ok, message = pcall(m.seepage_motion, m, { flows = true })
assert(not ok and tostring(message):find("there is no joint with seepage", 1, true), tostring(message))
