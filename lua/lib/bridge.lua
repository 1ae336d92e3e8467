-- m:bridge{...}: a bridge of simple spans from two tables, in the plane by m:abutment, m:pier and m:span.
local _, core = ...
local model_methods = core.members "model"

local known = { "x", "soffit_level", "gap", "seat", "material", "supports", "spans", "abutment", "pier", "span" }
local is_known = {}
for _, key in ipairs(known) do is_known[key] = true end

local what_is = core.what_is

local function check_table(options, key)
  local value = options[key]
  if value ~= nil and type(value) ~= "table" then
    core.fail(("bridge: '%s' is %s, must be a table"):format(key, what_is(value)))
  end
  return value or {}
end

local function names_in(row)
  local names = {}
  for name in pairs(row) do names[#names + 1] = tostring(name) end
  table.sort(names)
  return names
end

local function check_number(owner, row, key, preset)
  local value = row[key]
  if value == nil then value = preset end
  if value == nil then
    local near = core.hint(key, names_in(row)):match "did you mean '(.-)'"
    core.fail(("%s: '%s' is missing; %s"):format(owner, key,
      near and ("is it misspelled as '%s'?"):format(near) or "give a number in m"))
  end
  if type(value) ~= "number" or value ~= value or value == math.huge or value == -math.huge then
    core.fail(("%s: '%s' is %s, must be a finite number in m"):format(owner, key, what_is(value)))
  end
  return value
end

-- Rejects keys of rows that follow from the bridge as a whole.
local function refuse(owner, row, ...)
  for _, key in ipairs { ... } do
    if row[key] ~= nil then
      core.fail(("%s: '%s' is given, but follows from lengths and heights of the bridge; leave it out")
        :format(owner, key))
    end
  end
end

local function check(options)
  if type(options) ~= "table" then
    core.fail(("bridge: takes a table { supports = , spans = , ... }; this is %s"):format(what_is(options)))
  end
  local unknown
  for key in pairs(options) do
    if not is_known[key] and (not unknown or tostring(key) < unknown) then unknown = tostring(key) end
  end
  if unknown then core.fail(("bridge: unknown key '%s'%s"):format(unknown, core.hint(unknown, known))) end
  local supports, spans = check_table(options, "supports"), check_table(options, "spans")
  for _, key in ipairs { "gap", "seat" } do check_number("bridge", options, key, 0) end
  if #spans == 0 then core.fail "bridge: 'spans' is missing; give a list of spans, from left to right" end
  if #supports ~= #spans + 1 then
    core.fail(("bridge: %d spans and %d supports; there is one support more than spans, from left to right")
      :format(#spans, #supports))
  end
  for _, list in ipairs { "supports", "spans" } do
    for i, row in ipairs(options[list]) do
      if type(row) ~= "table" then
        core.fail(("bridge: row %d of '%s' is %s, must be a table"):format(i, list, what_is(row)))
      end
    end
  end
  return supports, spans
end

-- The values of the row; for missing keys the common values of its kind.
local function merged(...)
  local all = {}
  for _, t in ipairs { ... } do
    for key, value in pairs(t) do
      if all[key] == nil then all[key] = value end
    end
  end
  return all
end

local function owner_of(kind, row, i)
  return type(row.name) == "string" and ("%s '%s'"):format(kind, row.name) or ("bridge: %s %d"):format(kind, i)
end

-- Makes support i, `rise` lower than the soffit: by the height of its bearings.
local function add_support(model, options, row, place)
  local owner = owner_of(place.kind, row, place.i)
  local height = check_number(owner, row, "height")
  refuse(owner, row, "x", "station", "side", "ground_level")
  local keys = merged(row, { gap = options.gap, seat = options.seat, material = options.material })
  keys.ground_level = place.soffit - height
  keys.height = height - place.rise
  if place.kind == "pier" then
    keys.station = place.x
    return model:pier(keys)
  end
  for _, key in ipairs { "gap", "seat" } do
    if keys[key] == nil then
      core.fail(("%s: '%s' is missing; give a number in m, there or for the whole bridge"):format(owner, key))
    end
  end
  keys.side, keys.station = place.i == 1 and "left" or "right", place.x
  if keys.back_wall_height then
    keys.back_wall_height = check_number(owner, keys, "back_wall_height") + place.rise
  end
  return model:abutment(keys)
end

local function add_supports(model, options, supports, spans, soffit)
  local made, x = {}, check_number("bridge", options, "x", 0)
  for i, given in ipairs(supports) do
    local kind = (i == 1 or i == #supports) and "abutment" or "pier"
    local row = merged(given, check_table(options, kind))
    local span, side = spans[i] or spans[i - 1], spans[i] and "left" or "right"
    local rise = core.bearing_height(model, span[side], owner_of("span", span, i) .. ": " .. side)
    made[i] = add_support(model, options, row, { kind = kind, i = i, x = x, soffit = soffit, rise = rise })
    made[made[i].name] = made[i]
    if spans[i] then
      local owner = owner_of("span", spans[i], i)
      local length = check_number(owner, spans[i], "length")
      if length <= 0 then core.fail(("%s: 'length' is %g m, must be above 0"):format(owner, length)) end
      x = x + length
    end
  end
  return made
end

--- Adds a whole bridge or nothing: if a script catches the error, the model is unchanged. A model that has run receives
--- it as a whole, because a deck is supported by its bearings only.
function core.whole_bridge(model, make)
  local whole = false
  local _ <close> = setmetatable({}, { __close = function()
    if not whole then core.take_back(model) end
  end })
  core.add_together(model, true)
  local bridge = make()
  core.add_together(model, false)
  whole = true
  return bridge
end

local function made_of(model, options, supports, spans)
  local soffit = check_number("bridge", options, "soffit_level", 0)
  local shared = merged({ soffit_level = soffit }, check_table(options, "span"), { material = options.material })
  local rows = {}
  for i, span in ipairs(spans) do rows[i] = merged(span, shared) end
  local bridge = { supports = add_supports(model, options, supports, rows, soffit), spans = {} }
  for i, row in ipairs(rows) do
    refuse(owner_of("span", row, i), spans[i], "from", "to", "soffit_level")
    row.length, row.from, row.to = nil, bridge.supports[i], bridge.supports[i + 1]
    local span = model:span(row)
    bridge.spans[i], bridge.spans[span.name] = span, span
  end
  return bridge
end

--- m:bridge{ supports = {...}, spans = {...}, gap =, seat =, ... }: { supports, spans }, each in order and by name; in
--- space see core.bridge_in_space.
function model_methods.bridge(model, options)
  if model.dim == 3 then return core.bridge_in_space(model, options) end
  local supports, spans = check(options)
  return core.whole_bridge(model, function() return made_of(model, options, supports, spans) end)
end
