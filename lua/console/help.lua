-- help and apropos: the manual as text.
local console, core, terminal = ...

local function type_text(key)
  local text = key.type .. (key.unit ~= "" and " " .. key.unit or "")
  if key.preset then return text .. " = " .. key.preset end
  return key.optional and text .. ", optional" or text
end

local function add_keys(lines, keys)
  local wide, wide_type = 0, 0
  for _, key in ipairs(keys) do
    wide, wide_type = math.max(wide, #key.name), math.max(wide_type, #type_text(key))
  end
  for _, key in ipairs(keys) do
    lines[#lines + 1] = ("  %-" .. wide .. "s  %-" .. math.min(wide_type, 32) .. "s  %s"):format(key.name,
      type_text(key), console.key_text(key))
  end
end

--- Call syntax: "model:run{ duration = , to = , ... }".
function console.call_text(entry)
  if entry.is_field or entry.type then return entry.name end
  local names = {}
  for _, arg in ipairs(entry.args) do names[#names + 1] = arg.name end
  if entry.takes_table then
    if #names > 0 then return ("%s(%s) or %s{...}"):format(entry.name, table.concat(names, ", "), entry.member) end
    return entry.name .. "{...}"
  end
  return ("%s(%s)"):format(entry.name, table.concat(names, ", "))
end

--- An entry of the manual as text.
function console.entry_text(entry)
  local lines = { console.call_text(entry), "  " .. entry.doc }
  if entry.owner == "event type" then
    lines[2] = lines[2] .. (entry.type == "no value" and "" or ("; value: %s%s"):format(entry.type,
      entry.unit ~= "1" and " [" .. entry.unit .. "]" or ""))
    lines[3] = "  and type, time, id, cause, step, text, bodies, body, bearing, seat: help \"tables\""
  elseif entry.is_field then
    lines[2] = lines[2] .. (entry.unit ~= "" and entry.unit ~= "1" and " [" .. entry.unit .. "]" or "")
  end
  add_keys(lines, entry.args)
  if entry.takes_table and #entry.keys > 0 and #entry.args > 0 then lines[#lines + 1] = "  the table's keys:" end
  add_keys(lines, entry.keys)
  if #entry.with > 0 then
    lines[#lines + 1] = "  and the keys of bodies:"
    add_keys(lines, entry.with)
  end
  if entry.gives then lines[#lines + 1] = "  gives: " .. entry.gives end
  if entry.example then lines[#lines + 1] = "  example:\n    " .. entry.example:gsub("\n", "\n    ") end
  if entry.also then lines[#lines + 1] = "  search words: " .. entry.also end
  return table.concat(lines, "\n")
end

local function one_line(entry)
  return ("  %-28s %s"):format(entry.name, entry.doc)
end

local function owner_text(owner)
  local fields, methods = {}, {}
  for _, entry in ipairs(console.manual().list) do
    if entry.owner == owner then
      local list = entry.is_field and fields or methods
      list[#list + 1] = one_line(entry)
    end
  end
  local text = table.concat(methods, "\n")
  if #fields > 0 then text = text .. (#methods > 0 and "\n" or "") .. table.concat(fields, "\n") end
  return text
end

local function overview()
  local lines = {
    "The console executes Lua and prints the values of expressions.",
    "Tab completes, arrows recall lines, Ctrl-C interrupts.",
    "  help(x), help \"m.run\"        describes a value or a name",
    "  apropos \"bearing\"           finds entries that mention a word",
    "  help \"stages\"                prints a page of the manual. Pages:",
  }
  for _, page in ipairs(console.manual().pages) do
    lines[#lines + 1] = ("    %-12s %s"):format(page.name, page.title)
  end
  lines[#lines + 1] = "While a run is paused (Ctrl-C, m:break_on): `continue`, `stop`, `where`, `frame(n)`; "
    .. "local variables are available by name."
  lines[#lines + 1] = "`quit` or Ctrl-D leaves the console."
  return table.concat(lines, "\n")
end

local function page_text(name)
  for _, page in ipairs(console.manual().pages) do
    if page.name == name then
      local lines = { page.title }
      for _, entry in ipairs(console.manual().list) do
        if entry.page == name then lines[#lines + 1] = one_line(entry) end
      end
      return table.concat(lines, "\n")
    end
  end
  return nil
end

local function names_known()
  local names = {}
  for _, entry in ipairs(console.manual().list) do
    names[#names + 1] = entry.member
    names[#names + 1] = entry.name
  end
  for _, page in ipairs(console.manual().pages) do names[#names + 1] = page.name end
  for owner in pairs(console.kind_names) do names[#names + 1] = owner end
  table.sort(names)
  return names
end

local function text_named(text, value_of)
  if console.table_of(text) then return owner_text(text) end
  local page = page_text(text)
  local found = console.entries_named(text, value_of)
  if page and #found == 0 then return page end
  if #found > 0 and #found <= 3 then
    local parts = {}
    for i, entry in ipairs(found) do parts[i] = console.entry_text(entry) end
    return table.concat(parts, "\n")
  end
  if #found > 3 then
    local parts = {}
    for i, entry in ipairs(found) do parts[i] = one_line(entry) end
    return table.concat(parts, "\n")
  end
  local of_owner = owner_text(text)
  if of_owner ~= "" then return of_owner end
  local value = value_of and text:find "^[%a_][%w_]*$" and value_of(text)
  if value ~= nil and value ~= false and type(value) ~= "string" then return console.help_text(value, value_of) end
  local hint = core.hint(text, names_known())
  if hint:find("^; known:") then hint = ('; try apropos "%s"'):format(text) end
  core.fail(("help: there is nothing called '%s'%s"):format(text, hint))
end

local function function_name(f)
  for _, entry in ipairs(console.manual().list) do
    local members = console.table_of(entry.owner)
      or (console.kind_names[entry.owner] and core.members(console.kind_names[entry.owner]))
    if members and rawget(members, entry.member) == f then return entry end
  end
  return nil
end

--- Describes a value, or the object with the given name.
function console.help_text(value, value_of)
  if value == nil then return overview() end
  if type(value) == "string" then return text_named(value, value_of) end
  local kind = core.kind_of(value)
  if kind then return tostring(value) .. "\n" .. owner_text(console.owner_of(kind)) end
  if value == core.module then return owner_text "trilith" end
  if value == core.module.build then return owner_text "trilith.build" end
  if value == core.module.math then return owner_text "trilith.math" end
  if type(value) == "function" then
    local entry = function_name(value)
    if entry then return console.entry_text(entry) end
    local info = debug.getinfo(value, "S")
    return info.what == "C" and "a function of Lua itself, or of the program"
      or ("a function at %s:%d"):format(info.short_src, info.linedefined)
  end
  local sort = math.type(value) or type(value)
  return ("%s %s: %s"):format(sort == "integer" and "an" or "a", sort, console.show(value))
end

local function title_of(name)
  for _, page in ipairs(console.manual().pages) do
    if page.name == name then return page.title end
  end
  return ""
end

--- Entries that contain a word, in their text, search words or title of the page, one line each.
function console.apropos_text(word)
  if type(word) ~= "string" or word == "" then core.fail "apropos: takes a word, as in apropos \"bearing\"" end
  local lines, low = {}, word:lower()
  for _, entry in ipairs(console.manual().list) do
    local text = entry.name .. " " .. entry.doc .. " " .. title_of(entry.page) .. " " .. (entry.also or "")
    for _, keys in ipairs { entry.args, entry.keys } do
      for _, key in ipairs(keys) do text = text .. " " .. key.name .. " " .. key.doc end
    end
    if text:lower():find(low, 1, true) then lines[#lines + 1] = one_line(entry) end
  end
  if #lines == 0 then return ("no entry mentions '%s'"):format(word) end
  return table.concat(lines, "\n")
end

--- Adds help and apropos to a session.
function console.add_help(session)
  local function value_of(name) return console.value_of(session, name) end
  function session.words.help(value) terminal.write(console.help_text(value, value_of) .. "\n") end
  function session.words.apropos(word) terminal.write(console.apropos_text(word) .. "\n") end
end
