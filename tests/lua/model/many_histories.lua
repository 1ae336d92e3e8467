-- Four thousand histories and two hundred laws in one model: each history has all samples, and each name is found.
local trilith = require "trilith"

local m = trilith.model {}
m:material { name = "stone", density = 2400 }
for i = 1, 200 do
  m:contact { between = { "block " .. i, "floor" }, name = "law " .. i,
    law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-4 } }
  m:block { name = "block " .. i, width = 1, height = 1, at = { 2*i, 0 }, material = "stone" }
end
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-4 } }
m:block { name = "floor", width = 410, height = 1, at = { 0, -1 }, material = "stone", support = "fixed" }

local histories = {}
for i = 1, 4000 do
  histories[i] = m:history { name = "history " .. i, body = "block " .. ((i - 1)%200 + 1),
    what = i%2 == 0 and "x" or "y", every = 0.01 }
end
m:run { duration = 0.1 }
assert(m.verdict.sound)

for i, h in ipairs(histories) do
  assert(#h.values == 11, #h.values)
  local place = 2*((i - 1)%200 + 1) + 0.5
  local expected = i%2 == 0 and place or 0.5
  assert(math.abs(h.values[11] - expected) < 1e-3, ("%s: %g for %g"):format(h.name, h.values[11], expected))
end
