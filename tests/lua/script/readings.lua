-- All readings in handlers, in stories and between stages belong to one instant: they equal the histories at the same
-- time.
local trilith = require "trilith"

local function scene()
  local m = trilith.model { name = "readings" }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-4 } }
  m:block { name = "base", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
  return m, m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, 0.1 }, material = "stone",
    floating = true, velocity = { 1, 0 }, spin = 2 }
end

-- one reading as numbers: the ledger, contacts and their forces, the fastest point
local function read(m)
  local values = { m.residual, m.energy.kinetic, m.energy.contact_elastic or 0, m.speed, m.ratio }
  for _, c in ipairs(m:contacts()) do
    for _, key in ipairs { "normal", "shear", "slip" } do values[#values + 1] = c[key] end
  end
  return values
end

local function same(a, b)
  if #a ~= #b then return false end
  for i, value in ipairs(a) do if value ~= b[i] then return false end end
  return true
end

-- a history at every step keeps its readings; handlers of steps, times and events must read the same
local m, block = scene()
local seen, compared = {}, { step = 0, every = 0, event = 0, story = 0 }
local function compare(where)
  local before = seen[m.time]
  compared[where] = compared[where] + 1
  seen[m.time] = before or read(m)
  assert(same(seen[m.time], read(m)), where .. " read something else at " .. m.time)
end
m:history { name = "all", unit = "1", every = 1e-9, of = function()
  local now = read(m)
  assert(seen[m.time] == nil or same(seen[m.time], now), "a history read something else at " .. m.time)
  seen[m.time] = now
  return #now
end }
m:on_step(function() compare "step" end)
m:every(0.01, function() compare "every" end)
m:on("*", function() compare "event" end)
local report = m:run { duration = 0.5 }
assert(compared.step == report.steps and compared.every >= 49 and compared.event > 2)
compare "story" -- between stages
assert(block.y < 0.3)

-- a falling block dissipates nothing, whenever it is read
m = trilith.model { name = "fall" }
m:material { name = "stone", density = 2400 }
block = m:block { name = "block", width = 0.5, height = 0.3, at = { 0, 0 }, material = "stone", floating = true }
local dt, worst = 0.01, 0
local start = -block.mass * 9.80665^2 * dt^2 / 8 -- the leapfrog scheme starts with half a step
m:on_step(function() worst = math.max(worst, math.abs(m.residual - start)) end)
m:run { duration = 1, dt = dt }
assert(worst < 1e-8, "residual " .. worst)
assert(m.energy.kinetic > 10000)
