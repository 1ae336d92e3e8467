-- The manual as pages of Markdown: docs/reference is made of it.
local console = ...

local function cell(text)
  return (text:gsub("|", "\\|"):gsub("\n", " "))
end

local function key_row(key)
  local preset = key.preset and cell(key.preset) or key.optional and "–" or "needed"
  local unit = key.unit == "1" and "" or cell(key.unit)
  return ("| `%s` | %s | %s | %s | %s |"):format(key.name, cell(key.type), unit, preset, cell(key.doc))
end

local function add_keys(lines, keys, title)
  if #keys == 0 then return end
  lines[#lines + 1] = ("\n| %s | is | unit | default | |\n|---|---|---|---|---|"):format(title)
  for _, key in ipairs(keys) do lines[#lines + 1] = key_row(key) end
end

--- Where the keys stand that all bodies take: those of the plane and of space are not the same.
local function told_at(entry)
  return entry.owner == "space" and "space:block" or "model:body"
end

--- Those that all bodies take stand there alone; whoever takes more tells the rest.
local function add_keys_of_bodies(lines, entry)
  local told, body = {}, told_at(entry)
  local bodies = entry.owner == "space" and "bodies in space" or "bodies"
  for _, other in ipairs(console.manual().list) do
    if other.name == body and entry.name ~= body then
      for _, key in ipairs(other.with) do told[key.name] = true end
    end
  end
  local more = {}
  for _, key in ipairs(entry.with) do more[#more + 1] = not told[key.name] and key or nil end
  local which = entry.name == body and "all %s take:" or "%s take, see `" .. body .. "`."
  lines[#lines + 1] = "\nAnd what " .. which:format(bodies)
  add_keys(lines, more, "key")
end

local function add_entry(lines, entry)
  local doc = entry.doc:find "[.:]$" and entry.doc or entry.doc .. "."
  lines[#lines + 1] = ("\n### `%s`\n\n%s"):format(console.call_text(entry), doc)
  if entry.gives then lines[#lines] = lines[#lines] .. " Gives: " .. entry.gives .. "." end
  add_keys(lines, entry.args, "argument")
  add_keys(lines, entry.keys, "key")
  if #entry.with > 0 then add_keys_of_bodies(lines, entry) end
end

local function field_row(entry)
  local unit = entry.unit == "1" and "" or entry.unit or ""
  local text = cell(entry.doc) .. (entry.settable and "; can be set" or "")
  return ("| `%s` | %s | %s | %s |"):format(entry.member, cell(entry.type or ""), cell(unit), text)
end

--- Fields stand in one table for each owner, in the order of the manual.
local function add_fields(lines, entries)
  local owners, of = {}, {}
  for _, entry in ipairs(entries) do
    if not of[entry.owner] then owners[#owners + 1], of[entry.owner] = entry.owner, {} end
    table.insert(of[entry.owner], entry)
  end
  table.sort(owners)
  for _, owner in ipairs(owners) do
    lines[#lines + 1] = ("\n### `%s`\n\n| field | is | unit | |\n|---|---|---|---|"):format(owner)
    for _, entry in ipairs(of[owner]) do lines[#lines + 1] = field_row(entry) end
  end
end

--- One page, or without a name the list of them.
function console.page_markdown(name)
  local lines, fields, known = {}, {}, false
  if not name then
    lines[1] = "# Reference\n\nThe Lua interface, made from its declarations by `docs/reference/make`: the same text\n"
      .. "as `help` at the console.\n"
    for _, page in ipairs(console.manual().pages) do
      lines[#lines + 1] = ("- [%s](%s.md)"):format(page.title, page.name)
    end
    return table.concat(lines, "\n") .. "\n"
  end
  for _, page in ipairs(console.manual().pages) do
    if page.name == name then known, lines[1] = true, "# " .. page.title end
  end
  if not known then error(("manual: there is no page '%s'; `trilith manual` names them"):format(name), 0) end
  for _, entry in ipairs(console.manual().list) do
    if entry.page == name then
      if entry.is_field then fields[#fields + 1] = entry else add_entry(lines, entry) end
    end
  end
  add_fields(lines, fields)
  return table.concat(lines, "\n") .. "\n"
end

--- Names of the pages, a line each.
function console.page_names()
  local names = {}
  for i, page in ipairs(console.manual().pages) do names[i] = page.name end
  return table.concat(names, "\n") .. "\n"
end
