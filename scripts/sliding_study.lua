-- A study: how far a block slides on a floor before friction stops it, over speed and friction.
--
-- The block starts at speed v and decelerates by mu g until it rests: distance v^2/(2 mu g) (Coulomb), within 1 %.
-- `trilith study scripts/sliding_study.lua` runs the nine cases, each in its own process, into one table. Repeated,
-- it runs only unfinished cases. `trilith run scripts/sliding_study.lua --case 3` runs one case in this process.
local trilith = require "trilith"
local g = trilith.units "g"
local p = trilith.params { out = { "out/sliding_study.h5", "the table" } }

local study = trilith.study {
  file = p.out,
  parameters = { mu = { 0.2, 0.4, 0.6 }, v = { 0.5, 1, 2, unit = "m/s" } },
  case = function(case)
    local m = trilith.model { name = "slide", thickness = 1 }
    m:material { name = "stone", density = 2400 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 6e9, ks = 3e9, mu = case.mu, beta = 2e-4 } }
    m:block { name = "floor", width = 4, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
    local block = m:block { name = "block", width = 0.5, height = 0.1, at = { 0, -4e-7 }, material = "stone",
                            velocity = { case.v, 0 } }
    m:run { duration = 3, rest = { speed = 1e-4, hold = 0.05 } }
    return { distance = { block.ux, unit = "m" }, expected = { case.v^2 / (2*case.mu*g), unit = "m" } }
  end,
}

for _, row in ipairs(study.rows) do
  print(("mu %.1f  v %.1f m/s  %.4f m, expected %.4f m"):format(row.mu, row.v, row.distance, row.expected))
end
