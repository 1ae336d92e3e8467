-- Beams and frames from scripts: sections, members, messages for wrong input, and readings.
local trilith = require "trilith"

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed*math.abs(expected), ("%.9g instead of %.9g"):format(value, expected))
end

-- sections, by shape and by numbers
local rectangle = trilith.rectangle_section { width = 0.3, depth = 0.5 }
near(rectangle.area, 0.15, 1e-12)
near(rectangle.inertia, 0.3*0.5^3/12, 1e-12)
local corners = { { 0, 0 }, { 0.3, 0 }, { 0.3, 0.5 }, { 0, 0.5 } }
near(trilith.polygon_section { outline = corners }.inertia, rectangle.inertia, 1e-12)
local tee = trilith.t_section { depth = 1.0, web = 0.2, width = 1.2, thickness = 0.2 }
local same = trilith.polygon_section { outline = {
  { -0.1, 0 }, { 0.1, 0 }, { 0.1, 0.8 }, { 0.6, 0.8 }, { 0.6, 1 }, { -0.6, 1 }, { -0.6, 0.8 }, { -0.1, 0.8 } } }
near(tee.area, same.area, 1e-12)
near(tee.inertia, same.inertia, 1e-12)
near(tee.below, same.below, 1e-12)
local beam = trilith.i_section { depth = 0.4, web = 0.01, top_width = 0.2, top_thickness = 0.02, bottom_width = 0.2,
                                 bottom_thickness = 0.02 }
near(beam.inertia, (0.2*0.4^3 - 0.19*0.36^3)/12, 1e-12)
near(trilith.box_section { width = 2, depth = 1, webs = 0.4, top = 0.2, bottom = 0.2 }.area, 2 - 1.6*0.6, 1e-12)
near(trilith.circle_section { diameter = 1, hollow = 0.8 }.inertia, math.pi/64*(1 - 0.8^4), 1e-12)
near(trilith.section { area = 0.1, inertia = 1e-3, depth = 0.6, below = 0.2 }.above, 0.4, 1e-12)
refused("leaves no web", trilith.t_section, { depth = 0.2, web = 0.1, width = 1, thickness = 0.3 })
refused("'depth' is missing", trilith.rectangle_section, { width = 1 })
refused("deep", trilith.rectangle_section, { width = 1, deep = 1 })
refused("below the diameter", trilith.circle_section, { diameter = 1, hollow = 2 })
refused("below is", trilith.section, { area = 1, inertia = 1, depth = 1, below = 2 })

-- a cantilever under its weight: w L^4 / (8 E I) at the tip, w L^2 / 2 at the root
local m = trilith.model { name = "cantilever" }
m:material { name = "concrete", density = 2400, E = 30e9, nu = 0.2 }
m:material { name = "stone", density = 2400 }
local arm = m:beam { name = "arm", from = { 0, 0 }, to = { 4, 0 }, section = rectangle, material = "concrete",
                     divisions = 16, from_support = "fixed" }
