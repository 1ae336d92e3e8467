-- Plan of a bridge in space, computed from its tables before any body is made: positions of girder lines, axes, joints,
-- seats and bearings. x is along the bridge, y across it to the left, z up. A joint with the skew s lies at x = axis -
-- tan(s) y, and so do the edges of its seats; lengths along the bridge are equal on all girder lines.
local _, core = ...
local read, fail, what_is = core.bridge_rules.read, core.bridge_rules.fail, core.bridge_rules.what_is

local function tangent(angle) return core.module.math.sin(angle)/core.module.math.cos(angle) end

local function owner_of(kind, row, i)
  if type(row) ~= "table" then fail("bridge", "%s %d is %s, must be a table", kind, i, what_is(row)) end
  local name = row.name
  return type(name) == "string" and not name:find "%c" and ("%s '%s'"):format(kind, name)
    or ("bridge: %s %d"):format(kind, i)
end

--- Girder lines from right to left: { name, y }, and the width of a girder.
local function girder_lines(given, half)
  local owner, lines = "bridge: girders", {}
  local g = read("girders", owner, given)
  if g.at and (g.count or g.spacing) then fail(owner, "both at and count or spacing are given; keep one") end
  if not g.at and not g.count then
    fail(owner, "'count' is missing; give count and spacing, or the places at = { y, ... }")
  end
  if g.count and g.count > 1 and not g.spacing then fail(owner, "'spacing' is missing; give a number in m") end
  for k = 1, g.count or #g.at do
    local y = g.at and g.at[k] or g.count and (k - 0.5*(g.count + 1))*(g.spacing or 0)
    if type(y) ~= "number" or y ~= y or math.abs(y) == math.huge then
      fail(owner, "place %d of 'at' is %s, must be a finite number in m", k, what_is(y))
    end
    if k > 1 and y - lines[k - 1].y <= g.breadth then
      fail(owner, "lines %d and %d at y = %g and %g m are not farther apart than the breadth of a girder, %g m; they "
        .. "are given"
        .. " from right to"
        .. " left", k - 1, k, lines[k - 1].y, y, g.breadth)
    end
    if math.abs(y) + 0.5*g.breadth > half + 1e-9 then
      fail(owner, "line %d at y = %g m with a girder %g m broad reaches beyond the deck, which is %g m broad", k, y,
        g.breadth,
        2*half)
    end
    lines[k] = { name = "g" .. k, y = y }
  end
  return lines, g.breadth
end

local function shear_key_of(owner, given)
  if not given then return nil end
  owner = owner .. ": shear_key"
  local key = read("shear_key", owner, given)
  for _, name in ipairs { "gap", "height", "breadth" } do
    if key.law and key[name] then
      fail(owner, "'%s' is for a solid key, and law is for a bearing; keep one", name)
    end
    if not key.law and not key[name] then
      fail(owner, "'%s' is missing; give gap, height and breadth, or a law", name)
    end
  end
  if key.limit and not key.law then fail(owner, "'limit' is given, but no law to which it applies; give law") end
  return key
end

local foundation_laws = { "along", "across", "horizontal", "axial", "turning_along", "turning_across", "turning_axial" }

local function foundation_of(owner, given)
  if not given then return nil end
  owner = owner .. ": foundation"
  local found, any = read("foundation", owner, given), nil
  for _, name in ipairs(foundation_laws) do any = any or found[name] and name end
  for _, name in ipairs { "limit", "becomes" } do any = any or found.soil and found[name] and name end
  if found.soil and any then fail(owner, "both soil and '%s' are given; keep one", any) end
  if found.limit and not found.becomes then
    fail(owner, "'limit' is given, but no contact law for afterwards; give becomes")
  end
  if not found.soil and not any then fail(owner, "gives neither soil nor a law; give soil, the shear modulus in Pa") end
  return found
end

