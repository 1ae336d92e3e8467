-- Heat of friction: the energy that contacts dissipate, half in either body, in the plane and in space, in explicit and
-- implicit steps, in rigid and deformable bodies, and in processes.
local trilith = require "trilith"
local function near(a, b, share) assert(math.abs(a - b) <= share*math.abs(b), a .. " is not " .. b) end

local capacity = 900
-- A block that slides at 2 m/s on a fixed one.
local function sliding(dim, o)
  local m = trilith.model { name = "friction", dim = dim, threads = o.threads }
  m:material { name = "stone", density = 2400, E = 2e10, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.5, beta = 1e-4 } }
  local plane = dim == 2
  m:block(plane and { name = "base", width = 6, height = 0.5, at = { -1, -0.5 }, material = "stone", support = "fixed" }
    or { name = "base", size = { 6, 2, 0.5 }, at = { -1, -1, -0.5 }, material = "stone", support = "fixed" })
  m:block(plane and { name = "block", width = 0.5, height = 0.25, at = { 0, 0 }, material = "stone", body = o.body,
      velocity = { 2, 0 } }
    or { name = "block", size = { 0.5, 0.5, 0.25 }, at = { 0, -0.25, 0 }, material = "stone", body = o.body,
      velocity = { 2, 0, 0 } })
  m:heat { body = "block", conductivity = 2, heat_capacity = capacity, temperature = 10, expansion = o.expansion }
  if not o.one_sided then m:heat { body = "base", conductivity = 2, heat_capacity = capacity, temperature = 10 } end
  m:heat_contact { conductance = 0, friction = o.friction }
  return m
end

for _, dim in ipairs { 2, 3 } do
  for _, integrator in ipairs { "explicit", "implicit" } do
    local m = sliding(dim, { friction = true })
    local before = m:heat_state().content
    m:run { duration = 0.5, integrator = integrator, dt = integrator == "implicit" and 2e-3 or nil }
    m:run { duration = 0.01 } -- commits the last step of the first stage
    local state, mass = m:heat_state(), m:body("block").mass
    near(m.energy.contact_friction, 0.5*mass*2^2, 0.02) -- it stops after 0.41 s
    near(state.friction, m.energy.contact_friction, 1e-6)
    near(state.content - before, state.friction, 1e-6)
    near(m:temperature "block" - 10, 0.5*state.friction/(capacity*mass), 1e-6)
    near(m:temperature "base" - 10, 0.5*state.friction/(capacity*m:body("base").mass), 1e-6)
    assert(state.surroundings["friction of contacts"] == nil)
  end
end

-- Without the key nothing is heated; with one body the heat is all its own.
do
  local m = sliding(2, {})
  m:run { duration = 0.3 }
  assert(m:temperature "block" == 10 and m:heat_state().friction == nil and m.energy.contact_friction > 0)
  m = sliding(2, { friction = true, one_sided = true })
  m:run { duration = 0.5 }
  near(m:temperature "block" - 10, m:heat_state().friction/(capacity*m:body("block").mass), 1e-9)
end

-- A mesh that expands: its lower nodes are heated, the elastic energy is booked, and the ledger closes.
for _, dim in ipairs { 2, 3 } do
  local body = dim == 2 and { mesh = { 4, 2 } } or { mesh = { 3, 2, 2 } }
  local ends = {}
  for threads = 1, 2 do
    local m = sliding(dim, { friction = true, body = body, expansion = 1e-5, threads = threads })
    local before = m:heat_state().content
    m:run { duration = 0.05 }
    local low, high = dim == 2 and { 0.25, 0 } or { 0.25, 0, 0 }, dim == 2 and { 0.25, 0.25 } or { 0.25, 0, 0.25 }
    assert(m:temperature("block", low) > m:temperature("block", high))
    near(m:heat_state().content - before, m:heat_state().friction, 1e-6)
    assert(m.energy.contact_friction > 0 and math.abs(m.residual) < 1e-3*m.energy.contact_friction, m.residual)
    ends[threads] = m.hash
  end
  assert(ends[1] == ends[2])
end

-- In a process: a plate on a slope that is heated and cooled creeps, and its friction heats it.
do
  local m = trilith.model { name = "process" }
  m:material { name = "stone", density = 2400, E = 3e9, nu = 0 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e11, mu = 0.6 } }
  m:block { name = "base", width = 6, height = 1, at = { -1, -1 }, material = "stone", support = "fixed" }
  m:block { name = "plate", width = 4, height = 0.1, at = { 0, 0 }, material = "stone", body = { mesh = { 16, 1 } } }
  m:heat { body = "plate", conductivity = 2, heat_capacity = capacity, expansion = 1e-5 }
  m:heat_contact { conductance = 0, friction = true }
  m:heat_exchange { name = "air", body = "plate", side = "top", exchange = 20,
    temperature = { { 0, 0 }, { 86400, 40 } } }
  m:consolidate { integrator = "static" }
  local content, dissipated = m:heat_state().content, m.energy.contact_friction
  m:process { duration = 86400, step = 7200 }
  local state = m:heat_state()
  assert(state.friction > 0)
  near(state.friction, m.energy.contact_friction - dissipated, 1e-6)
  near(state.content - content, state.friction + state.surroundings.air.supplied, 1e-9)
end

local m = sliding(2, {})
m:heat_exchange { name = "friction of contacts", body = "block", side = "top", temperature = 5 }
local ok, said = pcall(m.heat_contact, m, { conductance = 0, friction = true })
assert(not ok and tostring(said):find("choose another name", 1, true), tostring(said))
