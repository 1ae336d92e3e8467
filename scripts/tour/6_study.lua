-- Restitution of a block over the damping ratio of its contact: the script of page 1, once for each value.
local trilith = require "trilith"

local study = trilith.study {
  file = "out/bounce_study.h5",
  script = "1_first_block.lua",
  parameters = { zeta = { 0.02, 0.05, 0.1, 0.2, 0.3, 0.5 } } }

for _, row in ipairs(study.rows) do
  print(("damping %.2f: restitution %.3f, formula %.3f"):format(row.zeta, row.restitution, row.formula))
end
