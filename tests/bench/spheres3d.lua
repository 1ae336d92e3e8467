-- Spheres of 80 to 120 mm that fall into a container in space, strike each other and settle.
--
-- `trilith run tests/bench/spheres3d.lua --profile` prints the time per step; `spheres=5000 across=17` is a tenth of
-- the default.
local trilith = require "trilith"
local p = trilith.params {
  spheres = { 50000, "spheres" }, seconds = { 0.5, "of fall" },
  across = { 36, "spheres in a row, and rows in a layer" },
}

local m = trilith.model { name = "spheres in space", dim = 3 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5, beta = 2e-4 } }

local pitch, layer = 0.125, p.across*p.across
local width, height = p.across*pitch, math.ceil(p.spheres/layer)*pitch + 1
local function wall(name, size, at)
  m:block { name = name, size = size, at = at, material = "stone", support = "fixed" }
end
wall("floor", { width + 2, width + 2, 1 }, { -1, -1, -1 })
wall("left", { 1, width, height }, { -1, 0, 0 })
wall("right", { 1, width, height }, { width, 0, 0 })
wall("front", { width + 2, 1, height }, { -1, -1, 0 })
wall("back", { width + 2, 1, height }, { -1, width, 0 })

-- Pseudo-random numbers between 0 and 1, equal on all platforms (Lehmer's generator).
local seed = 41
local function random()
  seed = seed*48271 % 2147483647
  return seed/2147483647
end

for i = 0, p.spheres - 1 do
  local row = i % layer
  m:sphere { name = "sphere" .. i, radius = 0.04 + 0.02*random(), material = "stone", floating = true,
    at = { (row % p.across + 0.5)*pitch, (row//p.across + 0.5)*pitch, 0.07 + (i//layer)*pitch },
    velocity = { random() - 0.5, random() - 0.5, -1 } }
end
local report = m:run { duration = p.seconds }
local told = "%d bodies, %d contacts, %g s: %d steps, hash %s"
print(told:format(p.spheres, #m:contacts(), p.seconds, report.steps, m.hash))
