-- m:absorbing_boundary{...}: dashpots on an edge of a mesh of ground, so that waves leave it (Lysmer and Kuhlemeyer
-- 1969).
--
--     normal: rho cp v per area,    tangential: rho cs v per area
--
-- A wave that enters from outside has twice its stress on the edge, 2 rho c v (Joyner and Chen 1975), of which the
-- dashpots take one half. At a side, a free field adds the motion and the stress of the ground far away: vertical waves
-- in a uniform layer on a half space. They are known exactly, as the sum of waves that rise and return:
--
--     up(t) = T sum over k of R^k v(t - 2 k H/c),    T = 2 Zb/(Zb + Z),    R = (Z - Zb)/(Z + Zb),    Z = rho c
--
-- The dashpots are bearings, linear in the velocity, against a small fixed body. All schemes, restart, the energy
-- balance and pictures know them already. Inputs are point loads.
local trilith, core = ...
local owner = "absorbing_boundary"
local methods = core.members "model"
local keys = { "body", "edge", "density", "cs", "cp", "directions", "motion", "free_field", "from", "to", "divisions",
  "name" }
local most_points = 200000 -- of all load curves of a call

local function fail(text, ...) core.fail(owner .. ": " .. text:format(...)) end

local function positive(owner_of, t, key, unit) return core.positive(owner_of, key, t[key], unit) end

-- Sides: axis of the outward normal, and its sign.
local function sides(dim)
  local up = dim == 2 and 2 or 3
  local s = { left = { 1, -1 }, right = { 1, 1 }, bottom = { up, -1 }, top = { up, 1 } }
  if dim == 3 then s.front, s.back = { 2, -1 }, { 2, 1 } end
  return s
end
local function side_names(dim)
  return dim == 2 and { "left", "right", "bottom", "top" } or { "left", "right", "front", "back", "bottom", "top" }
end

local function point(t, key, dim)
  local p = t[key]
  if type(p) ~= "table" or #p ~= dim then
    fail("'%s' is %s, must be a point of %d coordinates", key, p == nil and "missing" or core.what_is(p), dim)
  end
  for _, x in ipairs(p) do
    if type(x) ~= "number" or x ~= x or math.abs(x) == math.huge then fail("'%s' holds %s, must be numbers", key,
      core.what_is(x)) end
  end
  return p
end