--- Checks a bent, whose columns carry the seats by a cap.
local function check_columns(owner, v)
  if v.columns > 1 and not v.column_spacing then fail(owner, "'column_spacing' is missing; give a number in m") end
  if v.cap_thickness == 0 then fail(owner, "'cap_thickness' is missing: columns carry the seats by a cap") end
  if v.stem_breadth then fail(owner, "'stem_breadth' is for walls; for columns give column_breadth") end
  if not v.section and not v.column_breadth then fail(owner, "'column_breadth' is missing; give a number in m") end
  local reach = 0.5*(v.columns - 1)*(v.column_spacing or 0) + 0.5*(v.column_breadth or 0)
  if reach > 0.5*v.breadth + 1e-9 then
    fail(owner, "columns stand up to %g m from the middle, beyond the cap, whose breadth is %g m", reach, v.breadth)
  end
  if v.foundation and v.columns > 1 and v.footing_thickness == 0 then
    fail(owner, "columns stand on their foundation by a footing; give footing_width and footing_thickness")
  end
end

--- Checks a bent whose columns are members.
local function check_members(owner, v)
  if v.shear_key and not v.shear_key.law then
    fail(owner, "a solid shear key needs a rigid cap; on a cap of members give shear_key = { law = }")
  end
  if v.foundation and v.footing_weight == 0 then
    fail(owner, "'footing_weight' is missing: feet on springs of the ground need the mass of a footing; give a"
      .. " number in N")
  end
  if v.support ~= nil then
    fail(owner, "'support': feet of members are fixed where there is no foundation; leave it out")
  end
end

local function check_pier(owner, v)
  if (v.footing_width > 0) ~= (v.footing_thickness > 0) then
    fail(owner, "footing is %g m wide and %g m thick; give both or neither", v.footing_width, v.footing_thickness)
  end
  local stem = v.stem_width or not v.section and v.gap + 2*v.seat or 0
  if v.footing_width > 0 and v.footing_width < stem then
    fail(owner, "footing width is %g m, must not be below the stem width of %g m", v.footing_width, stem)
  end
  for _, key in ipairs { "column_spacing", "column_breadth", "section" } do
    if v[key] and not v.columns then fail(owner, "'%s' is given, but no columns; give how many", key) end
  end
  for _, key in ipairs { "cap_section", v.footing_weight > 0 and "footing_weight" or nil } do
    if v[key] and not v.section then fail(owner, "'%s' is for a bent of members, with section; leave it out", key) end
  end
  if v.columns then check_columns(owner, v) end
  if v.section then check_members(owner, v) end
  if v.footing_thickness + v.cap_thickness >= v.height - v.rise then
    fail(owner, "height is %g m, must be above footing, cap and bearings together, %g m", v.height,
      v.footing_thickness + v.cap_thickness + v.rise)
  end
end

--- Height of the bearings at both sides of a support: all are equal, because its top is level.
local function rise_of(plan, i, owner)
  local rise
  for _, at in ipairs { { i - 1, 2 }, { i, 1 } } do
    for _, kind in ipairs(plan.spans[at[1]] and plan.spans[at[1]].types[at[2]] or {}) do
      if rise and math.abs(kind.height - rise) > 1e-9 then
        fail(owner, "bearings %g and %g m high sit on its top, which is level; make them equally high", rise,
          kind.height)
      end
      rise = kind.height
    end
  end
  return rise
end

