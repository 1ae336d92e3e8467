-- Completions at Tab: names, fields and methods, keys of the table being written, names of the model in strings.
local console, core = ...

local keywords = { "and", "break", "do", "else", "elseif", "end", "false", "for", "function", "goto", "if", "in",
  "local", "nil", "not", "or", "repeat", "return", "then", "true", "until", "while" }

local function beginning_with(names, start)
  local found, seen = {}, {}
  for _, name in ipairs(names) do
    if name:sub(1, #start) == start and not seen[name] then
      seen[name] = true
      found[#found + 1] = name
    end
  end
  table.sort(found)
  return found
end

--- The open quote at the end of the text and the start of its string; nil if there is none.
local function open_string(text)
  local quote, from
  local i = 1
  while i <= #text do
    local c = text:sub(i, i)
    if quote then
      if c == "\\" then i = i + 1 elseif c == quote then quote = nil end
    elseif c == '"' or c == "'" then
      quote, from = c, i + 1
    end
    i = i + 1
  end
  if quote then return quote, from end
  return nil
end

local function models_seen(session)
  local models = {}
  for _, name in ipairs(console.names_of(session)) do
    local value = console.value_of(session, name)
    if core.kind_of(value) == "model" then models[#models + 1] = value end
  end
  if session.model then models[#models + 1] = session.model end
  return models
end

local function add_names_of(model, names, place)
  local function add(name) names[#names + 1] = name end
  local any = not place
  if any or place == "bodies" then
    for body in model:bodies {} do
      add(body.name)
      for _, group in ipairs(body.groups) do add(group) end
    end
  end
  if any or place == "bearings" then for _, bearing in ipairs(model.bearings) do add(bearing.name) end end
  if any or place == "seats" then for _, seat in ipairs(model.seats) do add(seat.name) end end
  if any then
    for _, name in ipairs(core.history_names(model)) do add(name) end
    for _, law in ipairs(core.contact_laws(model)) do add(law.name) end
  end
end

--- Files and folders with this beginning; folders end with a slash, so that Tab continues into them.
local function files_beginning_with(start)
  local folder, stem = start:match "^(.*/)([^/]*)$"
  if not folder then folder, stem = "", start end
  local names = {}
  for _, entry in ipairs(core.files_in(folder == "" and "." or folder)) do
    local fits = entry:sub(1, #stem) == stem and (stem ~= "" or entry:sub(1, 1) ~= ".")
    if fits then names[#names + 1] = folder .. entry end
  end
  table.sort(names)
  return names
end

local file_calls = { motion = true, dofile = true, loadfile = true, open = true, lines = true }

--- True if the string is a file name: of a key or a function that takes one, or a path.
local function is_file(before, start)
  local key, call = before:match "([%w_]+)%s*=%s*$", before:match "([%w_]+)%s*%(?%s*$"
  return start:find "/" or key == "file" or key == "script" or file_calls[call]
end

local function names_in_string(session, before, start)
  local names = {}
  local place = before:match "%.(bearings)%s*%[%s*$" or before:match "%.(seats)%s*%[%s*$"
    or (before:match ":%s*body%s*%(?%s*$" and "bodies")
  if before:match "%f[%w_]help%s*%(?%s*$" then
    for _, entry in ipairs(console.manual().list) do
      names[#names + 1] = entry.owner == "event type" and entry.member or entry.name
    end
  else
    for _, model in ipairs(models_seen(session)) do pcall(add_names_of, model, names, place) end
    if not place then for _, name in ipairs(core.event_names()) do names[#names + 1] = name end end
  end
  return beginning_with(names, start)
end

--- Fields (after a dot) or methods (after a colon) of a value.
local function members_of(value, mark)
  local names = {}
  local kind = core.kind_of(value)
  local members = kind and core.members(kind) or type(value) == "table" and value
    or type(value) == "string" and string or {}
  for name, member in next, members do
    local is_method = type(member) == "function"
    local fits = kind and is_method == (mark == ":") or not kind and (mark == "." or is_method)
    if type(name) == "string" and name:find "^[%a_]" and fits then names[#names + 1] = name end
  end
  return names
end

--- The value of "a.b['c'][1]": names and keys only, no calls.
local function value_of_chain(session, chain)
  if chain:find "[%(%){}]" then return nil end
  local chunk = load("return " .. chain, "=console", "t", session.environment)
  if not chunk then return nil end
  local good, value = pcall(chunk)
  return good and value or nil
end

--- Keys of the function whose table is open at the end of the text.
local function keys_of_call(session, before)
  local call = before:match "([%a_][%w_.:]*)%s*%(?%s*{[^{}]*$"
  local names = {}
  if not call or not before:find "[{,]%s*[%w_]*$" then return names end
  local function value_of(name) return console.value_of(session, name) end
  for _, entry in ipairs(console.entries_named(call, value_of)) do
    for _, keys in ipairs { entry.keys, entry.with } do
      for _, key in ipairs(keys) do names[#names + 1] = key.name end
    end
  end
  return names
end

--- The position (from 1) of the name at the end of `before`, and its possible completions.
function console.complete(before, session)
  local quote, from = open_string(before)
  if quote then
    local call, start = before:sub(1, from - 2), before:sub(from)
    return from, is_file(call, start) and files_beginning_with(start) or names_in_string(session, call, start)
  end
  local chain, mark, at, start = before:match "([%a_][%w_.]*)([.:])()([%w_]*)$"
  if not chain then chain, mark, at, start = before:match "([%a_][%w_.]*%b[])([.:])()([%w_]*)$" end
  if chain then return at, beginning_with(members_of(value_of_chain(session, chain), mark), start) end
  at, start = before:match "()([%a_][%w_]*)$"
  local keys = keys_of_call(session, before)
  if not at then return #before + 1, #keys > 0 and beginning_with(keys, "") or {} end
  local names = beginning_with(keys, start)
  if #names > 0 then return at, names end
  names = console.names_of(session)
  table.move(keywords, 1, #keywords, #names + 1, names)
  return at, beginning_with(names, start)
end
