-- What Tab offers.
local console = ...

--- The place (from 1) of the name at the end of `before`, and the names that could stand there.
function console.complete(before, session)
  local from, start = before:match "()([%a_][%w_]*)$"
  if not from then return #before + 1, {} end
  local names = {}
  for _, name in ipairs(console.names_of(session)) do
    if name:sub(1, #start) == start then names[#names + 1] = name end
  end
  return from, names
end