local function read_support(plan, options, i)
  local is_pier = i > 1 and i < #options.supports
  local kind, row = is_pier and "pier" or "abutment", options.supports[i]
  local owner = owner_of(kind, row, i)
  local b = plan.bridge
  local v = read(kind, owner, row, b[kind], { gap = b.gap, seat = b.seat, skew = b.skew, material = b.material,
    breadth = b.breadth })
  for _, key in ipairs { "gap", "seat" } do
    if not v[key] then fail(owner, "'%s' is missing; give a number in m, there or for the whole bridge", key) end
  end
  v.owner, v.kind, v.name = owner, kind, v.name or (is_pier and "P" or "A") .. i - 1
  v.slope, v.rise = tangent(v.skew), rise_of(plan, i, owner)
  v.top, v.bottom = b.soffit_level - v.rise, b.soffit_level - v.height
  v.shear_key, v.foundation = shear_key_of(owner, v.shear_key), foundation_of(owner, v.foundation)
  if is_pier then check_pier(owner, v) end
  if not is_pier and v.width <= v.gap + v.seat then
    fail(owner, "width is %g m, must be above seat and joint together, %g m", v.width, v.gap + v.seat)
  end
  if v.top <= v.bottom then fail(owner, "height is %g m, must be above the bearings' %g m", v.height, v.rise) end
  for _, line in ipairs(plan.lines) do
    if math.abs(line.y) >= 0.5*v.breadth then
      fail(owner, "breadth is %g m, so that the girder line at y = %g m has no seat on it", v.breadth, line.y)
    end
  end
  if v.ground == nil then v.ground = b.ground end
  if v.foundation and v.ground == nil then
    fail(owner, "has a foundation, but no ground under it; give ground = {} or the name of a body")
  end
  if v.ground ~= nil and v.support ~= nil then fail(owner, "both ground and support are given; keep one") end
  return v
end

