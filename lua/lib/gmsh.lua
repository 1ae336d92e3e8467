-- m:gmsh{...}: the physical groups of a Gmsh mesh (versions 4.1 and 2.2, ASCII) as bodies and groups.
local _, core = ...
local owner = "gmsh"
local methods = core.members "model"

-- Element types of Gmsh: dimension, number of nodes, and number of nodes that a body uses: in the plane the corners.
local types = {
  [15] = { dim = 0, nodes = 1 }, [1] = { dim = 1, nodes = 2 }, [8] = { dim = 1, nodes = 3 },
  [2] = { dim = 2, nodes = 3, corners = 3 }, [3] = { dim = 2, nodes = 4, corners = 4 },
  [9] = { dim = 2, nodes = 6, corners = 3 }, [16] = { dim = 2, nodes = 8, corners = 4 },
  [10] = { dim = 2, nodes = 9, corners = 4 }, [4] = { dim = 3, nodes = 4, corners = 4 },
  [5] = { dim = 3, nodes = 8, corners = 8 }, [6] = { dim = 3, nodes = 6, corners = 6 },
  [11] = { dim = 3, nodes = 10, corners = 10 },
}
local entity_names = { [2] = "surface", [3] = "volume" }

local function fail(file, ...) core.fail(("%s: '%s': %s"):format(owner, file.path, string.format(...))) end

--- The numbers of a section, one by one.
local function numbers_of(file, section)
  local next_word, text = (file.sections[section] or ""):gmatch "%S+", nil
  return function()
    text = next_word()
    local value = text and tonumber(text)
    if not value then
      fail(file, "section $%s %s", section, text and ("has '%s' where a number is expected"):format(text:sub(1, 40))
        or "ends too early")
    end
    return value
  end
end

--- The sections of a file as texts, by name.
local function read_sections(path)
  local handle = core.open_file(owner, path)
  local text = handle:read("a"):gsub("\r\n?", "\n") .. "\n"
  handle:close()
  local file, from = { path = path, sections = {} }, 1
  if not text:find "^%s*%$MeshFormat" then fail(file, "does not begin with $MeshFormat, so it is not a Gmsh mesh") end
  while true do
    local _, to, name, content = text:find("%$(%a+)[^\n]*\n(.-)%f[%$]%$End%1", from)
    if not to then break end
    if file.sections[name] then fail(file, "section $%s appears twice", name) end
    file.sections[name], from = content, to + 1
  end
  local version, binary = (file.sections.MeshFormat or ""):match "^%s*(%S+)%s+(%d+)"
  if version ~= "4.1" and version ~= "2.2" and version ~= "2" then
    fail(file, "has version '%s', must be 4.1 or 2.2; save it as Version 4 ASCII", tostring(version))
  end
  if binary ~= "0" then fail(file, "is binary, must be text; save it as Version 4 ASCII") end
  for _, name in ipairs { "Nodes", "Elements" } do
    if not file.sections[name] then fail(file, "has no complete section $%s", name) end
  end
  file.in_blocks = version == "4.1"
  return file
end

--- Names of physical groups of a dimension, by number.
local function read_names(file, dim)
  local names = {}
  for of, tag, name in (file.sections.PhysicalNames or ""):gmatch '(%d+)%s+(%d+)%s+"([^"\n]*)"' do
    if tonumber(of) == dim then names[tonumber(tag)] = name end
  end
  if not next(names) then
    fail(file, "no physical group of %ss has a name; give one with Physical %s(\"name\") = { ... }", entity_names[dim],
      dim == 2 and "Surface" or "Volume")
  end
  return names
end

--- Physical groups of the surfaces or volumes of version 4.1, by number of the entity.
local function read_entities(file, dim)
  local groups, number = {}, numbers_of(file, "Entities")
  local counts = { [0] = number(), number(), number(), number() }
  for of = 0, 3 do
    for _ = 1, counts[of] do
      local tag, list = number(), {}
      for _ = 1, of == 0 and 3 or 6 do number() end
      for i = 1, number() do list[i] = math.abs(number()) end
      for _ = 1, of == 0 and 0 or number() do number() end
      if of == dim then groups[tag] = list end
    end
  end
  return groups
end

local function add_node(file, nodes, tag, number)
  if nodes[tag] then fail(file, "node %d is given twice", tag) end
  nodes[tag] = { number(), number(), number() }
end

local function read_nodes(file)
  local nodes, number = {}, numbers_of(file, "Nodes")
  if not file.in_blocks then
    for _ = 1, number() do add_node(file, nodes, number(), number) end
    return nodes
  end
  local blocks = number()
  for _ = 1, 3 do number() end
  for _ = 1, blocks do
    local dim, _, parametric, tags = number(), number(), number() ~= 0, {}
    for i = 1, number() do tags[i] = number() end
    for _, tag in ipairs(tags) do
      add_node(file, nodes, tag, number)
      for _ = 1, parametric and dim or 0 do number() end
    end
  end
  return nodes
