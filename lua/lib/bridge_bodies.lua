-- Bodies of a bridge in space: polyhedra of supports and decks, members of bents and of grillages.
local _, core = ...
local body_words = core.bridge_rules.body_words
local portable = core.module.math
local standard_gravity = 9.80665 -- [m/s2], for weights in messages

--- The convex solid between two lines x = place - slope y, each { place, slope }, from y0 to y1 and from z0 to z1.
local function solid(a, b, y0, y1, z0, z1)
  local hull = {}
  for _, line in ipairs { a, b } do
    for _, y in ipairs { y0, y1 } do
      for _, z in ipairs { z0, z1 } do hull[#hull + 1] = { line[1] - line[2]*y, y, z } end
    end
  end
  return { hull = hull }
end

--- The body keys of a row, together with the values of the builder.
local function described(row, group, more)
  for _, key in ipairs(body_words) do more[key] = row[key] end
  local given = row.groups
  if given == nil then
    more.groups = { group }
  elseif type(given) == "table" then
    more.groups = table.move(given, 1, #given, 2, { group })
  elseif type(given) == "string" then
    more.groups = { group, given }
  end
  more.name, more.support = row.name, row.support
  return more
end

--- From the face of the back wall to the edge of the seat, and on to the abutment's back.
local function abutment_places(s, way)
  local face, front = s.x - way*0.5*s.gap, s.x + way*(0.5*s.gap + s.seat)
  return face, front, front - way*s.width
end

local function add_keys(s, pieces, a, b)
  local key = s.shear_key
  if not key or key.law then return end
  for _, out in ipairs { -1, 1 } do
    pieces[#pieces + 1] = solid(a, b, out*key.from, out*(key.from + key.breadth), s.top, s.top + key.height)
  end
end

local function add_abutment(model, plan, s, way)
  local half = 0.5*s.breadth
  local face, front, back = abutment_places(s, way)
  face, front, back = { face, s.slope }, { front, s.slope }, { back, s.slope }
  local pieces = { solid(front, back, -half, half, s.bottom, s.top) }
  if s.back_wall_height > 0 then
    pieces[2] = solid(face, back, -half, half, s.top, plan.bridge.soffit_level + s.back_wall_height)
  end
  add_keys(s, pieces, face, front)
  return model:body(described(s, "abutments", { pieces = pieces }))
end

local function column_places(s)
  local places = {}
  for k = 1, s.columns do places[k] = (k - 0.5*(s.columns + 1))*(s.column_spacing or 0) end
  return places
end

--- Footing, wall or columns, cap. A wall without a cap widens evenly to the length of its top.
local function add_pier(model, s)
  local reach, half = 0.5*s.gap + s.seat, 0.5*s.breadth
  local stem, foot, cap = 0.5*(s.stem_width or 2*reach), s.bottom + s.footing_thickness, s.top - s.cap_thickness
  local function lines(r) return { s.x - r, s.slope }, { s.x + r, s.slope } end
  local pieces = {}
  local function add(r, y0, y1, z0, z1)
    local a, b = lines(r)
    pieces[#pieces + 1] = solid(a, b, y0, y1, z0, z1)
  end
  if s.footing_thickness > 0 then
    local broad = 0.5*(s.footing_breadth or s.breadth)
    add(0.5*s.footing_width, -broad, broad, s.bottom, foot)
  end
  if s.columns then
    for _, y in ipairs(column_places(s)) do add(stem, y - 0.5*s.column_breadth, y + 0.5*s.column_breadth, foot, cap) end
  elseif s.cap_thickness > 0 then
    local broad = 0.5*(s.stem_breadth or s.breadth)
    add(stem, -broad, broad, foot, cap)
  else
    add(stem, -0.5*(s.stem_breadth or s.breadth), 0.5*(s.stem_breadth or s.breadth), foot, cap)
    local hull = pieces[#pieces].hull
    for k = 2, 8, 2 do -- the corners at the top
      local y = hull[k][2] > 0 and half or -half
      hull[k] = { s.x + (k > 4 and reach or -reach) - s.slope*y, y, s.top }
    end
  end
  if s.cap_thickness > 0 then add(reach, -half, half, cap, s.top) end
  local a, b = lines(reach)
  add_keys(s, pieces, a, b)
  return model:body(described(s, "piers", { pieces = pieces }))
end

--- Positions of the joints of a cap: over columns, at its ends, and under girders that are not close to one of these.
local function cap_places(plan, s, columns)
  local at = table.move(columns, 1, #columns, 1, {})
  local function add(y, close)
    for _, other in ipairs(at) do
      if math.abs(other - y) <= close then return end
    end
    at[#at + 1] = y
  end
  for _, y in ipairs { -0.5*s.breadth, 0.5*s.breadth } do add(y, 1e-6) end
  for _, line in ipairs(plan.lines) do add(line.y, 0.5*s.cap_thickness) end -- short deep beams would require short
                                                                            -- steps
  table.sort(at)
  return at
end

--- A bent of members: columns up to the axis of the cap, whose joints are at its ends, over columns and under girders.
local function add_bent(model, plan, s)
  local cosine, reach = portable.cos(s.skew), 0.5*s.gap + s.seat
  local section = s.cap_section or core.module.rectangle_section { width = 2*reach*cosine, depth = s.cap_thickness }
  local axis, foot = s.top - section.above, s.bottom + s.footing_thickness
  local columns, joints, members = column_places(s), {}, {}
  local at = cap_places(plan, s, columns)
  local function joint_at(y)
    for k, other in ipairs(at) do
      if math.abs(other - y) <= 1e-6 then return "cap" .. k end
    end
  end
  for k, y in ipairs(at) do
    joints["cap" .. k] = { s.x - s.slope*y, y, axis }
    if k > 1 then
      members[#members + 1] = { name = "cap" .. k - 1, from = "cap" .. k - 1, to = "cap" .. k, section = section,
        divisions = 1 }
    end
  end
  s.feet = {}
  local mass = s.footing_weight/standard_gravity/#columns
  local share = (s.footing_breadth or s.breadth)/#columns -- of a flat footing
  local inertia = mass*(s.footing_width*s.footing_width + share*share)/12
  for k, y in ipairs(columns) do
    s.feet[k] = { s.x - s.slope*y, y, foot }
    joints["foot" .. k] = s.foundation and { at = s.feet[k], mass = mass, inertia = inertia } or { at = s.feet[k],
      support = "fixed" }
    members[#members + 1] = { name = "column" .. k, from = "foot" .. k, to = joint_at(y), section = s.section,
      divisions = s.divisions, orientation = { portable.cos(s.skew), portable.sin(s.skew), 0 } }
  end
  local words = described(s, "piers", { joints = joints, members = members })
  words.support = nil
  words.floating = true
  return model:frame(words)
end

--- Positions of diaphragms as shares of the distance from the left end to the right one.
local function shares(count)
  local out = {}
  for k = 1, count do out[k] = count == 1 and 0.5 or (k - 1)/(count - 1) end
  return out
end

local function add_solid_deck(model, plan, v)
  local z, left, right = plan.bridge.soffit_level, v.ends[1], v.ends[2]
  local a, b = { left.x, left.support.slope }, { right.x, right.support.slope }
  local pieces, broad = { solid(a, b, -plan.half, plan.half, z + v.under, z + v.depth) }, 0.5*plan.girder
  if v.slab then
    for _, line in ipairs(plan.lines) do pieces[#pieces + 1] = solid(a, b, line.y - broad, line.y + broad, z,
      z + v.under) end
  end
  local d = v.diaphragm
  for _, share in ipairs(d and shares(d.count) or {}) do
    -- Its middle keeps half a thickness from both ends, so that the outer ones end with the deck.
    local x = a[1] + 0.5*d.thickness + share*(b[1] - a[1] - d.thickness)
    local slope = a[2] + share*(b[2] - a[2])
    for k = 1, #plan.lines - 1 do
      pieces[#pieces + 1] = solid({ x - 0.5*d.thickness, slope }, { x + 0.5*d.thickness, slope },
        plan.lines[k].y + broad,
        plan.lines[k + 1].y - broad, z + v.under - d.depth, z + v.under)
    end
  end
  return model:body(described(v, "spans", { pieces = pieces }))
end

--- A grillage: a member on each girder line from end to end of the deck, and cross beams between the lines. The outer
--- cross beams are a girder's depth from the ends, because short deep beams would require short steps. Rigid arms
--- connect the bearings to the nearest nodes.
local function add_grillage(model, plan, v)
  local z, d, inset = plan.bridge.soffit_level + v.section.below, v.diaphragm, v.section.depth
  local joints, members = {}, {}
  local across = shares(d and d.count or 0)
  for _, line in ipairs(plan.lines) do
    local function on(e) return e.x + e.way*e.set_back - e.support.slope*line.y end
    local from, to, names = on(v.ends[1]), on(v.ends[2]), { "a" }
    joints[line.name .. ".a"], joints[line.name .. ".b"] = { from, line.y, z }, { to, line.y, z }
    for k, share in ipairs(across) do
      names[#names + 1] = "d" .. k
      joints[line.name .. ".d" .. k] = { from + inset + share*(to - from - 2*inset), line.y, z }
    end
    names[#names + 1] = "b"
    for k = 2, #names do
      members[#members + 1] = { name = ("%s.%d"):format(line.name, k - 1), from = line.name .. "." .. names[k - 1],
        to = line.name .. "." .. names[k], section = v.section,
        divisions = (#across > 1 and (k == 2 or k == #names)) and 1 or v.divisions }
    end
  end
  for k in ipairs(across) do
    for j = 1, #plan.lines - 1 do
      members[#members + 1] = { name = ("diaphragm%d.%d"):format(k, j), from = ("%s.d%d"):format(plan.lines[j].name, k),
        to = ("%s.d%d"):format(plan.lines[j + 1].name, k), section = d.section, divisions = 2 }
    end
  end
  return model:frame(described(v, "spans", { joints = joints, members = members }))
end

--- The bodies of supports and decks, in `made` by the rows of the plan.
function core.bridge_bodies(model, plan)
  local made = { supports = {}, spans = {} }
  for i, s in ipairs(plan.supports) do
    made.supports[i] = s.section and add_bent(model, plan, s) or s.kind == "pier" and add_pier(model, s)
      or add_abutment(model, plan, s, i == 1 and 1 or -1)
  end
  for i, v in ipairs(plan.spans) do
    if v.weight_per_length then v.weight = v.weight_per_length*v.clear end
    made.spans[i] = (v.section and add_grillage or add_solid_deck)(model, plan, v)
  end
  return made
end

core.bridge_places = { abutment = abutment_places, solid = solid }
