-- Check of the manual against the Lua interface: no missing entries, no unknown entries, every key.
local console, core = ...

local function complain(list, ...) list[#list + 1] = string.format(...) end

local function check_members(list, manual)
  for owner, kind in pairs(console.kind_names) do
    for name, member in pairs(core.members(kind)) do
      local is_method = type(member) == "function"
      local entry = manual.by_name[owner .. (is_method and ":" or ".") .. name]
        or owner == "model" and manual.by_name["space:" .. name]
      if not entry then
        complain(list, "%s%s%s is not declared", owner, is_method and ":" or ".", name)
      elseif entry.is_field and not entry.type then
        complain(list, "%s.%s has no type; give it under fields of a page in lua/manual", owner, name)
      end
    end
  end
end

local function check_module(list, manual, t, name)
  for key, value in next, t do
    if type(value) == "table" then
      check_module(list, manual, value, name .. "." .. key)
    elseif not manual.by_name[name .. "." .. key] then
      complain(list, "%s.%s is not declared", name, key)
    end
  end
end

local function check_there(list, manual)
  for _, entry in ipairs(manual.list) do
    local owner = console.table_of(entry.owner)
      or console.kind_names[entry.owner] and core.members(console.kind_names[entry.owner])
      or entry.owner == "space" and core.members "model"
    if not entry.is_row and (not owner or rawget(owner, entry.member) == nil) then
      complain(list, "%s is declared but not there", entry.name)
    end
  end
end

-- With an unknown key a constructor lists its known ones.
local function keys_known(entry, things)
  local owner = console.table_of(entry.owner)
  local given = { zz_no_such_key_zz = 1 }
  local good, message
  if owner then
    good, message = pcall(owner[entry.member], given)
  else
    good, message = pcall(things[entry.owner][entry.member], things[entry.owner], given)
  end
  local known = not good and message:match "unknown key 'zz_no_such_key_zz'; known: (.*)$"
  if not known then return nil, tostring(message) end
  local keys = {}
  for key in known:gmatch "[%w_%[%]]+" do keys[key] = true end
  return keys
end

local function check_keys(list, manual)
  local trilith = core.module
  local things = { model = trilith.model {}, space = trilith.model { dim = 3 },
    motion = trilith.motion { acceleration = { 0, 1, 0 }, dt = 1 } }
  for _, entry in ipairs(manual.list) do
    if entry.takes_table and not entry.unread and (things[entry.owner] or entry.owner:find "^trilith") then
      local known, message = keys_known(entry, things)
      if not known then
        complain(list, "%s does not say which keys it knows: %s", entry.name, message)
      else
        local declared = {}
        for _, keys in ipairs { entry.keys, entry.with } do
          for _, key in ipairs(keys) do
            declared[key.name] = true
            if not known[key.name] and not entry.beside[key.name] and key.name ~= "[1]" then
              complain(list, "%s: key '%s' is declared but not known", entry.name, key.name)
            end
          end
        end
        for key in pairs(known) do
          if not declared[key] then complain(list, "%s: key '%s' is not declared", entry.name, key) end
        end
      end
    end
  end
end

--- Errors of the manual as text; empty if it is complete.
function console.undeclared()
  local manual, list = console.manual(), {}
  check_members(list, manual)
  check_module(list, manual, core.module, "trilith")
  check_there(list, manual)
  check_keys(list, manual)
  table.sort(list)
  return list
end
