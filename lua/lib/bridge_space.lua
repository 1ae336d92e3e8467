-- m:bridge{...} of a model in space: bodies, ground, foundations, bearings, seats and keys from the plan, and the table
-- by which a script finds them. After an error nothing of it remains in the model.
local _, core = ...
local read, fail, what_is = core.bridge_rules.read, core.bridge_rules.fail, core.bridge_rules.what_is
local trilith = core.module
local Bridge = {} -- methods of the result of m:bridge
Bridge.__index = Bridge

--- Base of a support on the ground: half of its length and width, and its middle along the bridge.
local function base_of(plan, s, i)
  if s.kind == "abutment" then
    local _, front, back = core.bridge_places.abutment(s, i == 1 and 1 or -1)
    return 0.5*math.abs(front - back), s.breadth, 0.5*(front + back)
  end
  if s.footing_width > 0 then return 0.5*s.footing_width, s.footing_breadth or s.breadth, s.x end
  local wide = s.stem_width or not s.section and s.gap + 2*s.seat or s.section.depth
  return 0.5*wide, s.columns and plan.bridge.breadth or s.stem_breadth or s.breadth, s.x
end

--- The block of ground under a support.
local function add_block(model, plan, s, i)
  local g = s.ground
  local half, broad, x = base_of(plan, s, i)
  half, broad = half + g.margin, 0.5*broad + g.margin
  s.ground_from, s.ground_to = x - half, x + half
  local before = plan.supports[i - 1]
  for _, y in ipairs { -broad, broad } do
    if before and before.ground_to and x - half - s.slope*y < before.ground_to - before.slope*y then
      fail(s.owner, "its ground and the ground of '%s' would overlap; give a smaller margin than %g m", before.name,
        g.margin)
    end
  end
  return model:body { name = s.name .. ".ground", groups = { "grounds" }, material = g.material or s.material,
    support = "fixed", pieces = { core.bridge_places.solid({ x - half, s.slope }, { x + half, s.slope }, -broad, broad,
      s.bottom - g.thickness, s.bottom) } }
end

local function body_called(model, owner, name)
  local names = {}
  for k, body in ipairs(model:bodies {}) do
    if body.name == name then return body end
    names[k] = body.name
  end
  return fail(owner, "ground: there is no body '%s'%s", name, core.hint(name, names))
end

--- Ground of a support, before any body is made: the values of a block, or an existing body.
local function read_ground(model, s)
  local given = s.ground
  if given == nil or type(given) == "userdata" and core.kind_of(given) == "body" then return given end
  if type(given) == "table" then return read("ground", s.owner .. ": ground", given) end
  if type(given) == "string" then return body_called(model, s.owner, given) end
  return fail(s.owner, "'ground' is %s, must be a table such as { margin = 1 }, a body or its name", what_is(given))
end

local function add_ground(model, plan, s, i)
  if s.section and not s.foundation or s.ground == nil then return nil end
  return type(s.ground) == "table" and add_block(model, plan, s, i) or s.ground
end

--- Springs of a rigid disc of this area on an elastic half space, as laws of a bearing (Gazetas 1991).
local function half_space(f, area)
  local r, g, nu = math.sqrt(area/math.pi), f.soil, f.poisson
  local function spring(k) return trilith.linear { stiffness = k, damping = f.beta*k } end
  local slide, rock = spring(8*g*r/(2 - nu)), spring(8*g*r*r*r/(3*(1 - nu)))
  return { along = slide, across = slide, axial = spring(4*g*r/(1 - nu)), turning_along = rock, turning_across = rock,
    turning_axial = spring(16/3*g*r*r*r) }
end