end

--- One element: its nodes are checked, and it is added if it has the dimension of the model.
local function add_element(file, list, kind, number, group, entity, nodes)
  local element = { group = group, entity = entity }
  for i = 1, kind.nodes do
    element[i] = number()
    if not nodes[element[i]] then fail(file, "an element has node %d, which does not exist", element[i]) end
  end
  if kind.dim == list.dim then
    element.kind = kind
    list[#list + 1] = element
  end
end

local function type_of(file, number)
  return types[number] or fail(file, "elements of type %d cannot be used; use triangles and quadrilaterals in the "
    .. "plane, tetrahedra, hexahedra of eight nodes and prisms in space", number)
end

--- Elements of the dimension, each with its group and surface or volume.
local function read_elements(file, dim, nodes)
  local list, number = { dim = dim }, numbers_of(file, "Elements")
  if not file.in_blocks then
    for _ = 1, number() do
      number()
      local kind, tags = type_of(file, number()), {}
      for i = 1, number() do tags[i] = number() end
      add_element(file, list, kind, number, { tags[1] ~= 0 and tags[1] or nil }, tags[2] or 0, nodes)
    end
    return list
  end
  local groups, blocks = read_entities(file, dim), number()
  for _ = 1, 3 do number() end
  for _ = 1, blocks do
    local _, entity = number(), number()
    local kind, count = type_of(file, number()), number()
    for _ = 1, count do
      number()
      add_element(file, list, kind, number, groups[entity] or {}, entity, nodes)
    end
  end
  return list
end

--- The name of an element's group. Each element is in one group, which has a name.
local function group_name(file, element, names, dim)
  local where = ("%s %d"):format(entity_names[dim], element.entity)
  local first, second = element.group[1], element.group[2]
  if not first then
    fail(file, "%s is in no physical group; put each %s into one group", where, entity_names[dim])
  end
  if second then
    fail(file, "%s is in the physical groups %s and %s; a body has one, so take it out of the other",
      where, names[first] or first, names[second] or second)
  end
  if not names[first] or names[first] == "" then
    fail(file, "the physical group %d, of %s, has no name; give it one, as in Physical %s(\"pier\") = { ... }", first,
      where, dim == 2 and "Surface" or "Volume")
  end
  return (names[first]:gsub("[^%w_.-]", "_"))
end

--- Version 2.2 writes an element of two groups twice.
local function require_single(file, seen, element, name)
  local sorted = { table.unpack(element, 1, element.kind.nodes) }
  table.sort(sorted)
  local key = table.concat(sorted, " ")
  if seen[key] then
    fail(file, "an element is in the physical groups %s and %s; a body has one, so take it out of the other",
      seen[key], name)
  end
  seen[key] = name
end

--- Elements of the plane have straight sides: each node of a side is its middle.
local function require_straight(file, element, nodes)
  local corners = element.kind.corners
  if element.kind.dim ~= 2 or element.kind.nodes < 2*corners then return end
  for k = 1, corners do
    local a, b, c = nodes[element[k]], nodes[element[k % corners + 1]], nodes[element[corners + k]]
    local dx, dy = c[1] - 0.5*(a[1] + b[1]), c[2] - 0.5*(a[2] + b[2])
    if dx^2 + dy^2 > 1e-4*((a[1] - b[1])^2 + (a[2] - b[2])^2) then
      fail(file, "an element has a curved side; save the mesh with order 1 and more elements")
    end
  end
end

--- Numbers the connected parts of a list of elements: elements that share a node. Returns the elements of each part.
local function connected_parts(elements)
  local above = {}
  local function root(n)
    while above[n] ~= n do
      above[n] = above[above[n]]
      n = above[n]
    end
    return n
  end
  for _, element in ipairs(elements) do
    for i = 1, element.kind.corners do
      above[element[i]] = above[element[i]] or element[i]
      above[root(element[i])] = root(element[1])
    end
  end
  local parts, by_root = {}, {}
  for _, element in ipairs(elements) do
    local r = root(element[1])
    if not by_root[r] then
      by_root[r] = {}
      parts[#parts + 1] = by_root[r]
    end
    table.insert(by_root[r], element)
  end
  return parts
end

--- The mesh of a part, with its own numbers of nodes.
local function mesh_of(file, elements, nodes, dim, scale)
  local mesh, number, level = { nodes = {}, elements = {} }, {}, nil
  for _, element in ipairs(elements) do
    require_straight(file, element, nodes)
    local own = {}
    for i = 1, element.kind.corners do
      local tag = element[i]
      if not number[tag] then
        local place = {}
        for k = 1, dim do place[k] = nodes[tag][k]*scale end
        mesh.nodes[#mesh.nodes + 1] = place
        number[tag] = #mesh.nodes
      end
      own[i] = number[tag]
      level = level or nodes[tag][3]
      if dim == 2 and math.abs(nodes[tag][3] - level) > 1e-9*math.max(1, math.abs(level)) then
        fail(file, "its nodes have different z, %g and %g; the mesh must lie in one plane of constant z", level,
          nodes[tag][3])
      end
    end
    mesh.elements[#mesh.elements + 1] = own
  end
  return mesh
end

--- Elements by name of their group, and the names in the order of the file.
local function by_group_name(file, dim, nodes)
  local names, elements = read_names(file, dim), read_elements(file, dim, nodes)
  local groups, order, seen = {}, {}, {}
  for _, element in ipairs(elements) do
    local name = group_name(file, element, names, dim)
    require_single(file, seen, element, name)
    if not groups[name] then
      groups[name] = {}
      order[#order + 1] = name
    end
    table.insert(groups[name], element)
  end
  if #order == 0 then
    fail(file, "has no %s elements; mesh the %ss (Mesh %d) before saving", dim == 2 and "surface" or "volume",
      entity_names[dim], dim)
  end
  return groups, order
end

--- Notes where parts of a group have nodes at the same places: a mesh that was cut, not merged, has them twice.
local function note_doubled(model, name, parts, nodes)
  local part_at, doubled = {}, false
  for i, elements in ipairs(parts) do
    for _, element in ipairs(elements) do
      for k = 1, element.kind.corners do
        local place = ("%.9g %.9g %.9g"):format(table.unpack(nodes[element[k]], 1, 3))
        doubled = doubled or (part_at[place] or i) ~= i
        part_at[place] = i
      end
    end
  end
  if not doubled then return end
  core.note_input(model, ("%s: group '%s' becomes %d bodies, which touch but share no node; if it is one body, merge "
    .. "the nodes in Gmsh with Coherence Mesh, and save the mesh again"):format(owner, name, #parts))
end

local body_keys = { "material", "density", "unit_weight", "support", "velocity", "floating", "body", "hold" }

local function list_of(value) return type(value) == "table" and value or { value } end

--- Names in a key that no group has.
local function require_groups(key, names, order)
  for _, name in ipairs(names) do
    local known = false
    for _, group in ipairs(order) do known = known or group == name end
    if not known then
      core.fail(("%s: '%s' has '%s', which is not a physical group%s"):format(owner, key, tostring(name),
        core.hint(tostring(name), order)))
    end
  end
end

--- The keys of the bodies of a group.
local function keys_of(options, name)
  local keys, fixed = {}, false
  for _, key in ipairs(body_keys) do keys[key] = options[key] end
  for key, value in pairs(options.by_group and options.by_group[name] or {}) do keys[key] = value end
  for _, one in ipairs(list_of(options.fixed)) do fixed = fixed or one == name end
  if fixed then keys.support = "fixed" end
  keys.groups = { name }
  for _, group in ipairs(list_of(options.groups)) do table.insert(keys.groups, group) end
  return keys
end

local function check(options)
  local known = { "file", "scale", "name", "groups", "fixed", "by_group", table.unpack(body_keys) }
  core.check_keys(owner, options, known)
  if type(options.file) ~= "string" then
    core.fail(("%s: 'file' is %s, must be the path of a Gmsh mesh"):format(owner,
      options.file == nil and "missing" or core.what_is(options.file)))
  end
  if options.by_group ~= nil and type(options.by_group) ~= "table" then
    core.fail(("%s: 'by_group' is %s, must be { group = { keys } }"):format(owner, core.what_is(options.by_group)))
  end
end

function methods.gmsh(model, options)
  check(options)
  local scale = options.scale == nil and 1 or core.positive(owner, "scale", options.scale, "")
  local file, dim = read_sections(options.file), model.dim
  local nodes = read_nodes(file)
  local groups, order = by_group_name(file, dim, nodes)
  require_groups("fixed", list_of(options.fixed), order)
  local named = {}
  for name in pairs(options.by_group or {}) do named[#named + 1] = name end
  table.sort(named, function(a, b) return tostring(a) < tostring(b) end)
  require_groups("by_group", named, order)
  local made, prefix = {}, options.name and options.name .. "." or ""
  for _, name in ipairs(order) do
    local parts = connected_parts(groups[name])
    if #parts > 1 then note_doubled(model, name, parts, nodes) end
    for i, elements in ipairs(parts) do
      local keys = keys_of(options, name)
      keys.name = prefix .. name .. (#parts > 1 and "." .. i or "")
      keys.mesh = mesh_of(file, elements, nodes, dim, scale)
      made[#made + 1] = model:body(keys).name
    end
  end
  return model:bodies { name = made }
end
