-- The sandbox: removes access to other files, programs or the internals of the library from a script's globals.
-- This file, like all of the library, uses a copy of the globals that no script can change. It calls no method of a
-- text, because a script can change these.
local room = ...
local G, fail, rawget, rawset, type, error, next, select = _G, room.fail, rawget, rawset, type, error, next, select
local meta_of, set_meta, open, lines = debug.getmetatable, setmetatable, io.open, io.lines
local own_get, getinfo, traceback, load_file = getmetatable, debug.getinfo, debug.traceback, loadfile
local input, output, collect = io.input, io.output, collectgarbage

local function refusal(name, why)
  return function()
    fail(name .. " is refused: " .. why .. "; `trilith run --trust SCRIPT` allows it for a script that you trust")
  end
end

-- Functions of a library that a script cannot use, with error messages.
local function refuse_others(name, whole, closed, why)
  for key, value in next, whole do
    if rawget(closed, key) == nil and type(value) == "function" then
      closed[key] = refusal(name .. "." .. key, why[key] or why[1])
    end
  end
  rawset(G, name, closed)
  rawget(G, "package").loaded[name] = closed
end

local function keep(whole, names)
  local closed = {}
  for _, name in next, names do closed[name] = whole[name] end
  return closed
end

-- Metatables: a script can access those it has set itself. All others are neither readable nor writable.
local set_by_script = set_meta({}, { __mode = "k" })
function G.getmetatable(value)
  local meta = meta_of(value)
  if meta == nil then return nil end
  if set_by_script[meta] or rawget(meta, "__metatable") ~= nil then return own_get(value) end
  return "locked"
end
function G.setmetatable(t, ...)
  local meta = ...
  if type(t) == "table" and type(meta) == "table" then
    if rawget(meta, "__gc") ~= nil then
      fail("setmetatable: '__gc' is refused: time limits do not apply in it; use a variable declared <close>")
    end
    local was = meta_of(t)
    if was ~= nil and not set_by_script[was] then fail("setmetatable: this table's metatable is locked") end
    set_by_script[meta] = true
  end
  return set_meta(t, ...)
end

-- Files.
local closed_io = keep(io, { "close", "read", "write", "type", "stdin", "stdout", "stderr", "tmpfile" })
function closed_io.open(path, mode) return open(room.for_mode(path, mode), mode) end
function closed_io.lines(path, ...)
  if path == nil then return lines() end
  return lines(room.readable(path, "io.lines"), ...)
end
function closed_io.input(file)
  if file == nil then return input() end
  return input(type(file) == "userdata" and file or room.readable(file, "io.input"))
end
function closed_io.output(file)
  if file == nil then return output() end
  return output(type(file) == "userdata" and file or room.writable(file, "io.output"))
end
refuse_others("io", io, closed_io, { "it reaches files outside the folders of the script",
  popen = "it starts programs" })

local closed_os = keep(os, { "clock", "date", "time", "difftime", "exit" })
closed_os.remove, closed_os.rename, closed_os.getenv = room.remove, room.rename, room.variable
refuse_others("os", os, closed_os, { "it changes this process", execute = "it starts programs",
  tmpname = "it makes a file outside the folders of the script; name one next to the results" })

-- Code: text only, from readable files.
local function loaded_file(path, owner, ...)
  room.readable(path, owner)
  return load_file(path, "t", ...)
end
function G.loadfile(path, _, ...) return loaded_file(path, "loadfile", ...) end
function G.dofile(path)
  local chunk, message = loaded_file(path, "dofile", G)
  if not chunk then error(message, 0) end
  return chunk()
end

local closed_string = rawget(G, "string")
closed_string.dump = refusal("string.dump", "bytecode is not allowed")

-- Parts of require: the library's searchers, which a script cannot access, and the script's package.path.
local searchers, path, preloaded = package.searchers, package.path, package.preload
local closed_package = { loaded = package.loaded, preload = preloaded, path = path, config = package.config }
for i = #searchers, 3, -1 do searchers[i] = nil end
searchers[2] = function(name)
  local places = rawget(closed_package, "path")
  local real, file = room.module_file(name, type(places) == "string" and places or "")
  if not real then return "no file of that name in package.path" end
  local chunk, message = load_file(file, "t", G)
  if not chunk then error(message, 0) end
  return chunk, file
end
refuse_others("package", package, closed_package, { "it loads code other than Lua scripts" })
set_meta(closed_package, { __metatable = "locked", __index = function(_, name)
  fail("package." .. (type(name) == "string" and name or "?") ..
    " is refused: modules are Lua files in package.path; `trilith run --trust SCRIPT` allows more")
end })

-- The debug library: only positions of objects, never the objects themselves.
local shown = { "currentline", "short_src", "source", "linedefined", "lastlinedefined", "what", "name", "namewhat" }
local closed_debug = { traceback = traceback }
function closed_debug.getinfo(at, ...)
  if type(at) ~= "number" and type(at) ~= "function" or select("#", ...) > 1 then
    fail("debug.getinfo: takes a level or a function, and a list of fields")
  end
  local found = getinfo(type(at) == "number" and at + 1 or at, "Sln")
  if not found then return nil end
  local told = {}
  for _, name in next, shown do told[name] = found[name] end
  return told
end
refuse_others("debug", debug, closed_debug, { "it changes the inside of other functions" })

function G.collectgarbage(option, ...)
  if option == nil or option == "collect" or option == "count" then return collect(option, ...) end
  fail("collectgarbage: takes \"collect\" or \"count\" here; `trilith run --trust SCRIPT` allows all")
end
