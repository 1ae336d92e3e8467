-- How well can the seven-span bridge reproduce the chain of events in its source, over all data that the source
-- leaves open? A Latin hypercube of 500 runs of bridge_chain.lua, with both signs and three versions of the record.
-- Each run is scored by nine links of the chain and by its deviation in time. The study prints the distribution of
-- scores and the best runs. `trilith study scripts/bridge_search.lua -j 1` takes about three quarters of an hour on
-- one core; a stopped study continues.
local trilith = require "trilith"
local p = trilith.params { out = { "out/bridge_search.h5", "table of the study" }, count = { 500, "number of runs" },
                           seed = { 1, "seed of the samples" } }
local study = trilith.study {
  file = p.out, script = "bridge_chain.lua", count = p.count, seed = p.seed,
  samples = {
    side = { uniform = { -1, 1 } }, version = { uniform = { 0, 3 } },
    deck = { uniform = { 3, 9 }, unit = "kip/ft" }, stem = { uniform = { 4, 16 }, unit = "kip/ft" },
    stem_stiffness = { log_uniform = { 0.02, 3 } }, soil = { log_uniform = { 3e9, 3e11 }, unit = "N m/rad" },
    gap = { uniform = { 0.25, 6 }, unit = "inch" }, mu = { uniform = { 0.02, 0.4 } },
    shear = { log_uniform = { 5, 200 }, unit = "kip/inch" }, core = { uniform = { -0.25, 0.25 } },
    zeta = { uniform = { 0.03, 0.2 } }, damping = { uniform = { 0, 0.3 }, unit = "1/s" } } }

local names = { "first", "first_when", "end_of_3", "end_when", "strikes", "two_leftmost", "span_1", "span_1_when",
                "others_stand" }
local rows, firsts, scores, holds = {}, {}, {}, {}
for _, row in ipairs(study.rows) do
  if row.status == "finished" then
    rows[#rows + 1] = row
    local first = row.chain:match "(S%d%.%a+) fails" or "none"
    firsts[first] = (firsts[first] or 0) + 1
    scores[row.score] = (scores[row.score] or 0) + 1
    for _, name in ipairs(names) do holds[name] = (holds[name] or 0) + (row[name] and 1 or 0) end
  end
end
print(("%d of %d runs finished"):format(#rows, #study.rows))
print "runs by number of links of the chain that hold:"
for score = 0, 9 do print(("  %d links: %d"):format(score, scores[score] or 0)) end
print "runs in which each link holds:"
for _, name in ipairs(names) do print(("  %-12s %d"):format(name, holds[name] or 0)) end
print "runs by the bearing that fails first:"
local order = {}
for name in pairs(firsts) do order[#order + 1] = name end
table.sort(order)
for _, name in ipairs(order) do print(("  %-8s %d"):format(name, firsts[name])) end
table.sort(rows, function(a, b)
  if a.score ~= b.score then return a.score > b.score end
  return a.off < b.off
end)
print "the nearest runs:"
for k = 1, math.min(8, #rows) do
  local row = rows[k]
  print(("  %d links, time error %.1f s: %s"):format(row.score, row.off, row.chain))
  print(("    side=%.3g version=%.3g deck=%.3g stem=%.3g stem_stiffness=%.3g soil=%.3g gap=%.3g mu=%.3g shear=%.3g "
    .. "core=%.3g zeta=%.3g damping=%.3g"):format(row.side, row.version, row.deck, row.stem, row.stem_stiffness,
      row.soil, row.gap, row.mu, row.shear, row.core, row.zeta, row.damping))
end
