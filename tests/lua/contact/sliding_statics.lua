-- Equilibrium by statics with friction that slides under the growing load and sticks at its limit at the end.
local trilith = require "trilith"

-- A block of 20 kN is pushed at its foot and held by a spring: at rest the spring carries the push minus mu times the
-- weight, for any number of load increments.
local function spring_at_rest(dim, push, shares, turn)
  local m = trilith.model { name = "slide", dim = dim, gravity = 10 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5, beta = 1e-4 } }
  local c, s = math.cos(turn), math.sin(turn)
  if dim == 3 then
    local about = { axis = { 0, 0, 1 }, angle = turn }
    m:block { name = "ground", size = { 20, 20, 1 }, at = { 0, 0, -0.5 }, anchor = "centre", material = "stone",
      support = "fixed", turn = about }
    m:block { name = "b", size = { 1, 1, 1 }, at = { 0, 0, 0.5 }, anchor = "centre", material = "stone", turn = about }
    m:bearing { name = "k", between = { "ground", "b" }, from = { 0, 0, 0.1 }, to = { 0, 0, 0.1 }, angle = turn,
      along = trilith.linear { stiffness = 1e6 } }
    m:point_load { body = "b", at = { 0, 0, 0.1 }, force = { push*c, push*s, 0 } }
  else
    m:block { name = "ground", width = 20, height = 1, at = { -10, -1 }, material = "stone", support = "fixed" }
    m:block { name = "b", width = 1, height = 1, at = { -0.5, 0 }, material = "stone" }
    m:bearing { name = "k", between = { "ground", "b" }, from = { 0, 0.1 }, to = { 0, 0.1 },
      along = trilith.linear { stiffness = 1e6 } }
    m:point_load { body = "b", at = { 0, 0.1 }, force = { push, 0 } }
  end
  m:consolidate { integrator = "static", shares = shares }
  local force = m.bearings.k.force_along
  m:close()
  return force
end
for _, case in ipairs { { 3, 10100, 1, 0 }, { 3, 10100, 1, 0.3 }, { 3, 11000, 1, 0.7 }, { 3, 30000, 1, 0.3 },
  { 3, 30000, 10, 0.3 }, { 3, 30000, 50, 0.3 }, { 2, 10100, 1, 0 }, { 2, 10100, 7, 0 }, { 2, 30000, 10, 0 } } do
  local dim, push, shares, turn = table.unpack(case)
  local force = math.abs(spring_at_rest(dim, push, shares, turn))
  assert(math.abs(force - (push - 10000)) < 1e-4*10000, ("%g N in %d shares: %g N"):format(push, shares, force))
end

-- Dry free-standing stones lean on each other and slide before they rest; they do not move in a following dynamic
-- stage.
do
  local m = trilith.model { dim = 3, name = "rubble" }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  m:block { name = "floor", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
  m:rubble { name = "r", low = { -0.5, -0.5, 0 }, high = { 0.5, 0.5, 1 }, stones = 12, seed = 1, material = "stone" }
  assert(m:consolidate { integrator = "static" }.steps < 300)
  m:run { duration = 0.02 }
  assert(m.speed < 1e-5, m.speed)
  m:close()
end

-- A failed search leaves the model unchanged, and a continued run is sound.
do
  local m = trilith.model { name = "pushed off", dim = 3 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  m:block { name = "ground", size = { 8, 8, 1 }, at = { -4, -4, -1 }, material = "stone", support = "fixed" }
  m:block { name = "b", size = { 1, 1, 1 }, at = { 0, 0, 0 }, material = "stone" }
  m:point_load { name = "P", body = "b", force = { 2e4, 0, 0 } }
  local ok, why = pcall(m.consolidate, m, { integrator = "static" })
  assert(not ok and tostring(why):find("did not come to rest", 1, true), why)
  m:remove "P"
  m:consolidate { integrator = "static" }
  assert(m.verdict.sound, m.verdict.text)
  m:close()
end
