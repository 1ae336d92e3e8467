-- Bodies of which one or both have elements far thinner than the overlap. Sinking through is reported once, and the
-- verdict is unsound. The depth is about half of the thickness of the thinner body. For two meshes it is the depth at
-- which their outer elements lose contact. A body that stays above is not reported.
local trilith = require "trilith"

local function name_of(body) return type(body) == "table" and "mesh of " .. table.concat(body.mesh, " x ") or body end

-- The heavy square of 0.5 m falls on a base of the height `high`, with the law `kn`.
local function sink(dim, heavy_body, base_body, high, density, kn, integrator)
  local plane = dim == 2
  local m = trilith.model { name = "fine", dim = dim, thickness = plane and 1 or nil }
  m:material { name = "stone", density = 2400, E = 1e7, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 0.6, beta = 1e-3 } }
  local base = { name = "base", material = "stone", support = "fixed", body = base_body }
  local heavy = { name = "heavy", material = "stone", floating = true, body = heavy_body }
  if plane then
    base.width, base.height, base.at = 1, high, { -0.5, -high }
    heavy.width, heavy.height, heavy.at, heavy.mass = 0.5, 0.5, { -0.25, 0 }, density*0.25
  else
    base.size, base.at = { 1, 1, high }, { -0.5, -0.5, -high }
    heavy.size, heavy.at, heavy.mass = { 0.5, 0.5, 0.5 }, { -0.25, -0.25, 0 }, density*0.125
  end
  m:block(base)
  local b = m:block(heavy)
  local told, depth = 0, 0
  m:on("body.passed", function(e) told, depth = told + 1, e.value end)
  m:run { duration = density > 1e4 and 0.4 or 0.2, integrator = integrator }
  local at, text = (plane and b.y or b.z) - 0.25, m.verdict.text
  local case = ("%d dimensions, %s on %s of %g m, %s: told %d, %g m deep, at %g m: %s"):format(dim,
    name_of(heavy_body), name_of(base_body), high, integrator, told, depth, at, text)
  m:close()
  if os.getenv "TRILITH_SHOW" then return print(case) end
  if density > 1e4 then
    assert(told == 1 and text:find "heavy" and at < -high, case)
    if plane then assert(depth > 0.1*high and depth < 0.75*high, case) end
  else
    assert(told == 0 and at > -0.02, case)
  end
end

local function both(...)
  local dim, heavy, base, high, integrator = ...
  sink(dim, heavy, base, high, 2e5, 1e5, integrator)
  sink(dim, heavy, base, high, 2400, 1e7, integrator)
end

for _, integrator in ipairs { "explicit", "implicit", "auto" } do
  for _, high in ipairs { 0.5, 0.25 } do
    both(2, { mesh = { 8, 8 } }, { mesh = { 16, 8 } }, high, integrator)
    both(2, "rigid", { mesh = { 32, 16 } }, high, integrator)
    both(2, "quad", { mesh = { 32, 16 } }, high, integrator)
    both(2, { mesh = { 16, 16 } }, "rigid", high, integrator)
  end
  both(3, "rigid", { mesh = { 3, 3, 3 } }, 0.5, integrator)
  if integrator ~= "implicit" then both(3, { mesh = { 3, 3, 3 } }, "rigid", 0.5, integrator) end
end
both(3, { mesh = { 3, 3, 3 } }, { mesh = { 4, 4, 4 } }, 0.5, "explicit")

print "every assertion holds"
