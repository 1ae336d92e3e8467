-- m:bolt{...}: a grouted bolt, anchor or tie bar through one or several bodies, with slip along its length.
--
-- In each body the bolt is a frame of beams whose nodes are held by bond springs. Their stiffness per length is `bond`,
-- and slip begins at the bond strength times the circumference (Farmer 1975; Li and Stillborg 1999). Across a joint the
-- two parts are linked by a short piece of the bar. It yields and breaks there, because the force is greatest there.
--
--     N'' = (bond/(E A)) N,    pull-out stiffness = sqrt(E A bond) tanh(length sqrt(bond/(E A)))
local trilith, core = ...
local owner = "bolt"
local methods = core.members "model"
local keys = { "name", "bodies", "from", "to", "joints", "diameter", "E", "material", "bond", "bond_strength", "dowel",
  "yield", "hardening", "rupture", "prestress", "prestress_ramp", "spacing" }
local most_springs = 2000
local jack = 1e-9 -- stiffness of a bar before it is locked, over its own

local function fail(text, ...) core.fail(owner .. ": " .. text:format(...)) end
local function positive(o, key, unit, preset)
  if o[key] == nil and preset then return preset end
  return core.positive(owner, key, o[key], unit)
end

local function point(o, key, dim)
  local p = o[key]
  local fine = type(p) == "table" and #p == dim
  for k = 1, fine and dim or 0 do
    fine = fine and type(p[k]) == "number" and p[k] == p[k] and math.abs(p[k]) < math.huge
  end
  if not fine then
    fail("'%s' is %s, must be a point of %d coordinates in m", key, p == nil and "missing" or core.what_is(p), dim)
  end
  return p
end

local function bodies_of(model, o)
  if type(o.bodies) ~= "table" or #o.bodies == 0 then
    fail("'bodies' is %s, must be a list of the bodies that the bolt passes, in order",
      o.bodies == nil and "missing" or core.what_is(o.bodies))
  end
  local out = {}
  for i, body in ipairs(o.bodies) do
    out[i] = model:body(core.name_of(model, "body", body, owner))
  end
  return out
end

-- Direction and length of the bolt.
local function axis_of(o, dim)
  local from, to, d, square = point(o, "from", dim), point(o, "to", dim), {}, 0
  for k = 1, dim do d[k] = to[k] - from[k] square = square + d[k]^2 end
  if square <= 0 then fail "'from' and 'to' are the same point; give the two ends of the bolt" end
  local length = math.sqrt(square)
  for k = 1, dim do d[k] = d[k]/length end
  return from, d, length
end

