-- Seepage: conservation, balance with the bodies, events, bits, dry joints, motion, rejected input.
local trilith = require "trilith"
local weight = 1000*9.80665
local function near(a, b, share) assert(math.abs(a - b) <= share*math.abs(b), a .. " is not " .. b) end
local function fails(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(text, 1, true), tostring(message))
end

local function model(threads, kn)
  local m = trilith.model { name = "seepage", threads = threads }
  m:material { name = "concrete", density = 2400, E = 2e10, nu = 0.2 }
  m:contact { between = { "*", "*" },
    law = trilith.frictional { kn = kn or 1e11, ks = kn or 1e11, mu = 0.75, beta = 1e-4 } }
  m:block { name = "rock", width = 20, height = 2, at = { -6, -2 }, material = "concrete", support = "fixed" }
  return m
end
-- A dam with a joint that is dry at first, behind water of 8 m.
local function dam(threads, body, filled)
  local m = model(threads)
  m:block { name = "dam", width = 8, height = 12, at = { 0, 0 }, material = "concrete", body = body }
  m:water { name = "lake", body = "dam", level = 8, side = "left" }
  m:seepage { name = "joint", upper = "dam", lower = "rock", aperture = 3e-4, divisions = 16, from = "heel", to = "toe",
    filled = filled }
  m:seepage_head { node = "heel", water = "lake" }
  m:seepage_head { node = "toe", head = 0 }
  m:consolidate { integrator = "static" }
  return m
end

-- The joint fills, with one event; water is conserved; in the end the head falls along the joint, and the contact
-- carries the rest of the weight.
for _, body in ipairs { "rigid", { mesh = { 4, 3 } } } do
  local m = dam(nil, body, false)
  local flooded = 0
  m:on("joint.flooded", function(e) flooded = flooded + 1; assert(e.text:find("dam and rock", 1, true), e.text) end)
  assert(m:seepage_state("joint").volume == 0)
  m:process { duration = 400, step = 10 }
  local s, net = m:seepage_state "joint", m:seepage_state()
  assert(flooded == 1, flooded)
  near(net.volume, net.nodes.heel.supplied + net.nodes.toe.supplied, 1e-10)
  near(s.inflow, s.outflow, 1e-3)
  near(s.wet_length, 8, 1e-9)
  for i = 2, 16 do assert(s.head[i] < s.head[i - 1] and s.head[i] >= 0) end
  near(s.force[2], 0.5*weight*8*8, 0.2) -- half of the full head; the aperture differs along the joint
  near(m:body("rock").reaction_y - 20*2*2400*9.80665, 12*8*2400*9.80665, 1e-6)
  near(m:body("dam").mass*9.80665, 12*8*2400*9.80665, 1e-9)
  -- The lake is lowered: the joint drains to the toe, and keeps its water below the head.
  m:set_level { name = "lake", level = 1 }
  m:process { duration = 400, step = 10 }
  local after = m:seepage_state "joint"
  assert(after.force[2] < s.force[2]/4, after.force[2])
  near(m:seepage_state().volume, m:seepage_state().nodes.heel.supplied + m:seepage_state().nodes.toe.supplied, 1e-10)
  -- In motion the pressure is held.
  local before = m:seepage_state("joint").pressure[8]
  m:seepage_motion { flows = false }
  m:run { duration = 0.01 }
  assert(m:seepage_state("joint").pressure[8] == before)
  assert(math.abs(m.residual) < 1e-3*math.max(1, math.abs(m.energy.water)))
end

-- The same bits for any number of threads, and for a process in two parts.
local hashes = {}
for run = 1, 3 do
  local m = dam(run, "rigid", false)
  for _ = 1, run == 3 and 2 or 1 do m:process { duration = run == 3 and 20 or 40, step = 5 } end
  local s = m:seepage_state "joint"
  hashes[run] = { run < 3 and m.hash, s.volume, s.pressure[1], s.pressure[9], m:body("dam").uy }
