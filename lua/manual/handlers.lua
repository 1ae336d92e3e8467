return {
  name = "handlers", title = "Handlers and stories: Lua code that runs at events",
  { "model:on", "Calls f(event) at each event of a type; \"*\" means all types. With filters: m:on({ \"impact\", "
    .. "body = b, above = 2 }, f), with body, bearing, seat, group and above as in m:wait. Returns the handler.",
    also = "callback, event handler, listener",
    args = [[
event  text      such as "bearing.failed"; or a table with filters
f      function  function of the event]], gives = "table",
    example = 'm:on("impact", function(e) print(e.time, e.value) end)' },
  { "model:every", "Calls f(model) at a fixed interval of simulated time. Returns the handler.", args = [[
interval  number s  time between calls  <above 0>
f         function  function of the model]], gives = "table",
    example = "m:every(0.1, function(model) print(model.time) end)" },
  { "model:on_step", "Calls f(model) after each step. Returns the handler.",
    args = "f  function  function of the model", gives = "table",
    example = "m:on_step(function(model) if model.speed > 10 then model:stop() end end)" },
  { "model:off", "Removes a handler.", args = "handler  table  result of on, every or on_step",
    example = 'local h = m:on("impact", print)\nm:off(h)' },
  { "model:keep", "Saves a table with each checkpoint on disk; a resumed run restores it. Returns the table.",
    also = "restart, checkpoint, resume",
    args = "state  table  numbers, texts, booleans, bodies, bearings, seats and tables of these", gives = "table",
    example = "local state = m:keep { impacts = 0 }\n"
      .. 'm:on("impact", function() state.impacts = state.impacts + 1 end)' },
  { "model:story", "Runs f(model) as a coroutine: up to its first m:wait at once, then on at each event it "
    .. "waits for.", args = "f  function  function of the model",
    example = "m:story(function() m:wait(0.05); print(m.time) end)" },
  { "model:wait", "In a story: waits for an event, or for a time. Returns the event, or nil after the time.",
    args = "what  text?  an event, or a time [s], or the table", keys = [[
[1]      text?      type of event
body     body?      only of this body
bearing  bearing?   only of this bearing
seat     seat?      only of this seat
group    text?      only of a body of this group
above    number?    only with a value above this  <at least 0>
within   number s?  longest time to wait  <at least 0>]], gives = "event",
    example = 'm:story(function()\n  local e = m:wait { "impact", body = "block", within = 2 }\n'
      .. '  if e then print("first impact", e.time) end\nend)' },
}
