-- Missing supports are checked as the first stage begins: supports, loads and readings may come before the bearing or
-- support that fixes a body. Parts added after this are checked at once.
local trilith = require "trilith"

local function model(dim)
  local m = trilith.model { name = "held later", dim = dim }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4 } }
  return m
end
local function block(m, name, at, support)
  if m.dim == 2 then
    return m:block { name = name, width = 1, height = 0.5, at = at, material = "stone", support = support }
  end
  return m:block { name = name, size = { 1, 1, 0.5 }, at = { at[1], 0, at[2] }, material = "stone", support = support }
end
local function spring(m, a, b, from, to)
  local function at(p) return m.dim == 2 and p or { p[1], 0.5, p[2] } end
  m:bearing { name = a .. " on " .. b, between = { b, a }, from = at(from), to = at(to),
              axial = trilith.linear { stiffness = 1e6, damping = 1e4 } }
end
local function refused(f, ...)
  local ok, text = pcall(f, ...)
  assert(not ok and text:find "body 'deck' has no support", text)
end

for _, dim in ipairs { 2, 3 } do
  local up = dim == 2 and "y" or "z"
  local m = model(dim)
  block(m, "base", { 0, -0.5 }, "fixed")
  local deck = block(m, "deck", { 0, 1 })
  m:fix(deck, "r")
  m:point_load { body = deck, force = dim == 2 and { 0, -1000 } or { 0, 0, -1000 }, name = "more" }
  assert(m:lint().text:find "body 'deck' has no support")
  refused(m.run, m, { duration = 0.01 })
  spring(m, "deck", "base", { 0.5, 0 }, { 0.5, 1 })
  assert(not m:lint().text:find "has no support")
  m:consolidate { rest = { ratio = 1e-6 } }
  local sunk, expected = -deck["u" .. up], (deck.mass*9.80665 + 1000)/1e6
  assert(math.abs(sunk/expected - 1) < 1e-4, ("%s m sunk, not %s"):format(sunk, expected))
  local ok, text = pcall(block, m, "late", { 5, 5 })
  assert(not ok and text:find "body 'late' has no support", text)
  m:close()

  -- Fixed by its support alone; a body added to a model that was only read is not checked yet either.
  local n = model(dim)
  local hung = block(n, "deck", { 0, 1 })
  n:fix(hung)
  block(n, "lower", { 0, -2 })
  spring(n, "lower", "deck", { 0.5, 1 }, { 0.5, -1.5 })
  n:run { duration = 0.01 }
  assert(hung["u" .. up] == 0)
  n:close()
end
