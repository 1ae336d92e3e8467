-- Natural frequencies on joints from soft to so stiff that the penetration is a nanometre: sqrt(kn A/m)/2 pi. Cases:
-- single blocks, tilted ones and a wall of two. Implicit steps and statics use the same stiffness.
local trilith = require "trilith"

local density, height, g = 2000, 0.8, 9.80665

-- One block, or a stack of two, on a fixed one; the model and gravity are tilted by an angle about y.
local function frequency(dim, kn, blocks, tilt)
  local s, c = math.sin(tilt), math.cos(tilt)
  local m = trilith.model { name = "joint", dim = dim, gravity = dim == 2 and { -g*s, -g*c } or { -g*s, 0, -g*c } }
  m:material { name = "s", density = density }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 0.7, beta = 1e-6 } }
  local function add(name, width, depth, tall, at, support)
    if dim == 2 then
      m:block { name = name, width = width, height = tall, at = { -width/2, at }, material = "s", support = support }
    else
      m:block { name = name, size = { width, depth, tall }, at = { -width/2, -depth/2, at }, material = "s",
        support = support }
    end
  end
  add("ground", 4, 4, 0.5, -0.5, "fixed")
  for i = 1, blocks do add("b" .. i, 1, 0.6, height, (i - 1)*height) end
  m:consolidate { integrator = "static" }
  local found
  local mass = density*height*(dim == 2 and 1 or 0.6)*blocks
  for _, mode in ipairs(m:modes { count = 6*blocks }) do
    if (dim == 2 and mode.mass_y or mode.mass_z) > 0.5*mass then found = mode.frequency end
  end
  m:close()
  return found
end

-- Two equal masses on two equal springs: the lowest root of x^2 - 3 x + 1.
local share = { 1, math.sqrt((3 - math.sqrt(5))/2) }
for _, dim in ipairs { 2, 3 } do
  for _, kn in ipairs { 1e10, 1e12, 1e13 } do
    for blocks = 1, 2 do
      for _, tilt in ipairs { 0, 0.2 } do
        local expected = share[blocks]*math.sqrt(kn/(density*height))/(2*math.pi)
        local found = frequency(dim, kn, blocks, tilt)
        assert(found and math.abs(found/expected - 1) < 1e-3, ("%dD, kn %g, %d blocks, tilt %g: %s Hz for %g Hz")
          :format(dim, kn, blocks, tilt, tostring(found), expected))
      end
    end
  end
end
