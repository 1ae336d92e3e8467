-- The spread of the claims of the gallery, in copies of the wall, the bridge or the façade. Their joint stiffness,
-- damping and onset differ by small stated amounts, by points of an even sequence. A claim is certain where it
-- holds in all copies or in none, likely where it holds in at least 90 % or in at most 10 %, and not decided between.
-- Results: docs/gallery/wall.md, bridge.md, facade3d.md; the words: docs/guide/what_can_be_predicted.md.
local trilith = require "trilith"
local p = trilith.params {
  model = { "bridge", choices = { "wall", "bridge", "facade" }, "model of the gallery" },
  copies = { 16, "number of copies" }, out = { "out/spread_gallery.h5", "table of the study" },
  stiffness = { 0.1, "largest change of the joint stiffness, as a share" },
  damping = { 0.2, "largest change of the damping, as a share" },
  onset = { 0.01, unit = "s", "latest onset of the record" },
  duration = { 6, unit = "s", "duration of the shaking of the wall" }, body = { "rigid", "model of its units" },
  jobs = { 2, "copies at a time" } }

-- Points of a sequence that fills the range from 0 to 1 evenly (van der Corput 1935), for each property another base.
local function even(i, base)
  local value, share = 0, 1/base
  while i > 0 do
    value, share, i = value + share*(i % base), share/base, i//base
  end
  return value
end

local function happens(value) return value ~= nil and value == value end -- a figure that a copy lacks is not a number
local function time(name) return { name, unit = "s" } end
local function share(name) return { name, unit = "%", scale = 100 } end
local psi = trilith.units "psi"

-- Script, keys and reference values of stiffness and damping, further keys, figures, and claims on a row.
local models = {
  wall = { script = "wall.lua", stiffness = { "kn", 1e5*psi }, damping = { "damping", 1 },
    more = { duration = p.duration, body = p.body },
    figures = { time "first bond", time "half of all", share "broken 1", share "broken 2", share "broken 3",
      share "apart 1", share "apart 2", share "apart 3" },
    claims = {
      { "the top slab has fallen by a foot", function(r) return r.collapsed end },
      { "all bonds are broken", function(r) return math.min(r["broken 1"], r["broken 2"], r["broken 3"]) > 0.99 end },
      { "the top storey has the most joints apart",
        function(r) return r["apart 3"] > math.max(r["apart 1"], r["apart 2"]) end },
      { "more than half of the joints of the top storey are apart", function(r) return r["apart 3"] > 0.5 end },
      { "the lowest storey has the fewest joints apart",
        function(r) return r["apart 1"] < math.min(r["apart 2"], r["apart 3"]) end } } },
  facade = { script = "facade3d.lua", stiffness = { "kn", 5e8 }, damping = { "damping", 1 }, more = {},
    figures = { time "first bond", time "half of all", time "first stone", share "apart 1", share "apart 2",
      share "out of place front.s2", share "out of place front.s1", share "out of place left.s2",
      share "out of place right.s2" },
    claims = {
      { "a stone reaches the ground within 5.6 s", function(r) return happens(r["first stone"]) end },
      { "half of the upper façade is out of place", function(r) return r["out of place front.s2"] > 0.5 end },
      { "half of the lower façade is in place", function(r) return r["out of place front.s1"] < 0.5 end },
      { "the whole upper left wall is out of place", function(r) return r["out of place left.s2"] > 0.99 end },
      { "the whole upper right wall is out of place", function(r) return r["out of place right.s2"] > 0.99 end } } },
  bridge = { script = "bridge.lua", stiffness = { "stiffness", 1 }, damping = { "zeta", 0.15 }, more = {},
    figures = { { "ends that fail" }, { "ends that leave" } }, claims = {} },
}
local bridge = models.bridge
for i = 1, 7 do
  for _, side in ipairs { "left", "right" } do
    for word, text in pairs { fails = "the bearing %s fails", leaves = "the end %s leaves its seat" } do
      local name = ("S%d.%s"):format(i, side)
      local key = name .. " " .. word
      bridge.figures[#bridge.figures + 1] = time(key)
      bridge.claims[#bridge.claims + 1] = { text:format(name), function(r) return happens(r[key]) end }
    end
  end
end
table.sort(bridge.claims, function(a, b) return a[1] < b[1] end)

local model, cases = models[p.model], {}
local function near_one(size, i, base) return i == 0 and 1 or 1 + size*(2*even(i, base) - 1) end
for i = 0, p.copies - 1 do -- the first copy is the model of the gallery itself
  local c = { onset = i == 0 and 0 or p.onset*even(i, 5) }
  c[model.stiffness[1]] = model.stiffness[2]*near_one(p.stiffness, i, 2)
  c[model.damping[1]] = model.damping[2]*near_one(p.damping, i, 3)
  for key, value in pairs(model.more) do c[key] = value end
  cases[#cases + 1] = c
end
local study = trilith.study { file = p.out, script = model.script, cases = cases, jobs = p.jobs }

local rows = {}
for _, row in ipairs(study.rows) do
  if row.status == "finished" then rows[#rows + 1] = row end
end
print(("%d of %d copies finished"):format(#rows, p.copies))
for _, figure in ipairs(model.figures) do
  local low, high, count, scale = math.huge, -math.huge, 0, figure.scale or 1
  for _, row in ipairs(rows) do
    local value = row[figure[1]]
    if happens(value) then low, high, count = math.min(low, value), math.max(high, value), count + 1 end
  end
  if count > 0 then
    print(("%-28s %7.2f to %7.2f %s in %d copies"):format(figure[1], scale*low, scale*high, figure.unit or "", count))
  end
end
for _, claim in ipairs(model.claims) do
  local holds = 0
  for _, row in ipairs(rows) do
    if claim[2](row) then holds = holds + 1 end
  end
  local part = holds/#rows
  local word = (part == 0 or part == 1) and "certain" or math.abs(part - 0.5) >= 0.4 and "likely" or "not decided"
  if holds > 0 or p.model ~= "bridge" then print(("%-60s %2d of %d: %s"):format(claim[1], holds, #rows, word)) end
end
