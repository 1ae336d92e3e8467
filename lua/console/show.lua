-- Display of values at the console: readable, and never longer than a screen.
local console, core = ...

local most_entries, most_depth, most_width = 24, 3, 100

local function number_text(x)
  if math.type(x) == "integer" then return tostring(x) end
  local short = ("%.6g"):format(x)
  return tonumber(short) == x and short or ("%.10g"):format(x)
end

local function key_text(key, show)
  if type(key) == "string" and key:find "^[%a_][%w_]*$" then return key end
  return "[" .. show(key) .. "]"
end

local function sorted_keys(t)
  local keys = {}
  for key in next, t do
    if math.type(key) ~= "integer" or key < 1 or key > #t then keys[#keys + 1] = key end
  end
  table.sort(keys, function(a, b)
    if type(a) == type(b) and (type(a) == "number" or type(a) == "string") then return a < b end
    return tostring(a) < tostring(b)
  end)
  return keys
end

local show

local function entries_of(t, depth, seen)
  local entries, left = {}, 0
  local function add(text)
    if #entries < most_entries then entries[#entries + 1] = text else left = left + 1 end
  end
  for i = 1, #t do add(show(t[i], depth, seen)) end
  for _, key in ipairs(sorted_keys(t)) do
    add(key_text(key, function(k) return show(k, depth, seen) end) .. " = " .. show(rawget(t, key), depth, seen))
  end
  if left > 0 then entries[#entries + 1] = ("and %d more"):format(left) end
  return entries
end

local function table_text(t, depth, seen)
  if seen[t] then return "{ itself }" end
  if depth > most_depth then return next(t) == nil and "{}" or "{ ... }" end
  seen[t] = true
  local entries = entries_of(t, depth + 1, seen)
  seen[t] = nil
  if #entries == 0 then return "{}" end
  local line = "{ " .. table.concat(entries, ", ") .. " }"
  if #line <= most_width and not line:find "\n" then return line end
  local indent = ("  "):rep(depth)
  return "{\n" .. indent .. table.concat(entries, ",\n" .. indent) .. "\n" .. indent:sub(3) .. "}"
end

function show(value, depth, seen)
  if type(value) == "number" then return number_text(value) end
  if type(value) == "string" then return depth == 1 and value or ("%q"):format(value):gsub("\\\n", "\\n") end
  if type(value) == "function" and depth > 1 then return "function" end
  if type(value) ~= "table" then return tostring(value) end
  local meta = debug.getmetatable(value)
  if meta and meta.__tostring then return tostring(value) end
  if getmetatable(value) == "rows" then return console.show_rows(value) end
  return table_text(value, depth, seen)
end

--- Bearings, seats or storeys of a model: one line each.
function console.show_rows(rows)
  local lines = {}
  for i = 1, math.min(#rows, most_entries) do lines[i] = tostring(rows[i]) end
  if #rows > most_entries then lines[#lines + 1] = ("and %d more"):format(#rows - most_entries) end
  return #lines == 0 and "none" or table.concat(lines, "\n")
end

--- The text of a value, with several lines for a complex one.
function console.show(value)
  local kind = core.kind_of(value)
  if kind then return console.show_handle(value, kind) end
  return show(value, 1, {})
end

local function value_text(value, unit)
  local text = show(value, 2, {})
  if math.type(value) == "float" then text = ("%.6g"):format(value) end
  if type(value) == "string" then text = value end
  if unit ~= "" and unit ~= "1" then text = text .. " " .. unit end
  return #text <= 60 and text or text:sub(1, 57) .. "..."
end

-- For a model the numbers that need no evaluation; for other kinds all except these.
local of_model = { time = true, steps = true, dt = true, speed = true, ratio = true }
local of_deformed = { sxx = true, syy = true, szz = true, sxy = true, syz = true, szx = true, plastic = true }

local function is_shown(handle, kind, name)
  if kind == "model" then return of_model[name] end
  if kind == "body" and of_deformed[name] then return handle.kind ~= "rigid" end
  if kind == "bearing" and (name == "force" or name == "displacement") then return false end -- by direction, below
  return name ~= "name" and name ~= "outline" and name ~= "names" and name ~= "t" and name ~= "values"
end

local function names_in(set)
  local names = {}
  for i = 1, math.min(#set, most_entries) do names[i] = set[i].name end
  if #set > most_entries then names[#names + 1] = ("and %d more"):format(#set - most_entries) end
  return table.concat(names, ", ")
end

-- Kinds with properties that the first stage of a model creates.
local needs_stage = { bearing = true, seat = true, storey = true, model = true }

--- A body, bearing, set, ...: its title and all numbers that can be read, with units.
function console.show_handle(handle, kind)
  local lines = { tostring(handle) }
  if kind == "model" then
    lines[1] = ("%s: %d bodies, %d bearings, %d seats"):format(lines[1], #handle:bodies {}, #handle.bearings,
      #handle.seats)
  end
  if needs_stage[kind] and not core.is_built(handle) then
    return lines[1] .. " (before its first stage)"
  end
  if kind == "set of bodies" then lines[#lines + 1] = "  " .. names_in(handle) end
  local wide, fields = 0, {}
  for _, property in ipairs(core.properties(kind) or {}) do
    if is_shown(handle, kind, property.name) then
      local good, value = pcall(function() return handle[property.name] end)
      if good and value ~= nil then
        fields[#fields + 1] = { property.name, value_text(value, property.unit), property.doc }
        wide = math.max(wide, #property.name)
      end
    end
  end
  for _, field in ipairs(fields) do
    lines[#lines + 1] = ("  %-" .. wide .. "s  %-20s  %s"):format(field[1], field[2], field[3])
  end
  return table.concat(lines, "\n")
end
