-- A flying buttress against a smooth wall that pushes with more, or less, than the least thrust for which it stands.
-- The thrust line of the least thrust runs from the extrados at the head to the intrados of the governing joint.
local trilith = require "trilith"

local g, head = 9.81, 0.4
local function model(dim)
  local m = trilith.model { name = "flyer", dim = dim, thickness = dim == 2 and 0.6 or nil, gravity = g }
  local function law(mu) return trilith.frictional { kn = 1e11, ks = 5e10, mu = mu, beta = 1e-5 } end
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = law(0.8) }
  m:contact { between = { "walls", "*" }, law = law(0), name = "smooth" }
  local flyer = { name = "f", voussoirs = 9, span = 4, rise = 2, thickness = head, pier_height = 3, wall_width = 0.8,
                  wall_height = 0.5 }
  local body = { material = "stone", fixed = { "piers", "walls" } }
  if dim == 2 then
    for key, value in pairs(body) do flyer[key] = value end
    m:flying_buttress(flyer)
  else
    body.depth, body.centred = 0.6, true
    m:add(trilith.build.flying_buttress(flyer), body)
  end
  return m
end

local function least_thrust(m)
  local least = 0
  for j = 0, 8 do
    local angle = math.asin(0.8)*(1 - j/9) -- the intrados: 5 m about (4, -3), level at the head
    local x, y, moment = 4 - 5*math.sin(angle), -3 + 5*math.cos(angle), 0
    for k = j + 1, 9 do
      local stone = m:body("f.v" .. k)
      moment = moment + stone.mass*g*(stone.x - x)
    end
    least = math.max(least, moment/(2 + head - y))
  end
  return least
end

-- Settlement of the middle stone after `seconds` [m].
local function sinks(dim, factor, seconds)
  local m = model(dim)
  local push = -factor*least_thrust(m)
  m:consolidate { rest = { ratio = 1e-4 } }
  m:free("f.wall", "x")
  m:point_load { body = "f.wall", at = dim == 2 and { 4.8, 2.2 } or { 4.8, 0, 2.2 },
                 force = dim == 2 and { push, 0 } or { push, 0, 0 } }
  m:run { duration = seconds }
  local stone = m:body "f.v5"
  local way = -(dim == 2 and stone.uy or stone.uz)
  m:close()
  return way
end

for _, dim in ipairs { 2, 3 } do
  assert(sinks(dim, 0.95, 2) > 0.1, "it collapses under less than the least thrust")
  assert(sinks(dim, 1.05, 1) < 2e-3, "it stands under more")
end

-- With a coping, and curved edges that leave stones of several pieces: no stone penetrates another.
for _, slope in ipairs { 20, 18, 15 } do
  local m = trilith.model { name = "coping", thickness = 0.6 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 5e10, mu = 0.7, beta = 1e-5 } }
  m:flying_buttress { name = "f", slope = slope*trilith.units "deg", pier_height = 3, pier_width = 1.6,
                      wall_width = 0.8, wall_height = 1.5, sub_edges = 2, material = "stone",
                      fixed = { "piers", "walls" } }
  m:on("body.passed", function(e) error(e.text) end)
  assert(m:consolidate { rest = { ratio = 1e-5 } }.rests)
  m:close()
end
