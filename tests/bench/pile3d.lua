-- Boxes of 0.15 to 0.25 m poured into a container in space: layers of them fall at random angles, strike each other and
-- come to rest.
--
-- `trilith run tests/bench/pile3d.lua --profile` prints the time per step and the share of the contact search. Fewer
-- boxes: `boxes=300 across=6`.
local trilith = require "trilith"
local p = trilith.params {
  boxes = { 5000, "boxes" }, seconds = { 1.5, "of fall" }, across = { 18, "boxes in a row, and rows in a layer" },
}

local m = trilith.model { name = "pile in space", dim = 3 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-3 } }

-- Boxes have diagonals of at most 0.433 m, so that none overlap at the start.
local pitch, layer = 0.45, p.across * p.across
local width, height = p.across * pitch, math.ceil(p.boxes / layer) * pitch + 2
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
  seed = seed * 48271 % 2147483647
  return seed / 2147483647
end

-- A vector rotated by `angle` about the unit axis `u` (Rodrigues 1840).
local function turned(v, u, angle)
  local c, s = math.cos(angle), math.sin(angle)
  local along = (1 - c) * (u[1] * v[1] + u[2] * v[2] + u[3] * v[3])
  return {
    c * v[1] + s * (u[2] * v[3] - u[3] * v[2]) + along * u[1],
    c * v[2] + s * (u[3] * v[1] - u[1] * v[3]) + along * u[2],
    c * v[3] + s * (u[1] * v[2] - u[2] * v[1]) + along * u[3],
  }
end

for i = 0, p.boxes - 1 do
  local row = i % layer
  local x, y = (row % p.across + 0.5) * pitch, (row // p.across + 0.5) * pitch
  local z = 0.3 + (i // layer) * pitch
  local w, d, h = 0.15 + 0.1 * random(), 0.15 + 0.1 * random(), 0.15 + 0.1 * random()
  local up, about, angle = 2 * random() - 1, 2 * math.pi * random(), math.pi * random()
  local flat = math.sqrt(1 - up * up)
  local axis, corners = { flat * math.cos(about), flat * math.sin(about), up }, {}
  for k, sign in ipairs {
    { -1, -1, -1 }, { 1, -1, -1 }, { 1, 1, -1 }, { -1, 1, -1 }, { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 },
  } do
    local c = turned({ sign[1] * w / 2, sign[2] * d / 2, sign[3] * h / 2 }, axis, angle)
    corners[k] = { x + c[1], y + c[2], z + c[3] }
  end
  m:hull { name = "box" .. i, points = corners, material = "stone", floating = true,
           velocity = { 2 * random() - 1, 2 * random() - 1, -1 } }
end
local report = m:run { duration = p.seconds }
local told = "%d boxes, %d contacts, %g s: %d steps, hash %s"
print(told:format(p.boxes, #m:contacts(), p.seconds, report.steps, m.hash))
