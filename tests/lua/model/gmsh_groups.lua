-- m:gmsh: physical groups of a mesh as bodies and groups, versions 2.2 and 4.1, in the plane and in space.
local trilith = require "trilith"
local near_expected = dofile "near_expected.lua"

local function near(value, expected, share) near_expected("gmsh", value, expected, share) end

local function plane(name)
  local m = trilith.model { name = name or "plane", thickness = 0.5 }
  m:material { name = "stone", density = 2000, E = 1e9, nu = 0.2 }
  m:material { name = "heavy", density = 3000, E = 1e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  return m
end

-- Version 2.2: a group of two parts gives two bodies; areas 2, 1/2 and 1 at thickness 0.5.
local m = plane()
local bodies = m:gmsh { file = "gmsh/plane_2_2.msh", material = "stone", body = "rigid", fixed = "pier",
  groups = "mesh", by_group = { loose_stone = { material = "heavy", floating = true } } }
assert(#bodies == 3 and m:body("pier").kind == "rigid")
near(m:body("pier").mass, 2*0.5*2000, 1e-12)
near(m:body("loose_stone.1").mass, 0.5*0.5*3000, 1e-12)
near(m:body("loose_stone.2").mass, 1*0.5*3000, 1e-12)
assert(#m:bodies { group = "loose_stone" } == 2 and #m:bodies { group = "mesh" } == 3)
local plane_notes = m.notes
local before = m:body("loose_stone.2").y
m:run { duration = 0.1 }
assert(m:body("pier").uy == 0)
near(m:body("loose_stone.2").y - before, -0.5*9.80665*0.1^2, 2e-2) -- a free fall

-- Version 4.1: bodies of elements that share an edge in the file touch as bodies, and the weight reaches the support.
m = plane "touching"
bodies = m:gmsh { file = "gmsh/plane_4_1.msh", name = "wall", scale = 0.5, material = "stone" }
near(bodies[1].mass, 0.25*0.5*2000, 1e-12)
near(bodies[2].mass, 0.25*0.5*2000, 1e-12)
assert(bodies[1].name == "wall.left" and bodies[1].kind == "quad")

-- One surface whose halves were not merged becomes two bodies, with a note; the loose stones above are apart.
local cut = plane "cut"
assert(#cut:gmsh { file = "gmsh/doubled_2_2.msh", material = "stone" } == 2)
assert(#cut.notes == 1 and cut.notes[1]:find "gmsh: group 'wall' becomes 2 bodies, which touch but share no node",
  table.concat(cut.notes, "; "))
for _, note in ipairs(plane_notes) do assert(not note:find "share no node", note) end

-- In space, as rigid bodies: the lower cube carries the upper one.
local box = trilith.model { name = "cubes", dim = 3 }
box:material { name = "stone", density = 2000 }
box:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.6, beta = 1e-3 } }
bodies = box:gmsh { file = "gmsh/space_4_1.msh", material = "stone", body = "rigid", fixed = "lower" }
assert(#bodies == 2 and bodies[2].name == "upper")
near(box:body("upper").mass, 2000, 1e-12)
near(box:body("upper").z, 1.5, 1e-12)
box:consolidate { rest = { ratio = 1e-5 } }
near(box:body("lower").reaction_z, 2*2000*9.80665, 1e-4)

local function refused(options, pattern)
  local good, message = pcall(m.gmsh, m, options)
  assert(not good and message:find(pattern, 1, true), tostring(message))
end
refused({ file = "gmsh/overlap_2_2.msh" }, "groups pier and loose_stone; a body has one")
refused({ file = "gmsh/unnamed_2_2.msh" }, "the physical group 2, of surface 2, has no name")
refused({ file = "gmsh/no_group_2_2.msh" }, "surface 3 is in no physical group")
refused({ file = "gmsh/none.msh" }, "cannot read 'gmsh/none.msh'")
refused({ file = "gmsh/plane_2_2.msh", fixed = "peer" }, "'peer', which is not a physical group; did you mean 'pier'")
refused({ file = "gmsh/plane_2_2.msh", fixd = "pier" }, "unknown key 'fixd'")
refused({ file = "dxf/facade.dxf" }, "does not begin with $MeshFormat")
refused({}, "'file' is missing")
local good, message = pcall(box.gmsh, box, { file = "gmsh/plane_2_2.msh" })
assert(not good and message:find "no physical group of volumes has a name", tostring(message))
good, message = pcall(box.gmsh, box, { file = "gmsh/overlap_4_1.msh" })
assert(not good and message:find "volume 2 is in the physical groups upper and lower", tostring(message))
