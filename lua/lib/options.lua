-- Checks of the tables that functions written in Lua take.
local _, core = ...

--- Fails unless `options` is a table whose keys are all in the list `known`.
function core.check_keys(owner, options, known)
  if type(options) ~= "table" then
    core.fail(("%s: takes a table { %s = , ... }; this is %s"):format(owner, known[1], core.what_is(options)))
  end
  local is_known, unknown = {}, nil
  for _, key in ipairs(known) do is_known[key] = true end
  for key in pairs(options) do
    if not is_known[key] and (not unknown or tostring(key) < unknown) then unknown = tostring(key) end
  end
  if unknown then core.fail(("%s: unknown key '%s'%s"):format(owner, unknown, core.hint(unknown, known))) end
end

--- `value` if it is a number above 0. `unit`: text after "a number above 0".
function core.positive(owner, key, value, unit)
  if type(value) ~= "number" or not (value > 0 and value < math.huge) then
    core.fail(("%s: '%s' is %s, must be a number above 0%s"):format(owner, key,
      value == nil and "missing" or core.what_is(value), unit))
  end
  return value
end

--- `value`, or `preset` if it is nil, if the list `known` contains it.
function core.one_of(owner, key, value, known, preset)
  if value == nil then value = preset end
  for _, one in ipairs(known) do
    if value == one then return value end
  end
  if type(value) ~= "string" then
    core.fail(("%s: '%s' is %s, must be one of: %s"):format(owner, key,
      value == nil and "missing" or core.what_is(value), table.concat(known, ", ")))
  end
  core.fail(("%s: there is no '%s' for the key '%s'%s"):format(owner, value, key, core.hint(value, known)))
end
