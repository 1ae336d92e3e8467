-- m:absorbing_boundary{...}: dashpots on an edge of a mesh of ground, so that waves leave it (Lysmer and Kuhlemeyer
-- 1969).
--
--     normal: rho cp v per area,    tangential: rho cs v per area
--
-- A wave that enters from outside has twice its stress on the edge, 2 rho c v (Joyner and Chen 1975), of which the
-- dashpots take one half. At a side, a free field adds the motion and the stress of the ground far away: vertical waves
-- in level layers on a half space (ground_column.lua).
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

-- Motions by axis: { x = , y = } or one for x.
local function read_motions(value, dim)
  local names, out = dim == 2 and { "x", "y" } or { "x", "y", "z" }, {}
  local by_axis = type(value) == "table" and value[1] == nil
  if not by_axis then value = { x = value } end
  core.check_keys(owner .. ": motion", value, names)
  for axis, name in ipairs(names) do
    if value[name] ~= nil then
      local v, last, step = core.velocity_of(value[name], "motion." .. name, fail)
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

local function height_of(name, t, key)
  if type(t[key]) ~= "number" or t[key] ~= t[key] then
    core.fail(("%s: '%s' is %s, must be a height in m"):format(name, key,
      t[key] == nil and "missing" or core.what_is(t[key])))
  end
  return t[key]
end

-- Layers of the free field from its base upwards.
local function read_layers(name, f)
  if type(f.layers) ~= "table" or #f.layers == 0 then
    core.fail(("%s: 'layers' is %s, must be a list of layers from the lowest one upwards, each with top, density, cs "
      .. "and cp"):format(name, core.what_is(f.layers)))
  end
  local out, from = {}, f.base
  for i, layer in ipairs(f.layers) do
    local of = ("%s: layer %d"):format(name, i)
    core.check_keys(of, layer, { "top", "density", "cs", "cp" })
    local top = height_of(of, layer, "top")
    if top <= from then
      core.fail(("%s: 'top' is %g m, must be above %g m, the %s below"):format(of, top, from,
        i == 1 and "base" or "top of the layer"))
    end
    out[i] = medium(layer, of)
    out[i].from, out[i].to, from = from, top, top
  end
  return out
end

