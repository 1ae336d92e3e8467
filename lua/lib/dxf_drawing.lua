-- Reads a DXF drawing into chains of points; trilith.dxf makes outlines of them.
local trilith, core = ...

local owner = "dxf"
local units = { [1] = 0.0254, [2] = 0.3048, [4] = 1e-3, [5] = 1e-2, [6] = 1, [14] = 0.1 } -- $INSUNITS to m
-- Entities without geometry of their own.
local silent_types = { VERTEX = true, SEQEND = true, ENDSEC = true, TEXT = true, MTEXT = true, DIMENSION = true,
  POINT = true, LEADER = true, MULTILEADER = true, VIEWPORT = true, ATTDEF = true }

--- Folder of the running script, with a final slash; "" if it is unknown.
local function script_folder()
  for level = 2, 20 do
    local info = debug.getinfo(level, "S")
    if not info then break end
    local folder = info.source:match "^@(.*/)"
    if folder then return folder end
  end
  return ""
end

--- A file in the current folder or in the folder of the script. `io` is the script's own one, whose paths are limited.
function core.open_file(caller, path)
  local open = rawget(_G, "io").open
  local file, why = open(path, "rb")
  if not file and path:sub(1, 1) ~= "/" and script_folder() ~= "" then file = open(script_folder() .. path, "rb") end
  if not file then core.fail(("%s: cannot read '%s': %s"):format(caller, path, tostring(why))) end
  return file
end