-- Nodes of a mesh in the plane on a side, each with the length of the edge that belongs to it.
local function nodes_of_edge(body, axis, sign, edge)
  local outline, most = body.outline, -math.huge
  local low, high = math.huge, -math.huge
  for _, p in ipairs(outline) do
    most = math.max(most, sign*p[axis])
    low, high = math.min(low, p[3 - axis]), math.max(high, p[3 - axis])
  end
  local at = {}
  for _, p in ipairs(outline) do
    if sign*p[axis] >= most - 1e-9*(high - low) then at[#at + 1] = p end
  end
  if #at < 2 then fail("body '%s' has no straight edge at its %s; give an upright or level edge", body.name, edge) end
  table.sort(at, function(p, q) return p[3 - axis] < q[3 - axis] end)
  local nodes = {}
  for i, p in ipairs(at) do
    local before, after = at[math.max(1, i - 1)], at[math.min(#at, i + 1)]
    nodes[i] = { at = { p[1], p[2] }, size = 0.5*(after[3 - axis] - before[3 - axis]) }
  end
  return nodes
end

-- Middles of equal parts of a rectangle in space.
local function nodes_of_rectangle(o, axis)
  local from, to, n = point(o, "from", 3), point(o, "to", 3), o.divisions
  if type(n) ~= "table" or math.type(n[1]) ~= "integer" or math.type(n[2]) ~= "integer" or n[1] < 1 or n[2] < 1
    or n[1]*n[2] > 10000 then
    fail("'divisions' is %s, must be two integers above 0, such as the elements along both sides of the rectangle",
      n == nil and "missing" or core.what_is(n))
  end
  local a, b = axis % 3 + 1, (axis + 1) % 3 + 1
  if a > b then a, b = b, a end
  if math.abs(to[axis] - from[axis]) > 0 then
    fail("'from' and 'to' differ along the normal of the %s; they are opposite corners of a rectangle on it", o.edge)
  end
  local da, db = (to[a] - from[a])/n[1], (to[b] - from[b])/n[2]
  if not (da > 0 and db > 0) then fail "'to' must be beyond 'from' in both directions of the edge" end
  local nodes = {}
  for i = 1, n[1] do
    for k = 1, n[2] do
      local p = { from[1], from[2], from[3] }
      p[a], p[b] = from[a] + (i - 0.5)*da, from[b] + (k - 0.5)*db
      nodes[#nodes + 1] = { at = p, size = da*db }
    end
  end
  return nodes
end

-- A velocity over time: function of t [s], end, and step of its points.
local function velocity_of(value, key)
  if type(value) == "userdata" and core.kind_of(value) == "motion" then
    return function(t)
      if t <= 0 then return 0 end
      local _, v = value:at(t)
      return v
    end, value.end_time, value.dt
  end
  local wanted = "must be a motion or a list of { time, velocity } with increasing times"
  if type(value) ~= "table" or #value < 2 then fail("%s is %s, %s", key, core.what_is(value), wanted) end
  local step = math.huge
  for i, p in ipairs(value) do
    if type(p) ~= "table" or type(p[1]) ~= "number" or type(p[2]) ~= "number" then
      fail("entry %d of %s is %s, %s", i, key, core.what_is(p), wanted)
    end
    if i > 1 then
      local by = p[1] - value[i - 1][1]
      if by <= 0 or by ~= by then fail("entry %d of %s is at %g s, after %g s; times must increase", i, key, p[1],
        value[i - 1][1]) end
      step = math.min(step, by)
    end
  end
  if value[1][2] ~= 0 then fail("%s begins with %g m/s; a wave begins with 0 m/s", key, value[1][2]) end
  local row = 1
  return function(t)
    if t <= value[1][1] then return 0 end
    if t >= value[#value][1] then return value[#value][2] end
    if t < value[row][1] then row = 1 end
    while value[row + 1][1] < t do row = row + 1 end
    local p, q = value[row], value[row + 1]
    return p[2] + (q[2] - p[2])*(t - p[1])/(q[1] - p[1])
  end, value[#value][1], step
end

-- Motions by axis: { x = , y = } or one for x.
local function read_motions(value, dim)
  local names, out = dim == 2 and { "x", "y" } or { "x", "y", "z" }, {}
  local by_axis = type(value) == "table" and value[1] == nil
  if not by_axis then value = { x = value } end
  core.check_keys(owner .. ": motion", value, names)
  for axis, name in ipairs(names) do
    if value[name] ~= nil then
      local v, last, step = velocity_of(value[name], "motion." .. name)
      out[axis] = { v = v, last = last, step = step }
    end
  end
  if not next(out) then fail "'motion' is empty; give motion = { x = , ... }" end
  return out
end

local function medium(o, name)
  local cs, cp = positive(name, o, "cs", " m/s"), positive(name, o, "cp", " m/s")
  if cp <= cs*math.sqrt(4/3) then
    core.fail(("%s: 'cp' is %g m/s, must be above 1.155 cs = %g m/s; it is cs sqrt((2 - 2 nu)/(1 - 2 nu))"):format(name,
      cp, cs*math.sqrt(4/3)))
  end
  return { density = positive(name, o, "density", " kg/m3"), cs = cs, cp = cp }
end

-- Velocity and stress [Pa] of vertical waves in a layer, as functions of height and time, for motion along `axis`.
local function layer_waves(ground, f, motion, axis, up)
  local c = axis == up and ground.cp or ground.cs
  local z, zb = ground.density*c, f.half_space.density*(axis == up and f.half_space.cp or f.half_space.cs)
  local height, through, back = f.surface - f.base, 2*zb/(zb + z), (z - zb)/(z + zb)
  local function rising(t)
    local sum, share = 0, through
    while t > 0 and math.abs(share) > 1e-12 do
      sum, share, t = sum + share*motion.v(t), share*back, t - 2*height/c
    end
    return sum
  end
  return function(level, t)
    local h = level - f.base
    local rise, fall = rising(t - h/c), rising(t - (2*height - h)/c)
    return rise + fall, z*(fall - rise)
  end, 2*height/c
end

local function read_free_field(o, ground, axis, dim)
  local f = o.free_field
  local name = owner .. ": free_field"
  if axis == (dim == 2 and 2 or 3) then
    fail("'free_field' is for upright edges, and '%s' is level; give motion", o.edge)
  end
  core.check_keys(name, f, { "base", "surface", "motion", "half_space" })
  for _, key in ipairs { "base", "surface" } do
    if type(f[key]) ~= "number" then
      core.fail(("%s: '%s' is %s, must be a height in m"):format(name, key,
        f[key] == nil and "missing" or core.what_is(f[key])))
    end
  end
  if f.surface <= f.base then
    core.fail(("%s: 'surface' is %g m, must be above the base at %g m"):format(name, f.surface, f.base))
  end
  local beyond = ground
  if f.half_space ~= nil then
    core.check_keys(name .. ": half_space", f.half_space, { "density", "cs", "cp" })
    beyond = medium(f.half_space, name .. ": half_space")
  end
  return { base = f.base, surface = f.surface, half_space = beyond, motions = read_motions(f.motion, dim) }
end

-- The fixed body that holds the dashpots, beyond the edge and without contact.
local function add_anchor(model, s, dim)
  local middle, reach, nodes, name, body = {}, 0, s.nodes, s.name, s.body
  for k = 1, dim do
    middle[k] = 0
    for _, node in ipairs(nodes) do middle[k] = middle[k] + node.at[k]/#nodes end
  end
  for _, node in ipairs(nodes) do
    local square = 0
    for k = 1, dim do square = square + (node.at[k] - middle[k])^2 end
    reach = math.max(reach, math.sqrt(square))
  end
  local small = 1e-3*math.max(reach, 1)
  middle[s.axis] = middle[s.axis] + s.sign*2*small
  for k = 1, dim do middle[k] = middle[k] - 0.5*small end -- blocks are given by their lowest corner
  local group = name .. ".anchors"
  local made = model:block { name = name .. ".anchor", at = middle, material = body.material, support = "fixed",
    groups = { group }, body = "rigid", width = dim == 2 and small or nil, height = dim == 2 and small or nil,
    size = dim == 3 and { small, small, small } or nil }
  model:contact { between = { group, "*" }, law = "none" }
  return made, reach + 4*small
end

-- Coefficients per area along each axis [N s/m3].
local function impedances(ground, axis, dim)
  local out = {}
  for k = 1, dim do out[k] = ground.density*(k == axis and ground.cp or ground.cs) end
  return out
end

local function laws_of(z, size, directions, dim)
  local names = dim == 2 and { "along", "axial" } or { "along", "across", "axial" }
  local out = {}
  for k, name in ipairs(names) do
    if directions[k] then out[name] = trilith.linear { stiffness = 0, damping = z[k]*size } end
  end
  return out
end

local function read_directions(o, dim)
  local all = dim == 2 and "xy" or "xyz"
  local given, out = o.directions == nil and all or o.directions, {}
  if type(given) ~= "string" or given == "" or given:match("[^" .. all .. "]") then
    fail("'directions' is %s, must be one or several of %s, as in \"%s\"",
      type(given) == "string" and ("'%s'"):format(given) or core.what_is(given), all, all)
  end
  for k = 1, dim do out[k] = given:find(all:sub(k, k), 1, true) ~= nil end
  return out
end

-- A load along one axis, from points of f(t).
local function add_load(model, name, body, node, axis, f, last, step)
  local count, most, curve = math.ceil(last/step - 1e-9), 0, {}
  for i = 0, count do
    local value = f(i*step)
    curve[i + 1] = { i*step, value }
    most = math.max(most, math.abs(value))
  end
  if most == 0 then return 0 end
  curve[count + 2] = { (count + 1)*step, f(last) }
  local force = {}
  for k = 1, model.dim do force[k] = k == axis and 1 or 0 end
  model:point_load { name = name, body = body, at = node.at, force = force, load_curve = curve }
  return #curve
end

-- The wave that enters: 2 rho c v on the whole edge.
local function add_motion(model, s)
  local points = 0
  for axis, motion in pairs(s.motions or {}) do
    if not s.directions[axis] then fail("motion along %s, but 'directions' has no dashpots along it",
      ("xyz"):sub(axis, axis)) end
    points = points + #s.nodes*(motion.last/motion.step + 2)
    if points > most_points then
      fail("the motion has %d points at %d nodes, together more than %d; resample it with a longer step",
        motion.last//motion.step + 1, #s.nodes, most_points)
    end
    for i, node in ipairs(s.nodes) do
      local full = 2*s.z[axis]*node.size
      add_load(model, ("%s.in%d.%d"):format(s.name, axis, i), s.body, node, axis,
        function(t) return full*motion.v(t) end, motion.last, motion.step)
    end
  end
end

-- Motion and stress of the free field at a side.
local function add_free_field(model, s)
  local f, dim = s.free_field, model.dim
  local up = dim == 2 and 2 or 3
  local squeeze = 1 - 2*(s.ground.cs/s.ground.cp)^2 -- stress across over stress along a vertical P wave
  for axis, motion in pairs(f.motions) do
    local waves, echo = layer_waves(s.ground, f, motion, axis, up)
    local last = motion.last + 20*echo
    if #s.nodes*last/motion.step > most_points then
      fail("the free field has %d points at %d nodes, together more than %d; resample the motion with a longer step",
        last//motion.step + 1, #s.nodes, most_points)
    end
    for i, node in ipairs(s.nodes) do
      local level = node.at[up]
      if level < f.base - 1e-9 or level > f.surface + 1e-9 then
        fail("a node lies at %g m, outside the free field from %g to %g m", level, f.base, f.surface)
      end
      local function velocity(t) return node.size*s.z[axis]*(waves(level, t)) end
      -- The stress acts on the side across the wave: along the vertical for S waves, along the normal for P waves.
      local stressed = axis == up and s.axis or axis == s.axis and up or nil
      local share = (axis == up and squeeze or 1)*s.sign*node.size
      local function stress(t)
        local _, value = waves(level, t)
        return share*value
      end
      local name = ("%s.free%d.%d"):format(s.name, axis, i)
      if s.directions[axis] then add_load(model, name .. "v", s.body, node, axis, velocity, last, motion.step) end
      if stressed then add_load(model, name .. "s", s.body, node, stressed, stress, last, motion.step) end
    end
  end
end

function methods.absorbing_boundary(model, o)
  core.check_keys(owner, o, keys)
  local dim = model.dim
  if o.body == nil then fail "'body' is missing, must be a body or its name" end
  local body = model:body(core.name_of(model, "body", o.body, owner))
  core.one_of(owner, "edge", o.edge, side_names(dim))
  local axis, sign = table.unpack(sides(dim)[o.edge])
  local s = { body = body, axis = axis, sign = sign, ground = medium(o, owner), directions = read_directions(o, dim),
    name = o.name or ("%s.%s"):format(body.name, o.edge) }
  if dim == 2 then
    for _, key in ipairs { "from", "to", "divisions" } do
      if o[key] ~= nil then fail("'%s' is for models in space; in the plane the nodes of the edge are used", key) end
    end
  end
  s.nodes = dim == 2 and nodes_of_edge(body, axis, sign, o.edge) or nodes_of_rectangle(o, axis)
  if dim == 2 then
    for _, node in ipairs(s.nodes) do node.size = node.size*model.thickness end
  end
  s.z = impedances(s.ground, axis, dim)
  if o.motion ~= nil and o.free_field ~= nil then
    fail "both motion and free_field are given; motion is for the base, free_field for the sides"
  end
  s.motions = o.motion ~= nil and read_motions(o.motion, dim) or nil
  s.free_field = o.free_field ~= nil and read_free_field(o, s.ground, axis, dim) or nil
  local anchor, reach = add_anchor(model, s, dim)
  local area, bearings = 0, {}
  for i, node in ipairs(s.nodes) do
    local spec = laws_of(s.z, node.size, s.directions, dim)
    spec.name, spec.between, spec.at, spec.arm = ("%s.%d"):format(s.name, i), { anchor, body }, node.at, reach
    bearings[i], area = model:bearing(spec), area + node.size
  end
  add_motion(model, s)
  if s.free_field then add_free_field(model, s) end
  return { name = s.name, area = area, bearings = bearings }
end
