-- No body passes through another one without a report. A block that falls on a fixed plate lies on it at the end, for
-- any plate, height, integrator and longest step. Laws too soft to hold a body: see sinking.lua.
local trilith = require "trilith"

-- A body of 0.1 m falls from `height` on a plate of `thick`.
local function fall(dim, form, thick, height, options)
  local m = trilith.model { name = "fall", dim = dim }
  m:material { name = "stone", density = 2400, E = 1e8, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-4 } }
  local plane = dim == 2
  local plate = { name = "plate", material = "stone", support = "fixed" }
  local fallen = { name = "fallen", material = "stone", floating = true }
  if plane then
    plate.width, plate.height, plate.at = 4, thick, { -2, -thick }
    fallen.width, fallen.height, fallen.at = 0.1, 0.1, { -0.05, height }
  else
    plate.size, plate.at = { 4, 4, thick }, { -2, -2, -thick }
    if form == "sphere" then fallen.radius, fallen.at = 0.05, { 0, 0, height + 0.05 }
    else fallen.size, fallen.at = { 0.1, 0.1, 0.1 }, { -0.05, -0.05, height } end
  end
  if form == "mesh" then fallen.body = { mesh = plane and { 2, 2 } or { 1, 1, 1 } } end
  if form == "tilted" then
    if plane then fallen.angle = 0.3 else fallen.turn = { axis = { 1, 0.4, 0 }, angle = 0.3 } end
  end
  m:block(plate)
  if form == "later" then m:run { duration = 0.01, integrator = options.integrator } end
  local body = form == "sphere" and m:sphere(fallen) or m:block(fallen)
  local told = 0
  m:on("body.passed", function() told = told + 1 end)
  options.duration = 0.9
  local result = m:run(options)
  local at = plane and body.y or body.z
  local what = ("%dD %s %s plate %g m height %g m dt %s: ends at %g m, told %d, sound %s, %s"):format(dim, form,
    options.integrator, thick, height, options.dt, at, told, m.verdict.sound, result.ending)
  assert(result.ending == "time" and m.verdict.sound and told == 0 and at > 0.04 and at < 0.2 + height, what)
  m:close()
end

for _, dim in ipairs { 2, 3 } do
  for _, thick in ipairs { 0.01, 0.1, 0.5 } do
    for _, height in ipairs { 0.02, 0.2, 2 } do
      for _, dt in ipairs { 0.05, 0.3, 2 } do
        fall(dim, "block", thick, height, { integrator = "implicit", dt = dt })
      end
      fall(dim, "block", thick, height, { integrator = "explicit" })
      fall(dim, "block", thick, height, { integrator = "auto", dt = 0.3 })
    end
  end
  for _, form in ipairs { dim == 3 and "sphere" or "later", "tilted", "later", "mesh" } do
    fall(dim, form, 0.1, 0.2, { integrator = "implicit", dt = 0.3 })
    fall(dim, form, 0.1, 0.2, { integrator = "auto", dt = 0.3 })
  end
end
