-- A pushover with a given rate begins without a jolt: the force that accelerates a block to the rate does not count as
-- its capacity. A block slides at mu W, in the plane and in space.
local trilith = require "trilith"
local near = dofile "near_expected.lua"
local g = 9.80665

for _, dim in ipairs { 2, 3 } do
  for _, rate in ipairs { 0.005, 0.01 } do
    local m = trilith.model { name = "sliding", dim = dim }
    m:material { name = "stone", density = 2400 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.4, beta = 1e-4 } }
    local block
    if dim == 2 then
      m:block { name = "ground", width = 4, height = 0.5, at = { -2, -0.5 }, material = "stone", support = "fixed" }
      block = m:block { name = "b", width = 1, height = 0.2, at = { -0.5, 0 }, material = "stone" }
    else
      m:block { name = "ground", size = { 4, 4, 0.5 }, at = { -2, -2, -0.5 }, material = "stone", support = "fixed" }
      block = m:block { name = "b", size = { 1, 1, 0.2 }, at = { -0.5, -0.5, 0 }, material = "stone" }
    end
    m:consolidate { rest = { ratio = 1e-5 } }
    local r = m:pushover { body = block, rate = rate, displacement = 0.02, samples = 60 }
    near("sliding force", r.peak_force, 0.4*block.mass*g, 0.02)
    m:close()
  end
end