assert(arm.kind == "frame")
refused("nothing has run yet", arm.forces, arm)
m:consolidate { rest = { ratio = 1e-7, speed = 1e-9 } }
local w = 2400*0.15*9.80665
near(-select(2, arm:point { 4, 0 }), w*4^4/(8*30e9*rectangle.inertia), 0.01)
local rows = arm:forces()
assert(#rows == 32)
near(rows[1].moment, -w*16/2, 0.02)
near(rows[1].shear, w*4, 0.04) -- half of the first element's weight is carried by the support directly
near(rows[#rows].along, 4, 1e-12)
m:close()

-- a portal by its joints; messages for wrong input name the key
local p = trilith.model { name = "portal" }
p:material { name = "concrete", density = 2400, E = 30e9, nu = 0.2 }
local joints = { a = { at = { 0, 0 }, support = "fixed" }, b = { 0, 4 }, c = { 6, 4 },
                 d = { at = { 6, 0 }, support = "fixed" } }
local function members(change)
  local list = {
    { name = "left", from = "a", to = "b", section = rectangle, to_at = { 0, 3.75 } },
    { name = "cap", from = "b", to = "c", section = rectangle },
    { name = "right", from = "d", to = "c", section = rectangle, to_at = { 6, 3.75 }, pinned = "to" },
  }
  if change then change(list) end
  return list
end
local function portal(change, other)
  local t = { name = "portal", joints = joints, members = members(change), material = "concrete" }
  for k, v in pairs(other or {}) do t[k] = v end
  return t
end
refused("'to' is 'bb', which is not a joint", p.frame, p, portal(function(l) l[1].to = "bb" end))
refused("'section' is missing", p.frame, p, portal(function(l) l[2].section = nil end))
refused("'pinned' names 'middle'", p.frame, p, portal(function(l) l[3].pinned = "middle" end))
refused("divisions", p.frame, p, portal(function(l) l[1].divisions = 0 end))
refused("unknown key 'body'", p.frame, p, portal(nil, { body = "rigid" }))
refused("members", p.frame, p, { name = "x", joints = joints, material = "concrete" })
refused("joints", p.frame, p, { name = "x", members = {}, material = "concrete" })
refused("no member leads", p.frame, p, portal(nil, {
  joints = { a = { 0, 0 }, b = { 0, 4 }, c = { 6, 4 }, d = { 6, 0 }, e = { 9, 9 } } }))
refused("joint 'b' is 4, must be", p.frame, p, portal(nil, { joints = { a = { 0, 0 }, b = 4 } }))
p:material { name = "stone", density = 2000 }
refused("stiffness", p.frame, p, portal(nil, { material = "stone" }))
p:material { name = "steel", density = 7850, solid = trilith.j2 { E = 2e11, nu = 0.3, yield = 2.4e8 } }
refused("members need an elastic material, and 'steel' is not elastic (j2", p.frame, p,
  portal(nil, { material = "steel" }))
refused("unknown key 'inertia'", p.frame, p, portal(nil, { inertia = 3 }))
local body = p:frame(portal())
p:consolidate { rest = { ratio = 1e-6, speed = 1e-8 } }
local total = 0
for _, name in ipairs { "left", "right" } do total = total - body:forces(name)[1].normal end
near(total, 2400*0.15*(6 + 2*3.75)*9.80665 - 2400*0.15*3.75/8*9.80665, 0.02) -- minus half an element at each foot
near(math.abs(body:forces "right"[16].moment) + 1, 1, 1e-6) -- zero at the pin
refused("name one", body.forces, body)
refused("no member 'lift'; did you mean 'left'", body.forces, body, "lift")
p:close()

-- Blocks as joints, from their outline; consistent mass; a history of a fibre's stress.
local b = trilith.model { name = "blocks", thickness = 1, gravity = 0 }
b:material { name = "concrete", density = 2500, E = 30e9, nu = 0.2 }
local square = trilith.rectangle_section { width = 0.4, depth = 0.4 }
local function post(change)
  local t = { name = "post", material = "concrete", floating = true, mass_matrix = "consistent",
              joints = { foot = { at = { 0, 0 }, support = "fixed" },
                         head = { outline = { { -1, 4 }, { 1, 4 }, { 1, 5 }, { -1, 5 } }, density = 1000 } },
              members = { { from = "foot", to = "head", section = square, divisions = 2 } } }
  for k, v in pairs(change) do t[k] = v end
  return t
end
refused("'mass_matrix' is 'full'", b.frame, b, post { mass_matrix = "full" })
refused("is not the centroid of its block, (0, 4.5)", b.frame, b, post {
  joints = { foot = { 0, 0 }, head = { at = { 0, 4 }, outline = { { -1, 4 }, { 1, 4 }, { 1, 5 }, { -1, 5 } } } } })
refused("must be convex", b.frame, b, post {
  joints = { foot = { 0, 0 }, head = { outline = { { -1, 4 }, { 1, 4 }, { 0, 4.1 }, { 0, 5 } } } } })
refused("a removed member keeps its mass at its nodes", b.frame, b, post {
  members = { { from = "foot", to = "head", section = square,
                hinge = trilith.end_hinge { sagging = 1e5, ultimate = 0.01, becomes = "removed" } } } })
local made = b:frame(post {})
local first = b:modes { count = 1 }[1].frequency
-- A cantilever of 4 m with a body of 2 t whose centre is 0.5 m beyond its end, and the post's own mass.
assert(first > 3 and first < 8, first)
near(made.mass, 2000 + 2500*0.16*4, 1e-12)
b:close()
