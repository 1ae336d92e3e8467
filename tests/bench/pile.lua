-- Boxes of 0.15 to 0.25 m poured into a container: rows of them fall at random angles, strike each other and come to
-- rest.
--
-- `trilith run tests/bench/pile.lua --profile` prints the time per step and the share of the contact search.
local trilith = require "trilith"
local p = trilith.params {
  boxes = { 5000, "boxes" }, seconds = { 2.0, "of fall" }, across = { 100, "boxes in a row" },
  safety = { 0.5, "share of the longest stable step" }, step = { 0, "length of a step; 0: as long as is stable", "s" },
}

local m = trilith.model { name = "pile", thickness = 1 }
m:material { name = "stone", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-3 } }

local pitch, rows = 0.36, math.ceil(p.boxes / p.across)
local width, height = p.across * pitch, rows * pitch + 2
m:block { name = "floor", width = width + 2, height = 1, at = { -1, -1 }, material = "stone", support = "fixed" }
m:block { name = "left", width = 1, height = height, at = { -1, 0 }, material = "stone", support = "fixed" }
m:block { name = "right", width = 1, height = height, at = { width, 0 }, material = "stone", support = "fixed" }

-- Pseudo-random numbers between 0 and 1, equal on all platforms (Lehmer's generator).
local seed = 41
local function random()
  seed = seed * 48271 % 2147483647
  return seed / 2147483647
end
for i = 0, p.boxes - 1 do
  local x, y = (i % p.across + 0.5) * pitch, 0.3 + (i // p.across) * pitch
  local w, h, turn = 0.15 + 0.1 * random(), 0.15 + 0.1 * random(), math.pi * random()
  local c, s, outline = math.cos(turn), math.sin(turn), {}
  for k, corner in ipairs { { -w, -h }, { w, -h }, { w, h }, { -w, h } } do
    outline[k] = { x + (c * corner[1] - s * corner[2]) / 2, y + (s * corner[1] + c * corner[2]) / 2 }
  end
  m:polygon { name = "box" .. i, outline = outline, material = "stone", floating = true,
              velocity = { 2 * random() - 1, -1 } }
end
local report = m:run { duration = p.seconds, safety = p.safety, dt = p.step > 0 and p.step or nil }
local told = "%d boxes, %d contacts, %g s: %d steps, hash %s"
print(told:format(p.boxes, #m:contacts(), p.seconds, report.steps, m.hash))
