return {
  name = "study", title = "Studies: many cases of one model",
  { "trilith.study", "Runs many cases, each in a process of its own, and gives their table.", keys = [[
file        text         the table; folders of the cases stand beside it
script      text?        runs a case
case        function?    or a function of the parameters, and of what before gave
before      function?    called once: the state it makes (a model at rest, say) every case goes on from, in a copy
parameters  table?       each value of one with each of the others
cases       list?        or these cases
samples     table?       or a sample of spreads, with count and seed
count       integer?     cases of the sample
seed        integer = 1  of the sample
histories   table?       figures from histories: names: largest absolute value; or name = last, max, min, largest
ida         table?       { over = parameter, stop = flag }: from its lowest value up, until the flag is true
jobs        integer = processors  cases at a time]], gives = "table", unread = true },
}
