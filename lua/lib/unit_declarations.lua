-- Units of arguments and results of each function of the module. They come from the pages of the manual, the laws and
-- the builders. Other tables have rules in lib/unit_rules.
local _, core = ...
local rules = core.unit_rules

--- "name  number s = 3  sentence" as name, type, unit, sentence.
local function read_line(line)
  line = line:gsub("%s%s<[^>]+>$", "")
  local name, kind, doc = line:match "^(%S+)%s%s+(%S.-)%s%s+(%S.*)$"
  kind = kind:gsub(" = .+$", ""):gsub("%?$", "")
  local number, unit = kind:match "^(number) (.+)$"
  return name, number or kind, unit, doc
end

-- Types whose values are the same in all units: handles, whose numbers are in SI inside, names and counts.
local same_types = {}
for _, name in ipairs { "integer", "flag", "text", "names", "body", "bodies", "two bodies", "bearing", "seat", "motion",
  "contact law", "direction law", "solid law", "fibre law", "hinge law", "section", "text or table", "table or body",
  "bearing or law", "model", "body form", "handler", "text or integer" } do
  same_types[name] = true
end

-- Types whose numbers are lengths, unless the sentence gives another unit in brackets.
local length_types = { point = true, points = true, vector = true, vectors = true, place = true }

--- The unit in brackets in a sentence: "m/s" of "velocity at the start [m/s]".
local function bracketed(doc)
  local unit = doc:match "%[([^%]]+)%]"
  return unit and core.dimension(unit) and unit or nil
end

local function refused(what)
  return function(_, system) rules.refuse(what, system) end
end

--- The rule of a key from its declaration.
local function rule_of(owner, name, kind, unit, doc)
  local special = rules.keys[owner .. "." .. name] or rules.keys[name]
  if kind == "function" then return "function" end
  if kind == "number" and unit then return rules.of(unit) end
  if special then return special end
  if same_types[kind] then return rules.same end
  if bracketed(doc) then return rules.of(bracketed(doc)) end
  if length_types[kind] then return rules.of "m" end
  if kind == "number" and name ~= "above" then return rules.same end
  return refused(("'%s' of %s"):format(name, owner))
end

--- Adds the rules of the lines of a declaration; a key that is there already keeps its rule.
local function add_lines(list, owner, text)
  for line in (text or ""):gmatch "[^\n]+" do
    local name, kind, unit, doc = read_line(line)
    if not list[name] then
      list[name] = rule_of(owner, name, kind, unit, doc)
      list[#list + 1] = name
    end
  end
  return list
end

local function add_shared(entry, shared, with)
  if not with then return end
  add_lines(entry.keys, entry.member, shared[with])
  local each = ({ bodies = "body", solids = "solid" })[with]
  if each then add_lines(entry.keys, entry.member, shared[each]) end
  if each then
    local keys = entry.keys
    keys.by_group = rules.each(function(value, system, direction)
      return core.convert_keys(keys, value, system, direction, entry.member)
    end)
  end
end

local function new_entry(name, gives)
  local owner, member = name:match "^(.-):(.+)$"
  if not owner then owner, member = name:match "^(.*)%.(.-)$" end
  return { name = name, owner = owner, member = member, gives = gives, args = {}, keys = {} }
end

local function add_pages(all, pages, shared)
  for _, page in ipairs(pages) do
    for _, row in ipairs(page) do
      local entry = new_entry(row[1], row.gives)
      add_lines(entry.args, entry.member, row.args)
      add_lines(entry.keys, entry.member, row.keys)
      add_shared(entry, shared, row.with)
      all[entry.name] = entry
    end
  end
end

local function add_laws(all)
  for _, laws in ipairs { core.laws() } do
    for name, law in pairs(laws) do
      local entry = new_entry("trilith." .. name, "law")
      for _, p in ipairs(law.parameters) do entry.keys[p.name] = rules.of(p.unit) end
      for _, key in ipairs { "points", "axial" } do
        entry.keys[key] = entry.keys[key] or rules.keys[name .. "." .. key]
      end
      entry.keys.name, entry.keys.becomes = rules.same, rules.same
      entry.parameters = law.parameters
      all[entry.name] = entry
    end
  end
end

local function add_builder(all, name, builder, gives, shared, with)
  local entry = all[name]
  if entry then return end
  entry = new_entry(name, gives)
  add_lines(entry.keys, entry.member, builder.keys)
  entry.keys.name = rules.same
  add_shared(entry, shared, with)
  all[name] = entry
end

local function add_builders(all, shared)
  local plane, space = core.builders()
  for _, builder in ipairs(plane) do
    add_builder(all, "model:" .. builder.name, builder, "set", shared, "bodies")
    add_builder(all, "trilith.build." .. builder.name, builder, "part[]")
    add_builder(all, "trilith." .. builder.name, builder, "part")
  end
  for _, builder in ipairs(space) do
    add_builder(all, "space:" .. builder.name, builder, "set", shared, "solids")
  end
end

--- Rules of the fields of a table that calls return, such as a report.
local function read_table(text)
  local known = {}
  for line in text:gmatch "[^\n]+" do
    local name, kind, unit = read_line(line)
    if kind == "number" then known[name] = unit or "1" end
    if kind == "integer" then known[name] = "1" end
  end
  return known
end

local function result_tables(pages)
  local tables = {}
  for _, page in ipairs(pages) do
    for name, text in pairs(type(page.tables) == "table" and page.tables or {}) do tables[name] = read_table(text) end
  end
  local scaling = rules.fields("mass_scaling", { bodies = "1", share = "1", most = "1", before = "s", energy = "J",
    kinetic = "J" })
  local push, limit = tables["pushover report"], { force = "N", displacement = "m" }
  push.curve = rules.fields("the curve", { t = rules.same, displacement = "m", force = "N", drift = "m" })
  push.limits = rules.each(rules.fields("a limit point", limit))
  push.happened = rules.each(function(value, system) return system:message(value) end)
  push.mass_scaling, tables.report.mass_scaling = scaling, scaling
  local found = {}
  for name, known in pairs(tables) do found[name] = rules.fields("the " .. name, known) end
  return found
end

--- All declarations: { entries = by name, tables = rules of results by name }.
function core.unit_declarations()
  local pages, shared = {}, {}
  for _, load_page in ipairs(core.manual_pages()) do pages[#pages + 1] = load_page() end
  for _, page in ipairs(pages) do
    for name, text in pairs(page.shared or {}) do shared[name] = text end
  end
  local all = {}
  add_pages(all, pages, shared)
  add_laws(all)
  add_builders(all, shared)
  return { entries = all, tables = result_tables(pages) }
end

--- The table of a call with its numbers converted. Unknown keys stay, so that the function names them.
function core.convert_keys(keys, value, system, direction, owner)
  if type(value) ~= "table" then return value end
  local copy = {}
  for key, one in next, value do
    local rule = keys[key]
    if rule == "function" then
      copy[key] = core.outside(one, owner, key)
    elseif rule then
      copy[key] = rule(one, system, direction)
    else
      copy[key] = one
    end
  end
  return setmetatable(copy, getmetatable(value))
end
