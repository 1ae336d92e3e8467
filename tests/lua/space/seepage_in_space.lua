-- Seepage between blocks in space: the numbers of the plane for the width of the joint, balance with the bodies,
-- volume, a turned model, bits, and refused joints.
local trilith = require "trilith"
local width = 2.5
local function near(a, b, share) assert(math.abs(a - b) <= share*math.abs(b), a .. " is not " .. b) end
local function fails(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(text, 1, true), tostring(message))
end

local function model(threads, kn)
  local m = trilith.model { name = "seepage", dim = 3, threads = threads }
  m:material { name = "concrete", density = 2400, E = 2e10, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn or 1e11, ks = kn or 1e11, mu = 0.75 } }
  return m
end
local dam_hash
-- A dam of 8 m on rock. `along`: the axis of the flow, "x" or "y".
local function dam(o)
  local m = model(o.threads, o.kn)
  local function size(a, b, c) return o.along == "y" and { b, a, c } or { a, b, c } end
  m:block { name = "rock", size = size(12, 6, 1), at = size(-2, -1, -1), material = "concrete", support = "fixed" }
  m:block { name = "dam", size = size(8, width, 4), at = size(0, 0, 0), material = "concrete", body = o.body }
  return m, size
end
local function steady(m)
  m:process { duration = 1e9, step = 1e9, mechanics = false }
  return m:seepage_state "joint"
end

-- A joint that tapers from 0.6 to 0.2 mm, and the reverse, along x and along y: flow, uplift and its place.
for _, along in ipairs { "x", "y" } do
  for _, way in ipairs { { { 6e-4, 2e-4 }, 529.559e3, 3.2958 }, { { 2e-4, 6e-4 }, 176.520e3, 1.8875 } } do
    local m, size = dam { along = along }
    m:seepage { name = "joint", upper = "dam", lower = "rock", aperture = way[1], from = "lake", to = "toe",
      heel = size(0, width/2, 0) }
    m:seepage_head { node = "lake", head = 9 }
    m:seepage_head { node = "toe", head = 0 }
    local s = steady(m)
    near(s.inflow, 3.30974e-5*width, 0.002)
    near(s.outflow, 3.30974e-5*width, 0.002)
    near(s.force[3], way[2]*width, 0.005)
    near(s.length, 8, 1e-9)
    local arm = along == "x" and -s.moment[2] or s.moment[1]
    near(arm/s.force[3], way[3], 0.005)
  end
end

-- Without a heel the first side is the one with the least x. The dam stands in equilibrium on the water: the contact
-- carries the rest of its weight, and the rock the whole.
for threads = 1, 2 do
  local m = dam { threads = threads }
  m:seepage { name = "joint", upper = "dam", lower = "rock", aperture = 3e-4, divisions = 16, from = "heel", to = "toe",
    filled = false }
  m:seepage_head { node = "heel", head = 5 }
  m:seepage_head { node = "toe", head = 0 }
  local flooded = 0
  m:on("joint.flooded", function(e) flooded = flooded + 1; assert(e.text:find("dam and rock", 1, true), e.text) end)
  m:consolidate { integrator = "static" }
  m:process { duration = 400, step = 10 }
  local s, net = m:seepage_state "joint", m:seepage_state()
  near(net.volume, net.nodes.heel.supplied + net.nodes.toe.supplied, 1e-9)
  near(s.inflow, s.outflow, 2e-3)
  assert(flooded == 1 and s.head[1] > 4.5 and s.head[16] < 0.5)
  local carried = 0
  for _, c in ipairs(m:contacts { between = { "dam", "rock" } }) do carried = carried + c.force[3] end
  near(math.abs(carried) + s.force[3], m:body("dam").mass*9.80665, 1e-5)
  near(m:body("rock").reaction_z, (m:body("dam").mass + m:body("rock").mass)*9.80665, 1e-5)
  if threads == 1 then dam_hash = m.hash else assert(m.hash == dam_hash) end
end

-- A plate that is loaded at once: the plate and the thin flow in one equation, as in the plane.
do
  local kn, load = 2e10, 1e5
  local m = model(1, kn)
  m:material { name = "light", density = 1 }
  m:block { name = "rock", size = { 4, 3, 1 }, at = { -1, -1, -1 }, material = "concrete", support = "fixed" }
  m:block { name = "plate", size = { 2, 1, 0.5 }, at = { 0, 0, 0 }, material = "light" }
  m:seepage { name = "joint", upper = "plate", lower = "rock", aperture = 2e-4, divisions = 30, from = "left",
    to = "right" }
  m:seepage_head { node = "left", head = 0 }
  m:seepage_head { node = "right", head = 0 }
  m:point_load { body = "plate", force = { 0, 0, -2*load }, name = "load" }
  m:process { duration = 0.0125, step = 0.0125/40, tolerance = 1e-7 }
  near(-m:body("plate").uz/(load/kn), 0.38868, 0.015)
end

-- Refused joints.
do
  local m = model()
  m:block { name = "rock", size = { 4, 3, 1 }, at = { 0, 0, -1 }, material = "concrete", support = "fixed" }
  m:block { name = "soft", size = { 1, 1, 1 }, at = { 0, 0, 0 }, material = "concrete", body = { mesh = { 2, 2, 2 } } }
  m:block { name = "far", size = { 1, 1, 1 }, at = { 2, 1, 3 }, material = "concrete", support = "fixed" }
  m:body { name = "wedge", material = "concrete", hull = { { 2, 0, 0 }, { 3, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 },
    { 3, 0, 1 }, { 2, 1, 1 } } }
  local function joint(upper) return { upper = upper, lower = "rock", aperture = 1e-4 } end
  fails("needs rigid ones", m.seepage, m, joint "soft")
  fails("must be one rectangle", m.seepage, m, joint "wedge")
  fails("lie on each other", m.seepage, m, joint "far")
end

-- In stages of motion pressures are held in space, and a note says why.
do
  local m = dam {}
  m:seepage { name = "joint", upper = "dam", lower = "rock", aperture = 3e-4, from = "heel", to = "toe" }
  m:seepage_motion {}
  m:run { duration = 1e-3 }
  local said = false
  for _, note in ipairs(m.notes) do said = said or note:find("in processes alone", 1, true) ~= nil end
  assert(said and m:seepage_state().clock == 0)
end
