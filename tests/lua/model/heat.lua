-- Heat in the plane and in space: exchange of rigid bodies, joints, frames, conservation, bits, ledger, rejected input.
local trilith = require "trilith"
local function near(a, b, share) assert(math.abs(a - b) <= share*math.abs(b), a .. " is not " .. b) end

local function model(dim, threads)
  local m = trilith.model { name = "heat", dim = dim, threads = threads }
  m:material { name = "stone", density = 2400, E = 2e10 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = 0.6, beta = 1e-4 } }
  return m
end
-- A cube of 1 m on a fixed one; `gap`: between them.
local function pair(dim, body, gap, threads)
  local m = model(dim, threads)
  local function cube(name, z, keys)
    local t = { name = name, material = "stone" }
    if dim == 2 then
      t.width, t.height, t.at = 1, 1, { 0, z }
    else
      t.size, t.at = { 1, 1, 1 }, { 0, 0, z }
    end
    for k, v in pairs(keys) do t[k] = v end
    return m:block(t)
  end
  cube("ground", -1, { support = "fixed" })
  cube("block", gap or 0, { body = body, floating = true })
  m:heat { body = "ground", conductivity = 2, heat_capacity = 900, temperature = 10 }
  m:heat { body = "block", conductivity = 2, heat_capacity = 900, temperature = 30 }
  m:heat_contact { conductance = 50 }
  return m
end

-- Two rigid bodies: the difference decays by exp(-t h A (1/C + 1/C)); an open joint carries nothing.
for _, dim in ipairs { 2, 3 } do
  local capacity, hour = 2400*900, 3600
  local m = pair(dim)
  local content = m:heat_state().content
  m:process { duration = 10*hour, step = 0.1*hour, mechanics = false }
  near(m:temperature "block" - m:temperature "ground", 20*trilith.math.exp(-10*hour*50*2/capacity), 1e-4)
  near(m:heat_state().content, content, 1e-13)
  assert(m:heat_state().clock > 10*hour - 1e-6)
  local open = pair(dim, nil, 0.001)
  open:process { duration = 10*hour, step = hour, mechanics = false }
  assert(open:temperature "block" == 30 and open:temperature "ground" == 10)
  -- The block expands or not, rests on the other, and the same bits follow for any number of threads, and for a
  -- process in two parts.
  local kind = dim == 2 and { mesh = { 3, 2 } } or { mesh = { 3, 2, 2 } }
  local texts = {}
  for run = 1, 3 do
    local n = pair(dim, kind, 0, run)
    n:consolidate { integrator = "static" }
    for _ = 1, run == 3 and 2 or 1 do
      n:process { duration = run == 3 and hour or 2*hour, step = hour/2 }
    end
    texts[run] = { run < 3 and n.hash, n:temperature "block", n:temperature "ground" }
  end
  assert(texts[1][1] == texts[2][1])
  for k = 2, 3 do assert(texts[1][k] == texts[2][k] and texts[1][k] == texts[3][k]) end
end

-- A mesh on a rigid base, warmed from above: it stays in equilibrium, the ledger closes, and motion holds temperatures.
for _, dim in ipairs { 2, 3 } do
  local m = model(dim)
  local plane = dim == 2
  m:block(plane and { name = "base", width = 4, height = 1, at = { -1, -1 }, material = "stone", support = "fixed" }
    or { name = "base", size = { 4, 4, 1 }, at = { -1, -1, -1 }, material = "stone", support = "fixed" })
  local slab = m:block(plane
    and { name = "slab", width = 2, height = 0.4, at = { 0, 0 }, material = "stone", body = { mesh = { 6, 2 } } }
    or { name = "slab", size = { 2, 1, 0.4 }, at = { 0, 0, 0 }, material = "stone", body = { mesh = { 4, 2, 2 } } })
  m:heat { body = slab, conductivity = 2, heat_capacity = 900, expansion = 1e-5, temperature = 5 }
  local name = m:heat_exchange { body = slab, side = "top", exchange = 20,
    temperature = { { 0, 5 }, { 6*3600, 25 }, period = 24*3600 } }
  m:consolidate { integrator = "static" }
  local content = m:heat_state().content
  m:process { duration = 6*3600, step = 1800 }
  local state = m:heat_state()
  near(state.surroundings[name].supplied, state.content - content, 1e-10)
  assert(m:temperature(slab, plane and { 1, 0.4 } or { 1, 0.5, 0.4 }) > m:temperature(slab))
  assert(m.energy.heat > 0 and m.energy.strain > 0)
  assert(math.abs(m.energy.residual) < 1e-6*m.energy.heat, m.energy.residual/m.energy.heat)
  local warm = m:temperature(slab)
  m:run { duration = 0.005 }
  assert(m:temperature(slab) == warm)
end

-- A cantilever in the plane and in space: it stretches, and bends away from its warmer face.
for _, dim in ipairs { 2, 3 } do
  local m = trilith.model { name = "cantilever", dim = dim, gravity = 0 }
  m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
  local from, to = dim == 2 and { 0, 0 } or { 0, 0, 0 }, dim == 2 and { 4, 0 } or { 4, 0, 0 }
  local beam = m:beam { name = "beam", from = from, to = to, material = "steel", from_support = "fixed",
    floating = true, section = trilith.rectangle_section { width = 0.1, depth = 0.2 }, divisions = 8 }
  m:heat { body = beam, conductivity = 50, heat_capacity = 450, expansion = 1.2e-5, depth = 0.2 }
  m:set_temperature { body = beam, temperature = 20, gradient = 100 }
  m:consolidate { integrator = "static" }
  local place = { beam:point(to) }
  local curvature = 1.2e-5*100
  near(place[1] - 4, 4*1.2e-5*20 - curvature^2*4^3/6, 1e-2) -- stretch less the shortening by bending
  near(place[dim], -1.2e-5*100*4^2/2, 1e-3)
  local mean, difference = m:temperature(beam)
  near(mean, 20, 1e-12)
  near(difference, 20, 1e-12)
end

-- Rejected input.
local function fails(text, f, ...)
  local good, said = pcall(f, ...)
  assert(not good and tostring(said):find(text, 1, true), tostring(said))
end
local m = pair(2)
fails("its shape cannot change", m.heat, m, { body = "block", conductivity = 2, heat_capacity = 900, expansion = 1e-5 })
fails("thermal properties already", m.heat, m, { body = "block", conductivity = 2, heat_capacity = 900 })
fails("must be finite and above 0", m.process, m, { duration = 0, step = 1 })
fails("give a longer step", m.process, m, { duration = 1e9, step = 1e-3 })
fails("give side", m.heat_exchange, m, { body = "block", temperature = 5 })
fails("must be {time, value}", m.heat_exchange, m, { body = "block", side = "top", temperature = { 1, 2 } })
fails("must be later", m.heat_exchange, m, { body = "block", side = "top", temperature = { { 1, 2 }, { 1, 3 } } })
fails("must be longer", m.heat_exchange, m,
  { body = "block", side = "top", temperature = { { 0, 2 }, { 10, 3 }, period = 5 } })
fails("has one temperature", m.set_temperature, m, { body = "block", temperature = 5, gradient = 2 })
fails("must not be below 0", m.heat_contact, m, { conductance = -1 })
local bare = model(2)
bare:block { name = "block", width = 1, height = 1, at = { 0, 0 }, material = "stone", support = "fixed" }
fails("declare m:heat or m:seepage first", bare.process, bare, { duration = 1, step = 1 })
fails("declare m:heat first", bare.heat_contact, bare, { conductance = 1 })
fails("declare m:heat first", bare.temperature, bare, "block")
