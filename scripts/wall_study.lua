-- Does stronger mortar save the wall? The study runs scripts/wall.lua over tensile strength, with eight copies each.
-- Each copy moves the head joints by a micrometre at random. Differences among copies are chance; an effect of the
-- strength must be larger. `trilith study scripts/wall_study.lua` runs unfinished cases;
-- `trilith plot TABLE --over tension` plots the table.
local trilith = require "trilith"
local p = trilith.params {
  out = { "out/wall_study.h5", "table of the study" }, copies = { 8, "copies of each strength" },
  duration = { 12, unit = "s", "duration of the shaking" }, body = { "quad", "model of a unit" } }
local copies = {}
for k = 1, p.copies do copies[k] = k end

local study = trilith.study {
  file = p.out, script = "wall.lua",
  parameters = { tension = { 0, 100, 400, 1600, unit = "psf" }, seed = copies, jitter = { 1e-6, unit = "m" },
                 duration = { p.duration, unit = "s" }, body = { p.body } } }

local by = {}
for _, row in ipairs(study.rows) do
  if row.status == "finished" then
    local sum = by[row.tension] or { n = 0, down = 0, apart = { 0, 0, 0 } }
    by[row.tension], sum.n, sum.down = sum, sum.n + 1, sum.down + (row.collapsed and 1 or 0)
    for k = 1, 3 do sum.apart[k] = sum.apart[k] + row["apart " .. k] end
  end
end
for _, tension in ipairs { 0, 100, 400, 1600 } do
  local sum = by[tension]
  if sum then
    print(("tension %4d psf: %d of %d collapsed; joints apart %2.0f, %2.0f, %2.0f %% in storeys 1, 2, 3"):format(
      tension, sum.down, sum.n, 100*sum.apart[1]/sum.n, 100*sum.apart[2]/sum.n, 100*sum.apart[3]/sum.n))
  end
end