--- Types of bearings at one end, { name, height } for each girder line.
local function types_at(model, owner, side, given, lines)
  local types = {}
  if type(given) == "table" and #given ~= #lines then
    fail(owner, "%s names %d types of bearings for %d girder lines; give one for each, or one for all", side, #given,
      #lines)
  end
  for k in ipairs(lines) do
    local name = given
    if type(given) == "table" then name = given[k] end
    types[k] = { name = name, height = core.bearing_height(model, name, ("%s: %s"):format(owner, side)) }
  end
  return types
end

local function check_deck(owner, v)
  if v.section then
    for _, key in ipairs { "depth", "slab" } do
      if v[key] then fail(owner, "'%s' is given in addition to section, for girders of members; leave it out", key) end
    end
  elseif not v.depth then
    fail(owner, "'depth' is missing; give a number in m, or the section of its girders")
  elseif v.slab and v.slab >= v.depth then
    fail(owner, "slab is %g m, must be below the depth of %g m", v.slab, v.depth)
  end
  for _, key in ipairs { "density", "unit_weight", "mass", "weight" } do
    if v.weight_per_length and v[key] then fail(owner, "both weight_per_length and %s are given; keep one", key) end
  end
end

local function diaphragm_of(owner, v, lines)
  if not v.diaphragm then return nil end
  owner = owner .. ": diaphragm"
  local d = read("diaphragm", owner, v.diaphragm)
  local of_members = v.section ~= nil
  if #lines < 2 then fail(owner, "is between girders, but there is only one line; leave it out") end
  if of_members and not d.section then fail(owner, "'section' is missing: the girders are members") end
  if of_members and (d.thickness or d.depth) then
    fail(owner, "thickness or depth is given in addition to section; leave it out")
  end
  if not of_members and d.section then fail(owner, "'section' is for girders that are members; give thickness") end
  if not of_members and not v.slab then fail(owner, "the deck is solid; give the slab on its girders") end
  if not of_members and not d.thickness then fail(owner, "'thickness' is missing; give a number in m") end
  d.depth = d.depth or not of_members and 0.75*(v.depth - v.slab)
  if not of_members and d.depth > v.depth - v.slab then
    fail(owner, "depth is %g m, must not be above the girders' %g m under the slab", d.depth, v.depth - v.slab)
  end
  return d
end

local function read_span(model, plan, options, i)
  local row = options.spans[i]
  local owner = owner_of("span", row, i)
  local v = read("span", owner, row, plan.bridge.span, { material = plan.bridge.material })
  v.owner, v.name = owner, v.name or "S" .. i
  check_deck(owner, v)
  v.diaphragm = diaphragm_of(owner, v, plan.lines)
  v.types = { types_at(model, owner, "left", v.left, plan.lines), types_at(model, owner, "right", v.right, plan.lines) }
  v.under = v.depth and (v.depth - (v.slab or v.depth))
  return v
end

--- The ends of a span: positions on the line y = 0, and the direction from each end into the span.
local function lay_span(plan, i)
  local v = plan.spans[i]
  v.ends = {}
  for side = 1, 2 do
    local s, way = plan.supports[i + side - 1], side == 1 and 1 or -1
    local x = s.x + way*0.5*s.gap
    -- Girders as members end square: at a skewed joint their corners keep half of the joint.
    local set_back = v.section and 0.5*plan.girder*math.abs(s.slope) or 0
    v.ends[side] = { support = s, way = way, x = x, set_back = set_back, edge = x + way*s.seat,
      bearing = x + way*0.5*s.seat,
      name = ("%s.%s"):format(v.name, side == 1 and "left" or "right") }
  end
  local seats = v.ends[1].support.seat + v.ends[2].support.seat
  for _, y in ipairs { -plan.half, plan.half } do
    local length = v.ends[2].x - v.ends[2].support.slope*y - (v.ends[1].x - v.ends[1].support.slope*y)
    if length <= seats then
      fail(v.owner, "at y = %g m the joints leave %g m of deck, which must be above the %g m of both seats", y,
        length, seats)
    end
  end
  v.clear = v.ends[2].x - v.ends[1].x
  local slopes = math.abs(v.ends[1].support.slope) + math.abs(v.ends[2].support.slope)
  local shortest = v.clear - slopes*(plan.half + 0.5*plan.girder)
  if v.section and v.diaphragm and shortest <= 2*v.section.depth then
    fail(v.owner, "its girders are %g m long, which leaves no room for diaphragms a depth of %g m from both ends",
      shortest, v.section.depth)
  end
end

--- Solid keys are next to the supported part of the deck: girders under a slab above the keys, or the solid deck.
local function lay_keys(plan, i)
  local s = plan.supports[i]
  local key = s.shear_key
  if not key or key.law then return end
  key.from = 0
  for _, v in ipairs { plan.spans[i - 1] or false, plan.spans[i] or false } do
    local reach = v and (v.slab or v.section) and math.max(-plan.lines[1].y,
      plan.lines[#plan.lines].y) + 0.5*plan.girder
      or v and plan.half or 0
    key.from = math.max(key.from, reach + key.gap)
    if v and v.slab and key.height > s.rise + v.under - 1e-9 then
      fail(s.owner, "its shear keys are %g m high and would reach into the slab of '%s', %g m above its seat",
        key.height, v.name,
        s.rise + v.under)
    end
  end
  if key.from + key.breadth > 0.5*s.breadth + 1e-9 then
    fail(s.owner, "breadth is %g m; shear keys next to the girders need %g m", s.breadth, 2*(key.from + key.breadth))
  end
end

local function check_names(rows, kind)
  local seen = {}
  for _, row in ipairs(rows) do
    if seen[row.name] then fail(row.owner, "there are two %s with that name", kind) end
    seen[row.name] = true
  end
  return seen
end

--- The whole plan; an error for invalid input.
function core.bridge_plan(model, options)
  if type(options) ~= "table" then
    fail("bridge", "takes a table { supports = , spans = , ... }; this is %s", what_is(options))
  end
  local b = read("bridge", "bridge", options)
  if #b.supports ~= #b.spans + 1 then
    fail("bridge", "%d spans and %d supports; there is one support more than spans, from left to right", #b.spans,
      #b.supports)
  end
  local plan = { bridge = b, half = 0.5*b.breadth, spans = {}, supports = {} }
  plan.lines, plan.girder = girder_lines(b.girders, plan.half)
  for i = 1, #b.spans do plan.spans[i] = read_span(model, plan, b, i) end
  local x = b.x
  for i = 1, #b.supports do
    plan.supports[i] = read_support(plan, b, i)
    plan.supports[i].x = x
    x = x + (plan.spans[i] and plan.spans[i].length or 0)
  end
  for i in ipairs(plan.spans) do lay_span(plan, i) end
  for i in ipairs(plan.supports) do lay_keys(plan, i) end
  check_names(plan.spans, "spans")
  local support_names = check_names(plan.supports, "supports")
  for _, v in ipairs(plan.spans) do
    if support_names[v.name] then fail(v.owner, "there is already a support with that name; give each its own name") end
  end
  return plan
end

core.bridge_foundation_laws = foundation_laws
