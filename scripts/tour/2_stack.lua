-- Four equal blocks overhang the edge of a table: each by its limit under the blocks above, times a factor.
local trilith = require "trilith"
local p = trilith.params {
  count = { 4, "blocks" },
  factor = { 0.98, "factor on the largest overhang" } }
local m = trilith.model { name = "stack", thickness = 1 }

m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 4e12, ks = 2e12, mu = 0.7, beta = 5e-9 } }
local blocks = m:harmonic_stack {
  name = "pile", count = p.count, length = 1, height = 0.2, factor = p.factor,
  table_height = 0.5, material = "stone", fixed = "table" }

m:results { file = "out/stack.h5", frames = 0.05 }
m:consolidate { duration = 2, rest = { speed = 1e-6 }, or_go_on = true } -- an unstable stack does not settle
m:run { name = "undamped", duration = 1 }

local largest = 0
for k = 1, p.count do largest = largest + 1/(2*k) end
local top = blocks[#blocks]
print(("overhang %.4f m, limit %.4f m"):format(p.factor*largest, largest))
print(math.abs(top.uy) < 0.01 and "stands" or "falls")