--- All groups of the file: codes and values, in turn.
local function read_groups(path)
  local file = core.open_file(owner, path)
  local text = file:read "a"
  file:close()
  if text:find("^AutoCAD Binary DXF") then
    core.fail(("%s: '%s' is a binary DXF file; save it as ASCII DXF"):format(owner, path))
  end
  local codes, values, line = {}, {}, 0
  for row in (text:gsub("\r\n?", "\n") .. "\n"):gmatch "(.-)\n" do
    line = line + 1
    local content = row:match "^%s*(.-)%s*$"
    if line % 2 == 1 then
      if content == "" then break end
      local code = tonumber(content)
      if not code then
        core.fail(("%s: '%s', line %d: '%s' is not a group code; the file is not an ASCII DXF file, or it is damaged")
          :format(owner, path, line, content:sub(1, 40)))
      end
      codes[#codes + 1] = code
    else
      values[#values + 1] = content
    end
    if line > 2e7 then core.fail(("%s: '%s' has more than 20,000,000 lines"):format(owner, path)) end
  end
  if #codes ~= #values or #codes < 2 then
    core.fail(("%s: '%s' ends within a group; the file is not an ASCII DXF file, or it is cut off"):format(owner, path))
  end
  return codes, values
end

local function number_of(path, code, value)
  local number = tonumber(value)
  if not number or number ~= number or math.abs(number) == math.huge then
    core.fail(("%s: '%s': group %d has the value '%s', must be a number"):format(owner, path, code, value))
  end
  return number
end

--- Entities of the drawing as { type, layer, groups = { {code, value}, ... } }, the unit of the header, and the blocks
--- by name, each { entities = , base = }.
local function read_entities(path)
  local codes, values = read_groups(path)
  local entities, blocks, section, entity, block, unit = {}, {}, nil, nil, nil, nil
  for i, code in ipairs(codes) do
    local value = values[i]
    if code == 0 and value == "SECTION" then
      section = codes[i + 1] == 2 and values[i + 1] or nil
    elseif code == 0 and value == "ENDSEC" then
      section, entity, block = nil, nil, nil
    elseif section == "HEADER" and code == 9 and value == "$INSUNITS" and codes[i + 1] == 70 then
      unit = units[tonumber(values[i + 1])]
    elseif section == "BLOCKS" and code == 0 and value == "BLOCK" then
      block = { entities = {}, layer = "0", groups = {} }
      entity = block
    elseif section == "BLOCKS" and code == 0 and value == "ENDBLK" then
      block, entity = nil, nil
    elseif (section == "ENTITIES" or block) and code == 0 then
      entity = { type = value, layer = "0", groups = {} }
      table.insert(block and block.entities or entities, entity)
    elseif entity then
      if code == 8 then entity.layer = value else entity.groups[#entity.groups + 1] = { code, value } end
      if entity == block and code == 2 then blocks[value] = block end
    end
  end
  return entities, unit, blocks
end

--- Value of the first group `code` of an entity.
local function group_of(path, entity, code, preset)
  for _, group in ipairs(entity.groups) do
    if group[1] == code then return number_of(path, code, group[2]) end
  end
  return preset
end

--- Points along the arc from a to b with the bulge tan(angle/4), without a and with b.
local function add_side(points, a, b, bulge, steps)
  if bulge ~= 0 and (a[1] ~= b[1] or a[2] ~= b[2]) then
    local angle = 4*trilith.math.atan(bulge)
    local count = math.max(1, math.ceil(math.abs(angle)/(math.pi/2)*steps))
    -- The centre lies on the perpendicular bisector of the chord.
    local away = (1 - bulge^2)/(4*bulge)
    local cx = (a[1] + b[1])/2 - (b[2] - a[2])*away
    local cy = (a[2] + b[2])/2 + (b[1] - a[1])*away
    for k = 1, count - 1 do
      local c, s = trilith.math.cos(angle*k/count), trilith.math.sin(angle*k/count)
      local x, y = a[1] - cx, a[2] - cy
      points[#points + 1] = { cx + c*x - s*y, cy + s*x + c*y }
    end
  end
  points[#points + 1] = { b[1], b[2] }
end

--- The points of corners { x, y, bulge }, with arcs as chords. Closed: the first point is not repeated.
local function flattened(corners, closed, steps)
  local points = { { corners[1][1], corners[1][2] } }
  for i = 2, #corners do add_side(points, corners[i - 1], corners[i], corners[i - 1].bulge, steps) end
  if closed then
    add_side(points, corners[#corners], corners[1], corners[#corners].bulge, steps)
    points[#points] = nil
  end
  return points
end

local function corners_of_lwpolyline(path, entity)
  local corners = {}
  for _, group in ipairs(entity.groups) do
    local code = group[1]
    if code == 10 then
      corners[#corners + 1] = { number_of(path, code, group[2]), 0, bulge = 0 }
    elseif #corners > 0 and code == 20 then
      corners[#corners][2] = number_of(path, code, group[2])
    elseif #corners > 0 and code == 42 then
      corners[#corners].bulge = number_of(path, code, group[2])
    end
  end
  return corners
end

--- Vertices that follow a POLYLINE, up to SEQEND.
local function corners_of_polyline(path, entities, first)
  local corners = {}
  for i = first + 1, #entities do
    local entity = entities[i]
    if entity.type ~= "VERTEX" then break end
    corners[#corners + 1] = { group_of(path, entity, 10, 0), group_of(path, entity, 20, 0),
      bulge = group_of(path, entity, 42, 0) }
  end
  return corners
end

--- The points of an ARC, anticlockwise between its angles, or of a whole CIRCLE.
local function points_of_arc(path, entity, steps)
  local x, y, radius = group_of(path, entity, 10, 0), group_of(path, entity, 20, 0), group_of(path, entity, 40, 0)
  local from, to = group_of(path, entity, 50, 0), group_of(path, entity, 51, 360)
  local angle = entity.type == "CIRCLE" and 360 or (to - from)%360
  if angle == 0 then angle = 360 end
  local count, points = math.max(1, math.ceil(angle/90*steps - 1e-9)), {}
  for k = 0, entity.type == "CIRCLE" and count - 1 or count do
    local at = math.rad((entity.type == "CIRCLE" and 0 or from) + angle*k/count)
    points[#points + 1] = { x + radius*trilith.math.cos(at), y + radius*trilith.math.sin(at) }
  end
  return points
end

--- Points and closedness of an entity with a geometry of its own, or nil.
local function geometry_of(path, entities, i, steps)
  local entity = entities[i]
  local closed = math.tointeger(group_of(path, entity, 70, 0)//1) & 1 == 1
  local corners
  if entity.type == "LINE" then
    return { { group_of(path, entity, 10, 0), group_of(path, entity, 20, 0) },
      { group_of(path, entity, 11, 0), group_of(path, entity, 21, 0) } }, false
  elseif entity.type == "ARC" or entity.type == "CIRCLE" then
    if group_of(path, entity, 40, 0) <= 0 then return {}, false end
    return points_of_arc(path, entity, steps), entity.type == "CIRCLE"
  elseif entity.type == "LWPOLYLINE" then
    corners = corners_of_lwpolyline(path, entity)
  elseif entity.type == "POLYLINE" then
    corners = corners_of_polyline(path, entities, i)
  end
  if not corners then return nil end
  if #corners < 2 then return {}, false end
  return flattened(corners, closed, steps), closed
end

-- A placement maps { x, y } to { a x + b y + e, c x + d y + f }; entities with a normal along -z are mirrored in x.
local in_place = { a = 1, b = 0, c = 0, d = 1, e = 0, f = 0 }

local function moved(p, at) return { at.a*p[1] + at.b*p[2] + at.e, at.c*p[1] + at.d*p[2] + at.f } end

--- `inner`, then `outer`.
local function after(outer, inner)
  local e = moved({ inner.e, inner.f }, outer)
  return { a = outer.a*inner.a + outer.b*inner.c, b = outer.a*inner.b + outer.b*inner.d,
    c = outer.c*inner.a + outer.d*inner.c, d = outer.c*inner.b + outer.d*inner.d, e = e[1], f = e[2] }
end

local function facing(path, entity)
  if group_of(path, entity, 230, 1) >= 0 then return in_place end
  return { a = -1, b = 0, c = 0, d = 1, e = 0, f = 0 }
end

--- Placements of the block of an INSERT: one, or one for each row and column.
local function placements_of(path, entity, block)
  local sx, sy = group_of(path, entity, 41, 1), group_of(path, entity, 42, 1)
  local turn = math.rad(group_of(path, entity, 50, 0))
  local c, s = trilith.math.cos(turn), trilith.math.sin(turn)
  local x, y = group_of(path, entity, 10, 0), group_of(path, entity, 20, 0)
  local bx, by = group_of(path, block, 10, 0), group_of(path, block, 20, 0)
  local columns, rows = group_of(path, entity, 70, 1), group_of(path, entity, 71, 1)
  if columns*rows > 1e5 then
    core.fail(("%s: '%s' inserts a block %g times, at most 100,000"):format(owner, path, columns*rows))
  end
  local wide, tall, out = group_of(path, entity, 44, 0), group_of(path, entity, 45, 0), {}
  for row = 0, math.max(1, rows) - 1 do
    for column = 0, math.max(1, columns) - 1 do
      local dx, dy = column*wide, row*tall
      local own = { a = c*sx, b = -s*sy, c = s*sx, d = c*sy, e = x + c*dx - s*dy, f = y + s*dx + c*dy }
      out[#out + 1] = after(facing(path, entity), after(own, { a = 1, b = 0, c = 0, d = 1, e = -bx, f = -by }))
    end
  end
  return out
end

--- Chains of points { layer, closed, points } of the drawing, and numbers of skipped entities by type. Entities of a
--- block on layer 0 are on the layer of its INSERT.
local function read_chains(path, drawing, blocks, steps)
  local chains, skipped = {}, {}
  local function add(entities, at, layer, open)
    for i, entity in ipairs(entities) do
      local own = layer and entity.layer == "0" and layer or entity.layer
      local points, closed = geometry_of(path, entities, i, steps)
      local name = nil
      if entity.type == "INSERT" then
        for _, group in ipairs(entity.groups) do name = name or group[1] == 2 and group[2] or nil end
      end
      if points and #points > 1 then
        local placement, out = after(at, facing(path, entity)), {}
        for k, p in ipairs(points) do out[k] = moved(p, placement) end
        chains[#chains + 1] = { layer = own, closed = closed, points = out }
      elseif name and blocks[name] then
        if open[name] then
          core.fail(("%s: '%s': the block '%s' contains itself"):format(owner, path, name))
        end
        open[name] = true
        for _, placement in ipairs(placements_of(path, entity, blocks[name])) do
          add(blocks[name].entities, after(at, placement), own, open)
        end
        open[name] = nil
      elseif not points and not silent_types[entity.type] then
        skipped[entity.type] = (skipped[entity.type] or 0) + 1
      end
    end
  end
  add(drawing, in_place, nil, {})
  return chains, skipped
end

--- Chains of a drawing on disk, its skipped entities by type, and its unit in m (nil without one in the header).
function core.read_drawing(path, steps)
  local entities, unit, blocks = read_entities(path)
  local chains, skipped = read_chains(path, entities, blocks, steps)
  return chains, skipped, unit
end
