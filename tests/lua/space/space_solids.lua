-- Deformable bodies in space from scripts: built, loaded, shaken, recorded, and messages for wrong input.
local trilith = require "trilith"

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed*math.abs(expected), ("%.9g instead of %.9g"):format(value, expected))
end

local function model(name, law)
  local m = trilith.model { name = name, dim = 3 }
  m:material { name = "stone", density = 2000, E = 1e9, nu = 0.2, beta = 1e-4 }
  m:material { name = "hard", density = 2000 }
  m:contact { between = { "*", "*" }, law = law or trilith.frictional { kn = 2e9, ks = 1e9, mu = 0.6, beta = 1e-4 } }
  m:block { name = "ground", size = { 4, 4, 0.5 }, at = { -2, -2, -0.5 }, material = "hard", support = "fixed" }
  return m
end

-- three stacked blocks, of every element form: the stress in each equals the weight above over the area
do
  local m = model "stack"
  for i, form in ipairs { "brick", { mesh = { 2, 2, 2 } }, { mesh = { 1, 1, 1 }, element = "tet10" } } do
    m:block { name = "b" .. i, size = { 1, 1, 0.5 }, at = { 0, 0, 0.5*(i - 1) }, material = "stone", body = form }
  end
  assert(m:body "b1".kind == "brick" and m:body "b2".kind == "mesh" and m:body "ground".kind == "rigid")
  near(m:body "b3".mass, 1000, 1e-12)
  m:consolidate { rest = { ratio = 1e-4 } }
  local weight = 1000*9.80665
  for i = 1, 3 do near(m:body("b" .. i).szz, -(3.5 - i)*weight, 0.02) end
  assert(math.abs(m:body "b1".sxy) < 100 and m:body "b1".plastic == 0)
  local ok, why = pcall(function() return m:body "ground".szz end) -- 0 would look like a result
  assert(not ok and tostring(why):find("body 'ground' is of kind 'rigid' and has no stress", 1, true), why)
  m:point_load { name = "push", body = "b3", at = { 0.5, 0.5, 1.5 }, force = { 0, 0, -1e4 } }
  m:consolidate { rest = { ratio = 1e-4 } }
  near(m:body "b1".szz, -2.5*weight - 1e4, 0.02)
  assert(m:explain_dt():find("elements alone", 1, true) or m:explain_dt():find("governs", 1, true))
  m:close()
end

