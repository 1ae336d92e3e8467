return {
  name = "study", title = "Studies: many cases of one model",
  { "trilith.study", "Runs many cases, each in a process of its own, and gives their table.", keys = [[
file        text         the table; folders of the cases stand beside it
script      text?        runs a case
case        function?    or a function of the parameters
parameters  table?       each value of one with each of the others
cases       list?        or these cases
samples     table?       or a sample of spreads, with count and seed
count       integer?     cases of the sample
seed        integer?     of the sample
histories   table?       figures from histories: last, max, min or largest
jobs        integer?     cases at a time]], gives = "table", unread = true },
}
