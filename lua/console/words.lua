-- Commands of the console: continue, stop, quit, where, frame, save. Each is a function; alone on a line it is called.
-- `print` shows the content of tables.
local console, core, terminal = ...

local function frame_line(session, i)
  local frame = session.frames[i]
  return ("%s %d  %s:%d, in %s\n"):format(i == session.frame and ">" or " ", i, frame.source, frame.line, frame.name)
end

local function need_pause(session, word)
  if not session.paused then core.fail(word .. ": no run pauses here") end
end

--- Adds the commands to a session.
function console.add_words(session)
  local words = session.words

  --- Continues the run.
  words["continue"] = function()
    need_pause(session, "continue")
    session.left = true
  end

  --- Ends the stage at this border, and continues the script.
  function words.stop()
    need_pause(session, "stop")
    if not session.model then core.fail "stop: no stage runs here" end
    session.model:stop()
    session.left = true
  end

  --- Leaves the program with an exit code.
  function words.quit(code)
    terminal.quit(code or 0, session.paused and "left at a pause" or "")
  end
  words.exit = words.quit

  --- Lists the running functions of the user, innermost first.
  function words.where()
    need_pause(session, "where")
    for i = 1, #session.frames do terminal.write(frame_line(session, i)) end
  end

  --- Chooses the frame whose locals are visible.
  function words.frame(i)
    need_pause(session, "frame")
    if not session.frames[i] then core.fail(("frame: there are frames 1 to %d"):format(#session.frames)) end
    session.frame = i
    terminal.write(frame_line(session, i))
  end

  --- Writes the present instant to a file, for `trilith -i --from FILE`.
  function words.save(file, model)
    model = model or session.model
    if not model then core.fail 'save: no run pauses here; give the model, as in save("end.instant", m)' end
    core.save(model, file)
    terminal.write(("%s contains the instant %.6g s; trilith -i --from %s opens it\n"):format(file, model.time, file))
  end

  --- Prints its arguments as the built-in function does, and plain tables with their content.
  function words.print(...)
    local texts = table.pack(...)
    for i = 1, texts.n do
      local value, meta = texts[i], debug.getmetatable(texts[i])
      local is_plain = type(value) == "table" and not (meta and (meta.__tostring or meta.__name))
      texts[i] = is_plain and console.show(value) or tostring(value)
    end
    terminal.write(table.concat(texts, "\t") .. "\n")
  end

  console.add_help(session)
  for name, word in pairs(words) do
    if name ~= "print" then session.acts[word] = word end -- "print" alone on a line is a value
  end
end
