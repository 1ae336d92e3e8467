-- Bodies that meet in the air at high speed, and a driven ram, do not pass through each other without a report. They
-- are thin plates, meshes and spheres, in the plane and in space. Steps are long enough to pass in each integrator.
local trilith = require "trilith"

local function model(dim)
  local m = trilith.model { name = "meeting", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 2400, E = 1e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-4 } }
  return m
end
local function body(m, form, name, x, width, speed)
  local t = { name = name, material = "stone", floating = true }
  if m.dim == 2 then
    t.velocity, t.width, t.height, t.at = { speed, 0 }, width, 0.2, { x, 0 }
  else
    t.velocity, t.size, t.at = { speed, 0, 0 }, { width, 0.2, 0.2 }, { x, 0, 0 }
  end
  if form == "mesh" then t.body = { mesh = m.dim == 2 and { 1, 2 } or { 1, 2, 2 } } end
  if form == "ram" and name == "left" then t.support, t.velocity = "fixed", nil end
  if form ~= "sphere" then return m:block(t) end
  t.size, t.radius, t.at = nil, width/2, { x + width/2, 0.1, 0.1 }
  return m:sphere(t)
end

for _, dim in ipairs { 2, 3 } do
  for _, form in ipairs { "plate", "mesh", "later", "ram", dim == 3 and "sphere" or nil } do
    for _, integrator in ipairs { "explicit", "implicit", "auto" } do
      for _, speed in ipairs { 5, 50 } do
        local m, width = model(dim), form == "mesh" and 0.1 or 0.04
        local left = body(m, form, "left", 0, width, speed)
        if form == "later" then m:run { duration = 1e-3, integrator = integrator } end
        local right = body(m, form, "right", 0.5, width, form == "ram" and 0 or -speed)
        if form == "ram" then m:drive { body = left, x = trilith.ramp { by = 0.05*2*speed, duration = 0.05 } } end
        local duration = form == "ram" and 0.05 or 0.5/speed
        local result = m:run { duration = duration, integrator = integrator,
          dt = integrator ~= "explicit" and duration or nil }
        local what = ("%dD %s %s at %g m/s: left at %g, right at %g m, %s"):format(dim, form, integrator, speed, left.x,
          right.x, result.ending)
        assert(left.x < right.x or not m.verdict.sound, what)
        assert(form == "ram" or math.abs(left.vx + right.vx) < 0.02*speed, what) -- the sum of the momenta stays zero
        m:close()
      end
    end
  end
end

print "every assertion holds"
