-- Frames in space with member ends offset from their joints, and with joints that are rigid blocks.
local trilith = require "trilith"

--- Whether `value` is within `share` of `expected`.
local function near(value, expected, share)
  local off = math.abs(value - expected)
  if off ~= off or off > share*math.abs(expected) then
    error(("%.9g, expected %.9g"):format(value, expected), 2)
  end
end
local E, density = 2e11, 7850
local width, depth = 0.1, 0.2
local up_and_down, sideways = width*depth^3/12, depth*width^3/12
local section = trilith.rectangle_section { width = width, depth = depth }
local function model(options)
  options.dim = 3
  local m = trilith.model(options)
  m:material { name = "steel", density = density, E = E, nu = 0.3 }
  m:material { name = "light", density = 1, E = E, nu = 0.3 }
  return m
end
local none = { 0, 0, 0 }

-- A cantilever with a rigid part at both ends, loaded along z and y at the joint: w = F (l^3/3 + a l^2 + a^2 l)/EI with
-- the flexible length l and the rigid length a at the joint. Rotating the model about an oblique axis changes nothing.
do
  local l, a, F = 1.5, 0.4, 1e3
  for _, turned in ipairs { false, true } do
    local function at(x, y, z) return turned and { 0.6*x - 0.8*y, 0.8*x + 0.6*y, z } or { x, y, z } end
    for axis, inertia in ipairs { sideways, up_and_down } do
      local m = model { name = "cantilever", gravity = none }
      m:frame { name = "beam", material = "steel",
        joints = { A = { at = { 0, 0, 0 }, support = "fixed" }, B = at(0.5 + l + a, 0, 0) },
        members = { { from = "A", to = "B", section = section, from_at = at(0.5, 0, 0), to_at = at(0.5 + l, 0, 0) } } }
      local force = axis == 1 and at(0, F, 0) or { 0, 0, F }
      m:point_load { body = "beam", at = "B", force = force }
      m:consolidate { integrator = "static" }
      local x, y, z = m:body("beam"):point "B"
      local start = at(0.5 + l + a, 0, 0)
      local moved = { x - start[1], y - start[2], z - start[3] }
      near((moved[1]*force[1] + moved[2]*force[2] + moved[3]*force[3])/F,
        F*(l^3/3 + a*l^2 + a^2*l)/(E*inertia), 1e-4)
    end
  end
end

