return {
  name = "study", title = "Studies: many cases of one model",
  { "trilith.study", "Runs many cases, each in its own process, and returns their table.",
    also = "fragility curve, incremental dynamic analysis, parameter study, Monte Carlo, Latin hypercube, sensitivity",
    keys = [[
file        text         file of the table; the folders of the cases are next to it
script      text?        script that runs a case; or case
case        function?    function of the parameters, and of the result of `before`
before      function?    called once: every case starts from a copy of the state it makes, such as a model at rest
parameters  table?       lists of values; all combinations are run
cases       list?        or a list of cases
samples     table?       or distributions, with count and seed
count       integer?     number of sampled cases  <at least 1>
seed        integer = 1  seed of the samples
histories   table?       figures from histories: names: largest absolute value; or name = last, max, min, largest
ida         table?       { over = parameter, stop = flag }: from its lowest value up, until the flag is true
jobs        integer = processors  number of cases at a time  <at least 1>]], gives = "table", unread = true,
    example = "local study = trilith.study {\n"
      .. '  file = "out/manual_study.h5", parameters = { mu = { 0.2, 0.4 }, pga = { 1, 2 } },\n'
      .. "  case = function(p) return { slides = p.pga > p.mu*9.81 } end }\n"
      .. "for _, row in ipairs(study.rows) do print(row.mu, row.pga, row.slides) end" },
}
