-- A pushover whose anchor breaks right after the peak: the released energy does not count as inertia at the peak.
--
-- A cart is pushed against a spring, behind which a light block is held by an anchor. The anchor breaks at its limit,
-- and the block springs back within a few milliseconds, less than a sample of the curve.
local trilith = require "trilith"

local spring, anchor, limit = 1e6, 2e6, 0.005 -- [N/m], [N/m], [m]

local function pushed(dim, rate)
  local m = trilith.model { dim = dim, gravity = 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  local function block(name, x, size, support)
    local keys = { name = name, material = "steel", support = support }
    if dim == 3 then
      keys.size, keys.at = { size, size, size }, { x, 0, 0 }
    else
      keys.width, keys.height, keys.at, keys.body_thickness = size, size, { x, 0 }, size
    end
    return m:block(keys)
  end
  local cart, light = block("cart", 0, 0.1), block("light", 0.15, 0.08)
  block("wall", 0.28, 0.1, "fixed")
  -- Only the horizontal direction moves; the others have stiff springs.
  local function link(name, one, other, x, stiffness, most)
    local stiff = trilith.linear { stiffness = 1e7, damping = 1e3 }
    local keys = { name = name, between = { one, other }, at = dim == 3 and { x, 0.04, 0.04 } or { x, 0.04 },
      along = trilith.linear { stiffness = stiffness, damping = 1000 }, axial = stiff,
      limit = most and { along = most } }
    if dim == 3 then
      keys.across, keys.turning_along, keys.turning_across, keys.turning_axial = stiff, stiff, stiff, stiff
    else
      keys.turning = stiff
    end
    m:bearing(keys)
  end
  link("spring", "cart", "light", 0.125, spring)
  link("anchor", "light", "wall", 0.255, anchor, limit)
  local broken = false
  m:on("bearing.failed", function() broken = true end)
  local push = m:pushover { body = cart, direction = "x", displacement = 0.02, rate = rate }
  assert(broken and light, "the anchor did not break")
  return push
end

for _, dim in ipairs { 2, 3 } do
  local push, force = pushed(dim, 0.01), anchor*limit
  assert(math.abs(push.peak_force - force) < 0.01*force, push.peak_force)
  assert(math.abs(push.displacement_at_peak - (limit + force/spring)) < 1e-4, push.displacement_at_peak)
  assert(push.quasi_static and math.abs(push.carried_at_peak - force) <= 0.02*force,
    ("dim %d: %g N carried of %g N"):format(dim, push.carried_at_peak, push.peak_force))
end
