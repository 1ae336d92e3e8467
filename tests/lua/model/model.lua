-- Models, bodies, sets, stages and readings.
local trilith = require "trilith"
local function near(a, b, tolerance) assert(math.abs(a - b) <= (tolerance or 1e-12), a .. " is not " .. b) end

local law = trilith.frictional { name = "dry", kn = 6e9, ks = 3e9, mu = 0.6, beta = 1e-4 }
assert(law.kn == 6e9 and law.name == "dry")
assert(tostring(law):find "^frictional{kn=6e%+09 Pa/m")

local m = trilith.model { name = "m", thickness = 0.5 }
m:material { name = "stone", density = 2000 }
m:contact { between = { "stone", "stone" }, law = law }
m:contact { between = { "left", "right" }, law = "none" }
local base = m:block { name = "base", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
local function tower(side, x)
  return m:stack { name = side, at = { x, 0 }, material = "stone", groups = side,
    blocks = { { width = 1, height = 0.5 }, { width = 0.8, height = 0.5, offset = 0.1 } } }
end
local left, right = tower("left", -1), tower("right", 1)

-- bodies before and after building
assert(base == m:body "base" and base.name == "base" and base.material == "stone")
near(left[1].mass, 2000 * 0.5 * 0.5)
near(left[1].inertia, left[1].mass * (1 + 0.25) / 12)
near(left[2].x, -0.9)
near(left[2].y, 0.75)
assert(left[2].groups[1] == "stack" and left[2].groups[2] == "left")
assert(#left[1].outline == 4)

-- sets
assert(#left == 2 and left.count == 2 and left + right == m:bodies { group = "stack" })
assert((left + right) - left == right and #(left * right) == 0 and left + base ~= left)
assert(m:bodies { name = "*.b1" } == left[1] + right[1])
assert((left + right - "right.b2").names[3] == "right.b1")
assert(left:has(left[2]) and not left:has(base))
assert(#m:bodies() == 5 and m:bodies { material = "st?ne", group = "left" } == left)
local names = {}
for body in left + right do names[#names + 1] = body.name end
assert(table.concat(names, " ") == "left.b1 left.b2 right.b1 right.b2")
for i, body in ipairs(left) do assert(body == left[i]) end

-- stages
local top = m:history { name = "top", body = left[2], what = "uy" }
local speed = m:history { name = "speed", what = "speed" }
local twice = m:history { name = "twice", unit = "m", of = function() return 2 * left[2].uy end }
local report = m:consolidate { rest = { ratio = 1e-6 }, duration = 20 }
assert(report.ending == "rest" and report.rests and report.name == "consolidation")
assert(report.ratio <= 1e-6 and report.steps > 100 and report.ended == m.time)
assert(#top == #top.t and #top == #top.values and top.last < 0 and top[#top] == top.last)
near(twice.last, 2 * top.last, 1e-18)
assert(top.unit == "m" and speed.max > speed.last and top.min <= top.max)

-- contacts and forces: each tower stands on its own weight
local weight = (left.mass) * 9.80665
local found = m:contacts { between = { base, left } }
assert(#found == 1 and found[1].law == "dry" and found[1].hold == "sticking")
near(found[1].normal, weight, 1e-3)
assert(#m:contacts { between = { left, right } } == 0 and #m:contacts() == 4)

-- a driven base, then a fixed tower, then a tilt
local quake = trilith.motion("elcentro_1940_rest_ns.csv"):scale { factor = 0.1 }
local before = left[1].x
report = m:shake { motions = { { body = base, x = quake } }, duration = 3 }
assert(report.ending == "time")
near(report.ended - report.begun, 3)
assert(math.abs(left[1].x - before) > 1e-4)
near(base.ux, select(3, quake:at(3)) - select(3, quake:at(0)), 1e-9)
m:fix(left + right, "xyr")
m:fix(base)
m:run { name = "held", duration = 0.01 }
assert(m.speed == 0 and (left + right).speed == 0)
m:free(left)
m:tilt { rate = 0.5, by = 0.1 }
m:run { duration = 0.3 }
near(m.tilted, 0.1, 1e-12)
near(m.gravity[1], 9.80665*math.sin(0.1), 1e-12)
near(m.gravity[2], -9.80665*math.cos(0.1), 1e-12)
assert(left.speed < 0.1) -- released, they get a new step: the step of the stage before was long, because nothing moved
assert(m.verdict.sound and m.verdict.text == "" and m.verdict.left == 0)
assert(m.energy.kinetic >= 0 and type(m.energy.residual) == "number" and m.residual == m.energy.residual)
assert(m:explain_dt():find "governs")
assert(m.hash:match "^%x%x%x%x%x%x%x%x%x%x%x%x%x%x%x%x$")
assert(m.events[1].type == "stage.begun" and #m.events >= 8)

-- a constant velocity
local push = trilith.motion { velocity = 0.01, duration = 0.5 }
local x = base.x
m:drive { body = base, x = push }
m:run { duration = 1 }
near(base.x - x, 0.005, 1e-6)
