-- A gravity dam of four lifts: its reservoir is filled, water enters each joint that opens, then an earthquake
-- shakes it with the added mass of the water at its face.
local trilith = require "trilith"
local s, g = trilith.units "s", trilith.units "g"
local p = trilith.params {
  level = { 11, unit = "m", "of the reservoir above the base" },
  base = { 9, unit = "m", "length of the base" },
  pga = { 0.15*g, unit = "m/s2", "of the ground motion" },
  duration = { 15*s, unit = "s", "of the shaking" },
  uplift = { true, "water in the joints" },
  out = { "out/dam.h5", "results" } }

local m = trilith.model { name = "dam" }
m:material { name = "concrete", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 2e10, ks = 1e10, mu = 0.75, beta = 4e-4 } }
m:block { name = "rock", width = 32, height = 2, at = { -12, -2 }, material = "concrete", support = "fixed" }
local height, base, crest, lifts = 12, p.base, 2, 4
local function width(z) return base - (base - crest)*z/height end
local names = { [0] = "rock" }
for i = 1, lifts do
  local low, high = (i - 1)*height/lifts, i*height/lifts
  names[i] = "lift " .. i
  m:polygon { name = names[i], groups = { "dam" }, material = "concrete",
    outline = { { 0, low }, { width(low), low }, { width(high), high }, { 0, high } } }
end
m:results { file = p.out, frames = 0.05*s, energy = 0.05*s }
m:consolidate { integrator = "static" }

-- Filling, slow enough for statics.
m:water { name = "reservoir", body = "dam", level = 0, side = "left" }
local joints = {}
for i = 1, p.uplift and lifts or 0 do
  joints[i] = m:uplift { name = "joint " .. i, upper = names[i], lower = names[i - 1], upstream = "reservoir" }
end
m:set_level { name = "reservoir", level = p.level, duration = 4*s }
m:run { name = "filling", duration = 5*s, local_damping = 0.5, rest = { ratio = 1e-5, from = 4.2*s } }

local function cracks()
  local longest = {}
  for i, name in ipairs(joints) do
    local state = m:water_state(name)
    longest[i] = state.crack/state.length
  end
  return longest
end
local function report(title, list)
  local texts = {}
  for i, share in ipairs(list) do texts[i] = ("%.0f %%"):format(100*share) end
  print(("%s: joints open from upstream %s"):format(title, #texts > 0 and table.concat(texts, ", ") or "not flooded"))
end
report("full reservoir", cracks())

-- The water before the face moves with it: each lift has its share.
for i = 1, lifts do
  local low, high = (i - 1)*height/lifts, i*height/lifts
  if low < p.level then
    m:added_mass { body = names[i], side = "left", level = p.level, bed = 0, from = low, to = math.min(high, p.level) }
  end
end
local most = {}
for i = 1, #joints do most[i] = 0 end
m:shake { name = "El Centro", body = "rock", x = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga },
  duration = p.duration, until_true = function(now)
    if now.steps and now.steps % 20 ~= 0 then return false end
    for i, share in ipairs(cracks()) do most[i] = math.max(most[i], share) end
    return false
  end }
report("largest during the shaking", most)
report("afterwards", cracks())
local rock = m:body "rock"
for i = 1, lifts do
  local below = m:body(names[i - 1])
  print(("%s has slid %.2f mm over %s"):format(names[i], 1e3*(m:body(names[i]).ux - below.ux), names[i - 1]))
end
print(("crest %.1f mm downstream; work of the water %.1f kJ, error of the ledger %.1g"):format(
  1e3*(m:body(names[lifts]).ux - rock.ux), 1e-3*m.energy.water, m.residual/math.max(1, m.energy.water)))
