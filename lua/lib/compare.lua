-- m:compare(): differences between the run that rewind removed and the present one.
local _, core = ...
local model_methods = core.members "model"

core.findings.__tostring = function(found)
  return found.text == "" and found.sound and "the run is valid" or found.text
end

-- Identity of an event without its numbers.
local function key_of(event)
  local names = {}
  for _, body in ipairs(event.bodies) do names[#names + 1] = body.name end
  local of = event.bearing and event.bearing.name or event.seat and event.seat.name or table.concat(names, ", ")
  return event.type .. "  " .. of
end

local function first_times(events)
  local times, order = {}, {}
  for _, event in ipairs(events) do
    local key = key_of(event)
    if not times[key] then
      times[key] = event.time
      order[#order + 1] = key
    end
  end
  return times, order
end

local function event_changes(before, now)
  local changes = {}
  local was, was_order = first_times(before)
  local is, is_order = first_times(now)
  for _, key in ipairs(was_order) do
    if not is[key] then
      changes[#changes + 1] = { time = was[key], what = key, before = was[key] }
    elseif is[key] ~= was[key] then
      changes[#changes + 1] = { time = math.min(was[key], is[key]), what = key, before = was[key], now = is[key] }
    end
  end
  for _, key in ipairs(is_order) do
    if not was[key] then changes[#changes + 1] = { time = is[key], what = key, now = is[key] } end
  end
  table.sort(changes, function(a, b) return a.time < b.time or (a.time == b.time and a.what < b.what) end)
  return changes
end

local function change_line(change)
  if not change.now then return ("  %-44s before at %.4f s, not now"):format(change.what, change.before) end
  if not change.before then return ("  %-44s now at %.4f s, not before"):format(change.what, change.now) end
  return ("  %-44s before at %.4f s, now at %.4f s"):format(change.what, change.before, change.now)
end

local function add_some(lines, title, list, line_of)
  if #list == 0 then return end
  lines[#lines + 1] = title
  for i = 1, math.min(#list, 12) do lines[#lines + 1] = line_of(list[i]) end
  if #list > 12 then lines[#lines + 1] = ("  and %d more"):format(#list - 12) end
end

local function text_of(found)
  if not found.now then
    return ("the branches separate at %.4f s and have no later time in common; the earlier branch is kept from %.4f to "
      .. "%.4f s: continue to that time to compare them"):format(found.from, found.kept_from, found.kept_to)
  end
  if found.same then return ("identical at %.4f s; the branches separate at %.4f s"):format(found.now, found.from) end
  local lines = { ("at %.4f s, compared with the earlier branch (%.4f s); they separate at %.4f s"):format(found.now,
    found.before, found.from) }
  add_some(lines, "bodies moved most", found.moved, function(row)
    return ("  %-24s %.4g m, turned %.3g rad"):format(row.body.name, row.distance, row.turn)
  end)
  add_some(lines, "events", found.events, change_line)
  local histories = {}
  for name, h in pairs(found.histories) do
    if h.difference > 0 then histories[#histories + 1] = { name = name, row = h } end
  end
  table.sort(histories, function(a, b) return a.name < b.name end)
  add_some(lines, "histories, largest difference", histories, function(h)
    return ("  %-24s %.4g %s at %.4f s"):format(h.name, h.row.difference, h.row.unit, h.row.at)
  end)
  return table.concat(lines, "\n")
end

--- m:compare(): { from, before, now, same, moved, events, histories }, and the same in words.
function model_methods.compare(model)
  local found = core.compare(model)
  if not found then core.fail "compare: there is no earlier branch; call m:rewind(seconds), then run on" end
  if found.now then
    found.events = event_changes(found.events_before, found.events_now)
    found.events_before, found.events_now = nil, nil
    for name, row in pairs(found.histories) do row.own = core.own(model).sampled[name] end
  end
  found.text = text_of(found)
  return setmetatable(found, core.findings)
end
