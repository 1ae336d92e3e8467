-- The top of a push: free, level or locked. A block of width b and height h rocks between a base and a beam, without
-- tension. N acts on the beam. The pressure of a toe is a triangle of length c. At the rotation a the push is
-- N (b - 2c/3 - h a)/h under a level top. Under a locked top V replaces N. The beam keeps its height, so the toes
-- overlap by e = (b a - h a^2/2)/2 + N/(kn b t). Then c = e/a, and V = kn t e^2/(2 a) grows.
local trilith = require "trilith"
local near = dofile "near_expected.lua"

local b, h, t, N, kn = 0.4, 1, 0.5, 1e5, 1e10

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

local function pier(dim)
  local m = trilith.model { name = "pier", dim = dim, thickness = dim == 2 and t or nil, gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn, mu = 2, beta = 1e-5 } }
  local function add(name, width, height, y, support)
    if dim == 2 then
      return m:block { name = name, width = width, height = height, at = { -width/2, y }, material = "stone",
        support = support }
    end
    return m:block { name = name, size = { width, t, height }, at = { -width/2, 0, y }, material = "stone",
      support = support }
  end
  add("base", 2, 0.5, -0.5, "fixed")
  local block = add("block", b, h, 0)
  local beam = add("beam", 1, 0.2, h)
  m:point_load { body = beam, force = dim == 2 and { 0, -N } or { 0, 0, -N } }
  m:consolidate { rest = { ratio = 1e-6 }, grow = 0.1 }
  return m, block, beam
end

-- Rotation of the block in the plane of the push.
local function lean(block, dim) return math.abs(dim == 2 and block.rotation or block.rotation_y) end

local function push(dim, top, control)
  local m, block, beam = pier(dim)
  local start = dim == 2 and beam.y or beam.z
  local options = { body = beam, top = top, displacement = 0.004, samples = 100, control = control }
  if control ~= "arc" then options.rate = 4e-3 end
  local p = m:pushover(options)
  local force = p.force
  local a = lean(block, dim)
  local rise = (dim == 2 and beam.y or beam.z) - start
  return force, a, rise, m
end

for _, case in ipairs { { 2 }, { 2, "arc" }, { 3 } } do
  local dim, control = case[1], case[2]
  local force, a, rise = push(dim, "level", control)
  local c = math.sqrt(2*N/(kn*t*a))
  local name = ("dim %d, control %s"):format(dim, control or "time")
  near("level top, " .. name, force, N*(b - 2*c/3 - h*a)/h, 0.005)
  assert(rise > 0.4*b*a, "a level top rises")
  force, a, rise = push(dim, "locked", control)
  local e = (b*a - h*a^2/2)/2 + N/(kn*b*t)
  near("locked top, " .. name, force, kn*t*e^2/(2*a)*(b - 2*e/a/3 - h*a)/h, 0.005)
  assert(math.abs(rise) < 1e-12, "a locked top keeps its height")
  assert(force > 2*N*b/h, "the vertical force of a locked top has grown")
end

-- A free top turns: about half of the force of a level top. The default is free, with the same bits.
local free, _, _, m = push(2, "free")
local default = push(2)
assert(free == default)
assert(free < 0.6*push(2, "level"), "a free top carries half of the force of a level one")
refused("'top' is \"locked\", which holds the height of the pushed bodies, but the push is vertical", m.pushover, m,
  { body = "beam", top = "locked", direction = "-y", displacement = 1e-3 })
refused("free, level, locked", m.pushover, m, { body = "beam", top = "fixed", displacement = 1e-3 })

local soft = trilith.model { name = "soft" }
soft:material { name = "rubber", density = 1000, solid = trilith.linear_elastic { E = 1e8, nu = 0.3 } }
soft:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 1 } }
soft:block { name = "base", width = 2, height = 0.5, at = { -1, -0.5 }, material = "rubber", support = "fixed" }
soft:block { name = "pad", width = 1, height = 0.5, at = { -0.5, 0 }, material = "rubber", body = "quad" }
soft:consolidate { rest = { ratio = 1e-4 } }
refused("'top' holds the rotation of body 'pad'", soft.pushover, soft,
  { body = "pad", top = "level", displacement = 1e-3 })
