-- A motion that ends with a velocity stops its body within one step, and a note reports this. Cases: drive and shake,
-- along and about axes, samples and constant velocity, in the plane and in space. A motion that ends at rest gives no
-- note.
local trilith = require "trilith"

local function table_of(dim)
  local m = trilith.model { name = "end", dim = dim }
  m:material { name = "s", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e7, ks = 1e7, mu = 0.2, beta = 1e-4 } }
  local base = dim == 2
    and m:block { name = "base", width = 4, height = 1, at = { -2, -1 }, material = "s", support = "fixed" }
    or m:block { name = "base", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "s", support = "fixed" }
  return m, base
end

local function pushed(a, n) local out = {} for i = 1, n do out[i] = a end return out end
local fast = trilith.motion { acceleration = pushed(4.9, 301), dt = 1e-3, allow_drift = true, name = "fast" }
local back = { 0, 2, 2, 2, 0, -2, -2, -2, 0 }
local motions = {
  { fast, 1.47 }, { trilith.motion { velocity = 0.5, duration = 0.3 }, 0.5 },
  { trilith.ramp { by = 0.1, duration = 0.3 } }, { trilith.motion { acceleration = back, dt = 0.03, name = "back" } } }

for _, dim in ipairs { 2, 3 } do
  for _, stage in ipairs { "drive", "shake" } do
    for _, along in ipairs(dim == 2 and { "x", "y", "rotation" } or { "x", "z", "rotation_z" }) do
      for _, case in ipairs(motions) do
        local m, base = table_of(dim)
        m[stage](m, { body = base, [along] = case[1] })
        if stage == "drive" then m:run { duration = 0.35 } end
        local said = table.concat(m.notes, "; ")
        local found = said:find(stage .. ": motion '", 1, true) and said:find("stops there along " .. along, 1, true)
        if case[2] then
          assert(found and said:find(("ends at %.3g "):format(case[2]), 1, true), said)
        else
          assert(not found, said)
        end
        if stage == "drive" and along == "x" then assert(math.abs(base.vx) < 1e-9, base.vx) end
        m:close()
      end
    end
  end
end