-- A column offset from its joints: the load on the joint bends it with constant curvature, by P e h^2 / 2 EI, and both
-- ends read the moment P e.
do
  local h, e, P = 2, 0.15, 1e4
  local m = model { name = "column", gravity = none }
  m:frame { name = "column", material = "steel",
    joints = { A = { at = { 0, 0, 0 }, support = "fixed" }, B = { 0, 0, h } },
    members = { { from = "A", to = "B", section = section, from_at = { e, 0, 0 }, to_at = { e, 0, h } } } }
  m:point_load { body = "column", at = "B", force = { 0, 0, -P } }
  m:consolidate { integrator = "static" }
  local x = m:body("column"):point "B"
  near(x, -P*e*h^2/(2*E*up_and_down), 2e-3) -- the top of an upright member's section points to x
  local rows = m:body("column"):forces()
  near(math.abs(rows[1].moment_z), P*e, 2e-3)
  near(rows[1].normal, -P, 1e-3)
  assert(math.abs(rows[1].x - e) < 1e-12 and math.abs(rows[#rows].x - e) < 1e-3)
end

-- A massless mast with a rigid block: both bending directions and torsion have the frequencies of a rigid body on the
-- mast's stiffness, with the block's centroid beyond the mast's end.
do
  local l, side = 3, { 0.6, 0.5, 0.8 }
  local m = model { name = "mast", gravity = none }
  local hull = {}
  for _, x in ipairs { -side[1]/2, side[1]/2 } do
    for _, y in ipairs { -side[2]/2, side[2]/2 } do
      for _, z in ipairs { l, l + side[3] } do hull[#hull + 1] = { x, y, z } end
    end
  end
  m:frame { name = "mast", material = "light",
    joints = { A = { at = { 0, 0, 0 }, support = "fixed" }, B = { hull = hull, density = 2000 } },
    members = { { from = "A", to = "B", section = section, divisions = 4 } } }
  local mass, d = 2000*side[1]*side[2]*side[3], side[3]/2
  near(m:body("mast").mass, mass + l*width*depth, 1e-9)
  --- Lowest root of det(K - w^2 M) for a stiffness EI and an inertia J about the centroid.
  local function lowest(EI, J)
    local k11, k12, k22 = 12*EI/l^3, -6*EI/l^2, 4*EI/l
    local m11, m12, m22 = mass, mass*d, J + mass*d^2
    local a, b, c = m11*m22 - m12^2, -(k11*m22 + k22*m11 - 2*k12*m12), k11*k22 - k12^2
    return math.sqrt((-b - math.sqrt(b^2 - 4*a*c))/(2*a))/(2*math.pi)
  end
  local modes = m:modes { count = 3 }
  local along_y = lowest(E*sideways, mass*(side[2]^2 + side[3]^2)/12)
  local along_x = lowest(E*up_and_down, mass*(side[1]^2 + side[3]^2)/12)
  near(modes[1].frequency, along_y, 1e-3)
  near(modes[2].frequency, along_x, 1e-3)
  -- Released, it oscillates with this period.
  m:point_load { name = "pull", body = "mast", at = "B", force = { 0, 1e3, 0 } }
  m:consolidate { integrator = "static" }
  local _, start = m:body("mast"):point "B"
  m:remove "pull"
  local crossed, before = {}, start
  m:on_step(function()
    local _, y = m:body("mast"):point "B"
    if (y > 0) ~= (before > 0) then crossed[#crossed + 1] = m.time end
    before = y
  end)
  m:run { duration = 1.6/along_y, integrator = "implicit", dt = 1e-3 }
  near(crossed[3] - crossed[1], 1/along_y, 5e-3)
end

-- A shaken bent of two columns whose cap lies on blocks: explicit and implicit steps agree, with lumped and consistent
-- masses, and the energy of the free vibration is conserved.
local function bent(options)
  local m = model { name = "bent", gravity = none }
  local function block(x, z)
    local hull = {}
    for _, i in ipairs { -0.2, 0.2 } do
      for _, j in ipairs { -0.15, 0.15 } do
        for _, k in ipairs { -0.2, 0.2 } do hull[#hull + 1] = { x + i, j, z + k } end
      end
    end
    return hull
  end
  m:frame { name = "bent", material = "steel", mass_matrix = options.mass_matrix,
    joints = { A = { at = { 0, 0, 0 }, support = "fixed" }, D = { at = { 3, 0, 0 }, support = "fixed" },
      B = { hull = block(0, 4) }, C = { hull = block(3, 4) }, T = { at = { 1.5, 0.5, 4 }, mass = 500, inertia = 5 } },
    members = { { from = "A", to = "B", section = section, divisions = options.divisions },
      { from = "D", to = "C", section = section, divisions = options.divisions },
      { from = "B", to = "T", section = section, divisions = options.divisions, to_at = { 1.5, 0, 4 } },
      { from = "T", to = "C", section = section, divisions = options.divisions, from_at = { 1.5, 0, 4 } } } }
  m:point_load { body = "bent", at = "T", force = { 3e3, 6e3, -4e3 }, load_curve = { smooth = 0.02 } }
  m:run { duration = 0.1, dt = options.dt, integrator = options.integrator }
  local x, y, z = m:body("bent"):point "T"
  local turn = m:body("bent"):point { 1.5, 0.4, 4 }
  return { x, y, z, turn }, m
end
do
  local explicit, m = bent { divisions = 8 }
  assert(math.abs(explicit[2] - 0.5) > 2e-3, explicit[2])
  local e = m.energy
  assert(math.abs(e.residual) < 1e-3*e.load, e.residual)
  for _, mass_matrix in ipairs { "lumped", "consistent" } do
    local implicit = bent { divisions = 8, dt = 2e-4, integrator = "implicit", mass_matrix = mass_matrix }
    for i, start in ipairs { 1.5, 0.5, 4, 1.5 } do
      local moved = explicit[i] - start
      assert(math.abs(implicit[i] - explicit[i]) < 0.02*math.max(math.abs(moved), 1e-3),
        ("%s %d: %.9g, explicit %.9g of %.9g"):format(mass_matrix, i, implicit[i] - start, moved, start))
    end
  end
end

-- Wrong input gives a message.
local function refused(expected, joints, member)
  local m = model { name = "wrong" }
  member.section = section
  local fine, message = pcall(m.frame, m, { name = "f", material = "steel", joints = joints, members = { member } })
  assert(not fine and message:find(expected, 1, true), message)
end
local cube = { { 2, 0, 0 }, { 3, 0, 0 }, { 2, 1, 0 }, { 3, 1, 0 }, { 2, 0, 1 }, { 3, 0, 1 }, { 2, 1, 1 }, { 3, 1, 1 } }
refused("'at' is not the centroid of its block, (2.5, 0.5, 0.5)",
  { A = { 0, 0, 0 }, B = { hull = cube, at = { 2, 0, 0 } } }, { from = "A", to = "B" })
refused("joint 'B': has 1 points", { A = { 0, 0, 0 }, B = { hull = { { 0, 0, 0 } } } }, { from = "A", to = "B" })
refused("member 'A-B' is 0 m long; its ends must lie apart", { A = { 0, 0, 0 }, B = { 1, 0, 0 } },
  { from = "A", to = "B", from_at = { 0.5, 0, 0 }, to_at = { 0.5, 0, 0 } })
refused("'from_at' is 3, must be", { A = { 0, 0, 0 }, B = { 1, 0, 0 } }, { from = "A", to = "B", from_at = 3 })
refused("joint 'B': density is -1", { A = { 0, 0, 0 }, B = { hull = cube, density = -1 } }, { from = "A", to = "B" })
