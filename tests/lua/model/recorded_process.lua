-- A process without mechanics is recorded: bodies stay, and water has its head, in the plane and in space.
local trilith = require "trilith"

for _, dim in ipairs { 2, 3 } do
  local file = os.tmpname()
  os.remove(file)
  local m = trilith.model { name = "recorded", dim = dim }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e11, mu = 0.75, beta = 1e-4 } }
  local wide = dim == 3 and 1 or nil
  local function block(name, length, height, x, z, support)
    local t = { name = name, material = "stone", support = support }
    if wide then
      t.size, t.at = { length, wide, height }, { x, 0, z }
    else
      t.width, t.height, t.at = length, height, { x, z }
    end
    m:block(t)
  end
  block("rock", 12, 2, -2, -2, "fixed")
  block("dam", 8, 12, 0, 0)
  m:seepage { name = "joint", upper = "dam", lower = "rock", aperture = 3e-4, divisions = 8, from = "heel", to = "toe" }
  m:seepage_head { node = "heel", head = 8 }
  m:seepage_head { node = "toe", head = 0 }
  m:results { file = file .. ".h5", frames = 1 }
  m:consolidate { integrator = "static" }
  local before = m:body("dam")[dim == 3 and "uz" or "uy"]
  m:process { duration = 1e4, step = 5e3, mechanics = false }
  assert(m:body("dam")[dim == 3 and "uz" or "uy"] == before)
  local head = m:seepage_state("joint").head
  for i = 2, #head do assert(head[i] < head[i - 1]) end
  m:run { duration = 1e-3 }
  m:close()
  os.remove(file .. ".h5")
end
