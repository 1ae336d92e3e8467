-- A run is rewound, changed, and continues for so long that checkpoints of the common part are dropped: the two
-- branches are compared at the end of the first.
local trilith = require "trilith"

local function branches(dim, count, longer)
  local m = trilith.model { name = "branches", dim = dim }
  m:material { name = "stone", density = 2400 }
  m:contact { name = "joint", between = { "*", "*" },
    law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.6, beta = 1e-4 } }
  local function block(name, size, at, support)
    local t = { name = name, material = "stone", support = support }
    if dim == 3 then
      t.size, t.at = { size[1], size[1], size[2] }, { at[1], at[1], at[2] }
    else
      t.width, t.height, t.at = size[1], size[2], at
    end
    m:block(t)
  end
  block("ground", { 4, 0.5 }, { -2, -0.5 }, "fixed")
  block("b", { 0.5, 0.4 }, { -0.25, 0 })
  m:checkpoints { every = 0.01, count = count }
  m:run { duration = 0.3 }
  local back = m:rewind { to = 0.15 }
  m:change { law = "joint", mu = 0.3 }
  m:run { duration = longer }
  return m:compare(), back
end

for _, dim in ipairs { 2, 3 } do
  for _, case in ipairs { { 400, 0.2 }, { 20, 0.2 }, { 20, 0.6 }, { 20, 0.1 } } do
    local found, back = branches(dim, case[1], case[2])
    assert(math.abs(back - 0.15) < 0.011, back)
    assert(found.now, ("in %d dimensions, of %d checkpoints, %g s later: %s"):format(dim, case[1], case[2], found.text))
    -- at the latest common time, and at one time within a step and a half
    assert(math.abs(found.now - math.min(0.3, back + case[2])) < 0.012, found.text)
    assert(math.abs(found.now - found.before) < 2e-3, found.text)
  end
end

-- Checkpoints of both branches are at whole multiples of the interval, however long their steps are.
local found = branches(2, 400, 0.05)
assert(found.now and found.now > 0.18, found.text)