-- a wall of bricks that is shaken, with its results
do
  local m = model("wall", trilith.bonded { kn = 2e9, ks = 1e9, mu = 0.6, beta = 2e-4, tension = 1e5, cohesion = 1e5 })
  local wall = m:wall { name = "wall", length = 0.8, courses = 3, at = { 0, 0, 0 }, material = "stone", body = "brick" }
  assert(wall[1].kind == "brick")
  local path = os.tmpname() .. ".h5"
  m:results { file = path, frames = 0.01 }
  m:consolidate { rest = { ratio = 1e-2 } }
  m:drive { body = "ground", x = trilith.ramp { by = 0.01, duration = 0.05 } }
  m:run { duration = 0.05 }
  near(m:body "ground".ux, 0.01, 1e-6)
  assert(wall[#wall].ux > 0.002)
  m:close()
  os.remove(path)
end

-- longer steps by added mass that acts on deformation only
do
  local m = model "longer steps"
  m:block { name = "low", size = { 0.4, 0.4, 0.2 }, material = "stone", body = { mesh = { 2, 2, 2 } } }
  m:block { name = "top", size = { 0.4, 0.4, 0.2 }, at = { 0, 0, 0.2 }, material = "stone", body = "brick" }
  local path = os.tmpname() .. ".h5"
  m:results { file = path, frames = 0.01 }
  local plain = m:run { duration = 0.005, local_damping = 0.8 }
  -- The lone brick rotates with its own rotary inertia, on which contacts are three times as stiff as on its nodes.
  local step = 3.5*plain.longest_dt
  assert(plain.mass_scaling == nil)
  local report = m:run { name = "longer", duration = 0.01, local_damping = 0.8, mass_scaling = { step = step } }
  local scaled = report.mass_scaling
  assert(report.longest_dt == step and scaled.before < 1.1*plain.longest_dt and scaled.bodies == 2)
  assert(scaled.share > 0 and scaled.most < 30 and scaled.energy < scaled.kinetic)
  assert(m:run { duration = 0.005, local_damping = 0.8 }.longest_dt < 1.1*plain.longest_dt)
  refused("body 'top' (brick), whose masses are not scaled", m.run, m,
    { duration = 0.01, mass_scaling = { step = step, bodies = "low" } })
  refused("even if it were rigid", m.run, m, { duration = 0.01, mass_scaling = { step = 0.01 } })
  m:close()
  os.remove(path)
end

-- a mesh of a file
do
  local path = os.tmpname()
  local file = assert(io.open(path, "w"))
  file:write [[
$MeshFormat
4.1 0 8
$EndMeshFormat
$Nodes
1 5 1 5
3 1 0 5
1
2
3
4
5
0 0 0
1 0 0
0 1 0
0 0 1
1 1 1
$EndNodes
$Elements
2 3 1 3
2 1 2 1
1 1 2 3
3 1 4 2
2 1 2 3 4
3 2 3 4 5
$EndElements
]]
  file:close()
  local m = model "mesh"
  local b = m:body { name = "b", mesh = { file = path }, material = "stone", floating = true }
  near(b.mass, 2000*(1/6 + 1/3), 1e-9)
  m:close()
  os.remove(path)
end

-- wrong input
do
  local m = model "wrong"
  local size = { 1, 1, 1 }
  refused("'body' is 'quad', must be \"rigid\", \"brick\" or { mesh = {nx, ny, nz} }",
          function() m:block { name = "b", size = size, material = "stone", body = "quad" } end)
  refused("three whole numbers {nx, ny, nz}", function()
    m:block { name = "b", size = size, material = "stone", body = { mesh = { 2, 2 } } } end)
  refused("it deforms, so it needs a material with a stiffness (E, nu); 'hard' has none",
          function() m:block { name = "b", size = size, material = "hard", body = "brick" } end)
  refused("leave it rigid, or give it a mesh", function()
    m:prism { name = "b", radius = 1, height = 1, material = "stone", body = "brick" } end)
  refused("spheres do not deform", function()
    m:sphere { name = "b", radius = 1, material = "stone", body = "brick" } end)
  refused("hold is for nodes of deformable bodies", function()
    m:block { name = "b", size = size, material = "stone", hold = { { from = size, to = size } } } end)
  refused("element 1 of the mesh (tetrahedron) is flat", function()
    m:body { name = "b", material = "stone", mesh = { nodes = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } },
                                                      elements = { { 1, 2, 3, 4 } } } } end)
  refused("must be a list of four, six, eight or ten numbers of nodes", function()
    m:body { name = "b", material = "stone", mesh = { nodes = { { 0, 0, 0 } }, elements = { { 1, 2, 3 } } } } end)
  m:block { name = "soft", size = size, material = "stone", body = "brick", at = { 0, 0, 0 } }
  refused("give 'at', the point where the force that follows acts", function()
    m:point_load { name = "p", body = "soft", force = { 1, 0, 0 }, follow = true }
  end)
  m:close()
end

-- Tetrahedra flush with bricks also touch them by edges, and rounding may create a tiny penetration: nothing has
-- passed.
for _, element in ipairs { "tet4", "tet10" } do
  local m = trilith.model { name = "flush", dim = 3 }
  m:material { name = "stone", density = 2000, E = 5e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-5 } }
  m:block { name = "lower", size = { 0.4, 0.4, 0.2 }, material = "stone", support = "fixed",
            body = { mesh = { 2, 2, 2 } } }
  m:block { name = "upper", size = { 0.4, 0.4, 0.2 }, at = { 0, 0, 0.2 }, material = "stone",
            body = { mesh = { 2, 2, 1 }, element = element } }
  m:on("body.passed", function(e) error(e.text) end)
  m:run { duration = 0.002 }
  m:close()
end
