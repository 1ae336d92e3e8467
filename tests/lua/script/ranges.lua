-- Each number whose range the reference pages give refuses the values just outside of it, and NaN and infinity, with a
-- message that names the key. Each call is the call of an example, with one key changed. Functions without an
-- example get values from within their ranges.
local trilith = require "trilith"
local show = os.getenv "TRILITH_SHOW"

local function new_model(dim)
  local m = trilith.model { name = "ranges", dim = dim }
  m:material { name = "stone", density = 2400, E = 1e10, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 2e-4 } }
  if dim == 2 then
    m:block { name = "ground", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", width = 0.5, height = 1, at = { -0.25, 0 }, material = "stone" }
  else
    m:block { name = "ground", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", size = { 0.5, 0.5, 1 }, at = { -0.25, -0.25, 0 }, material = "stone" }
  end
  return m
end

-- Values just outside of a range such as "above 0, at most 0.9", and one inside; none for texts without a range.
local function outside(range, is_integer)
  range = range:gsub(";.*$", "")  -- the plausible range follows
  range = range:gsub("(%-?%d+)/(%d+)", function(a, b) return ("%.17g"):format(a/b) end)
  if range:find "^usual" or range == "" then return nil end
  local out, number = { 0/0, 1/0, -1/0 }, "(%-?[%d.]+[e%d+-]*)"
  local function beyond(bound, sign) return bound + sign*(is_integer and 1 or math.max(1e-6, math.abs(bound)*1e-6)) end
  local low, high = range:match("^" .. number .. " to " .. number)
  if low then
    out[#out + 1], out[#out + 2] = beyond(tonumber(low), -1), beyond(tonumber(high), 1)
    return out, tonumber(low) + 0.5*(tonumber(high) - tonumber(low))
  end
  local above, least = range:match("above " .. number), range:match("at least " .. number)
  local below, most = range:match("below " .. number), range:match("at most " .. number)
  if above then out[#out + 1] = tonumber(above) end
  if least then out[#out + 1] = beyond(tonumber(least), -1) end
  if below then out[#out + 1] = tonumber(below) end
  if most then out[#out + 1] = beyond(tonumber(most), 1) end
  if #out == 3 then return nil end
  local from, to = tonumber(above or least or most or below), tonumber(most or below)
  return out, to and 0.5*(from + to) or from + 1
end

-- { name =, keys = { { name, type, outside, inside, needed }, ... }, example = } of each function of a page.
local function functions_of(page)
  local list, entry, example
  list = {}
  for line in io.lines(page) do
    local name = line:match "^### `([%w_.:]+)[{(]"
    if line:find "^###" then entry = name and { name = name, keys = {} } or nil end
    if entry and name then list[#list + 1] = entry end
    if entry and line == "```lua" then example, entry.example = true, entry.example or {}
    elseif line == "```" then example = nil
    elseif entry and example then entry.example[#entry.example + 1] = line end
    if entry and line:find "^| key " then entry.with_range = line:find("| range |", 1, true) ~= nil end
    local key, kind, _, preset, range = line:match "^| `([%w_]+)` | ([^|]*) | ([^|]*) | ([^|]*) | ([^|]*) |"
    if entry and entry.with_range and key then
      local values, inside = outside(range, kind == "integer")
      entry.keys[#entry.keys + 1] = { name = key, type = kind, outside = values, inside = inside or 1,
                                      needed = preset == "–" }
    end
  end
  return list
end

local tested, reached, faults, unreached = 0, {}, {}, {}

-- Calls f(options) with each key of the entry outside its range.
local function probe(entry, options, f)
  for _, key in ipairs(entry.keys) do
    for _, value in ipairs(key.outside or {}) do
      local given = {}
      for k, v in pairs(options) do given[k] = v end
      given[key.name] = value
      local good, message = pcall(f, given)
      local names = not good and (tostring(message):find(key.name, 1, true)
        or tostring(message):find(key.name:gsub("_", " "), 1, true))
      local where = ("%s{ %s = %s }"):format(entry.name, key.name, value)
      if good then faults[#faults + 1] = where .. " is accepted"
      elseif names then tested, reached[entry.name .. "." .. key.name] = tested + 1, true
      else unreached[#unreached + 1] = where .. ": " .. tostring(message) end
    end
  end
end

local function resolve(name)
  local value = trilith
  for part in name:gsub("^trilith%.", ""):gmatch "[^.]+" do value = value[part] end
  return value
end

-- Runs the example of an entry, with its call replaced by probes and the call.
local scratch = os.tmpname()
local function probe_example(entry, dim)
  local text = table.concat(entry.example, "\n"):gsub('"out/', '"' .. scratch)
  local owner, member = entry.name:match "^(.*):([%w_]+)$"
  local count
  if owner then
    text, count = text:gsub("([%w_]+):" .. member .. "%s*(%b{})", "probed(%1, %2)")
  else
    text, count = text:gsub((entry.name:gsub("%.", "%%.")) .. "%s*(%b{})", "probed(nil, %1)")
  end
  if count == 0 then return false end
  local m = new_model(dim)
  local done = false
  local there = setmetatable({ m = m, trilith = trilith, print = function() end }, { __index = _G })
  function there.probed(self, options)
    local f = self and function(o) return self[member](self, o) end or resolve(entry.name)
    if not done then done = true; probe(entry, options, f) end
    return f(options)
  end
  local chunk = load(text, "=" .. entry.name, "t", there)
  if chunk then pcall(chunk) end
  m:close()
  return done
end

-- A function without an example: numbers from within their ranges.
local function probe_plain(entry)
  local options = {}
  for _, key in ipairs(entry.keys) do
    if key.needed and (key.type == "number" or key.type == "integer") then options[key.name] = key.inside end
  end
  local f = entry.name:find "^trilith%." and resolve(entry.name)
  if type(f) ~= "function" then return end
  probe(entry, options, f)
end

for page in io.popen("ls ../../docs/reference/*.md"):lines() do
  for _, entry in ipairs(functions_of(page)) do
    local ranged = false
    for _, key in ipairs(entry.keys) do ranged = ranged or key.outside ~= nil end
    if ranged and entry.name ~= "trilith.study" then  -- a script has one study
      local dim = entry.name:find "^space:" and 3 or 2
      if not (entry.example and probe_example(entry, dim)) then probe_plain(entry) end
    end
  end
end
os.execute(("rm -rf %s*"):format(scratch))

if show then
  for _, fault in ipairs(faults) do print("accepted", fault) end
  for _, text in ipairs(unreached) do print("unreached", text) end
  local keys = 0
  for _ in pairs(reached) do keys = keys + 1 end
  print(tested, "values", keys, "keys", #faults, "accepted", #unreached, "unreached")
else
  assert(#faults == 0, table.concat(faults, "\n"))
  assert(#unreached == 0, table.concat(unreached, "\n"))
  assert(tested > 1700, ("only %d values were tried"):format(tested))
end
