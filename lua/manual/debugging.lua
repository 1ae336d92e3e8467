return {
  name = "debugging", title = "At the console: breaks, checkpoints and checks",
  { "model:break_on", "Sets a break: the run pauses there, and the console opens. Returns the number of the break.",
    args = "where  text?  an event type, a condition f(model), or the table", keys = [[
[1]      text?             type of event
body     body?             only of this body
bearing  bearing?          only of this bearing
seat     seat?             only of this seat
group    text?             only of a body of this group
above    number?           only with a value above this  <at least 0>
when     function?         pauses when f(model) becomes true
line     text or integer?  a line of a script: "bridge.lua:40"
once     flag = false      only the first time]], gives = "integer" },
  { "model:break_off", "Removes a break; without a number all of them.",
    args = "number  integer?  number of the break" },
  { "model:breaks", "Lists the active breaks by number.", gives = "string[]" },
  { "model:step", "Runs a number of steps: of the paused stage, or of a new one.",
    args = "n  integer = 1  number of steps" },
  { "model:continue", "Continues a paused run, or the stage that rewind returned to.", gives = "report" },
  { "model:rewind", "Returns to the checkpoint in memory nearest to a time. Earlier results stay in an "
    .. "unfinished file. Later results go to a new file.",
    args = "seconds  number s?  time to go back by; or the table",
    keys = "to  number s  time to go back to", gives = "number" },
  { "model:checkpoints", "Sets the checkpoints kept in memory. The console keeps one every 0.1 s by default.",
    keys = [[
every  number s = 0.1      interval  <at least 0>
count  integer = 400       largest number  <at least 1>
bytes  number = 256e6      largest memory, in bytes  <above 0>
on     flag = true         false: no checkpoints]], gives = "findings" },
  { "model:compare", "Differences between the run before rewind and the present one.", gives = "findings" },
  { "model:change", "Changes numbers of a law or a bearing, from now on; in a handler, from the end of the step. "
    .. "The energy term `added` has the energy of the change.", keys = [[
law      text?   a contact law, with its numbers: mu = 0.4
bearing  text?   or a bearing
along    direction law?  law along; a law of another kind restarts
across   direction law?  in space: law across
horizontal  direction law?  in space: one law of along and across, instead of these
axial    direction law?  law in the axial direction
turning  direction law?  in the plane: law of rotation
turning_along   direction law?  in space: law of rotation about along
turning_across  direction law?  in space: law of rotation about across
turning_axial   direction law?  in space: law of rotation about axial
limit    table?  limits by direction, { along = , axial = }; other limits stay
angle    number rad?  in the plane: angle of the direction along
replaces_contact  flag?  it replaces the flat contact at its place
becomes  text?  successor after failure: a contact law or a waiting bearing; false: none
becomes_from  text or table?  origin of the successor's displacement: "start" or "here"; or { along = "here" }]],
    beside = { along = true, across = true, horizontal = true, axial = true, turning = true, turning_along = true,
               turning_across = true, turning_axial = true, angle = true, replaces_contact = true, becomes = true,
               becomes_from = true } },
  { "model:lint", "Lists reasons why a model cannot be built, and input that is probably a mistake, each with a "
    .. "remedy.", keys = [[
slip  number m = 0.1  expected slip of joints: the elastic slip of friction should be below 0.001 of it  <above 0>]],
    gives = "findings" },
  examples = {
    ["model:break_on"] = [[
m:break_on { "impact", above = 0.5 }]],
    ["model:break_off"] = [[
local number = m:break_on "impact"
m:break_off(number)]],
    ["model:breaks"] = [[
m:break_on "impact"
for _, line in ipairs(m:breaks()) do print(line) end]],
    ["model:step"] = [[
m:step(10)
print(m.time)]],
    ["model:continue"] = [[
m:checkpoints { every = 0.05, count = 10 }
m:run { duration = 0.2 }
m:rewind(0.1)
m:continue()]],
    ["model:compare"] = [[
m:checkpoints { every = 0.05, count = 10 }
m:run { duration = 0.2 }
m:rewind(0.1)
m:continue()
print(m:compare())]],
    ["model:change"] = [[
m:contact { between = { "block", "ground" }, name = "joint",
  law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 2e-4 } }
m:run { duration = 0.01 }
m:change { law = "joint", mu = 0.4 }]],
    ["model:lint"] = [[
print(m:lint())]],
    ["model:checkpoints"] = [[
m:checkpoints { every = 0.05, count = 10 }
m:run { duration = 0.2 }]],
    ["model:rewind"] = [[
m:checkpoints { every = 0.05, count = 10 }
m:run { duration = 0.2 }
m:rewind(0.1)]],
  },
}
