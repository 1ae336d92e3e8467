-- A rigid body with a crack plane is pressed, and then pulled or bent for a moment. It cracks where its strength is
-- exceeded, however short the moment is compared with the steps, and not below.
local trilith = require "trilith"
local size, long, strength = 0.1, 0.4, 3e6
local capacity = strength*size*size

-- A rod without gravity, pressed at both ends by `pressed`; for 2 ms from 0.02 s on, `pulse` replaces it.
local function cracks(pressed, pulse, bent)
  local m = trilith.model { name = "rod", gravity = 0, thickness = size }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.bonded { name = "stone", kn = 1e10, ks = 1e10, mu = 0.6,
    tension = strength, cohesion = 1.5*strength } }
  m:block { name = "rod", width = long, height = size, at = { 0, 0 }, material = "stone", floating = true,
    cracks = "mid", crack_law = "stone" }
  local function curve(value) return { { 0, pressed }, { 0.02, pressed }, { 0.0201, value }, { 0.0219, value },
    { 0.022, pressed } } end
  m:point_load { name = "left", body = "rod", at = { 0, size/2 }, force = { 1, 0 }, load_curve = curve(-pulse) }
  m:point_load { name = "right", body = "rod", at = { long, size/2 }, force = { -1, 0 }, load_curve = curve(-pulse) }
  if bent then
    local moment = { { 0, 0 }, { 0.02, 0 }, { 0.0201, bent }, { 0.0219, bent }, { 0.022, 0 } }
    for _, one in ipairs { { 0, 1 }, { 0.5*long - 0.01, -1 }, { 0.5*long + 0.01, -1 }, { long, 1 } } do
      m:point_load { body = "rod", at = { one[1], 0 }, force = { 0, one[2] }, load_curve = moment }
    end
  end
  local count = 0
  m:on("unit.cracked", function() count = count + 1 end)
  m:run { duration = 0.03, dt = 1e-4 }
  m:close()
  return count
end

for _, pressed in ipairs { 0, 0.1*capacity, 2*capacity, 20*capacity } do
  for _, share in ipairs { 0.98, 1.02, 3 } do
    local found = cracks(pressed, share*capacity)
    assert(found == (share > 1 and 1 or 0), ("pressed by %g of its capacity and pulled by %g, the rod cracks %d times")
      :format(pressed/capacity, share, found))
  end
  -- The moment of the loads about the middle over the section modulus is the stress, and the pressure takes its part.
  local lever, modulus = 0.5*long - 0.01, size^3/6
  for _, share in ipairs { 0.97, 1.03 } do
    local bent = share*(strength + pressed/size^2)*modulus/lever
    local found = cracks(pressed, -pressed, bent)
    assert(found == (share > 1 and 1 or 0), ("pressed by %g of its capacity and bent by %g, the rod cracks %d times")
      :format(pressed/capacity, share, found))
  end
end
