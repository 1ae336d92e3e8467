-- Contact laws that all differ, each between one material and all others. Declaring them and starting a run costs
-- little more for each law where there are many.
local trilith = require "trilith"

-- CPU time of n laws and a short run of one body for each law, by law [s].
local function cost(n)
  local m = trilith.model {}
  local begun = os.clock()
  for i = 1, n do
    local name = "stone " .. i
    m:material { name = name, density = 2400 }
    m:contact { between = { name, "*" }, law = trilith.frictional { kn = 1e8 + i, ks = 1e7, mu = 0.5 } }
    m:block { name = "block " .. i, width = 1, height = 1, at = { 2*i, 0 }, material = name, floating = true }
  end
  m:run { duration = 1e-4 }
  local spent = os.clock() - begun
  m:close()
  return spent/n
end

local few, many = math.huge, math.huge
for _ = 1, 3 do few, many = math.min(few, cost(150)), math.min(many, cost(1200)) end
if os.getenv "TRILITH_SHOW" then print(few*1e6, many*1e6) end
-- Quadratic cost is eight times as much for each law. The table of laws by pairs is small compared with the rest.
assert(many < 5*few, ("%.3g us for each of 1200 laws, %.3g us for each of 150"):format(many*1e6, few*1e6))
