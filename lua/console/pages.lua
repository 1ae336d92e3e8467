-- The manual as pages of Markdown, from which docs/reference is made.
local console = ...

local function cell(text)
  return (text:gsub("|", "\\|"):gsub("\n", " "))
end

local function key_row(key, with_range)
  local preset = key.preset and cell(key.preset) or key.optional and "–" or "needed"
  local unit = key.unit == "1" and "" or cell(key.unit)
  local range = with_range and cell(key.range or "") .. " | " or ""
  return ("| `%s` | %s | %s | %s | %s%s |"):format(key.name, cell(key.type), unit, preset, range, cell(key.doc))
end

local function add_keys(lines, keys, title)
  if #keys == 0 then return end
  local with_range = false
  for _, key in ipairs(keys) do with_range = with_range or key.range ~= nil end
  local range = with_range and "range | " or ""
  lines[#lines + 1] = ("\n| %s | type | unit | default | %smeaning |"):format(title, range)
  lines[#lines + 1] = with_range and "|---|---|---|---|---|---|" or "|---|---|---|---|---|"
  for _, key in ipairs(keys) do lines[#lines + 1] = key_row(key, with_range) end
end

--- Entry that lists the keys of all bodies, in the plane or in space.
local function told_at(entry)
  return entry.owner == "space" and "space:block" or "model:body"
end

--- The keys of all bodies are listed once; other entries list only further keys.
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
  local which = entry.name == body and "Further keys that all %s take:" or "Further keys of %s: see `" .. body .. "`."
  lines[#lines + 1] = "\n" .. which:format(bodies)
  add_keys(lines, more, "key")
end

--- The entry that lists the keys of a builder, where `entry` is another function with the same keys.
local function main_of(entry)
  local known = console.manual().by_name
  local main = known["model:" .. entry.member]
  if not (main and main.made) then main = known["trilith.build." .. entry.member] end
  if entry.made and main and main.made and main ~= entry then return main end
  return nil
end

--- Other names of a builder: `trilith.build.wall`, and `trilith.block` for a single part.
local function add_other_names(lines, entry)
  local names = {}
  for _, other in ipairs(console.manual().list) do
    if other.member == entry.member and main_of(other) == entry then
      names[#names + 1] = ("`%s` (gives: %s)"):format(console.call_text(other), other.gives)
    end
  end
  if #names > 0 then lines[#lines + 1] = "\nAlso without a model: " .. table.concat(names, ", ") .. "." end
end

--- A text in lines of at most 150 characters.
local function wrapped(text)
  local lines, line = {}, ""
  for word in text:gmatch "%S+" do
    if #line + #word > 148 then lines[#lines + 1], line = line, "" end
    line = line .. (line == "" and "" or " ") .. word
  end
  lines[#lines + 1] = line
  return table.concat(lines, "\n")
end

local function add_entry(lines, entry)
  local doc = entry.doc:find "[.:]$" and entry.doc or entry.doc .. "."
  if entry.gives then doc = doc .. " Gives: " .. entry.gives .. "." end
  lines[#lines + 1] = ("\n### `%s`\n\n%s"):format(console.call_text(entry), wrapped(doc))
  add_other_names(lines, entry)
  if entry.example then lines[#lines + 1] = "\n```lua\n" .. entry.example .. "\n```" end
  add_keys(lines, entry.args, "argument")
  add_keys(lines, entry.keys, "key")
  if #entry.with > 0 then add_keys_of_bodies(lines, entry) end
  if entry.also then lines[#lines + 1] = "\nSearch words: " .. entry.also .. "." end
end

local function field_row(entry)
  local unit = entry.unit == "1" and "" or entry.unit or ""
  local text = cell(entry.doc) .. (entry.settable and "; can be set" or "")
  return ("| `%s` | %s | %s | %s |"):format(entry.member, cell(entry.type or ""), cell(unit), text)
end

--- One table of fields for each owner, in the order of the manual.
local function add_fields(lines, entries)
  local owners, of = {}, {}
  for _, entry in ipairs(entries) do
    if not of[entry.owner] then owners[#owners + 1], of[entry.owner] = entry.owner, {} end
    table.insert(of[entry.owner], entry)
  end
  table.sort(owners)
  for _, owner in ipairs(owners) do
    lines[#lines + 1] = ("\n### `%s`\n\n| field | type | unit | meaning |\n|---|---|---|---|"):format(owner)
    for _, entry in ipairs(of[owner]) do lines[#lines + 1] = field_row(entry) end
  end
end

--- One page, or without a name the list of pages.
function console.page_markdown(name)
  local lines, fields, known = {}, {}, false
  if not name then
    lines[1] = "# Reference\n\nAfter this page you can find every function, key, event and reading of the Lua "
      .. "interface.\n"
      .. "The pages are made from the declarations by `docs/reference/make`. `help` at the console has the same "
      .. "text.\n\n"
      .. "```sh\ntrilith manual run            # prints the reference of a function\n```\n"
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
      if entry.is_field then
        fields[#fields + 1] = entry
      elseif not main_of(entry) then
        add_entry(lines, entry)
      end
    end
  end
  add_fields(lines, fields)
  return table.concat(lines, "\n") .. "\n"
end

--- Names of the pages, one per line.
function console.page_names()
  local names = {}
  for i, page in ipairs(console.manual().pages) do names[i] = page.name end
  return table.concat(names, "\n") .. "\n"
end
