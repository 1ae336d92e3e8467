return {
  name = "debugging", title = "At the console: looking, pausing, going back",
  { "model:break_on", "The run pauses there, and the console opens. Gives the break's number.",
    args = "where  text?  an event, or a function that says when, or the table", keys = [[
[1]      text?             an event
body     body?             of this body
bearing  bearing?          of this bearing
seat     seat?             of this seat
group    text?             of a body of this group
above    number?           of a value above this
when     function?         pauses when f(model) becomes true
line     text or integer?  a line of a script: "bridge.lua:40"
once     flag = false      only the first time]], gives = "integer" },
  { "model:break_off", "That break is over; without a number all are.",
    args = "number  integer?  as break_on gave it" },
  { "model:breaks", "Breaks that hold, in words by number.", gives = "string[]" },
  { "model:step", "So many steps more: of the stage that pauses, or of one of its own.",
    args = "n  integer = 1  how many" },
  { "model:continue", "Lets a run that pauses go on, or the stage that rewind has brought back.", gives = "report" },
  { "model:rewind", "Back to the checkpoint in memory nearest to that time. What was recorded since stays in an "
    .. "unfinished file; what follows goes to one of its own.", args = "seconds  number s?  how far back; or the table",
    keys = "to  number s  the time to go back to", gives = "number" },
  { "model:checkpoints", "What is kept in memory to go back to; at a console one each 0.1 s by itself.", keys = [[
every  number s = 0.1      between them
count  integer = 400       at most so many
bytes  number = 256e6      in at most so much memory
on     flag = true         false: none are taken]], gives = "findings" },
  { "model:compare", "What changed between the run that rewind took back and the present one.", gives = "findings" },
  { "model:change", "Another number from now on; in a handler, from the next step border on. The energy `added` has "
    .. "what that puts in.", keys = [[
law      text?   a contact law, with its numbers: mu = 0.4
bearing  text?   or a bearing
along    direction law?  its law along; one of another kind begins anew
across   direction law?  in space: its law across
horizontal  direction law?  in space: one law of along and across, instead of these
axial    direction law?  its law in the axial direction
turning  direction law?  in the plane: for turning
turning_along   direction law?  in space: for turning about along
turning_across  direction law?  in space: for turning about across
turning_axial   direction law?  in space: for turning about axial
limit    table?  its limits by the names of these, { along = , axial = }; those that are not named stay
angle    number rad?  in the plane: of its direction along
replaces_contact  flag?  it stands for the flat contact it sits in
becomes  text?  what is there after it failed: a contact law or a bearing that waits; false: nothing
becomes_from  text or table?  where that bearing counts from, "start" or "here"; or { along = "here" }]],
    beside = { along = true, across = true, horizontal = true, axial = true, turning = true, turning_along = true,
               turning_across = true, turning_axial = true, angle = true, replaces_contact = true, becomes = true,
               becomes_from = true } },
  { "model:lint", "What keeps a model from being built, and what of it is likely not meant, each with the next "
    .. "thing to try.", keys = [[
slip  number m = 0.1  how far joints are expected to slide: friction is to give by a thousandth of that at most]],
    gives = "findings" },
}