-- Distances of the ends of each part from the start.
local function parts_of(o, bodies, length)
  local joints = o.joints or {}
  if type(joints) ~= "table" then fail("'joints' is %s, must be a list of distances from the start in m",
    core.what_is(joints)) end
  if #joints ~= #bodies - 1 then
    fail("'joints' has %d distances for %d bodies; it needs one between each two bodies", #joints, #bodies)
  end
  local parts, last = {}, 0
  for i, body in ipairs(bodies) do
    local stop = i < #bodies and joints[i] or length
    if type(stop) ~= "number" or stop ~= stop or stop <= last or stop > length then
      fail("joint %d is at %s, must be above %g m and below the length %g m", i,
        type(stop) == "number" and ("%g m"):format(stop) or core.what_is(stop), last, length)
    end
    parts[i], last = { body = body, from = last, length = stop - last }, stop
  end
  return parts
end

local function read(model, o)
  core.check_keys(owner, o, keys)
  local dim = model.dim
  if type(o.name) ~= "string" or o.name == "" then
    fail("'name' is %s, must be a text", o.name == nil and "missing" or core.what_is(o.name))
  end
  if type(o.material) ~= "string" then
    fail("'material' is %s, must be the name of a material with E and density",
      o.material == nil and "missing" or core.what_is(o.material))
  end
  local s = { name = o.name, dim = dim, material = o.material }
  s.start, s.axis, s.length = axis_of(o, dim)
  s.parts = parts_of(o, bodies_of(model, o), s.length)
  s.d, s.E, s.bond = positive(o, "diameter", " m"), positive(o, "E", " Pa"), positive(o, "bond", " N/m per m")
  s.strength = o.bond_strength ~= nil and positive(o, "bond_strength", " Pa") or nil
  s.dowel = positive(o, "dowel", " N/m per m", s.bond)
  s.area, s.inertia = math.pi*s.d^2/4, math.pi*s.d^4/64
  local shortest = s.length
  for _, part in ipairs(s.parts) do shortest = math.min(shortest, part.length) end
  s.spacing = positive(o, "spacing", " m", shortest/20)
  if s.spacing > 0.5*shortest then
    fail("'spacing' is %g m, must be at most half of the shortest part, %g m", s.spacing, 0.5*shortest)
  end
  if s.length/s.spacing > most_springs then
    fail("'spacing' is %g m, which gives more than %d springs; give a longer one", s.spacing, most_springs)
  end
  return s
end

local function read_bar(s, o)
  s.prestress = o.prestress ~= nil and positive(o, "prestress", " N") or 0
  s.yield = o.yield ~= nil and positive(o, "yield", " Pa")*s.area or nil
  s.hardening = o.hardening == nil and 0 or o.hardening
  if type(s.hardening) ~= "number" or not (s.hardening >= 0 and s.hardening < 1) then
    fail("'hardening' is %s, must be from 0 to below 1", core.what_is(s.hardening))
  end
  if o.hardening ~= nil and not s.yield then fail "'hardening' needs 'yield' [Pa]" end
  s.rupture = o.rupture ~= nil and positive(o, "rupture", " m, an elongation across a joint") or nil
  s.ramp = o.prestress_ramp ~= nil and positive(o, "prestress_ramp", " s") or nil
  if s.yield and s.prestress >= s.yield then
    fail("'prestress' is %g N, must be below the yield force %g N", s.prestress, s.yield)
  end
  if (s.prestress > 0 or s.yield or s.rupture) and #s.parts < 2 then
    fail "prestress, yield and rupture belong to the bar across a joint; give two bodies and a joint"
  end
end

local function along(s, distance)
  local p = {}
  for k = 1, s.dim do p[k] = s.start[k] + distance*s.axis[k] end
  return p
end

-- The axes of a bearing whose direction along is the bolt.
local function turned(s, spec)
  if s.dim == 2 then
    spec.angle = trilith.math.atan(s.axis[2], s.axis[1])
    return spec
  end
  local a = s.axis
  local level = math.sqrt(a[2]^2 + a[3]^2)
  if level > 1e-12 then
    spec.turn = { axis = { 0, -a[3]/level, a[2]/level }, angle = trilith.math.atan(level, a[1]) }
  elseif a[1] < 0 then
    spec.turn = { axis = { 0, 0, 1 }, angle = math.pi }
  end
  return spec
end

-- Laws along the bolt, across it, and of rotation.
local function laws(s, spec, law, across, turning, twist)
  spec.along, spec.axial = law, trilith.linear { stiffness = across }
  if s.dim == 2 then
    if turning then spec.turning = trilith.linear { stiffness = turning } end
    return spec
  end
  spec.across = trilith.linear { stiffness = across }
  if turning then
    spec.turning_across, spec.turning_axial = trilith.linear { stiffness = turning },
      trilith.linear { stiffness = turning }
  end
  spec.turning_along = trilith.linear { stiffness = twist }
  return spec
end

local function spring(stiffness, yield, hardening)
  if not yield then return trilith.linear { stiffness = stiffness } end
  return trilith.elastic_plastic { stiffness = stiffness, yield = yield, hardening = hardening }
end

-- The frame of a part and its bond springs.
local function add_part(model, s, i, group)
  local part = s.parts[i]
  local n = math.max(2, math.floor(part.length/s.spacing + 0.5))
  local step = part.length/n
  local first, last = part.from + 0.5*step, part.from + part.length - 0.5*step
  local rod = model:beam { name = ("%s.rod%d"):format(s.name, i), from = along(s, first), to = along(s, last),
    divisions = n - 1, material = s.material, section = trilith.circle_section { diameter = s.d }, groups = { group },
    floating = true }
  local bonds = {}
  for k = 1, n do
    local spec = turned(s, { name = ("%s.bond%d.%d"):format(s.name, i, k), between = { part.body, rod },
      at = along(s, first + (k - 1)*step) })
    local law = spring(s.bond*step, s.strength and s.strength*math.pi*s.d*step, 0)
    bonds[k] = model:bearing(laws(s, spec, law, s.dowel*step, nil, s.bond*step*0.25*s.d^2))
  end
  return { rod = rod, bonds = bonds, first = first, last = last }
end

-- The piece of the bar between two parts. A bar with prestress has no stiffness before it is locked.
local function add_link(model, s, i, before, after)
  local length = after.first - before.last
  local spec = turned(s, { name = ("%s.bar%d"):format(s.name, i), between = { before.rod, after.rod },
    from = along(s, before.last), to = along(s, after.first) })
  if s.rupture then spec.limit = { along = s.rupture } end
  local stiffness = s.E*s.area/length
  local law = spring(stiffness, s.yield and s.yield - s.prestress, s.hardening)
  local bar = model:bearing(laws(s, spec, s.prestress > 0 and trilith.linear { stiffness = jack*stiffness } or law,
    12*s.E*s.inertia/length^3, s.E*s.inertia/length, 0.8*s.E*s.inertia/length))
  return bar, law
end

-- Prestress pulls both ends of the bar at a joint towards each other.
local function add_prestress(model, s, i, before, after)
  for side, part in ipairs { before, after } do
    local force, at = {}, along(s, side == 1 and before.last or after.first)
    for k = 1, s.dim do force[k] = (side == 1 and 1 or -1)*s.prestress*s.axis[k] end
    model:point_load { name = ("%s.prestress%d.%d"):format(s.name, i, side), body = part.rod, at = at, force = force,
      load_curve = s.ramp and { smooth = s.ramp } or nil }
  end
end

function methods.bolt(model, o)
  local s = read(model, o)
  read_bar(s, o)
  local group, rods, bonds, links, made, bars = s.name .. ".rods", {}, {}, {}, {}, {}
  for i = 1, #s.parts do
    made[i] = add_part(model, s, i, group)
    rods[i], bonds[i] = made[i].rod, made[i].bonds
  end
  model:contact { between = { group, "*" }, law = "none" }
  for i = 1, #made - 1 do
    links[i], bars[i] = add_link(model, s, i, made[i], made[i + 1])
    if s.prestress > 0 then add_prestress(model, s, i, made[i], made[i + 1]) end
  end
  local locked = s.prestress == 0
  local out = { name = s.name, rods = rods, bonds = bonds, bars = links }
  --- Force of the bar at a joint [N], in tension above 0, with its prestress.
  function out.force(i)
    local bar = links[i or 1]
    if not bar then fail("there is no joint %s; the bolt has %d", tostring(i), #links) end
    return bar.status == "failed" and 0 or bar.force_along + s.prestress
  end
  --- Locks the bars at the prestress, at their present length.
  function out.lock()
    if locked then fail("'%s' %s", s.name, s.prestress == 0 and "has no prestress to lock" or "is locked already") end
    locked = true
    for i, bar in ipairs(links) do
      model:change { bearing = bar.name, along = bars[i] }
      model:remove(bar)
      model:put_back(bar)
    end
  end
  return out
end
