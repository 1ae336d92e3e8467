-- The manual for editors: a file of declarations that Lua language servers read.
local console = ...

local class_of = {
  model = "trilith.model", body = "trilith.body", set = "trilith.set", bearing = "trilith.bearing",
  seat = "trilith.seat", history = "trilith.history", storey = "trilith.storey", motion = "trilith.motion",
  ["contact law"] = "trilith.contact_law", ["direction law"] = "trilith.direction_law",
  ["solid law"] = "trilith.solid_law", ["fibre law"] = "trilith.fibre_law", ["hinge law"] = "trilith.hinge_law",
  section = "trilith.section", report = "trilith.report", ["pushover report"] = "trilith.pushover_report",
  energy = "trilith.energy", bilinear = "trilith.bilinear_curve",
  findings = "trilith.findings",
  event = "trilith.event", part = "trilith.part", space = "trilith.space_model",
}
local type_of = {
  text = "string", flag = "boolean", integer = "integer", number = "number", point = "number[]", points = "number[][]",
  numbers = "number[]", names = "string|string[]", list = "table[]", table = "table", ["function"] = "function",
  body = "trilith.body|string", bodies = "trilith.body|trilith.set|string|table", bearing = "trilith.bearing|string",
  seat = "trilith.seat|string", motion = "trilith.motion", rest = "boolean|table", ["body form"] = "string|table",
  ["contact law"] = "trilith.contact_law|string", ["direction law"] = "trilith.direction_law",
  ["solid law"] = "trilith.solid_law", ["fibre law"] = "trilith.fibre_law", ["hinge law"] = "trilith.hinge_law",
  section = "trilith.section", ["text or integer"] = "string|integer",
  ["load curve"] = "number|table",
  level = "number|table", course = "number|table", planes = "string|integer|table[]|boolean",
  vector = "number[]", vectors = "number[][]", ["text or table"] = "string|table", ["table or number"] = "number|table",
  place = "number[]|string", ["two bodies"] = "table[]", ["table or body"] = "table|trilith.body|string",
  ["bearing or law"] = "trilith.bearing|trilith.contact_law|string", storeys = "integer|table[]",
}

local function gives_type(text)
  local types = {}
  for one in text:gmatch "[^,]+" do
    local name, list = one:match "^%s*(.-)%s*(%[?%]?)$"
    types[#types + 1] = (class_of[name] or name) .. list
  end
  return table.concat(types, ", ")
end

local function type_text(key)
  local text = type_of[key.type]
  if not text then error(("manual: '%s' has a type that is not known: %s"):format(key.name, key.type), 0) end
  return text
end

local function key_line(key)
  local unit = key.unit ~= "" and " [" .. key.unit .. "]" or ""
  local preset = key.preset and " (default " .. key.preset .. ")" or ""
  return console.key_text(key) .. unit .. preset
end

local function options_class(entry)
  return "trilith.options." .. entry.name:gsub("^trilith%.", ""):gsub("[.:]", "_")
end

local function add_options(lines, entry)
  lines[#lines + 1] = "---@class " .. options_class(entry)
  for _, keys in ipairs { entry.keys, entry.with } do
    for _, key in ipairs(keys) do
      local name = key.name
      lines[#lines + 1] = ("---@field %s%s %s %s"):format(name, key.optional and "?" or "", type_text(key),
        key_line(key))
    end
  end
  lines[#lines + 1] = ""
end

local function add_function(lines, entry)
  if entry.takes_table then add_options(lines, entry) end
  lines[#lines + 1] = "---" .. entry.doc
  local names = {}
  if entry.takes_table then
    names[1] = "options"
    local types = options_class(entry)
    for _, arg in ipairs(entry.args) do types = types .. "|" .. type_text(arg) end
    lines[#lines + 1] = ("---@param options%s %s"):format(#entry.args > 0 and "?" or "", types)
  else
    for i, arg in ipairs(entry.args) do
      names[i] = arg.name == "function" and "f" or arg.name
      lines[#lines + 1] = ("---@param %s%s %s %s"):format(names[i], arg.optional and "?" or "", type_text(arg),
        key_line(arg))
    end
  end
  if entry.gives then lines[#lines + 1] = "---@return " .. gives_type(entry.gives) end
  local owner = entry.owner
  local place
  if console.table_of(owner) then
    place = owner .. "." .. entry.member
  else
    place = class_of[owner]:gsub("%.", "_") .. ":" .. entry.member
  end
  lines[#lines + 1] = ("function %s(%s) end"):format(place, table.concat(names, ", "))
  lines[#lines + 1] = ""
end

local function field_type(entry)
  if entry.is_row then return class_of[entry.type] or type_text(entry) end
  return entry.type
end

local function add_class(lines, owner)
  -- A model in space is a model with other builders of bodies.
  lines[#lines + 1] = "---@class " .. class_of[owner] .. (owner == "space" and ": trilith.model" or "")
  for _, entry in ipairs(console.manual().list) do
    if entry.owner == owner and entry.is_field then
      local unit = entry.unit ~= "" and entry.unit ~= "1" and " [" .. entry.unit .. "]" or ""
      lines[#lines + 1] = ("---@field %s%s %s %s%s"):format(entry.member, entry.optional and "?" or "",
        field_type(entry), entry.doc, unit)
    end
  end
  lines[#lines + 1] = "local " .. class_of[owner]:gsub("%.", "_") .. " = {}"
  lines[#lines + 1] = ""
end

--- The whole file.
function console.meta_text()
  local manual = console.manual()
  local lines = { "---@meta trilith", "-- Made by trilith manual --meta; see docs/editor.md.", "" }
  for _, owner in ipairs { "report", "pushover report", "bilinear", "energy", "findings", "event", "part",
    "direction law", "solid law", "fibre law",
    "hinge law", "section", "model", "space",
    "body", "set",
    "bearing", "seat", "history", "storey", "motion", "contact law" } do
    add_class(lines, owner)
  end
  lines[#lines + 1] = "---@class trilith"
  lines[#lines + 1] = "local trilith = { build = {}, math = {} }\n"
  for _, entry in ipairs(manual.list) do
    if not entry.is_field then
      if entry.type then
        lines[#lines + 1] = ("---%s\n---@type %s\n%s = nil\n"):format(entry.doc, entry.type, entry.name)
      else
        add_function(lines, entry)
      end
    end
  end
  lines[#lines + 1] = "return trilith"
  return table.concat(lines, "\n") .. "\n"
end
