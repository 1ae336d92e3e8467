-- A rigid body with a crack plane is pressed, and then pulled or bent for a moment. It cracks where its strength is
-- exceeded, however short the moment is compared with the steps, and not below.
local trilith = require "trilith"
local size, long, strength = 0.1, 0.4, 3e6
local capacity = strength*size*size

-- A rod without gravity, pressed at both ends by `pressed`. For 2 ms from 0.02 s on it is pulled by `pulled` and bent
-- by four forces `bent`.
local function cracks(dim, pressed, pulled, bent)
  local m = trilith.model { name = "rod", dim = dim, gravity = 0, thickness = dim == 2 and size or nil }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.bonded { name = "stone", kn = 1e10, ks = 1e10, mu = 0.6,
    tension = strength, cohesion = 1.5*strength } }
  local flat = dim == 2
  m:block { name = "rod", width = flat and long or nil, height = flat and size or nil, material = "stone",
    size = not flat and { long, size, size } or nil, at = flat and { 0, 0 } or { 0, 0, 0 }, floating = true,
    cracks = "mid", crack_law = "stone" }
  local function push(x, height, along, up, curve)
    m:point_load { body = "rod", at = flat and { x, height } or { x, 0.5*size, height },
      force = flat and { along, up } or { along, 0, up }, load_curve = curve }
  end
  local function curve(before, value)
    return { { 0, before }, { 0.02, before }, { 0.0201, value }, { 0.0219, value }, { 0.022, before } }
  end
  push(0, 0.5*size, 1, 0, curve(pressed, -pulled))
  push(long, 0.5*size, -1, 0, curve(pressed, -pulled))
  for _, one in ipairs { { 0, 1 }, { 0.5*long - 0.01, -1 }, { 0.5*long + 0.01, -1 }, { long, 1 } } do
    push(one[1], 0, 0, one[2], curve(0, bent))
  end
  local count = 0
  m:on("unit.cracked", function()
    count = count + 1
    m:stop()
  end)
  m:run { duration = 0.03, dt = 1e-4 }
  m:close()
  return count
end

for _, dim in ipairs { 2, 3 } do
  for _, pressed in ipairs { 0, 0.1*capacity, 2*capacity, 20*capacity } do
    local words = ("in %d dimensions, pressed by %g of its capacity"):format(dim, pressed/capacity)
    for _, share in ipairs { 0.98, 1.02, 3 } do
      local found = cracks(dim, pressed, share*capacity, 0)
      assert(found == (share > 1 and 1 or 0),
        ("%s and pulled by %g, the rod cracks %d times"):format(words, share, found))
    end
    -- The moment about the middle over the section modulus is the stress; the pressure takes its part.
    local lever, modulus = 0.5*long - 0.01, size^3/6
    for _, share in ipairs { 0.97, 1.03 } do
      local found = cracks(dim, pressed, -pressed, share*(strength + pressed/size^2)*modulus/lever)
      assert(found == (share > 1 and 1 or 0),
        ("%s and bent by %g, the rod cracks %d times"):format(words, share, found))
    end
  end
end
