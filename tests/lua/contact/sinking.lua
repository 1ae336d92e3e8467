-- A law too soft to hold a body: sinking through is reported once, and the verdict is unsound. Bodies of exactly equal
-- thickness are included.
local trilith = require "trilith"

local function sink(dim, form, thick, high, wide, integrator)
  local m = trilith.model { name = "sink", dim = dim }
  m:material { name = "stone", density = 2400, E = 1e9, nu = 0.2 }
  local meshed = form == "mesh" or form == "meshes"
  m:contact { between = { "*", "*" },
    law = trilith.frictional { kn = meshed and 1e5 or 1e7, ks = 5e4, mu = 0.6, beta = 1e-3 } }
  local plane = dim == 2
  local base = { name = "base", material = "stone", support = "fixed" }
  local heavy = { name = "heavy", material = "stone", floating = true, mass = not meshed and 1e9 or nil,
    density = meshed and 2e4 or nil }
  if plane then
    base.width, base.height, base.at = 4, thick, { -2, -thick }
    heavy.width, heavy.height, heavy.at = wide, high, { -wide/2, 0 }
  else
    base.size, base.at = { 4, 4, thick }, { -2, -2, -thick }
    if form == "sphere" then heavy.radius, heavy.at = high/2, { 0, 0, high/2 }
    else heavy.size, heavy.at = { wide, wide, high }, { -wide/2, -wide/2, 0 } end
  end
  if meshed then heavy.body = { mesh = plane and { 2, 2 } or { 2, 2, 2 } } end
  if form == "meshes" then base.body = { mesh = plane and { 8, 3 } or { 4, 4, 2 } } end
  if form == "tilted" then
    if plane then heavy.angle, heavy.at[2] = 0.5, high
    else heavy.turn, heavy.at[3] = { axis = { 1, 0.6, 0.2 }, angle = 0.5 }, high end
  end
  m:block(base)
  if form == "later" then m:run { duration = 0.01, integrator = integrator } end
  local body = form == "sphere" and m:sphere(heavy) or m:block(heavy)
  local told = 0
  m:on("body.passed", function(e)
    told = told + 1
    assert(e.value > 0.4*math.min(thick, high, wide) or meshed, e.value)
  end)
  local result = m:run { duration = 0.8, integrator = integrator }
  local at = plane and body.y or body.z
  assert(result.ending ~= "time" or at < -thick, ("%s does not sink: %g m"):format(form, at))
  assert(told == 1 and not m.verdict.sound, ("%dD %s %s %g on %g: told %d, sound %s, at %g m, %s"):format(dim, form,
    integrator, high, thick, told, m.verdict.sound, at, result.ending))
  m:close()
end

for _, dim in ipairs { 2, 3 } do
  for _, integrator in ipairs { "explicit", "implicit", "auto" } do
    for _, form in ipairs { "block", dim == 3 and "sphere" or "block", "tilted", "later", "mesh", "meshes" } do
      for _, size in ipairs { { 0.5, 0.5, 0.5 }, { 1, 1, 1 }, { 0.5, 0.499999, 0.5 }, { 0.25, 0.5, 0.5 } } do
        sink(dim, form, size[1], size[2], size[3], integrator)
      end
    end
  end
end

print "every assertion holds"
