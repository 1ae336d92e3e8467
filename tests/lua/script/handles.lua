-- Handles of another model, of a closed model, and read at the very end of a script. Every function of the interface is
-- taken from the declarations in lua/manual and called with a foreign handle under each of its keys, so new functions
-- are covered too.
local trilith = require "trilith"

local function make(name)
  local m = trilith.model { name = name }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e7, ks = 5e6, mu = 0.6, beta = 2e-3 } }
  m:block { name = "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
  local body = m:block { name = "b", width = 0.5, height = 0.3, at = { -0.25, 0.2 }, material = "stone",
    floating = true, groups = "storey 1" }
  local bearing = m:bearing { name = "B", between = { "b", "base" }, at = { 0, 0.1 },
    along = trilith.linear { stiffness = 1e3 } }
  local seat = m:seat { name = "S", body = "b", support = "base", at_end = { 0, 0.2 }, edge = { 0.1, 0.2 } }
  local history = m:history { name = "H", body = body, what = "x" }
  return { model = m, body = body, set = m:bodies {}, bearing = bearing, seat = seat, history = history,
    storey = m.storeys[1] }
end

local other, closed = make "other", make "closed"
closed.model:close()
closed.model = nil
local quake = trilith.motion { acceleration = { 0, 1, 0, -1, 0 }, dt = 0.1, allow_drift = true }

-- Values of the keys that are not under test.
local fillers = {
  text = "impact", names = { "stone", "stone" }, number = 1, integer = 1, flag = true, point = { 0.5, 0.5 },
  points = { { 0, 0 }, { 1, 0 }, { 1, 1 } }, vector = { 1, 1, 1 }, vectors = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
  { 0, 0, 1 } }, ["text or table"] = "fixed", numbers = { 1, 2 }, table = {}, list = {}, ["function"] = function() end,
  body = "b", bodies = "b", bearing = "B", seat = "S", motion = quake, ["two bodies"] = { "b", "base" },
  ["contact law"] = trilith.frictional { kn = 1, ks = 1, mu = 1 }, ["text or integer"] = "x.lua:1",
}
-- Handle types accepted by a declared type, in the form of an argument.
local function as_it_is(h) return h end
local takes = {
  body = { body = { as_it_is } }, bearing = { bearing = { as_it_is } }, seat = { seat = { as_it_is } },
  bodies = { body = { as_it_is, function(h) return { "b", h } end }, set = { as_it_is } },
  ["two bodies"] = { body = { function(h) return { h, "base" } end, function(h) return { "base", h } end } },
  ["bearing or law"] = { bearing = { as_it_is } },
}

--- Parses "name  number s = 3  sentence" as a key; columns are two or more spaces apart.
local function read_key(line)
  local name, kind = line:match "^(%S+)%s%s+(%S.-)%s%s+%S"
  local wanted = not kind:find "[?=]"
  return { name = name, type = kind:gsub("%s*=.*$", ""):gsub("%?$", ""):gsub("^number .*", "number"), wanted = wanted }