end
assert(hashes[1][1] == hashes[2][1])
for k = 2, 5 do assert(hashes[1][k] == hashes[2][k] and hashes[1][k] == hashes[3][k]) end

-- Heat and seepage in one process, in either order of declaration.
for _, first in ipairs { "heat", "seepage" } do
  local m = model()
  m:block { name = "dam", width = 8, height = 2, at = { 0, 0 }, material = "concrete" }
  local function heat() m:heat { body = "dam", conductivity = 2, heat_capacity = 900, temperature = 12 } end
  if first == "heat" then heat() end
  m:seepage { name = "f", length = 1, aperture = 1e-4, from = "a", to = "b" }
  if first == "seepage" then heat() end
  m:seepage_head { node = "a", head = 1 }
  m:process { duration = 10, step = 5, mechanics = false }
  assert(m:temperature "dam" == 12 and m:heat_state().clock == 10 and m:seepage_state().clock == 10)
  near(m:seepage_state("f").head_to, 1, 1e-6)
end

-- Fissures in space: series of two.
local m3 = trilith.model { name = "space", dim = 3 }
m3:material { name = "stone", density = 2400 }
m3:block { name = "rock", size = { 1, 1, 1 }, at = { 0, 0, 0 }, material = "stone", support = "fixed" }
m3:block { name = "rock2", size = { 1, 1, 1 }, at = { 3, 0, 0 }, material = "stone", support = "fixed" }
m3:seepage { name = "wide", length = 2, width = 2, aperture = 3e-4, from = "a", to = "b", elevation = { 0, 1 } }
m3:seepage { name = "narrow", length = 1, width = 2, aperture = 1.5e-4, from = "b", to = "c", elevation = { 1, 1 } }
fails("lie on each other at the start", m3.seepage, m3, { upper = "rock", lower = "rock2", aperture = 1e-4 })
m3:seepage_head { node = "a", head = 5 }
m3:seepage_head { node = "c", head = 2 }
for _ = 1, 2 do m3:process { duration = 1e6, step = 1e6, mechanics = false } end
near(m3:seepage_state().nodes.a.inflow, 2*6.61949e-6, 1e-3)
near(m3:seepage_state().nodes.b.head, 4.4, 1e-3)

-- Rejected input.
local m = dam()
fails("'aperture' is missing", m.seepage, m, { name = "x", length = 1 })
fails("aperture is 0 m, must be finite and above 0", m.seepage, m, { name = "x", length = 1, aperture = 0 })
fails("give upper and lower, the bodies of a joint, or length", m.seepage, m, { aperture = 1e-4 })
fails("'upper' and 'lower' are the same body", m.seepage, m, { upper = "dam", lower = "dam", aperture = 1e-4 })
fails("divisions is 0", m.seepage, m, { length = 1, aperture = 1e-4, divisions = 0 })
fails("from and to are both 'a'", m.seepage, m, { length = 1, aperture = 1e-4, from = "a", to = "a" })
fails("its end at node 'heel' has the elevation 3 m", m.seepage, m,
  { length = 1, aperture = 1e-4, from = "heel", to = "y", elevation = { 3, 0 } })
fails("there is a joint of that name already", m.seepage, m, { name = "joint", length = 1, aperture = 1e-4 })
fails("there is no node of that name; nodes are heel, toe", m.seepage_head, m, { node = "lake", head = 1 })
fails("there is no water of that name", m.seepage_head, m, { node = "heel", water = "sea" })
fails("give either head", m.seepage_head, m, { node = "heel" })
fails("there is no joint 'joints'", m.seepage_state, m, "joints")
m:process { duration = 1, step = 1 }
fails("declare all joints before the first process", m.seepage, m, { length = 1, aperture = 1e-4 })
local empty = model()
fails("there is no joint with seepage", empty.seepage_state, empty)
fails("no joint has seepage", empty.process, empty, { duration = 1, step = 1 })
