-- The console: reads lines, runs them, shows their results. One session at the top level, further ones at pauses of a
-- run.
local console, core, terminal = ...

local kept = {} -- names that outlive the chunk in which they were local
console.kept = kept

--- Keeps the locals of the function at `level` (seen from the caller) under their names.
local function keep_locals(level)
  for i = 1, math.huge do
    local name, value = debug.getlocal(level + 1, i)
    if not name then return end
    if name:find "^[%a_]" and name ~= "_kept" then kept[name] = { value = value } end
  end
end

-- Beginning of the first line of each chunk: its locals are kept when the chunk is left. After an error the chunk has
-- ended already, and the message handler has kept them.
console.prelude = "local _kept <close> = require 'trilith.kept'; "
package.loaded["trilith.kept"] = setmetatable({}, { __close = function(_, failure)
  if failure == nil then keep_locals(2) end
end })

local function is_users(info)
  return info.what ~= "C" and not info.source:find "^=trilith/"
end

--- Within a message handler: keeps the locals of the chunk and of the function that failed.
local function keep_failed()
  local innermost = true
  for level = 3, math.huge do
    local info = debug.getinfo(level, "S")
    if not info then return end
    if is_users(info) and (innermost or info.what == "main") then
      innermost = false
      keep_locals(level)
    end
    if info.what == "main" then return end
  end
end

--- The frames of the user's own functions below the caller, innermost first, at a pause of a run.
local function frames_now()
  local total = 1
  while debug.getinfo(total + 1, "l") do total = total + 1 end
  local frames = {}
  for level = 2, total do
    local info = debug.getinfo(level, "Slfn")
    if is_users(info) and info.source ~= "=console" then
      frames[#frames + 1] = { index = total - level, func = info.func, source = info.short_src,
        line = info.currentline, name = info.what == "main" and "the script" or info.name or "a function" }
    end
  end
  return frames, coroutine.running()
end

--- Access by get, set and count functions to locals and upvalues of a frame; nil for an unknown name.
local function frame_variable(session, name)
  local frame = session.frames[session.frame]
  if not frame or coroutine.running() ~= session.thread then return nil end
  local total = 1
  while debug.getinfo(total + 1, "l") do total = total + 1 end
  local level, found = total - frame.index, nil
  for i = 1, math.huge do
    local known = debug.getlocal(level, i)
    if not known then break end
    if known == name then found = i end
  end
  if found then
    local _, value = debug.getlocal(level, found)
    return { value = value }, function(new) debug.setlocal(level, found, new) end
  end
  for i = 1, math.huge do
    local known, value = debug.getupvalue(frame.func, i)
    if not known then break end
    if known == name and name ~= "_ENV" then
      return { value = value }, function(new) debug.setupvalue(frame.func, i, new) end
    end
  end
  return nil
end

