-- trilith.dxf{...}: closed outlines of a DXF drawing as parts for m:add, with their layers as groups.
local trilith, core = ...

local owner = "dxf"
local most_arc_segments = 1000
local unit_names = { mm = 1e-3, cm = 1e-2, dm = 0.1, m = 1, ["in"] = 0.0254, ft = 0.3048 }

local function reversed(points)
  local out = {}
  for i = #points, 1, -1 do out[#out + 1] = points[i] end
  return out
end

--- Joins open chains of a layer whose ends meet. Ends are compared on a grid of the tolerance, and in its neighbours.
local function join(chains, tolerance)
  local ends = {}
  local function cell(p, dx, dy)
    return ("%d,%d"):format(math.floor(p[1]/tolerance + 0.5) + dx, math.floor(p[2]/tolerance + 0.5) + dy)
  end
  local function add(chain, p)
    local key = cell(p, 0, 0)
    ends[key] = ends[key] or {}
    table.insert(ends[key], chain)
  end
  for _, chain in ipairs(chains) do add(chain, chain.points[1]) add(chain, chain.points[#chain.points]) end
  local function next_at(p)
    for dx = -1, 1 do
      for dy = -1, 1 do
        for _, chain in ipairs(ends[cell(p, dx, dy)] or {}) do
          if not chain.used then
            local a, b = chain.points[1], chain.points[#chain.points]
            if math.max(math.abs(a[1] - p[1]), math.abs(a[2] - p[2])) <= tolerance then return chain, chain.points end
            if math.max(math.abs(b[1] - p[1]), math.abs(b[2] - p[2])) <= tolerance then
              return chain, reversed(chain.points)
            end
          end
        end
      end
    end
    return nil
  end
  local loops, open = {}, 0
  for _, start in ipairs(chains) do
    if not start.used then
      start.used = true
      local points = table.move(start.points, 1, #start.points, 1, {})
      for _ = 1, 2 do -- from its end, then from its start
        local chain, more = next_at(points[#points])
        while chain do
          chain.used = true
          table.move(more, 2, #more, #points + 1, points)
          chain, more = next_at(points[#points])
        end
        points = reversed(points)
      end
      local a, b = points[1], points[#points]
      if #points > 3 and math.max(math.abs(a[1] - b[1]), math.abs(a[2] - b[2])) <= tolerance then
        points[#points] = nil
        loops[#loops + 1] = { layer = start.layer, points = points }
      else
        open = open + 1
      end
    end
  end
  return loops, open
end

--- Without points that repeat their predecessor within the tolerance.
local function cleaned(points, tolerance)
  local out = {}
  for _, p in ipairs(points) do
    local last = out[#out]
    if not last or math.max(math.abs(last[1] - p[1]), math.abs(last[2] - p[2])) > tolerance then out[#out + 1] = p end
  end
  while #out > 1 and math.max(math.abs(out[1][1] - out[#out][1]), math.abs(out[1][2] - out[#out][2])) <= tolerance do
    out[#out] = nil
  end
  return out
end

--- Loops of the drawing in the order of their layers in the file, and the number of open chains.
local function loops_of(chains, wanted, tolerance)
  local loops, open_by_layer, layers, open = {}, {}, {}, 0
  for _, chain in ipairs(chains) do
    if not wanted or wanted[chain.layer] then
      if chain.closed then
        loops[#loops + 1] = chain
      else
        if not open_by_layer[chain.layer] then
          open_by_layer[chain.layer], layers[#layers + 1] = {}, chain.layer
        end
        table.insert(open_by_layer[chain.layer], chain)
      end
    end
  end
  for _, layer in ipairs(layers) do
    local joined, left = join(open_by_layer[layer], tolerance)
    table.move(joined, 1, #joined, #loops + 1, loops)
    open = open + left
  end
  return loops, open
end

local function scale_of(options, unit, path)
  if options.unit == nil then
    if unit then return unit end
    core.fail(("%s: '%s' names no unit of length; give unit = \"mm\", \"cm\", \"m\", \"in\" or \"ft\""):format(owner,
      path))
  end
  return unit_names[core.one_of(owner, "unit", options.unit, { "mm", "cm", "dm", "m", "in", "ft" })]
end

local function wanted_layers(options, chains)
  if options.layers == nil then return nil end
  local given = type(options.layers) == "string" and { options.layers } or options.layers
  if type(given) ~= "table" then
    core.fail(("%s: 'layers' is %s, must be a name or a list of names"):format(owner, core.what_is(given)))
  end
  local known, names, wanted = {}, {}, {}
  for _, chain in ipairs(chains) do
    if not known[chain.layer] then known[chain.layer], names[#names + 1] = true, chain.layer end
  end
  for _, layer in ipairs(given) do
    if not known[layer] then
      core.fail(("%s: there is no layer '%s' with lines%s"):format(owner, tostring(layer),
        core.hint(tostring(layer), names)))
    end
    wanted[layer] = true
  end
  return wanted
end

local function list_text(skipped)
  local names = {}
  for name, count in pairs(skipped) do names[#names + 1] = ("%d %s"):format(count, name) end
  table.sort(names)
  return table.concat(names, ", ")
end

function trilith.dxf(options)
  core.check_keys(owner, options, { "file", "unit", "layers", "origin", "arc_segments", "tolerance" })
  if type(options.file) ~= "string" then
    core.fail(("%s: 'file' is %s, must be the path of a DXF file"):format(owner,
      options.file == nil and "missing" or core.what_is(options.file)))
  end
  local steps = options.arc_segments == nil and 4 or options.arc_segments
  if math.type(steps) ~= "integer" or steps < 1 or steps > most_arc_segments then
    core.fail(("%s: 'arc_segments' is %s, must be a whole number from 1 to %d"):format(owner, core.what_is(steps),
      most_arc_segments))
  end
  local tolerance = options.tolerance == nil and 1e-4 or core.positive(owner, "tolerance", options.tolerance, " m")
  local origin = options.origin or { 0, 0 }
  if type(origin) ~= "table" or type(origin[1]) ~= "number" or type(origin[2]) ~= "number" then
    core.fail(("%s: 'origin' is %s, must be a point {x, y} of the drawing, in m"):format(owner, core.what_is(origin)))
  end
  local chains, skipped, unit = core.read_drawing(options.file, steps)
  local scale = scale_of(options, unit, options.file)
  local loops, open = loops_of(chains, wanted_layers(options, chains), tolerance/scale)
  local parts, count = {}, {}
  for _, loop in ipairs(loops) do
    local points = cleaned(loop.points, tolerance/scale)
    if #points >= 3 then
      local layer = loop.layer:gsub("%s+", "_")
      count[layer] = (count[layer] or 0) + 1
      local outline = {}
      for i, p in ipairs(points) do outline[i] = { p[1]*scale - origin[1], p[2]*scale - origin[2] } end
      parts[#parts + 1] = { name = ("%s.%d"):format(layer, count[layer]), outline = outline, groups = { layer } }
    end
  end
  if #parts == 0 then
    core.fail(("%s: '%s' has no closed outline%s; draw each stone as a closed polyline, or give a larger 'tolerance'")
      :format(owner, options.file, next(skipped) and " (not read: " .. list_text(skipped) .. ")" or ""))
  end
  return setmetatable(parts, { __index = { open = open, skipped = list_text(skipped), unit = scale } })
end
