-- Spheres of 80 to 120 mm that fall into a container in space, strike each other and settle.
--
-- `trilith run tests/bench/spheres3d.lua --profile` says what a step costs; `spheres=5000 across=17` is a tenth of it.
local trilith = require "trilith"
local p = trilith.params {
  spheres = { 50000, "spheres" }, seconds = { 0.5, "of fall" }, across = { 36, "spheres in a row, and rows in a layer" },
}

local m = trilith.model { name = "spheres in space", dim = 3 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5, beta = 2e-4 } }

local pitch, layer = 0.125, p.across*p.across
local width, height = p.across*pitch, math.ceil(p.spheres/layer)*pitch + 1
for name, at in pairs { floor = { { -1, -1, -1 }, { width + 1, width + 1, 0 } }, left = { { -1, 0, 0 }, { 0, width, height } },
  right = { { width, 0, 0 }, { width + 1, width, height } }, front = { { -1, -1, 0 }, { width + 1, 0, height } },
  back = { { -1, width, 0 }, { width + 1, width + 1, height } } } do
  local low, high = at[1], at[2]
  m:block { name = name, size = { high[1] - low[1], high[2] - low[2], high[3] - low[3] }, at = low, material = "stone",
    support = "fixed" }
end

-- Numbers between 0 and 1 that are the same everywhere (Lehmer's generator).
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
print(("%d bodies, %d contacts, %g s: %d steps, hash %s"):format(p.spheres, #m:contacts(), p.seconds, report.steps, m.hash))
