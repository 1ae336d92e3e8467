-- The spread of a claim: a granite block rocks under a record at four intensities, in copies whose joint stiffness,
-- damping and onset differ by small stated amounts. A claim is certain where it holds in all copies.
-- See docs/guide/what_can_be_predicted.md.
local trilith = require "trilith"
local g = trilith.units "g"
local p = trilith.params { copies = { 16, "copies of each intensity" }, out = { "out/spread.h5", "table of the " ..
  "study" } }

local width, height = 0.25, 1.0
local record = trilith.motion "elcentro_1940_rest_ns.csv"

-- Stiffness and damping as factors, onset as the time at rest before the record.
local function rock(c)
  local m = trilith.model { name = "block", thickness = 0.754 }
  m:material { name = "granite", density = 2670 }
  local kn = 1e11*c.stiffness
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 0.6, beta = 1e-4*c.damping } }
  local ground = m:block { name = "ground", width = 8, height = 0.5, at = { -4, -0.5 }, material = "granite",
    support = "fixed" }
  local lift, foot = 1e-3, 0.05*width
  local mass = 2670*width*height*0.754
  local block = m:body { name = "block", material = "granite", mass = mass, inertia = mass*(width^2 + height^2)/12,
    outline = { { 0, 0 }, { foot, 0 }, { foot, lift }, { width - foot, lift }, { width - foot, 0 }, { width, 0 },
      { width, height }, { 0, height } } }
  m:consolidate { rest = { ratio = 1e-4 } }
  local begun, first, most = m.time, 0/0, 0
  local alpha = trilith.math.atan(width, height)
  m:shake { body = ground, x = record:scale { pga = c.pga*g }:delay(c.onset), duration = 15, until_true = function()
    local t, tilt = m.time - begun - c.onset, math.abs(block.rotation)/alpha
    if first ~= first and tilt > 0.01 then first = t end
    most = math.max(most, tilt)
    return tilt > 2
  end }
  return { first_tilt = { first, unit = "s" }, most_tilt = most, overturned = most > 2 }
end

-- Points of a sequence that fills the range from 0 to 1 evenly (van der Corput 1935), for each property another base.
local function even(i, base)
  local value, share = 0, 1/base
  while i > 0 do
    value, share, i = value + share*(i % base), share/base, i//base
  end
  return value
end

local levels, cases = { 0.3, 0.35, 0.5, 0.8 }, {}
for _, pga in ipairs(levels) do
  for i = 1, p.copies do
    cases[#cases + 1] = { pga = pga, stiffness = 0.9 + 0.2*even(i, 2), damping = 0.8 + 0.4*even(i, 3),
      onset = 0.01*even(i, 5) }
  end
end
local study = trilith.study { file = p.out, case = rock, cases = cases }

for _, pga in ipairs(levels) do
  local low, high, first_low, first_high, fell = 1e9, 0, 1e9, 0, 0
  for _, row in ipairs(study.rows) do
    if row.pga == pga then
      low, high = math.min(low, row.most_tilt), math.max(high, row.most_tilt)
      first_low, first_high = math.min(first_low, row.first_tilt), math.max(first_high, row.first_tilt)
      if row.overturned then fell = fell + 1 end
    end
  end
  local share = fell/p.copies
  local word = (share == 0 or share == 1) and "certain" or math.abs(share - 0.5) >= 0.4 and "likely" or "not decided"
  print(("%.2f g: %d of %d overturn: %s; first tilt %.3f s to %.3f s, largest tilt over alpha %.2f to %.2f"):format(pga,
    fell, p.copies, word, first_low, first_high, low, math.min(high, 1)))
end
