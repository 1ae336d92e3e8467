return {
  name = "tables", title = "Tables that calls give",
  tables = {
    report = [[
name         text      what the stage is called
ending       text      time, rest, unstable (at rest elsewhere), stopped, not at rest, diverged or all left
rests        flag      true where it ended at rest
reason       text      what went otherwise, in words
steps        integer   steps taken
begun        number s  when it began
ended        number s  when it ended
shortest_dt  number s  shortest step
longest_dt   number s  longest step
speed        number m/s  fastest point at the end
ratio        number    unbalanced force over the largest carried one
threads      integer   that shared a step at the end
thread_gain  number    how many times as fast as one these were; 0 where that was not timed
mass_scaling  table?  bodies, share of added mass, most of a body, before (its step, s), energy and kinetic (J)]],
    event = [[
type        text      such as "bearing.failed"
time        number s  when
id          integer   rising from 0
cause       integer?  id of the event that led to this one
step        integer   in which step
value       number    see value_name
value_name  text      what the value is
x           number m  where
y           number m  where
z           number m?  where, in space
mode        text?     of a joint: "tension", "shear" or "compression"
text        text      in words
bodies      list      the bodies concerned
body        body?     the first of them
bearing     bearing?  the bearing concerned
seat        seat?     the seat concerned]],
    findings = "text  text  all of it in words",
    part = [[
name     text    its name
outline  points  corners in order
groups   names   groups it belongs to]],
  },
}