--- All names visible to a chunk of this session.
function console.names_of(session)
  local names, seen = {}, {}
  local function add(name)
    if type(name) == "string" and name:find "^[%a_][%w_]*$" and not seen[name] then
      seen[name] = true
      names[#names + 1] = name
    end
  end
  for name in pairs(session.words) do add(name) end
  for name in pairs(kept) do add(name) end
  for name in pairs(_G) do add(name) end
  local frame = session.frames[session.frame]
  if frame and coroutine.running() == session.thread then
    local total = 1
    while debug.getinfo(total + 1, "l") do total = total + 1 end
    for i = 1, math.huge do
      local name = debug.getlocal(total - frame.index, i)
      if not name then break end
      add(name)
    end
    for i = 1, math.huge do
      local name = debug.getupvalue(frame.func, i)
      if not name then break end
      if name ~= "_ENV" then add(name) end
    end
  end
  table.sort(names)
  return names
end

--- The value of a name; no error for an unknown name.
function console.value_of(session, name)
  local variable = frame_variable(session, name) or kept[name]
  if variable then return variable.value end
  if session.words[name] ~= nil then return session.words[name] end
  return rawget(_G, name)
end

-- Environment of the chunks of a session: locals and upvalues of the chosen frame, kept names, console commands,
-- globals.
local function environment_of(session)
  return setmetatable({}, {
    __index = function(_, name)
      local variable = frame_variable(session, name) or kept[name]
      if variable then return variable.value end
      if session.words[name] ~= nil then return session.words[name] end
      local value = rawget(_G, name)
      if value == nil then
        local hint = core.hint(tostring(name), console.names_of(session)):gsub("^; known:.*$", "")
        core.fail(("there is no '%s' here%s"):format(tostring(name), hint))
      end
      return value
    end,
    __newindex = function(_, name, value)
      local variable, set = frame_variable(session, name)
      if variable then
        set(value)
      elseif kept[name] then
        kept[name].value = value
      else
        rawset(_G, name, value)
      end
    end,
  })
end

--- The text as a function; or nil, a message, and true if only further lines are missing.
local function compile(text, environment)
  local chunk = load("return " .. text, "=console", "t", environment)
  if chunk then return chunk end
  local message
  chunk, message = load(console.prelude .. text, "=console", "t", environment)
  if chunk then return chunk end
  return nil, message, message:find "near <eof>$" ~= nil
end

--- A message handler: the message without the console's own part of the traceback, and without a meaningless place. It
--- keeps the locals of the failed function.
function console.told(message)
  console.unsolved = terminal.told(message)
  keep_failed()
  message = terminal.traced(message)
  local lines = {}
  for line in (message .. "\n"):gmatch "(.-)\n" do
    local own = line:find "trilith/session.lua:" or line:find "%[C%]: in function 'xpcall'"
    if own and lines[#lines] ~= "stack traceback:" then break end
    if not own then lines[#lines + 1] = line end
  end
  while #lines > 1 and (lines[#lines]:find "console:%d+: in main chunk" or lines[#lines]:find "^\t%[C%]: in"
      or lines[#lines] == "stack traceback:") do
    lines[#lines] = nil
  end
  lines[1] = lines[1]:gsub("^console:1: ", "")
  if lines[1] == "interrupted" and terminal.interactive then lines[1] = "\ninterrupted" end
  return table.concat(lines, "\n")
end
local told = console.told

local function show_results(session, ...)
  local count = select("#", ...)
  if count == 0 then return end
  for i = 1, count do
    local value = select(i, ...)
    if value ~= nil or count > 1 then
      local act = type(value) == "function" and session.acts[value]
      if act and count == 1 then return act() end
      terminal.write(console.show(value) .. "\n")
    end
  end
end

--- Runs a chunk and shows its results. False where it failed, and then whether a search in it had no solution.
local function run(session, chunk)
  local results = table.pack(xpcall(chunk, told))
  if not results[1] then
    terminal.write_error(results[2] .. "\n")
    return false, console.unsolved
  end
  local shown, message = xpcall(show_results, told, session, table.unpack(results, 2, results.n))
  if not shown then terminal.write_error(message .. "\n") end
  return shown
end

--- Reads one chunk: lines until it is complete. Returns its function and text, or nil and a message; false at the end
--- of the input.
local function read(session)
  local text = nil
  while true do
    local line = terminal.read(text and (" "):rep(#session.prompt - 3) .. ">> " or session.prompt, session)
    if line == false then return nil, nil end -- Ctrl-C drops the typed text
    if not line then
      if text then return nil, "the input ends within a chunk:\n" .. text end
      return false
    end
    text = text and text .. "\n" .. line or line
    if text:find "^%s*=" then text = "return " .. text:gsub("^%s*=", "", 1) end
    if text:find "^%s*$" then return nil, nil end
    local chunk, message, unfinished = compile(text, session.environment)
    if chunk then return chunk, text end
    if not unfinished then return nil, (message:gsub("^console:1: ", "")) end
  end
end

local function prompt_at(model) return ("%.4f s> "):format(model.time) end

local function new_session(prompt, frames, thread)
  local session = { prompt = prompt, frames = frames, frame = 1, thread = thread, words = {}, acts = {} }
  session.environment = environment_of(session)
  console.add_words(session)
  session.words.trilith = core.module -- available without `require`, for convenience
  return session
end

--- Reads and runs chunks until the session is left. True if no chunk failed.
local function loop(session)
  local all_good, ends = true, 0
  while not session.left do
    local chunk, message = read(session)
    if chunk then
      ends = 0
      -- Input during a pause is not part of the script: the results record it.
      if session.model then core.note(session.model, ("console at %.6g s: %s"):format(session.model.time, message)) end
      local good, unsolved = run(session, chunk)
      console.no_solution = console.no_solution or unsolved
      all_good = (good or unsolved) and all_good
      core.arm_lines()
      local why = session.model and core.pause_reason(session.model) or ""
      if why ~= "" then terminal.write(("Paused: %s.\n"):format(why)) end
      if session.model then session.prompt = prompt_at(session.model) end
    elseif message then
      terminal.write_error(message .. "\n")
      all_good = false
    elseif chunk == false then
      ends = ends + 1
      if not session.paused or not terminal.interactive then break end
      if ends > 1 then terminal.quit(0, "left at a pause") end
      terminal.write "`continue` continues the run, `stop` ends the stage here, Ctrl-D once more leaves the program.\n"
    end
  end
  console.failed = console.failed or not all_good
end

--- The console at the top, until it is left. Returns whether no chunk failed, and whether a search in a chunk
--- had no solution.
function console.top()
  loop(new_session("> ", {}, coroutine.running()))
  return not console.failed, console.no_solution
end

--- The console at a pause of `model`, or (nil) of a script: returns when it continues.
function console.pause(why, model)
  local frames, thread = frames_now()
  local session = new_session(model and prompt_at(model) or "paused> ", frames, thread)
  session.paused, session.model = true, model
  if why == "interrupted" and terminal.interactive then terminal.write "\n" end
  terminal.write(("Paused: %s.\n"):format(why))
  if frames[1] then
    terminal.write(("%s:%d, in %s. "):format(frames[1].source, frames[1].line, frames[1].name))
  end
  local hint = "`continue` continues the run, `stop` ends the stage here, `help` prints more.\n"
  terminal.write(console.has_paused and "\n" or hint)
  console.has_paused = true
  local outer = core.leave_pause
  function core.leave_pause() session.left = true end
  loop(session)
  core.leave_pause = outer
  core.arm_lines()
end