-- The free field of a side without the ground of a uniform one, which belongs to the edge.
local function read_free_field(o, axis, dim)
  local f = o.free_field
  local name = owner .. ": free_field"
  if axis == (dim == 2 and 2 or 3) then
    fail("'free_field' is for upright edges, and '%s' is level; give motion", o.edge)
  end
  core.check_keys(name, f, { "base", "surface", "motion", "half_space", "layers" })
  local out = { base = height_of(name, f, "base"), motions = read_motions(f.motion, dim) }
  if f.layers ~= nil then
    out.layers = read_layers(name, f)
    out.surface = out.layers[#out.layers].to
    if f.surface ~= nil and f.surface ~= out.surface then
      core.fail(("%s: 'surface' is %s, but the uppermost layer ends at %g m; leave it out"):format(name,
        core.what_is(f.surface), out.surface))
    end
  else
    out.surface = height_of(name, f, "surface")
    if out.surface <= out.base then
      core.fail(("%s: 'surface' is %g m, must be above the base at %g m"):format(name, out.surface, out.base))
    end
  end
  if f.half_space ~= nil then
    core.check_keys(name .. ": half_space", f.half_space, { "density", "cs", "cp" })
    out.half_space = medium(f.half_space, name .. ": half_space")
  end
  return out
end

-- Density and velocities at the edge: given ones, or the properties of the layer next to it.
local function ground_of(o, f, nodes, up)
  if not (f and f.layers) or o.density ~= nil or o.cs ~= nil or o.cp ~= nil then return medium(o, owner) end
  local low, high = math.huge, -math.huge
  for _, node in ipairs(nodes) do low, high = math.min(low, node.at[up]), math.max(high, node.at[up]) end
  for _, layer in ipairs(f.layers) do
    local slack = 1e-9*(layer.to - layer.from)
    if low >= layer.from - slack and high <= layer.to + slack then return layer end
  end
  fail("the edge from %g to %g m is next to no single layer; give density, cs and cp", low, high)
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

local function check_motions(s)
  local points = 0
  for axis, motion in pairs(s.motions or {}) do
    if not s.directions[axis] then fail("motion along %s, but 'directions' has no dashpots along it",
      ("xyz"):sub(axis, axis)) end
    points = points + #s.nodes*(motion.last/motion.step + 2)
    if points > most_points then
      fail("the motion has %d points at %d nodes, together more than %d; resample it with a longer step",
        motion.last//motion.step + 1, #s.nodes, most_points)
    end
  end
end

-- The wave that enters: 2 rho c v on the whole edge.
local function add_motion(model, s)
  for axis, motion in pairs(s.motions or {}) do
    for i, node in ipairs(s.nodes) do
      local full = 2*s.z[axis]*node.size
      add_load(model, ("%s.in%d.%d"):format(s.name, axis, i), s.body, node, axis,
        function(t) return full*motion.v(t) end, motion.last, motion.step)
    end
  end
end

-- Layers as one kind of wave meets them, and the impedance of the half space.
local function column_of(s, is_pressure)
  local f, out = s.free_field, {}
  local layers = f.layers or { { from = f.base, to = f.surface, density = s.ground.density, cs = s.ground.cs,
    cp = s.ground.cp } }
  local function speed(m) return is_pressure and m.cp or m.cs end
  for i, layer in ipairs(layers) do
    out[i] = { from = layer.from, to = layer.to, c = speed(layer), z = layer.density*speed(layer) }
  end
  local beyond = f.half_space or layers[1]
  return out, beyond.density*speed(beyond)
end

-- The waves of the free field along each axis, and when they are over. Nothing is added to the model before all is
-- known.
local function prepare_free_field(s, dim)
  local f, up, out = s.free_field, dim == 2 and 2 or 3, {}
  for _, node in ipairs(s.nodes) do
    local level = node.at[up]
    if level < f.base - 1e-9 or level > f.surface + 1e-9 then
      fail("a node lies at %g m, outside the free field from %g to %g m", level, f.base, f.surface)
    end
  end
  for axis, motion in pairs(f.motions) do
    local layers, beyond = column_of(s, axis == up)
    local waves, last = core.ground_column(layers, beyond, motion, fail)
    if #s.nodes*last/motion.step > most_points then
      fail("the free field has %d points at %d nodes, together more than %d; resample the motion with a longer step",
        last//motion.step + 1, #s.nodes, most_points)
    end
    out[axis] = { waves = waves, last = last, step = motion.step }
  end
  return out
end

-- Motion and stress of the free field at a side.
local function add_free_field(model, s, fields)
  local up = model.dim == 2 and 2 or 3
  local squeeze = 1 - 2*(s.ground.cs/s.ground.cp)^2 -- stress across over stress along a vertical P wave
  for axis, field in pairs(fields) do
    for i, node in ipairs(s.nodes) do
      local level = node.at[up]
      local function velocity(t) return node.size*s.z[axis]*(field.waves(level, t)) end
      -- The stress acts on the side across the wave: along the vertical for S waves, along the normal for P waves.
      local stressed = axis == up and s.axis or axis == s.axis and up or nil
      local share = (axis == up and squeeze or 1)*s.sign*node.size
      local function stress(t)
        local _, value = field.waves(level, t)
        return share*value
      end
      local name = ("%s.free%d.%d"):format(s.name, axis, i)
      if s.directions[axis] then add_load(model, name .. "v", s.body, node, axis, velocity, field.last, field.step) end
      if stressed then add_load(model, name .. "s", s.body, node, stressed, stress, field.last, field.step) end
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
  local s = { body = body, axis = axis, sign = sign, directions = read_directions(o, dim),
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
  if o.motion ~= nil and o.free_field ~= nil then
    fail "both motion and free_field are given; motion is for the base, free_field for the sides"
  end
  s.motions = o.motion ~= nil and read_motions(o.motion, dim) or nil
  s.free_field = o.free_field ~= nil and read_free_field(o, axis, dim) or nil
  s.ground = ground_of(o, s.free_field, s.nodes, dim == 2 and 2 or 3)
  s.z = impedances(s.ground, axis, dim)
  check_motions(s)
  local fields = s.free_field and prepare_free_field(s, dim) or {}
  local anchor, reach = add_anchor(model, s, dim)
  local area, bearings = 0, {}
  for i, node in ipairs(s.nodes) do
    local spec = laws_of(s.z, node.size, s.directions, dim)
    spec.name, spec.between, spec.at, spec.arm = ("%s.%d"):format(s.name, i), { anchor, body }, node.at, reach
    bearings[i], area = model:bearing(spec), area + node.size
  end
  add_motion(model, s)
  add_free_field(model, s, fields)
  return { name = s.name, area = area, bearings = bearings }
end
