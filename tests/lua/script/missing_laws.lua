-- Two bodies that may touch but have no m:contact statement would pass through each other. This is an error before the
-- stage, which names both and the missing statement; law = "none" marks it as intended.
local trilith = require "trilith"

local function law() return trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 2e-4 } end

local function block(m, name, material, x, z, options)
  local b = options or {}
  b.name, b.material = name, material
  if m.dim == 2 then b.width, b.height, b.at = 0.5, 0.5, { x, z }
  else b.size, b.at = { 0.5, 0.5, 0.5 }, { x, 0, z } end
  return m:block(b)
end

local function model(dim, contacts)
  local m = trilith.model { name = "pairs", dim = dim }
  m:material { name = "stone", density = 2400, E = 1e9, nu = 0.2 }
  m:material { name = "brick", density = 1800, E = 1e9, nu = 0.2 }
  for _, c in ipairs(contacts) do m:contact { between = { c[1], c[2] }, law = c[3] or law() } end
  return m
end

local function has(text, words) return text:find(words, 1, true) ~= nil end

--- The next stage is rejected; its message and the list of m:lint() contain these words.
local function refused(m, ...)
  local said = tostring(m:lint())
  local ok, message = pcall(m.run, m, { duration = 0.01 })
  assert(not ok, "a pair without a law is let through")
  for _, words in ipairs { ... } do
    assert(has(tostring(message), words), tostring(message))
    assert(has(said, words) or not has(words, "'"), said)
  end
  assert(has(message, 'law = "none"'), message)
  m:close()
end
local function runs(m)
  assert(m:run { duration = 0.01 }.ending == "time")
  m:close()
end

for _, dim in ipairs { 2, 3 } do
  local held = { support = "fixed" }
  local function ground(m, material) return block(m, "ground", material, 0, -0.5, { support = "fixed" }) end

  -- a brick that falls on stone
  local m = model(dim, { { "stone", "stone" }, { "brick", "brick" } })
  ground(m, "stone")
  block(m, "b", "brick", 0, 0.1, { floating = true })
  refused(m, "'b' (brick)", "'ground' (stone)", 'm:contact { between = { "brick", "stone" }')

  -- bricks of one material that hit each other
  m = model(dim, { { "stone", "stone" }, { "brick", "stone" } })
  ground(m, "stone")
  block(m, "a", "brick", 0, 0, { floating = true })
  block(m, "b", "brick", 2, 0, { floating = true })
  refused(m, "'a' (brick)", "'b' (brick)", '{ "brick", "brick" }')

  -- laws for some groups only
  m = model(dim, { { "walls", "floors" } })
  block(m, "floor", "stone", 0, -0.5, { support = "fixed", groups = { "floors" } })
  block(m, "wall", "stone", 0, 0, { groups = { "walls" }, floating = true })
  block(m, "other", "stone", 2, 0, { groups = { "walls" }, floating = true })
  refused(m, "'other' (stone)", "'wall' (stone)", "before the calls for groups")

  -- no law at all; of elements; a sphere
  m = model(dim, {})
  ground(m, "stone")
  block(m, "q", "brick", 0, 0, { body = { mesh = dim == 2 and { 1, 1 } or { 1, 1, 1 } }, floating = true })
  if dim == 3 then m:sphere { name = "s", radius = 0.1, at = { 2, 0, 2 }, material = "brick", floating = true } end
  refused(m, "no contact law", "'q' (brick)")

  -- all pairs are in one message
  m = model(dim, { { "stone", "stone", "none" } })
  ground(m, "stone")
  block(m, "c", "stone", 4, 0, { floating = true })
  block(m, "a", "brick", 0, 0, { floating = true })
  block(m, "b", "brick", 2, 0, { floating = true })
  refused(m, '{ "brick", "stone" }', '{ "brick", "brick" }')

  -- intended
  m = model(dim, { { "*", "*", "none" } })
  ground(m, "stone")
  block(m, "b", "brick", 0, 0.1, { floating = true })
  runs(m)
  m = model(dim, { { "brick", "stone" }, { "brick", "brick", "none" } })
  ground(m, "stone")
  block(m, "a", "brick", 0, 0, { floating = true })
  block(m, "b", "brick", 2, 0, { floating = true })
  runs(m)

  -- two fixed bodies need none, nor does a single body
  m = model(dim, { { "brick", "stone" } })
  ground(m, "stone")
  block(m, "other", "stone", 2, 0, held)
  block(m, "b", "brick", 0, 0, { floating = true })
  runs(m)
  m = model(dim, {})
  block(m, "b", "brick", 0, 0, { floating = true })
  runs(m)

  -- added between stages: rejected as the next one begins, unless declared before
  for _, declared in ipairs { false, true } do
    m = model(dim, { { "stone", "brick" } })
    ground(m, "stone")
    block(m, "a", "brick", 0, 0, { floating = true })
    m:run { duration = 0.01 }
    block(m, "late", "brick", 2, 0, { floating = true })
    if declared then
      m:contact { between = { "brick", "brick" }, law = law() }
      runs(m)
    else
      refused(m, "'a' (brick)", "'late' (brick)")
    end
  end
end
