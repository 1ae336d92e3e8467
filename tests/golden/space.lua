-- Four collapses in space: a façade in mortar between return walls, a tower of drums, a dome without thrust ring.
-- The fourth is a frame that yields under a falling block. Each lasts about a second or less.
-- usage: trilith run --quiet space.lua scene=NAME
local trilith = require "trilith"
local p = trilith.params {
  scene = { "tower", choices = { "facade", "tower", "dome", "frame" }, "what collapses" } }

local m = trilith.model { name = p.scene, dim = 3 }
m:material { name = "stone", density = 2200 }
m:material { name = "steel", density = 7850, E = 210e9, nu = 0.3 }
local function contact(t)
  local law = t.tension and trilith.bonded(t) or trilith.frictional(t)
  m:contact { between = { "*", "*" }, name = "joint", law = law }
end
--- An acceleration of 1.5 g that leaves neither a velocity nor a displacement: a cosine in a window of 0.6 s.
local function pulse(waves)
  local values = {}
  for i = 0, 120 do
    local angle = 2*math.pi*i/120
    values[i + 1] = 1.5*9.80665*trilith.math.cos(waves*angle)*(1 - trilith.math.cos(angle))/2
  end
  return trilith.motion { dt = 0.005, acceleration = values }
end
local function ground(x, y)
  return m:block { name = "ground", size = { 2*x, 2*y, 0.5 }, at = { -x, -y, -0.5 }, material = "stone",
                   support = "fixed" }
end

local scenes = {}

function scenes.facade()
  contact { kn = 5e8, ks = 2e8, mu = 0.6, beta = 2e-4, tension = 2e3, cohesion = 3e3 }
  m:building { name = "house", material = "stone", fixed = "base",
    walls = { { name = "front", from = { 0, 0.15 }, to = { 3, 0.15 },
        openings = { { storey = 1, from = 0.9, width = 1.2, height = 1.2 } } },
      { name = "left", from = { 0.15, 0.15 }, to = { 0.15, 1.5 } },
      { name = "right", from = { 2.85, 0.15 }, to = { 2.85, 1.5 } } },
    storeys = { { courses = 6, slab_height = 0 } },
    unit_length = 0.6, unit_height = 0.3, lintel_bearing = 0.3, base_height = 0.5, base_margin = 1 }
  m:shake { body = "house.base", x = pulse(2), y = pulse(3), duration = 0.4 }
end

function scenes.tower()
  contact { kn = 1e9, ks = 4e8, mu = 0.7, beta = 1e-5 }
  ground(3, 3)
  m:column { name = "tower", material = "stone", drums = 8, height = 4, sides = 8, radius = 0.3, top_radius = 0.2,
    at = { 0, 0, 0 } }
  m:shake { body = "ground", x = pulse(2):scale { factor = 4 }, y = pulse(3), duration = 1.2 }
end

function scenes.dome()
  contact { kn = 2e9, ks = 1e9, mu = 0.3, beta = 1e-5 }
  ground(4, 4)
  m:dome { name = "dome", radius = 2, thickness = 0.2, rings = 4, sectors = 8, material = "stone" }
  m:run { duration = 0.4 }
end

function scenes.frame()
  contact { kn = 1e9, ks = 4e8, mu = 0.5, beta = 1e-5 }
  ground(4, 4)
  local section = trilith.rectangle_section { width = 0.1, depth = 0.1 }
  local hinge = trilith.end_hinge { sagging = 5e4, across = 5e4 }
  local joints, members = {}, {}
  local function member(name, from, to)
    members[#members + 1] = { name = name, from = from, to = to, section = section, hinge = hinge, divisions = 2 }
  end
  for i, at in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
    joints["foot " .. i] = { at = { at[1], at[2], 0 }, support = "fixed" }
    joints["head " .. i] = { at[1], at[2], 3 }
    member("column " .. i, "foot " .. i, "head " .. i)
    member("beam " .. i, "head " .. i, "head " .. i % 4 + 1)
  end
  m:frame { name = "portal", material = "steel", joints = joints, members = members }
  m:block { name = "load", material = "stone", size = { 2.6, 2.6, 1 }, at = { -1.2, -1.3, 3.1 },
    velocity = { 1, 0, -3 }, floating = true }
  m:run { duration = 0.2 }
end

scenes[p.scene]()
