return {
  name = "events", title = "Types of events, and the meaning of their value",
  events = [[
stage.begun         a stage began
stage.ended         a stage ended; text: the ending
bond.cracked        the bond of a joint opened on a part of its face; value: force of the bond at that time
bond.broken         the bond of a joint is lost; value: its last force; text: a couple or stress at which it broke
joint.crushed       a joint reached its compressive strength; value: force
bearing.yielded     a bearing left its elastic range for the first time
bearing.failed      a bearing reached a limit; it carries nothing more, or its successor takes over
bearing.changed     a bearing was replaced by its successor (`becomes`)
member.yielded      a member of a frame yielded at an end for the first time
member.failed       a member of a frame separated or lost its moment capacity
member.removed      a member of a frame was removed by its hinge; value: its energy
contact.made        two bodies came into contact
contact.lost        two bodies separated
seat.lost           the end of a span left its seat; seat: the seat
impact              two bodies collided faster than the model's impact_speed; value: closing speed
body.rest           a body came to rest
body.left           a body left the bounds and is no longer part of the model
body.passed         a body was found inside another; the run is not valid from here
element.overstrained  an element exceeded the strain limit of its material
stage.diverged      a stage was ended by divergence; value: last valid time; text: reason
stage.unsettled     a consolidation did not come to rest near its start; value: out-of-balance ratio
body.added          a body was added or returned
body.removed        a body was removed; value: its speed
bearing.added       a bearing was added or returned
bearing.removed     a bearing was removed
integrator.changed  the integrator changed; value: its time step]],
}