--- Foundation of a support on its ground: one link at the middle of its base, or one at each foot of members.
local function add_foundations(model, plan, s, i, body, ground)
  if not s.foundation then return {} end
  local half, broad, x = base_of(plan, s, i)
  local places = s.feet or { { x, 0, s.bottom } }
  local laws = s.foundation.soil and half_space(s.foundation, 2*half*broad/#places) or {}
  if not s.foundation.soil then
    for _, key in ipairs(core.bridge_foundation_laws) do laws[key] = s.foundation[key] end
    laws.limit, laws.becomes = s.foundation.limit, s.foundation.becomes
  end
  local links = {}
  for k, place in ipairs(places) do
    local link = { name = s.name .. ".foundation" .. (s.feet and k or ""), between = { ground, body },
      from = { place[1], place[2], s.bottom }, to = place }
    for key, law in pairs(laws) do link[key] = law end
    links[k] = model:bearing(link)
  end
  -- Ground springs with an axial law replace the whole contact of ground and base.
  if laws.axial then plan.apart[#plan.apart + 1] = { ground.name, s.name } end
  return links
end

--- Bearing, seat and place of each girder line at one end of a span: { [number] =, [name of the line] = }.
local function add_lines(model, plan, v, side, deck, out)
  local e, soffit = v.ends[side], plan.bridge.soffit_level
  local s = e.support
  for k, line in ipairs(plan.lines) do
    local y, name = line.y, ("%s.%s"):format(e.name, line.name)
    local x = e.bearing - s.slope*y
    local laid = core.lay_bearing(model, { name = name, type = v.types[side][k].name, support = s.name, span = v.name,
      from = { x, y, s.top }, to = { x, y, soffit } })
    local seat = model:seat { name = name, body = deck, support = s.name,
      at_end = { e.x + e.way*e.set_back - s.slope*y, y, soffit },
      edge = { e.edge - s.slope*y, y, s.top }, inward = { -e.way, -e.way*s.slope, 0 } }
    for _, key in ipairs { k, line.name } do
      out.bearings[key], out.seats[key], out.places[key] = laid, seat, { x, y, soffit }
    end
  end
end

--- Sideways seats of the outer girders, up to the end of the support's top; and the key there, if it is a bearing.
local function add_sideways(model, plan, v, side, deck)
  local e, soffit, out = v.ends[side], plan.bridge.soffit_level, {}
  local s = e.support
  for _, row in ipairs { { "right", -1, plan.lines[1].y }, { "left", 1, plan.lines[#plan.lines].y } } do
    local word, way, y = row[1], row[2], row[3]
    local x = e.bearing - s.slope*y
    out[word] = model:seat { name = ("%s %sward"):format(e.name, word), body = deck, support = s.name,
      at_end = { x, y, soffit }, edge = { x, 0.5*way*s.breadth, s.top }, inward = { 0, -way, 0 } }
  end
  local key = s.shear_key
  if key and key.law then
    local place = { e.bearing, 0, soffit }
    out.key = model:bearing { name = e.name .. ".key", between = { s.name, v.name }, at = place, across = key.law,
      limit = key.limit and { across = key.limit } or nil }
  end
  return out
end

local sides = { "left", "right" }

local function add_links(model, plan, bridge, made)
  for i, v in ipairs(plan.spans) do
    local rows = { bearings = {}, seats = {}, places = {}, side_seats = {}, keys = {} }
    for side, word in ipairs(sides) do
      local out = { bearings = {}, seats = {}, places = {} }
      add_lines(model, plan, v, side, made.spans[i], out)
      for kind, found in pairs(out) do rows[kind][word] = found end
      rows.side_seats[word] = add_sideways(model, plan, v, side, made.spans[i])
      rows.side_seats[word].key, rows.keys[word] = nil, rows.side_seats[word].key
    end
    for kind, found in pairs(rows) do bridge[kind][i], bridge[kind][v.name] = found, found end
  end
end

--- The body that follows the ground motion at each support: its ground, or the support itself if that is fixed.
local function driven_by(s, ground, body)
  if ground then return ground end
  return (s.section and not s.foundation or s.support ~= nil) and body or nil
end

local function made_of(model, plan)
  local bridge = setmetatable({ lines = {}, axes = {}, supports = {}, spans = {}, grounds = {}, foundations = {},
    bearings = {}, seats = {}, side_seats = {}, places = {}, keys = {}, driven = {} }, Bridge)
  for k, line in ipairs(plan.lines) do bridge.lines[k] = line.name end
  local made = core.bridge_bodies(model, plan)
  for i, s in ipairs(plan.supports) do
    local body, ground = made.supports[i], add_ground(model, plan, s, i)
    local links = add_foundations(model, plan, s, i, body, ground)
    for _, key in ipairs { i, s.name } do
      bridge.supports[key], bridge.grounds[key], bridge.foundations[key], bridge.axes[key] = body, ground or false,
        links, s.x
      bridge.driven[key] = driven_by(s, ground, body) or false
    end
  end
  for i, v in ipairs(plan.spans) do bridge.spans[i], bridge.spans[v.name] = made.spans[i], made.spans[i] end
  add_links(model, plan, bridge, made)
  for _, two in ipairs(plan.apart) do model:contact { between = two, law = "none" } end
  return bridge
end

local function built(model, options)
  local plan = core.bridge_plan(model, options)
  plan.apart = {} -- names of grounds and supports without contact
  for _, s in ipairs(plan.supports) do s.ground = read_ground(model, s) end
  return core.whole_bridge(model, function() return made_of(model, plan) end)
end

--- The motion at support i along one axis, common to all supports or from a list, delayed by its delay or the wave.
local function motion_at(bridge, given, key, i)
  local motion = given[key]
  if type(motion) == "table" then
    if #motion ~= #bridge.supports then
      fail("motions", "'%s' lists %d motions for %d supports; give one for each, or one for all", key, #motion,
        #bridge.supports)
    end
    motion = motion[i]
  end
  if motion == nil then return nil end
  if type(motion) ~= "userdata" or core.kind_of(motion) ~= "motion" then
    fail("motions", "'%s' is %s, must be a motion, or a list of one for each support", key, what_is(motion))
  end
  local far = bridge.axes[i] - bridge.axes[1]
  if given.velocity and far > 0 then return motion:passage { distance = far, velocity = given.velocity } end
  local late = given.delay and given.delay[i] or 0
  return late ~= 0 and motion:delay(late) or motion
end

local function check_delays(bridge, given)
  if not given.delay then return end
  if given.velocity then fail("motions", "both velocity and delay are given; keep one") end
  if #given.delay ~= #bridge.supports then
    fail("motions", "'delay' lists %d delays for %d supports; give one for each", #given.delay, #bridge.supports)
  end
  for i = 1, #given.delay do
    local late = given.delay[i]
    if type(late) ~= "number" or not (late >= 0 and late < 1e6) then
      fail("motions", "delay %d is %s, must be a number of seconds, not below 0", i, what_is(late))
    end
  end
end

--- bridge:motions{ x =, y =, z =, velocity =, delay = }: the list for m:shake{ motions = }.
function Bridge:motions(given)
  given = read("motions", "motions", given)
  check_delays(self, given)
  if not (given.x or given.y or given.z) then fail("motions", "gives no motion; give x, y or z") end
  local rows, seen = {}, {}
  for i = 1, #self.supports do
    local body = self.driven[i]
    if not body then
      fail("motions", "support '%s' has no ground of the bridge and is not fixed; give ground, or move its ground"
        .. " by m:shake",
        self.supports[i].name)
    end
    local row = { body = body }
    for _, key in ipairs { "x", "y", "z" } do row[key] = motion_at(self, given, key, i) end
    local other = seen[body.name]
    if not other then
      rows[#rows + 1], seen[body.name] = row, row
    elseif given.velocity or given.delay or other.x ~= row.x or other.y ~= row.y or other.z ~= row.z then
      fail("motions", "'%s' is the ground of several supports and cannot follow several motions; give each its own"
        .. " ground",
        body.name)
    end
  end
  return rows
end

core.bridge_in_space = built
