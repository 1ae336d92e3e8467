-- State of the script in a resumed run: m:keep{...} saves tables, and other changed variables are named.
local _, core = ...
local model_methods = core.members "model"
local pack, unpack = string.pack, string.unpack

-- Handles are kept by their kind and name.
local kinds = { ["trilith.body"] = "body", ["trilith.bearing"] = "bearing", ["trilith.seat"] = "seat" }

local function kind_of(value)
  local meta = debug.getmetatable(value)
  return meta and kinds[rawget(meta, "__name")]
end

--- Appends `value` to the list `out`. `seen`: number of each written table. `path`: name of the value in errors.
local function write(out, value, model, seen, path)
  local t = type(value)
  if t == "boolean" then
    out[#out + 1] = value and "y" or "n"
  elseif math.type(value) == "integer" then
    out[#out + 1] = pack("<c1i8", "i", value)
  elseif t == "number" then
    out[#out + 1] = pack("<c1d", "d", value)
  elseif t == "string" then
    out[#out + 1] = pack("<c1s8", "s", value)
  elseif t == "userdata" and kind_of(value) then
    local kind = kind_of(value)
    out[#out + 1] = pack("<c1s8s8", "h", kind, core.name_of(model, kind, value, "keep"))
  elseif t ~= "table" then
    core.fail(("keep: %s is %s; it takes numbers, texts, booleans, bodies, bearings, seats and tables of these")
      :format(path, core.what_is(value)))
  elseif seen[value] then
    out[#out + 1] = pack("<c1i8", "r", seen[value])
  else
    seen.count = seen.count + 1
    seen[value] = seen.count
    out[#out + 1] = "("
    for key, inner in next, value do
      write(out, key, model, seen, ("a key of %s"):format(path))
      write(out, inner, model, seen, ("%s.%s"):format(path, tostring(key)))
    end
    out[#out + 1] = ")"
  end
end

local function bytes_of(tables, model)
  local out, seen = {}, { count = 0 }
  for i, t in ipairs(tables) do write(out, t, model, seen, "table " .. i) end
  return table.concat(out)
end

--- Reads the value at position `at`; returns it and the next position. A table is read into `into`, if that is a table.
local function read(bytes, at, model, seen, into)
  local mark = bytes:sub(at, at)
  at = at + 1
  if mark == "y" or mark == "n" then return mark == "y", at end
  if mark == "i" then return unpack("<i8", bytes, at) end
  if mark == "d" then return unpack("<d", bytes, at) end
  if mark == "s" then return unpack("<s8", bytes, at) end
  if mark == "r" then
    local number, after = unpack("<i8", bytes, at)
    return seen[number], after
  end
  if mark == "h" then
    local kind, name, after = unpack("<s8s8", bytes, at)
    if kind == "bearing" then return core.bearing(model, name), after end
    if kind == "seat" then return core.seat(model, name), after end
    return model:body(name), after
  end
  local values = type(into) == "table" and into or {}
  seen[#seen + 1] = values
  local inside = {}
  while bytes:sub(at, at) ~= ")" do
    local key, value
    key, at = read(bytes, at, model, seen)
    value, at = read(bytes, at, model, seen, rawget(values, key))
    inside[key] = value
  end
  for key in next, values do
    if inside[key] == nil then values[key] = nil end
  end
  for key, value in next, inside do values[key] = value end
  return values, at + 1
end

--- m:keep(table): saves its contents with each checkpoint, and restores them in a resumed run. Returns the table.
function model_methods.keep(model, kept)
  if type(kept) ~= "table" or getmetatable(kept) then
    core.fail(("keep: takes a table, as in local state = m:keep { count = 0 }; this is %s"):format(core.what_is(kept)))
  end
  local own = core.own(model)
  bytes_of({ kept }, model)
  own.kept_tables[#own.kept_tables + 1] = kept
  core.effect(model)
  core.keeps(model)
  return kept
end

-- Changes by handlers: the script's variables are copied at the start of a stage and compared at its first checkpoint.

local most_depth, most_entries = 3, 200

local function picture(value, depth, left_out)
  if type(value) == "number" or type(value) == "string" or type(value) == "boolean" then return value end
  if type(value) ~= "table" then return tostring(value) end
  if depth == 0 or left_out[value] or debug.getmetatable(value) then return "table" end
  local out, count = {}, 0
  for key, inner in next, value do
    count = count + 1
    if count > most_entries then break end
    out[type(key) == "table" and "a table" or key] = picture(inner, depth - 1, left_out)
  end
  return out
end

local function differs(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a ~= b end
  for key, value in next, a do
    if differs(value, b[key]) then return true end
  end
  for key in next, b do
    if a[key] == nil then return true end
  end
  return false
end

--- Calls each(name, value, identity) for all upvalues of f and of the functions among them.
local function each_variable(f, seen, each)
  if seen[f] then return end
  seen[f] = true
  local info = debug.getinfo(f, "S")
  local own = info.what ~= "C" and info.source:sub(1, 1) ~= "="
  for i = 1, 255 do
    local name, value = debug.getupvalue(f, i)
    if not name then break end
    if type(value) == "function" then
      each_variable(value, seen, each)
    elseif own and name ~= "_ENV" then
      each(name, value, debug.upvalueid(f, i))
    end
  end
end

local function all_variables(own, each)
  local seen = {}
  for _, f in ipairs(own.called) do each_variable(f, seen, each) end
  for name, value in next, core.globals do
    if type(name) == "string" and type(value) ~= "function" and not own.first_globals[name] then
      each(name, value, name)
    end
  end
end

local function is_open_file(value)
  return type(value) == "userdata" and io.type(value) == "file" and value ~= io.stdout and value ~= io.stderr
    and value ~= io.stdin
end

local function sentence(names, one, several)
  local text = table.concat(names, "', '")
  return ("%s '%s'"):format(#names == 1 and one or several, text)
end

core.made[#core.made + 1] = function(model, own)
  own.kept_tables, own.called, own.first_globals = {}, {}, {}
  for name in next, core.first_globals do own.first_globals[name] = true end

  function own.kept() return #own.kept_tables > 0 and bytes_of(own.kept_tables, model) or "" end

  function own.keep_again(bytes)
    local at, seen = 1, {}
    for _, kept in ipairs(own.kept_tables) do
      if at > #bytes then break end
      local _, after = read(bytes, at, model, seen, kept)
      at = after
    end
  end

  local function left_out()
    local out = { [core.module] = true }
    for _, kept in ipairs(own.kept_tables) do out[kept] = true end
    return out
  end

  --- At the start of a stage: copies the variables.
  function own.watch_state()
    own.pictures = {}
    local without = left_out()
    all_variables(own, function(_, value, id) own.pictures[id] = picture(value, most_depth, without) end)
  end

  --- Names the state that a resumed run does not restore; "" if there is none.
  function own.unkept()
    local without, lost, files, told = left_out(), {}, {}, {}
    all_variables(own, function(name, value, id)
      if told[id] then return end
      told[id] = true
      if is_open_file(value) then
        files[#files + 1] = name
      elseif own.pictures and own.pictures[id] ~= nil and not without[value]
        and differs(own.pictures[id], picture(value, most_depth, without)) then
        lost[#lost + 1] = name
      end
    end)
    local parts = {}
    if #lost > 0 then
      parts[1] = "handlers change " .. sentence(lost, "the variable", "the variables")
        .. "; a resumed run does not restore " .. (#lost == 1 and "it" or "them")
        .. "; put state of handlers into a table given to m:keep"
    end
    if #files > 0 then
      parts[#parts + 1] = sentence(files, "the open file", "the open files")
        .. (#files == 1 and " is" or " are") .. " not restored; a resumed run opens it where the script does"
    end
    return table.concat(parts, "; ")
  end
end
