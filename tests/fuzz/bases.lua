-- Small results files of several kinds, for damage: `trilith run bases.lua kind=...`.
local trilith = require "trilith"
local p = trilith.params {
  kind = { "all", choices = { "all", "unfinished", "rigid", "wall", "diverged", "still" }, "which" } }
local m = trilith.model { name = p.kind }
m:material { name = "stone", density = 2400, E = 1e8, nu = 0.2 }
local bonded = trilith.bonded { kn = 1e9, ks = 4e8, mu = 0.6, cohesion = 1e5, tension = 5e4, beta = 1e-3 }
local dry = trilith.frictional { name = "dry", kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-3 }
m:contact { between = { "*", "*" }, law = p.kind == "wall" and bonded or dry }
m:block { name = "base", width = 6, height = 0.5, at = { -3, -0.5 }, material = "stone", support = "fixed",
  body = "rigid" }
if p.kind == "wall" then
  m:wall { name = "wall", at = { -1, 0 }, units = 2, courses = 2, storeys = 2, unit_length = 0.6, unit_height = 0.3,
    material = "stone", body = "rigid" }
else
  local low = m:block { name = "low", width = 1, height = 0.5, at = { -0.5, 0.05 }, material = "stone", groups = "pile",
    floating = true, body = "rigid" }
  local high = m:block { name = "high", width = 1, height = 0.5, at = { -0.5, 0.6 }, material = "stone",
    groups = "pile", floating = true, body = p.kind ~= "rigid" and { mesh = { 2, 1 } } or "rigid" }
  m:history { name = "top", body = high, what = "y" }
  if p.kind ~= "rigid" then
    m:bearing { name = "link", between = { "base", "low" }, at = { 0, 0 },
      along = trilith.linear { stiffness = 1e6, damping = 1e3 }, limit = { along = 0.01 } }
    m:seat { name = "rest", body = low, support = "base", at_end = { -0.5, 0 }, edge = { 3, 0 }, inward = { -1, 0 } }
    m:drive { body = "base", x = trilith.ramp { by = 0.05, duration = 0.2 } }
  end
  if p.kind == "diverged" then m:point_load { body = high, at = "centroid", force = { 1e12, -1e12 } } end
end
m:results { file = p.kind .. ".h5", frames = 0.02, velocities = p.kind == "all", joints = p.kind ~= "rigid" }
pcall(m.run, m, { duration = p.kind == "still" and 1e-4 or 0.2 })
if p.kind == "unfinished" then os.exit(1) end
