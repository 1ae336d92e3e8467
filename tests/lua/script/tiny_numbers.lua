-- Numbers so small that their products overflow or underflow are rejected where they are declared, and runs with
-- numbers near this limit end in time, sound or not.
local trilith = require "trilith"

local function refused(what, f, ...)
  local good, why = pcall(f, ...)
  assert(not good and tostring(why):find("too small for any quantity", 1, true) and tostring(why):find(what, 1, true),
    ("%s: %s"):format(what, tostring(why)))
end

-- A cantilever in space on a hinge with an almost zero moment in one sense.
local function hinged(hogging)
  local m = trilith.model { name = "hinged", dim = 3 }
  m:material { name = "soft", density = 2000, E = 1e8, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5 } }
  m:beam { name = "B", from = { 1, 0, 1 }, to = { 2, 0, 1 }, material = "soft", from_support = "fixed",
    section = trilith.rectangle_section { width = 0.2, depth = 0.3 },
    from_hinge = trilith.end_hinge { sagging = 1e4, hogging = hogging, across = 1e4 } }
  m:point_load { body = "B", force = { 0, 0, -1e5 } }
  return m
end

-- A block of almost zero mass next to a fixed one, under a load.
local function light(density)
  local m = trilith.model { name = "light", dim = 3 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-3 } }
  m:block { name = "base", size = { 6, 6, 0.5 }, at = { -3, -3, -0.5 }, material = "stone", support = "fixed" }
  m:block { name = "b", size = { 0.5, 0.5, 0.5 }, at = { 0, 0, 1 }, density = density, velocity = { 1, 0, 0 },
    spin = { 0.1, 0.1, 0.1 }, load = { 1, 1, 1 }, material = "stone", floating = true }
  return m
end

refused("hogging", hinged, 1e-308)
refused("density", light, 1e-310)
refused("kn", trilith.frictional, { kn = -1e-305 })

for _, density in ipairs { 1e-299, 1e-200 } do
  local m = light(density)
  assert(m:run { duration = 0.005 }.ending ~= "time", "it stays no number")
  m:close()
end
for _, hogging in ipairs { 0, 1e-3, 1e-100 } do
  local m = hinged(hogging)
  m:run { duration = 0.005 }
  m:close()
end
