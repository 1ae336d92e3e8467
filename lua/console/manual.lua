-- The manual: all declarations of the Lua interface, from lua/manual/*.lua, from the properties of the kinds of handles
-- and from the laws' parameters. Help, completion for editors and the reference pages are made from it.
local console, core = ...

-- Names in declarations: the kind of handle.
local kind_names = {
  model = "model", body = "body", set = "set of bodies", bearing = "bearing", seat = "seat", history = "history",
  storey = "storey", motion = "motion", ["contact law"] = "contact law", section = "section",
}
local law_kinds = { "contact law", "direction law", "solid law", "fibre law", "hinge law", "section" }

--- A range for a table: "0 to 1" for "not below 0 and at most 1".
local function short_range(text)
  text = text:gsub("^finite and ", ""):gsub("^from ", ""):gsub("^not below (%S+) and at most ", "%1 to ")
  return (text:gsub("^not below", "at least"):gsub(" and at most", ", at most"))
end

local function joined_range(allowed, usual)
  local parts = {}
  for _, text in ipairs { allowed, usual } do parts[#parts + 1] = text ~= "" and text or nil end
  return #parts > 0 and table.concat(parts, "; "):gsub("e%+0*(%d)", "e%1") or nil
end

--- The sentence of a key with its range.
function console.key_text(key)
  return key.range and ("%s (%s)"):format(key.doc, key.range) or key.doc
end

--- "name  number s = 3  sentence  <range>" as { name, type, unit, preset, optional, doc, range }.
local function read_key(line)
  local allowed = line:match "%s%s<([^>]+)>$"
  if allowed then line = line:gsub("%s%s<[^>]+>$", "") end
  local name, kind, doc = line:match "^(%S+)%s%s+(%S.-)%s%s+(%S.*)$"
  if not name then error("manual: cannot read '" .. line .. "'", 0) end
  local key = { name = name, doc = doc }
  local before, preset = kind:match "^(.-) = (.+)$"
  kind = before or kind
  key.preset = preset
  kind, key.optional = kind:gsub("%?$", "")
  key.optional = key.optional > 0 or preset ~= nil
  local number, unit = kind:match "^(number) (.+)$"
  key.type, key.unit = number or kind, unit or ""
  key.range = joined_range(short_range(allowed or ""), number and core.usual(name, unit) or "")
  return key
end

local function read_keys(text)
  local keys = {}
  for line in (text or ""):gmatch "[^\n]+" do keys[#keys + 1] = read_key(line) end
  return keys
end

local function read_entry(row, page, shared)
  local owner, member = row[1]:match "^(.-):(.+)$"
  if not owner then owner, member = row[1]:match "^(.*)%.(.-)$" end
  local entry = { name = row[1], owner = owner, member = member, doc = row[2], gives = row.gives, type = row.type,
    also = row.also, example = row.example, made = row.made,
    page = page.name, args = read_keys(row.args), keys = read_keys(row.keys), with = {}, takes_table = row.keys ~= nil }
  -- For the check of the manual: keys that are known only together with others; constructors without keys here.
  entry.beside, entry.unread = row.beside or {}, row.unread
  if row.with then entry.with = read_keys(shared[row.with]) end
  local each = ({ bodies = "body", solids = "solid" })[row.with]
  if each then table.move(read_keys(shared[each]), 1, 99, #entry.with + 1, entry.with) end
  return entry
end

local function sentence_of(builder) return builder.doc:gsub("^%l", string.upper) .. "." end

-- Builders of the plane, declared in engine/build/plane. The declaration of a function of the model (`model:span`)
-- takes
-- precedence over the declaration of a builder with the same name.
local function add_makers(manual, page, shared)
  for _, builder in ipairs((core.builders())) do
    local row = { builder.name, sentence_of(builder), keys = builder.keys,
      parts_only = manual.by_name["model:" .. builder.name] ~= nil }
    for _, owner in ipairs { "model:", "trilith.build." } do
      local single = rawget(manual.module, row[1]) ~= nil
      local of_model = owner == "model:"
      if not (of_model and row.parts_only) then
        manual.add(read_entry({ owner .. row[1], row[2], keys = row.keys, made = true,
          with = of_model and (single and "body" or "bodies") or nil,
          gives = not of_model and "part[]" or single and "body" or "set" }, page, shared))
      end
    end
    if rawget(manual.module, row[1]) then
      manual.add(read_entry({ "trilith." .. row[1], row[2] .. " Returns one part, for the shape of a body.",
        keys = row.keys, made = true, gives = "part" }, page, shared))
    end
  end
end

-- Builders of space, declared in engine/build/space.
local function add_makers_in_space(manual, page, shared)
  local _, builders = core.builders()
  for _, builder in ipairs(builders) do
    manual.add(read_entry({ "space:" .. builder.name, sentence_of(builder), keys = builder.keys,
      with = builder.single and "solid" or "solids", gives = builder.single and "body" or "set" }, page, shared))
  end
end

local function add_laws(manual)
  for i, laws in ipairs { core.laws() } do
    local names = {}
    for name in pairs(laws) do names[#names + 1] = name end
    table.sort(names)
    for _, name in ipairs(names) do
      local doc = laws[name].doc:gsub("^%l", string.upper)
      local entry = { name = "trilith." .. name, owner = "trilith", member = name, doc = doc, args = {}, keys = {},
        with = {}, beside = {}, gives = law_kinds[i], page = "laws", takes_table = true }
      if i == 1 then
        entry.keys[1] = { name = "name", type = "text", unit = "", optional = true, doc = "name in results" }
      end
      if name == "end_hinge" then
        entry.keys[1] = { name = "axial", type = "points", unit = "", optional = true,
          doc = "{ normal force, remaining share of the moment }, ..., instead of tension, compression, exponent" }
        entry.keys[2] = { name = "becomes", type = "text", unit = "", optional = true, preset = '"pinned"',
          doc = "state of its beam without moment: \"pinned\", or \"removed\", without any force" }
      end
      if name == "table" then
        entry.keys[1] = { name = "points", type = "points", unit = "", doc = "{ displacement, force }, ..." }
      end
      for _, p in ipairs(laws[name].parameters) do
        entry.keys[#entry.keys + 1] = { name = p.name, type = "number", unit = p.unit == "1" and "" or p.unit,
          doc = p.doc, range = joined_range(short_range(p.range), p.usual), optional = p.preset ~= nil,
          preset = p.preset and ("%g"):format(p.preset) }
      end
      manual.add(entry)
    end
  end
end

local function add_fields(manual, types)
  for owner, kind in pairs(kind_names) do
    for _, p in ipairs(core.properties(kind) or {}) do
      manual.add { name = owner .. "." .. p.name, owner = owner, member = p.name, doc = p.doc, unit = p.unit,
        type = p.number and "number" or types[kind] and types[kind][p.name], is_field = true, args = {}, keys = {},
        with = {}, page = "fields", settable = p.settable }
    end
  end
end

--- Tables that calls return: their fields are rows of a page.
local function add_tables(manual, page)
  for _, name in ipairs { "report", "pushover report", "bilinear", "energy", "event", "findings", "part" } do
    for _, key in ipairs(read_keys(page.tables[name])) do
      manual.add { name = name .. "." .. key.name, owner = name, member = key.name, doc = key.doc, unit = key.unit,
        type = key.type, optional = key.optional, is_field = true, is_row = true, args = {}, keys = {}, with = {},
        page = page.name }
    end
  end
end

--- The types of events, from their rows in the engine.
local function add_events(manual, page)
  for _, event in ipairs(core.event_types()) do
    local parts = { event.doc }
    if event.value_doc ~= "" then parts[#parts + 1] = "value: " .. event.value_doc end
    if event.text_doc ~= "" then parts[#parts + 1] = "text: " .. event.text_doc end
    if event.place then parts[#parts + 1] = "x, y: place" end
    if event.mode then parts[#parts + 1] = "mode: tension, shear or compression" end
    parts[#parts + 1] = "severity: " .. event.severity
    manual.add { name = ('event "%s"'):format(event.name), owner = "event type", member = event.name, unit = event.unit,
      doc = table.concat(parts, "; "), type = event.value ~= "" and event.value or "no value", is_field = true,
      is_row = true, args = {}, keys = {}, with = {}, page = page.name }
  end
end

--- Examples of pages, by the name of the entry.
local function add_examples(manual)
  for _, page in ipairs(manual.pages) do
    for name, text in pairs(page.examples or {}) do
      local entry = manual.by_name[name] or error("manual: an example names '" .. name .. "', which is not declared", 0)
      entry.example = text:gsub("%s+$", "")
    end
  end
end

--- The whole manual: { by_name, list (in order of pages), pages }.
function console.manual()
  if console.manual_made then return console.manual_made end
  local manual = { by_name = {}, list = {}, pages = {}, module = core.module }
  console.manual_made = manual
  function manual.add(entry)
    if manual.by_name[entry.name] then error("manual: '" .. entry.name .. "' is declared twice", 0) end
    manual.by_name[entry.name] = entry
    manual.list[#manual.list + 1] = entry
  end
  local pages, shared, types = {}, {}, {}
  for _, load_page in ipairs(core.manual_pages()) do pages[#pages + 1] = load_page() end
  for _, page in ipairs(pages) do
    for name, text in pairs(page.shared or {}) do shared[name] = text end
    for kind, fields in pairs(page.fields or {}) do types[kind] = fields end
  end
  for _, page in ipairs(pages) do
    manual.pages[#manual.pages + 1] = page
    for _, row in ipairs(page) do manual.add(read_entry(row, page, shared)) end
    if page.has_makers then add_makers(manual, page, shared) end
    if page.has_makers_in_space then add_makers_in_space(manual, page, shared) end
    if page.tables then add_tables(manual, page) end
    if page.has_events then add_events(manual, page) end
    if page.has_laws then add_laws(manual) end
  end
  manual.pages[#manual.pages + 1] = { name = "fields", title = "Readings, by kind of object" }
  add_fields(manual, types)
  add_examples(manual)
  return manual
end

--- The table of functions for an owner of entries: the module or a table in it; nil for kinds of handles.
function console.table_of(owner)
  if owner == "trilith" then return core.module end
  local inner = owner:match "^trilith%.(%w+)$"
  local member = inner and rawget(core.module, inner)
  return type(member) == "table" and member or nil
end

--- The name of a kind of handle in declarations: "set" for "set of bodies".
function console.owner_of(kind)
  for owner, name in pairs(kind_names) do
    if name == kind then return owner end
  end
  return kind
end
console.kind_names = kind_names

--- Entries named by `text`: "m.consolidate" where m is a handle, "model:run", "trilith.build.wall", "run".
function console.entries_named(text, value_of)
  local manual = console.manual()
  local event = manual.by_name[('event "%s"'):format(text)]
  if manual.by_name[text] then return { manual.by_name[text], event } end
  if event then return { event } end
  local first, rest = text:match "^([%a_][%w_]*)[.:](.+)$"
  local kind = first and value_of and core.kind_of(value_of(first))
  if kind then
    local owner = console.owner_of(kind)
    local entry = manual.by_name[owner .. ":" .. rest] or manual.by_name[owner .. "." .. rest]
    if entry then return { entry } end
  end
  local found, of_others = {}, {}
  local member = rest or text
  for _, entry in ipairs(manual.list) do
    if entry.member == member then
      table.insert((not first or entry.owner == first) and found or of_others, entry)
    end
  end
  -- "m.run" without a variable m: all entries of this name, of any owner.
  if #found == 0 and first and not kind_names[first] and first ~= "trilith" then return of_others end
  return found
end
