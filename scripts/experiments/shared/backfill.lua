-- Fill over an arch: its weight on the voussoirs, and the passive pressure of the soil against voussoirs that move
-- into it. In the plane; pressures act along x on the height of each voussoir's back.
local trilith = require "trilith"

-- Horizontal pressure [Pa] at a depth: passive (by the share), at rest (Jaky 1944) and active (Rankine 1857).
local function pressures(s, depth)
  local tan, sin = trilith.math.tan, trilith.math.sin
  local root = tan(math.pi/4 + s.friction_angle/2) -- of Rankine's passive coefficient
  local passive = s.passive*(root^2*s.unit_weight*depth + 2*(s.cohesion or 0)*root)
  if not s.at_rest then return passive, 0, 0 end
  local rest = (1 - sin(s.friction_angle))*s.unit_weight*depth
  local active = math.max(0, s.unit_weight*depth/root^2 - 2*(s.cohesion or 0)/root)
  return math.max(passive, rest), rest, math.min(active, rest)
end

-- Table of a force [N] over the displacement [m] into the soil, which is along `way`: from `back` at `-retreat` to
-- `front` at `move`.
local function resistance(way, retreat, back, move, front)
  local far = 10
  local points = { { -far, back }, { -retreat, back }, { 0, 0 }, { move, front }, { far, front } }
  if retreat == 0 then points = { { -far, 0 }, { 0, 0 }, { move, front }, { far, front } } end
  if way < 0 then
    local turned = {}
    for i = #points, 1, -1 do turned[#turned + 1] = { -points[i][1], -points[i][2] } end
    points = turned
  end
  for i = 2, #points do -- forces rise, if only by rounding
    if points[i][2] <= points[i - 1][2] then points[i][2] = points[i - 1][2] + 1e-6*math.abs(points[i - 1][2]) end
  end
  return trilith.table { points = points }
end

-- Soil against one voussoir: pressure along x, and friction on its back against its rise.
local function support(m, s, i, body, back)
  local x, y = (back.x0 + back.x1)/2, (back.y0 + back.y1)/2
  local way = x < s.middle and -1 or 1 -- direction into the soil
  local depth, area = s.top - y, math.abs(back.y1 - back.y0)*s.width
  local passive, rest, active = pressures(s, depth)
  local move = s.mobilised*math.max(depth, 0.1)
  if rest > 0 then m:point_load { body = body, at = { x, y }, force = { -way*rest*area, 0 } } end
  local friction = s.wall_friction and s.wall_friction > 0 and trilith.math.tan(s.wall_friction)*passive*area
  m:bearing { name = "soil" .. i, between = { "soil", body }, from = { -29.9, y }, to = { x, y }, arm = 60,
    along = resistance(way, rest > 0 and 0.1*move or 0, (active - rest)*area, move, (passive - rest)*area),
    axial = friction and resistance(1, 0, 0, move, friction) or nil }
end

--- Adds the fill to the voussoirs `bodies`, in order. Returns its weight [N]. The table s has `top` (y of the surface),
--- `middle` (x of the crown), `width` [m], `unit_weight` [N/m3] and `friction_angle` [rad]. `backs` has the ends of the
--- back of each voussoir. `passive` is the share of Rankine's passive coefficient; 0 leaves the weight alone.
--- `cohesion` [Pa] adds twice its product with the root of the coefficient to the pressure, by the same share.
--- `mobilised` is the displacement at which the pressure is reached, over the depth below the surface. `at_rest` begins
--- with the pressure at rest, which falls to the active one within a tenth of that displacement where the back recedes.
--- `wall_friction` [rad] is the angle of friction on the back: the passive force times its tangent resists the rise of
--- a voussoir, within the same displacement.
return function(m, bodies, s)
  if s.passive > 0 then
    m:block { name = "soil", width = 0.2, height = 0.2, at = { -30, 0 }, material = s.material, support = "fixed" }
  end
  local total = 0
  for i, body in ipairs(bodies) do
    local ends = s.backs[i] -- ends of the back of the voussoir: { x, y } left and right
    local back = { x0 = ends[1][1], y0 = ends[1][2], x1 = ends[2][1], y1 = ends[2][2] }
    local depth = s.top - (back.y0 + back.y1)/2
    local weight = s.unit_weight*depth*math.abs(back.x1 - back.x0)*s.width
    total = total + weight
    m:point_load { body = body, at = { (back.x0 + back.x1)/2, (back.y0 + back.y1)/2 }, force = { 0, -weight } }
    if s.passive > 0 and math.abs(back.y1 - back.y0) > 1e-3 then support(m, s, i, body, back) end
  end
  return total
end
