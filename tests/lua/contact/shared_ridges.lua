-- A ridge or corner shared by several pieces of one body slides as on one convex piece: no braking without friction,
-- and Coulomb friction otherwise (docs/decisions/contact/0038-shared-edges.md).
local trilith = require "trilith"
local near = dofile "near_expected.lua"

local g <const> = 9.81

local function model_of(dim, mu, beta)
  local m = trilith.model { name = "ridges", dim = dim, gravity = g }
  m:material { name = "stone", density = 2000, E = 2e10, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = mu, beta = beta } }
  return m
end

-- Fixed ridges 2 m apart, of one kind: one polygon, a chevron of two pieces, two triangles of a mesh.
local function add_ridge(m, dim, kind, name, x)
  local solid = { { x - 0.3, -0.3 }, { x + 0.3, -0.3 }, { x, 0 } }
  if kind == "chevron" then solid = { { x - 0.3, -0.3 }, { x, -0.15 }, { x + 0.3, -0.3 }, { x, 0 } } end
  if kind == "triangles" then
    m:body { name = name, material = "stone", support = "fixed",
             mesh = { nodes = { { x - 0.3, -0.3 }, { x, -0.3 }, { x + 0.3, -0.3 }, { x, 0 } },
                      elements = { { 1, 2, 4 }, { 2, 3, 4 } } } }
  elseif dim == 2 then
    m:polygon { name = name, outline = solid, material = "stone", support = "fixed" }
  else
    m:extrusion { name = name, outline = solid, from = -0.5, depth = 1, material = "stone", support = "fixed" }
  end
end

local function slab(m, dim, height, speed)
  if dim == 2 then
    return m:block { name = "slab", width = 4, height = height, at = { -2, 0 }, material = "stone",
                     velocity = { speed, 0 } }
  end
  return m:block { name = "slab", size = { 4, 0.8, height }, at = { -2, -0.4, 0 }, material = "stone",
                   velocity = { speed, 0, 0 } }
end

-- Speed of the slab after 0.3 s. It leans slightly, so that its weight drives it.
local function speed_after(dim, kind, beta, integrator)
  local m = model_of(dim, 0, beta)
  for i, x in ipairs { -1, 1 } do add_ridge(m, dim, kind, "ridge" .. i, x) end
  local a = slab(m, dim, 0.3, 1)
  m:run { duration = 0.3, integrator = integrator }
  local speed = a.vx
  assert(m.energy.contact_damping >= -1e-9, kind)
  m:close()
  return speed
end

for _, case in ipairs {
  { 2, "chevron" }, { 2, "chevron", "implicit" }, { 2, "triangles" }, { 2, "triangles", "implicit" },
  { 3, "chevron" }, { 3, "chevron", "implicit" },
} do
  local dim, kind, integrator = table.unpack(case)
  near(("dim %d, %s, %s: speed after .3 s"):format(dim, kind, integrator or "explicit"),
    speed_after(dim, kind, 1e-3, integrator), speed_after(dim, "convex", 1e-3, integrator), 1e-5)
end

-- Pushed beyond the friction limit, and released: the deceleration is mu g.
for _, dim in ipairs { 2, 3 } do
  for _, mu in ipairs { 0.1, 0.6 } do
    local m = model_of(dim, mu, 0)
    for i, x in ipairs { -1, 1 } do add_ridge(m, dim, "chevron", "ridge" .. i, x) end
    local a = slab(m, dim, 0.1, 0)
    m:consolidate { rest = { ratio = 1e-7 }, duration = 4 }
    m:point_load { name = "push", body = a, at = "centroid",
                   force = dim == 2 and { 1.5*a.mass*g, 0 } or { 1.5*a.mass*g, 0, 0 } }
    m:run { duration = 0.1 }
    m:set_load { name = "push", factor = 0 }
    m:run { duration = 0.01 }
    local x, given_off = a.ux, m.energy.contact_friction
    m:run { duration = 0.04 }
    near(("dim %d, mu %g: lost over weight times way"):format(dim, mu),
      (m.energy.contact_friction - given_off)/(a.mass*g*(a.ux - x)), mu, 0.01)
    m:close()
  end
end

-- A slab on corners of cubes that stand on a corner each: rigid cubes, and cubes of six tetrahedra, several of which
-- share the corner.
local function speed_on_corners(body)
  local m = model_of(3, 0, 1e-3)
  for i, at in ipairs { { -1, -0.5 }, { 1, -0.5 }, { -1, 0.5 }, { 1, 0.5 } } do
    m:block { name = "cube" .. i, size = { 0.3, 0.3, 0.3 }, anchor = "centre",
              turn = { axis = { 1, -1, 0 }, angle = math.acos(1/math.sqrt(3)) },
              at = { at[1], at[2], -0.15*math.sqrt(3) }, material = "stone", support = "fixed", body = body }
  end
  local a = m:block { name = "slab", size = { 4, 1.6, 0.3 }, at = { -2, -0.8, 0 }, material = "stone",
                      velocity = { 1, 0, 0 } }
  m:run { duration = 0.3 }
  local speed = a.vx
  m:close()
  return speed
end

near("on four corners of tetrahedra: speed after .3 s", speed_on_corners { mesh = { 1, 1, 1 }, element = "tet4" },
  speed_on_corners(), 1e-5)

-- A corner slides over the joints of a floor of elements.
local m = model_of(2, 0, 1e-3)
m:block { name = "floor", width = 2, height = 0.1, at = { -0.5, -0.1 }, material = "stone", support = "fixed",
          body = { mesh = { 50, 2 } } }
local tilt = 0.3
local a = m:block { name = "a", width = 0.5, height = 0.3, anchor = "centre", angle = -tilt,
                    at = { 0, 0.25*math.sin(tilt) + 0.15*math.cos(tilt) }, material = "stone", velocity = { 2, 0 },
                    support = { rotation = "fixed" } }
m:run { duration = 0.3 }
near("a corner over 30 joints: speed after .3 s", a.vx, 2, 1e-5)
m:close()
