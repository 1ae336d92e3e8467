return {
  name = "handlers", title = "Handlers and stories: Lua that runs when something happens",
  { "model:on", "Calls f(event) at each such event; \"*\": at every one. Of some bodies alone: m:on({ \"impact\", "
    .. "body = b, above = 2 }, f), with body, bearing, seat, group, above as m:wait has them. Gives the handler.",
    args = [[
event  text      such as "bearing.failed"; or a table with filters
f      function  is given the event]], gives = "table" },
  { "model:every", "Calls f(model) each interval of simulated time. Gives the handler.", args = [[
interval  number s  between calls
f         function  is given the model]], gives = "table" },
  { "model:on_step", "Calls f(model) after each step. Gives the handler.", args = "f  function  is given the model",
    gives = "table" },
  { "model:off", "That handler is not called any more.", args = "handler  table  what on, every or on_step gave" },
  { "model:story", "Runs f(model) alongside the model: up to its first m:wait at once, then on when that happens.",
    args = "f  function  is given the model" },
  { "model:wait", "In a story: waits for an event, or for a time. Gives the event, nil when the time is over.",
    args = "what  text?  an event, or a time [s], or the table", keys = [[
[1]      text?      the event
body     body?      of this body
bearing  bearing?   of this bearing
seat     seat?      of this seat
group    text?      of a body of this group
above    number?    of a value above this
within   number s?  and no longer than this]], gives = "event" },
}