end
local function read_keys(text)
  local keys = {}
  for line in (text or ""):gmatch "[^\n]+" do keys[#keys + 1] = read_key(line) end
  return keys
end

local functions, shared = {}, {}
local function add(name, args, keys, with)
  local owner, member = name:match "^(.-)[:.]([%w_]+)$"
  local inner = name:match "^trilith%.%l+%."
  if inner then owner, member = inner:sub(1, -2), name:match "[%w_]+$" end
  functions[#functions + 1] = { name = name, owner = owner, member = member, args = read_keys(args),
    keys = read_keys(keys), with = with, takes_table = keys ~= nil }
end
local pages = {}
for file in io.popen("ls ../../lua/manual/*.lua"):lines() do pages[#pages + 1] = dofile(file) end
assert(#pages >= 10, "the declarations are not found")
for _, page in ipairs(pages) do
  for name, text in pairs(page.shared or {}) do shared[name] = text end
  for _, row in ipairs(page) do
    if not row.type then add(row[1], row.args, row.keys, row.with) end
  end
  for _, row in ipairs(page.makers or {}) do add("model:" .. row[1], nil, row.keys, "bodies") end
end

local function call(f, self, ...)
  if f.owner == "trilith" then return trilith[f.member](...) end
  local inner = f.owner:match "^trilith%.(%l+)$"
  if inner then return trilith[inner][f.member](...) end
  return self[f.member](self, ...)
end

--- Message of a call, in its own story because m:wait needs one; nil if the call succeeds.
local function refusal(f, self, ...)
  local given, message = table.pack(...), nil
  self.model:story(function()
    local good, what = pcall(call, f, self[f.owner], table.unpack(given, 1, given.n))
    message = not good and tostring(what) or nil
  end)
  return message
end

local function filled(keys)
  local t = {}
  for _, key in ipairs(keys) do
    if key.wanted then t[tonumber(key.name:match "%d+") or key.name] = fillers[key.type] end
  end
  return t
end

local tried, own = 0, 0
--- Calls the function with `value` at one place; it must be rejected, for the reason `why` if it is given.
local function try(f, key, value, why, by_key)
  local here = make "here"
  here.motion, here.space = quake, trilith.model { dim = 3 }
  local message
  if by_key then
    local t = filled(f.keys)
    if f.name == "model:break_on" or f.name == "model:wait" then t[1] = "impact" end
    if key.name == "when" or key.name == "line" then t[1] = nil end
    if f.name == "model:history" then t.what = "x" end
    if f.name == "model:bearing" and not (key.name == "from" or key.name == "to") then t.at = { 0, 0.1 } end
    t[key.name == "[1]" and 1 or key.name] = value
    message = refusal(f, here, t)
  else
    local given = {}
    for i, arg in ipairs(f.args) do given[i] = fillers[arg.type] end
    given[key.at] = value
    message = refusal(f, here, table.unpack(given, 1, #f.args))
  end
  tried = tried + 1
  local place = ("%s, %s = %s"):format(f.name, key.name, tostring(value))
  assert(message, place .. " is taken")
  assert(not why or message:find(why), ("%s (%s): %s"):format(place, why or "", message))
  own = own + (why and 1 or 0)
end

local function try_all(f, key, by_key)
  local wanted = takes[key.type] or {}
  for kind, handle in pairs(other) do
    if kind ~= "model" then
      for _, given in ipairs(wanted[kind] or { as_it_is }) do
        try(f, key, given(handle), wanted[kind] and "belongs to another model", by_key)
        try(f, key, given(closed[kind]), wanted[kind] and "of a closed model", by_key)
      end
    end
  end
end

for _, f in ipairs(functions) do
  if f.name ~= "trilith.study" and f.name ~= "trilith.params" and f.name ~= "model:story" then
    for i, arg in ipairs(f.args) do
      arg.at = i
      try_all(f, arg, false)
    end
    if f.takes_table then
      for _, keys in ipairs { f.keys, read_keys(shared[f.with]) } do
        for _, key in ipairs(keys) do try_all(f, key, true) end
      end
    end
  end
end
assert(tried > 1000 and own > 50, ("%d tried, %d of their own"):format(tried, own))

-- Nothing of a closed model can be read, written or called; messages may use its name.
for kind, h in pairs(closed) do
  local good, message = pcall(function() return h.name end)
  assert(not good and message:find "the model is closed", message)
  good, message = pcall(function() h.x = 1 end)
  assert(not good and message:find "the model is closed", message)
  assert(tostring(h):find "closed" or kind == "storey", tostring(h))
end
for _, f in ipairs { function() return #closed.set end, function() return closed.set + closed.body end,
  function() return closed.set - other.set end, function() return other.set * closed.set end,
  function() for _ in closed.set do end end, function() return other.set(nil, closed.body) end,
  function() return other.set:has(closed.body) end, function() return other.set:has(make("a").body) end } do
  local good, message = pcall(f)
  assert(not good and (message:find "closed" or message:find "another model"), message)
end
assert(other.set == other.model:bodies {} and other.set ~= make("same").set)

-- A finalizer may close a model during a call that reads it: garbage collection can run at every table allocation.
do
  local m = make("m").model
  m:run { duration = 0.001 }
  setmetatable({}, { __gc = function() m:close() end })
  collectgarbage("setpause", 0)
  local good, message
  repeat good, message = pcall(function() for _ = 1, 1e6 do m:joints() end end) until not good
  assert(message:find "the model is closed", message)
  collectgarbage("setpause", 200)
end

-- A table with a handle's metatable is not a handle, and a handle is destroyed once.
local meta = debug.getmetatable(other.model)
local file = debug.setmetatable(assert(io.open("script/handles.lua")), meta)
assert(not pcall(function() return file.time end))
debug.setmetatable(file, nil)
do
  local m = make("twice").model
  meta.__gc(m)
  meta.__gc(m)
  assert(not pcall(function() return m.time end))
  debug.setuservalue(other.body, nil)
  assert(not pcall(function() return other.body + other.body end))
end

-- Finalizers run in the reverse order of construction: these handles are read after their model and they themselves are
-- gone. A failure is printed, which fails the test.
local first = setmetatable({}, { __gc = function(o)
  for kind, h in pairs(o) do
    local good, message = pcall(function() return kind == "motion" and h:delay(1) or h.name end)
    if good or not (message:find "the model is closed" or message:find "must be a motion") then
      io.stderr:write(kind, ": ", tostring(message), "\n")
    end
  end
end })
for kind, h in pairs(make "last") do first[kind] = h end
first.motion = quake:delay(1)
