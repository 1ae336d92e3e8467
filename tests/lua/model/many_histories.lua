-- Histories cost little more for each one where there are many: declaring them, a run, and reading their values.
local trilith = require "trilith"

-- CPU time of n histories and a run of eleven samples, by history [s].
local function cost(n)
  local m = trilith.model {}
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-4 } }
  m:block { name = "floor", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
  local b = m:block { name = "b", width = 1, height = 1, at = { -0.5, 0 }, material = "stone" }
  local begun = os.clock()
  local last
  for i = 1, n do last = m:history { name = "history " .. i, body = b, what = "y", every = 0.01 } end
  m:run { duration = 0.1 }
  assert(#last.values == 11 and m.verdict.sound, #last.values)
  local spent = os.clock() - begun
  m:close()
  return spent/n
end

cost(500) -- the first call also loads shared parts
local few, many = math.huge, math.huge
-- Quadratic cost would be eight times as much for each one.
for _ = 1, 3 do few, many = math.min(few, cost(500)), math.min(many, cost(4000)) end
assert(many < 5*few, ("%g s for each of 4000 histories, %g s for each of 500"):format(many, few))
