-- Units give SI factors; products and quotients of them too.
local trilith = require "trilith"
local ft, inch, kip, g, s, deg = trilith.units "ft inch kip g s deg"
local function near(a, b) assert(math.abs(a - b) <= 1e-13 * math.abs(b), a .. " is not " .. b) end
near(ft, 12 * inch)
near(kip, 4448.2216152605)
near(g, 9.80665)
near(s, 1)
near(180 * deg, math.pi)
local k, rho = trilith.units "kip/ft, slug/ft3"
near(k, kip / ft)
near(rho, 515.3788183931961)
assert(select("#", trilith.units "") == 0)
