-- Beams and frames in space from scripts: built, loaded, read, recorded, and messages for wrong input.
local trilith = require "trilith"

local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed*math.abs(expected), ("%.9g instead of %.9g"):format(value, expected))
end

local E, nu = 30e9, 0.2
local function model(name, threads)
  local m = trilith.model { name = name, dim = 3, threads = threads }
  m:material { name = "concrete", density = 2400, E = E, nu = nu }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5, beta = 1e-4 } }
  return m
end
local section = trilith.rectangle_section { width = 0.3, depth = 0.5 }

-- a cantilever under its weight, oblique in plan: w L^4 / (8 E I) at the tip; its depth is upright by default
do
  local m = model "cantilever"
  local arm = m:beam { name = "arm", from = { 0, 0, 0 }, to = { 2.4, 3.2, 0 }, section = section, material = "concrete",
                       from_support = "fixed" }
  assert(arm.kind == "frame")
  near(arm.mass, 2400*0.15*4, 1e-12)
  refused("nothing has run yet", arm.forces, arm)
  m:consolidate { rest = { ratio = 1e-6 } }
  local w = 2400*0.15*9.80665
  local x, y, z = arm:point { 2.4, 3.2, 0 }
  near(-z, w*4^4/(8*E*section.inertia), 0.02)
  near(x, 2.4, 1e-3)
  near(y, 3.2, 1e-3)
  local _, _, tip = arm:point "to"
  assert(tip == z)
  local rows = arm:forces()
  assert(#rows == 16)
  near(rows[1].moment_z, -w*16/2, 0.02)
  near(rows[1].shear_y, w*4, 0.1) -- half of the first element's weight is carried by the support directly
  near(rows[#rows].along, 4, 1e-12)
  assert(math.abs(rows[1].moment_y) < 1e-3*w and math.abs(rows[1].torque) < 1e-3*w)
  refused("point: takes {x, y, z} or the name of a joint; this is 3", arm.point, arm, 3)
  refused("has no joint 'top'", arm.point, arm, "top")
  m:close()
end

-- on its side it is softer; under a torque at its end it rotates by T L / (G J)
do
  local m = model "flat"
  m:beam { name = "flat", from = { 0, 0, 0 }, to = { 4, 0, 0 }, section = section, material = "concrete",
           from_support = "fixed", orientation = { 0, 1, 0 } }
  m:beam { name = "shaft", from = { 0, 9, 0 }, to = { 4, 9, 0 }, section = trilith.circle_section { diameter = 0.4 },
           material = "concrete", from_support = "fixed" }
  m:point_load { body = "shaft", at = { 4, 9, 0 }, moment = { 2e4, 0, 0 } }
  m:consolidate { rest = { ratio = 1e-6 } }
  -- the same cantilever about its other axis: the shear of its weight has the sign that it has upright
  near((m:body "flat"):forces()[1].shear_z, 2400*0.15*9.80665*4, 0.1)
  local _, _, z = m:body "flat":point "to"
  near(-z, 2400*0.15*9.80665*4^4/(8*E*0.5*0.3^3/12), 0.02)
  local G, J = E/(2*(1 + nu)), math.pi/32*0.4^4
  local _, y, up = m:body "shaft":point { 4, 9.2, 0 }
  near(math.atan(up - select(3, m:body "shaft":point "to"), y - 9), 2e4*4/(G*J), 0.01)
  near(m:body "shaft":forces()[1].torque, 2e4, 0.01)
  m:close()
end

-- a bent of two columns and a cap on a moving ground; recorded, drawn and exported
do
  local m = model "bent"
  local joints = { a = { at = { 0, 0, 0 }, support = "fixed" }, b = { 0, 0, 4 }, c = { 0, 6, 4 },
                   d = { at = { 0, 6, 0 }, support = "fixed", mass = 10 } }
  local members = { { name = "left", from = "a", to = "b", section = section, divisions = 4 },
                    { name = "cap", from = "b", to = "c", section = section, divisions = 4 },
                    { name = "right", from = "c", to = "d", section = section, divisions = 4 } }
  local bent = m:frame { name = "bent", joints = joints, members = members, material = "concrete" }
  near(bent.mass, 2400*0.15*14 + 10, 1e-12)
  m:block { name = "slab", size = { 0.6, 3, 0.2 }, at = { -0.3, 1.5, 4.25 }, material = "stone" }
  local file = os.tmpname() .. ".h5"
  m:results { file = file, frames = 0.02 }
  m:consolidate { rest = { ratio = 1e-4 } }
  local weight = (bent.mass - 10 + m:body "slab".mass)*9.80665
  local stump = 2400*0.15*0.5*9.80665 -- half of the first element's weight is carried by the support directly
  near(bent:forces "left"[1].normal, stump - weight/2, 1e-3)
  near(bent:forces "left"[1].normal, bent:forces "right"[8].normal, 0.01)
  m:shake { body = "bent", x = trilith.ramp { by = 0.01, duration = 0.2 }, duration = 0.2 }
  local x = bent:point "a"
  near(x, 0.01, 1e-6)
  m:close()
  os.remove(file)
end

-- a member pinned at both ends sags five times as far as a clamped one; it is removed and added again
do
  local m = model "pinned"
  local function bar(name, y, pinned)
    return m:frame { name = name, material = "concrete",
      joints = { a = { at = { 0, y, 0 }, support = "fixed" }, b = { at = { 6, y, 0 }, support = "fixed" } },
      members = { { from = "a", to = "b", section = section, divisions = 16, pinned = pinned } } }
  end
  local pinned, held = bar("pinned", 0, { "from", "to" }), bar("held", 3)
  m:consolidate { rest = { ratio = 1e-6 } }
  local w = 2400*0.15*9.80665
  local function sag(body, y) return -select(3, body:point { 3, y, 0 }) end
  near(sag(pinned, 0), 5*w*6^4/(384*E*section.inertia), 0.01)
  near(sag(held, 3), w*6^4/(384*E*section.inertia), 0.01)
  m:remove "pinned"
  m:run { duration = 0.05 }
  assert(not pinned.present)
  m:put_back "pinned"
  m:run { duration = 0.05 }
  assert(pinned.present)
  m:fix(held, "xyzr")
  m:run { duration = 0.05 }
  assert(held.speed == 0)
  m:close()
end

-- the same bits for one thread and for two
do
  local function run(threads)
    local m = model("bits", threads)
    m:block { name = "ground", size = { 8, 4, 1 }, at = { -1, -2, -2 }, material = "stone", support = "fixed" }
    m:beam { name = "girder", from = { 0, 0, -0.3 }, to = { 5, 0.5, 0.4 }, section = section, material = "concrete",
             floating = true }
    m:run { duration = 0.3 }
    m:run { duration = 0.1 }
    local hash = m.hash
    m:close()
    return hash
  end
  assert(run(1) == run(2))
end

-- messages
local m = model "wrong"
local function beam(change)
  local t = { name = "b", from = { 0, 0, 0 }, to = { 1, 0, 0 }, section = section, material = "concrete" }
  for k, v in pairs(change) do t[k] = v end
  return function() return m:beam(t) end
end
refused("is 0 m long; its ends must lie apart", beam { to = { 0, 0, 0 } })
refused("its orientation (-2, 0, 0) is parallel to it", beam { orientation = { -2, 0, 0 } })
refused("without a torsion constant, which is needed in space; give it torsion",
  beam { section = trilith.section { area = 0.1, inertia = 1e-3, depth = 0.4 } })
refused("without a second moment across; give it inertia_across",
  beam { section = trilith.section { area = 0.1, inertia = 1e-3, depth = 0.4, torsion = 1e-3 } })
refused("without a profile; give it width",
  beam { section = trilith.section { area = 0.1, inertia = 1e-3, depth = 0.4, torsion = 1e-3, inertia_across = 1e-3 } })
refused("its members need a material with a stiffness (E, nu); 'stone' has none", beam { material = "stone" })
refused("there is no material 'ston' for its member", beam { material = "ston" })
refused("'to' is {1, 2}, must be {x, y, z}, three finite numbers", beam { to = { 1, 2 } })
refused("pinned at both ends; give it at least two divisions", beam { pinned = { "from", "to" }, divisions = 1 })
refused("unknown key 'oriented'", beam { oriented = 1 })
refused("in space it bends about both axes, and across is 0; give it the yield moment of lateral bending, such as "
  .. "across = 100000", beam { hinge = trilith.end_hinge { sagging = 1e5 } })
refused("end_hinge: its start is pinned already",
  beam { from_hinge = trilith.end_hinge { sagging = 1e5, across = 1e5 }, pinned = "from" })
refused("'contour' is 3", function() trilith.end_hinge { sagging = 1e5, contour = 3 } end)
refused("'mass_matrix' is 'heavy'", beam { mass_matrix = "heavy" })
refused("'to' is 'C', which is not a joint", function()
  m:frame { name = "f", joints = { A = { 0, 0, 0 }, B = { 0, 0, 1 } }, material = "concrete",
            members = { { from = "A", to = "C", section = section } } }
end)
refused("no member leads from joint 'A' to joint 'C'", function()
  m:frame { name = "f", joints = { A = { 0, 0, 0 }, B = { 0, 0, 1 }, C = { 1, 1, 1 } }, material = "concrete",
            members = { { from = "A", to = "B", section = section } } }
end)
refused("the body deforms; give 'at', the point where the force that follows acts", function()
  m:beam { name = "b", from = { 0, 0, 0 }, to = { 1, 0, 0 }, section = section, material = "concrete", floating = true }
  m:point_load { body = "b", force = { 0, 0, 1 }, follow = true }
end)

-- The head of a column is a face if the adjoining beams cover a part of it.
for _, at in ipairs { { 4.09, -0.09 }, { 3.9, 0.1 }, { 4.1, 0.05 } } do
  local corner = trilith.model { name = "corner", dim = 3 }
  corner:material { name = "steel", density = 7850, E = 2e11, nu = 0.3 }
  corner:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.5, beta = 1e-4 } }
  local square = trilith.rectangle_section { width = 0.3, depth = 0.3 }
  corner:frame { name = "f", material = "steel",
    joints = { B = { at = { 4, 0, 0 }, support = "fixed" }, a = { 0, 0, 3 }, b = { 4, 0, 3 }, c = { 4, 3, 3 } },
    members = { { from = "B", to = "b", section = square }, { from = "a", to = "b", section = square },
                { from = "b", to = "c", section = square } } }
  corner:block { name = "stone", size = { 0.06, 0.06, 0.06 }, anchor = "centre", at = { at[1], at[2], 3.2 },
                 material = "steel", floating = true }
  corner:run { duration = 0.3 }
  assert(corner:body "stone".z > 3.0, ("a stone falls through a corner at %g, %g to %g"):format(at[1], at[2],
    corner:body "stone".z))
  corner:close()
end
