-- Level ground: bodies rest on it at any place, in the plane and in space, and none reaches its end.
local trilith = require "trilith"

local function model(dim)
  local m = trilith.model { name = "ground", dim = dim }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 5e-4 } }
  return m
end

local function refused(words, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(words, 1, true), ("%s is not in: %s"):format(words, tostring(why)))
end

-- In the plane: a block at rest on the ground carries its weight, and another one that slides far away comes to rest by
-- friction after v^2 / (2 mu g).
local m = model(2)
local still = m:block { name = "still", width = 1, height = 0.5, at = { 0, 2 }, material = "stone" }
local fast = m:block { name = "fast", width = 1, height = 0.2, at = { 5, 2 }, material = "stone", velocity = { 8, 0 } }
local ground = m:ground { level = 2 } -- a fixed body needs no material
assert(ground.name == "ground" and ground.y < 2)
m:run { duration = 3 }
assert(math.abs(still.ux) < 1e-3 and math.abs(still.uy) < 1e-3, "the block at rest moved")
assert(fast.speed < 1e-3, "the sliding block did not come to rest")
local way = 8^2/(2*0.6*9.80665)
assert(math.abs(fast.ux - way) < 0.02*way, ("it slid by %.3f m, expected %.3f m"):format(fast.ux, way))

-- In space: a sphere-like stone that falls next to the tower rests on the ground, at the ground's level.
local s = model(3)
local tower = s:block { name = "tower", size = { 0.5, 0.5, 2 }, at = { 0, 0, 0 }, material = "stone" }
local stone = s:block { name = "stone", size = { 0.3, 0.3, 0.3 }, at = { 3, -4, 0.2 }, material = "stone",
  floating = true }
s:level_ground { level = 0, name = "plain", reach = 40 }
s:run { duration = 2 }
assert(math.abs(stone.z - 0.15) < 1e-3 and stone.speed < 1e-3, "the stone does not rest on the ground")
assert(math.abs(tower.uz) < 1e-3 and math.abs(tower.ux) < 1e-3)

-- Wrong input.
local e = model(2)
refused("the model has no body yet", e.level_ground, e, { level = 0, material = "stone" })
e:block { name = "b", width = 1, height = 1, at = { 0, 0 }, material = "stone" }
refused("'level' is missing, must be a number in m", e.level_ground, e, { material = "stone" })
refused("'reach' is", e.level_ground, e, { level = 0, material = "stone", reach = -1 })
-- A message begins with the name that the script uses.
refused("level_ground: 'reach' is", e.level_ground, e, { level = 0, reach = -1 })
refused("ground: 'reach' is", e.ground, e, { level = 0, reach = -1 })
do
  local _, why = pcall(e.ground, e, { level = 0, reach = -1 })
  assert(not tostring(why):find("level_ground:", 1, true), tostring(why))
end
refused("unknown key 'lavel'", e.level_ground, e, { lavel = 0 })
m:close() s:close() e:close()
