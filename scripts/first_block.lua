-- A block of stone, 0.5 m by 0.3 m, falls 0.2 m onto a fixed base and comes to rest.
--
-- Free fall from h = 0.2 m takes sqrt(2 h / g) = 0.2020 s and ends at sqrt(2 g h) = 1.981 m/s (Galileo); at rest the
-- block has sunk in by its weight over kn times its width, W/(kn b) = rho g H / kn = 1.2e-6 m.
local trilith = require "trilith"
local m = trilith.model { name = "first block", thickness = 1 }
m:material { name = "stone", density = 2400 }
local joint = trilith.frictional { kn = 6e9, ks = 3e9, mu = 0.6, beta = 2e-4 }
m:contact { between = { "stone", "stone" }, law = joint }
m:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
local block = m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, 0.2 }, material = "stone",
                        floating = true }
m:on("impact", function(e) print(("%.4f s: the block strikes at %.3f m/s"):format(e.time, e.value)) end)
local report = m:run { duration = 5, rest = true }
print(("%.2f s: %s, block at y = %.9f m"):format(report.ended, report.ending, block.y))
