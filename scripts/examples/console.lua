-- A block on an incline, made for the console. Type the lines below, or send them through a pipe:
--
--     trilith -i scripts/examples/console.lua
--     > m:run { duration = 0.5 }
--     > block
--     > print { speed = block.vx, share = block.vx/9.81 }
--     > m.energy
--
-- The console prints the values of expressions and the content of tables. `help "m.run"` describes a function.
local trilith = require "trilith"
local m = trilith.model { name = "incline" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5e9, ks = 2e9, mu = 0.3, beta = 1e-4 } }
m:polygon { name = "incline", outline = { { 0, 0 }, { 8, 0 }, { 0, 4 } }, material = "stone", support = "fixed" }
local block = m:polygon { name = "block", material = "stone",
  outline = { { 1, 3.5 }, { 2, 3 }, { 2, 3.6 }, { 1, 4.1 } } }
m:results { file = "out/console.h5", frames = 0.02 }
print(("%s of %.0f kg on a slope of 1 : 2"):format(block.name, block.mass))
