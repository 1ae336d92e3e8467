-- Fragility of a dry arch: one settled model, six pulses of each size, each in its own process.
-- Draw the curve with: trilith plot out/arch_fragility.h5 --fragility collapsed --over pga
local trilith = require "trilith"
local p = trilith.params { out = { "out/arch_fragility.h5", "table of the study" } }

local function arch_at_rest()
  local m = trilith.model { name = "arch", thickness = 1 }
  m:material { name = "stone", density = 2200 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 2e9, ks = 1e9, mu = 0.7, beta = 2e-4 } }
  m:arch { name = "arch", voussoirs = 12, span = 6, rise = 3, thickness = 0.75, material = "stone",
           fixed = "abutments" }
  m:consolidate { duration = 5 }
  return m
end

--- One period of a sine acceleration, from rest to rest after its displacement.
local function pulse(pga, period)
  local samples, n = {}, 100
  for i = 0, 2*n do
    local t = i/n -- of the period
    samples[i + 1] = t <= 1 and pga*math.sin(2*math.pi*t) or -pga*math.sin(2*math.pi*(t - 1))
  end
  return trilith.motion { acceleration = samples, dt = period/n, name = "double pulse" }
end

local study = trilith.study { file = p.out, before = arch_at_rest,
  parameters = { pga = { 0.3, 0.5, 0.7, 0.9, 1.1, unit = "g" },
    period = { 0.4, 0.6, 0.8, 1, 1.2, 1.4, unit = "s" } },
  case = function(case, m)
    local crown = m:bodies { group = "voussoirs" }[6]
    local y0, lost = crown.uy, false
    m:on_step(function()
      lost = lost or crown.uy - y0 < -0.5
      if lost then m:stop() end
    end)
    m:shake { body = m:bodies { group = "abutments" }, x = pulse(case.pga, case.period), duration = 2*case.period + 1 }
    return { collapsed = lost, sank = { y0 - crown.uy, unit = "m" } }
  end }

local collapses = {}
for _, row in ipairs(study.rows) do
  collapses[row.pga] = (collapses[row.pga] or 0) + (row.collapsed and 1 or 0)
end
for _, pga in ipairs { 0.3, 0.5, 0.7, 0.9, 1.1 } do
  print(("%.1f g: %d of 6 collapse"):format(pga, collapses[pga]))
end
