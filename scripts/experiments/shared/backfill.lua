-- Fill over an arch: its weight on the voussoirs, and the passive pressure of the soil against voussoirs that move
-- into it. In the plane; pressures act along x on the height of each voussoir's back.
local trilith = require "trilith"

--- Adds the fill to the voussoirs `bodies`, in order. Returns its weight [N]. The table s has `top` (y of the surface),
--- `middle` (x of the crown), `width` [m], `unit_weight` [N/m3] and `friction_angle` [rad]. `backs` has the ends of the
--- back of each voussoir. `passive` is the share of Rankine's passive coefficient; 0 leaves the weight alone.
--- `cohesion` [Pa] adds twice its product with the root of the coefficient to the pressure, by the same share.
--- `mobilised` is the displacement at which the pressure is reached, over the depth below the surface.
return function(m, bodies, s)
  local tan = trilith.math.tan
  local root = tan(math.pi/4 + s.friction_angle/2) -- of Rankine's coefficient
  local function pressure(depth) return s.passive*(root^2*s.unit_weight*depth + 2*(s.cohesion or 0)*root) end
  if s.passive > 0 then
    m:block { name = "soil", width = 0.2, height = 0.2, at = { -30, 0 }, material = s.material, support = "fixed" }
  end
  local total = 0
  for i, body in ipairs(bodies) do
    local back = s.backs[i] -- ends of the back of the voussoir: { x, y } left and right
    local x0, y0, x1, y1 = back[1][1], back[1][2], back[2][1], back[2][2]
    local depth = s.top - (y0 + y1)/2
    local weight = s.unit_weight*depth*math.abs(x1 - x0)*s.width
    total = total + weight
    m:point_load { body = body, at = { (x0 + x1)/2, (y0 + y1)/2 }, force = { 0, -weight } }
    local height = math.abs(y1 - y0)
    if s.passive > 0 and height > 1e-3 then
      local force = pressure(depth)*height*s.width
      local way = (x0 + x1)/2 < s.middle and -1 or 1 -- direction into the soil
      local far = 10
      local move = s.mobilised*math.max(depth, 0.1)
      local points = way > 0 and { { -far, 0 }, { 0, 0 }, { move, force }, { far, force*(1 + 1e-6) } }
        or { { -far, -force*(1 + 1e-6) }, { -move, -force }, { 0, 0 }, { far, 0 } }
      m:bearing { name = "soil" .. i, between = { "soil", body }, from = { -29.9, (y0 + y1)/2 },
        to = { (x0 + x1)/2, (y0 + y1)/2 }, arm = 60, along = trilith.table { points = points } }
    end
  end
  return total
end
