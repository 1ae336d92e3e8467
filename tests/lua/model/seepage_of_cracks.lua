-- Water in joints whose bodies crack: the joint goes on, the crack is a new joint without water, and steady flows
-- before and after follow from the apertures in series and in parallel.
local trilith = require "trilith"
local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.15g is not %.15g"):format(what or "", a, b))
end

local strength, w, mu = 2e4, 9806.65, 1e-3
-- t.body: of the dam; t.role: that the dam has at the joint.
local function dam(t)
  local m = trilith.model { name = "water in cracks", threads = t.threads }
  m:material { name = "stone", density = 2400, E = 3e10, nu = 0 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e13, ks = 5e12, mu = 0.7, beta = 1e-6 } }
  local bond = { kn = 1e13, ks = 5e12, mu = 0.7, tension = strength, cohesion = 2*strength, beta = 1e-6 }
  if t.body then bond.energy_tension, bond.energy_shear = 0.2, 0.8 end
  m:contact { between = { "dam", "dam" }, name = "plane",
    law = t.body and trilith.cohesive(bond) or trilith.bonded(bond) }
  m:block { name = "rock", width = 8, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
  m:block { name = "dam", width = 4, height = 2, at = { 0, 0 }, material = "stone", body = t.body,
    cracks = t.cracks ~= false and "mid" or false, crack_law = t.cracks ~= false and "plane" or nil }
  m:seepage { name = "joint", upper = t.lower and "rock" or "dam", lower = t.lower and "dam" or "rock",
    aperture = 1e-3, crack_aperture = t.cracks ~= false and 5e-4 or nil, divisions = 16, from = "heel", to = "toe",
    heel = t.lower and { 0, 0 } or nil }
  m:seepage_head { node = "heel", head = 4 }
  m:seepage_head { node = "toe", head = 2.5 }
  return m
end
local function settle(m) m:process { duration = 50, step = 2, mechanics = false } end

-- Flow for a difference of the head of 1 m through the first n cells of a list of apertures, or from cell n on.
local function conductance(apertures, length, from, to)
  local resistance = 0
  for i = from, to do
    resistance = resistance + 12*mu*length/#apertures/(w*apertures[i]^3)
  end
  return 1/resistance
end

local function cracked_dam(t)
  local m = dam(t)
  m:consolidate { integrator = "static" }
  settle(m)
  local joint = m:seepage_state "joint"
  near(joint.inflow, 1.5*conductance(joint.aperture, 4, 1, 16), 1e-3, "flow before")
  near(joint.outflow, joint.inflow, 1e-9, "steady before")
  local volume, cells, text = m:seepage_state().volume, m:seepage_state().cells
  m:on("unit.cracked", function(e) text = e.plane end)
  -- Both ends are pulled apart for a short time.
  for x, sign in pairs { [0] = -1, [4] = 1 } do
    m:point_load { name = "pull " .. x, body = "dam", at = { x, 1 }, force = { sign*3*strength*2, 0 },
      load_curve = { { 0, 0 }, { 2e-3, 1 }, { 2.2e-3, 0 } } }
  end
  m:run { duration = 0.05, safety = 0.2 }
  assert(text == 1, "the dam has cracked")
  near(m:seepage_state().volume, volume, 1e-14, "volume of water")
  assert(m:seepage_state().cells == cells + 8)
  local crack = m:seepage_state "dam crack"
  assert(crack.volume == 0 and #crack.pressure == 8)
  assert(#m:seepage_state("joint").pressure == 16 and math.abs(m:seepage_state("joint").length - 4) < 1e-9)
  m:consolidate { integrator = "static" }
  -- The water flows into the crack and out of it at the crest, 2 m above the joint.
  local total = m:seepage_state().volume
  local function supplied()
    local sum = 0
    for _, node in pairs(m:seepage_state().nodes) do sum = sum + (node.supplied or 0) end
    return sum
  end
  local given = supplied()
  m:process { duration = 1, step = 0.1, mechanics = false }
  near(m:seepage_state().volume - total, supplied() - given, 1e-9, "conservation of volume")
  settle(m)
  joint, crack = m:seepage_state "joint", m:seepage_state "dam crack"
  local k1, k2 = conductance(joint.aperture, 4, 1, 8), conductance(joint.aperture, 4, 9, 16)
  local k3 = conductance(crack.aperture, 2, 1, #crack.aperture)
  local head = (4*k1 + 2.5*k2 + 2*k3)/(k1 + k2 + k3)
  near(joint.inflow, k1*(4 - head), 2e-3, "flow into the heel")
  near(joint.outflow, k2*(head - 2.5), 2e-3, "flow out of the toe")
  near(joint.inflow - joint.outflow, k3*(head - 2), 2e-3, "flow out of the crack")
  for i, a in ipairs(crack.aperture) do assert(a > 4.9e-4, ("%d: %g"):format(i, a)) end
  assert(math.abs(m.residual) < 2e-3*m.energy.load, m.residual/m.energy.load)
  return m.hash, joint.inflow
end
local hash, inflow = cracked_dam { threads = 1 }
for threads = 2, 4 do
  local own, flow = cracked_dam { threads = threads }
  assert(own == hash and flow == inflow, "same bits")
end
cracked_dam { body = { mesh = { 8, 4 } } }
cracked_dam { lower = true }
cracked_dam { lower = true, body = { mesh = { 8, 4 } } }

-- The flow has the same bits with planes that do not crack.
do
  local texts = {}
  for _, cracks in ipairs { true, false } do
    local m = dam { cracks = cracks }
    m:consolidate { integrator = "static" }
    m:process { duration = 20, step = 2 }
    texts[#texts + 1] = m.hash
  end
  assert(texts[1] == texts[2])
end

-- The water of the joint carries the block that lies on it, and its pressure counts in the section of a rigid body: the
-- section of a block on equal reactions is free of forces. Without the water there would be a bending stress of four
-- times the strength.
do
  local m = dam {}
  for _, node in ipairs { "heel", "toe" } do m:seepage_head { node = node, head = 3 } end
  m:process { duration = 20, step = 2 }
  m:run { duration = 0.05 }
  assert(m:body "dam".present, "no crack")
end

-- In space the refusal says what to do.
do
  local m = trilith.model { name = "space", dim = 3 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, name = "plane", law = trilith.bonded { kn = 1e10, ks = 5e9, mu = 0.7,
    tension = strength, cohesion = strength } }
  m:block { name = "rock", size = { 8, 1, 1 }, at = { -2, 0, -1 }, material = "stone", support = "fixed" }
  m:block { name = "dam", size = { 4, 1, 2 }, at = { 0, 0, 0 }, material = "stone", cracks = "mid",
    crack_law = "plane" }
  local ok, why = pcall(m.seepage, m, { upper = "dam", lower = "rock", aperture = 1e-3 })
  assert(not ok and tostring(why):find("'dam' has crack planes, and in space water does not follow a crack"),
    tostring(why))
end
