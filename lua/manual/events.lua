return {
  name = "events", title = "Types of events that handlers hear of, and what their value is",
  events = [[
stage.begun         a stage began
stage.ended         a stage ended; text: how
bond.cracked        the bond of a joint opened on a part of its face; value: the force it then carried
bond.broken         the bond of a joint is lost; value: the force it carried last; text: a couple or stress it broke at
joint.crushed       a joint reached its strength in compression; value: the force
bearing.yielded     a bearing left its elastic range for the first time
bearing.failed      a bearing reached its limit, as that counts, and carries nothing more, or what it becomes does
bearing.changed     a bearing became what its `becomes` says
member.yielded      a member of a frame yielded at an end for the first time
member.failed       a member of a frame parted or lost its moment
member.removed      a member of a frame is gone, as its hinge says; value: the energy it held
contact.made        two bodies came to touch
contact.lost        two bodies parted
seat.lost           the end of a span left its seat; seat: which one
impact              two bodies hit each other faster than the model's limit; value: how fast they closed
body.rest           a body came to rest
body.left           a body left the bounds and is no longer part of the step
body.passed         a body was found in another; the run is not to be trusted from here
element.overstrained  an element went beyond the strain its law holds for
stage.diverged      a stage broke off; value: until when it may be trusted; text: why
stage.unsettled     a consolidation did not come to rest, or not near where it began; value: the unbalanced force left
body.added          a body came, new or back
body.removed        a body was taken away; value: how fast it was
bearing.added       a bearing came, new or back
bearing.removed     a bearing was taken away
integrator.changed  time is stepped by the other integrator from here; value: its step]],
}
