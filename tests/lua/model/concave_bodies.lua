-- Bodies of several pieces whose faces overlap in part: a contact keeps its energy when it crosses inner joints, and
-- pressure acts on the open part of a face.
local trilith = require "trilith"

local function near(value, expected, allowed)
  assert(math.abs(value - expected) <= allowed, ("%.9g is not %.9g"):format(value, expected))
end

local function box(x, y, z, a, b, c)
  local corners = {}
  for i = 0, 7 do corners[i + 1] = { x + (i & 1)*a, y + (i >> 1 & 1)*b, z + (i >> 2 & 1)*c } end
  return corners
end

local function model()
  local m = trilith.model { dim = 3, gravity = 0 }
  m:material { name = "stone", density = 2500 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 0, mu = 0 } }
  return m
end

-- A wedge with fixed rotation slides over the joint of a step, whose lower part has a free side. On a smooth, level and
-- undamped step the energy is conserved: energy lost by the wedge is stored in the springs.
do
  local m = model()
  m:body { name = "step", pieces = { { hull = box(-1, -1, -1, 1, 2, 1) }, { hull = box(0, -1, -0.5, 1, 2, 0.5) } },
    material = "stone", support = "fixed" }
  local wedge = m:hull { name = "wedge", material = "stone", floating = true, velocity = { 0.5, 0, -0.05 },
    points = { { -0.1, -0.1, 0.0005 }, { -0.1, 0.1, 0.0005 }, { -0.2, -0.1, 0.15 }, { -0.2, 0.1, 0.15 },
      { 0, -0.1, 0.15 }, { 0, 0.1, 0.15 } },
    support = { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" }, load = { 0, 0, -70 } }
  local before = m.energy.kinetic
  m:run { duration = 0.4, safety = 0.05 }
  assert(wedge.x > 0.05, wedge.x)
  near(m.residual, 0, 1e-5*before)
end

-- Blocks strike a cross in free flight; the middle piece of the cross has sides that are partly surface and partly
-- inner cut in one plane.
do
  local function cross_at(m, spin)
    return m:extrusion { name = "cross", depth = 0.4, centred = true, material = "stone", floating = true, spin = spin,
      outline = { { -0.1, -0.5 }, { 0.1, -0.5 }, { 0.1, -0.1 }, { 0.5, -0.1 }, { 0.5, 0.1 }, { 0.1, 0.1 },
        { 0.1, 0.5 }, { -0.1, 0.5 }, { -0.1, 0.1 }, { -0.5, 0.1 }, { -0.5, -0.1 }, { -0.1, -0.1 } } }
  end
  local struck = 0
  for i = 1, 12 do
    local function by(share) return math.fmod(share*i, 2) - 1 end -- from -1 to 1, spread over the runs
    local m = model()
    local cross = cross_at(m, { by(0.37), by(0.71), by(1.13) })
    m:block { name = "block", size = { 0.5, 0.4, 0.3 }, anchor = "centre", at = { 0.25*by(0.83), 0.1*by(0.59), 1 },
      turn = { axis = { by(0.31), by(0.53), 1 }, angle = 3*by(0.97) }, material = "stone", floating = true,
      velocity = { 0, 0, -3 }, spin = { 3*by(0.43), 3*by(0.67), 3*by(1.21) } }
    local before = m.energy.kinetic
    m:run { duration = 0.6, safety = 0.1 }
    near(m.residual, 0, 1e-4*before)
    if math.abs(cross.vz) > 0.01 then struck = struck + 1 end
  end
  assert(struck == 12, struck)
end

-- The foot of a post covers a part of its slab's top.
local function pressed(face, pieces)
  local m = model()
  local body = m:body { name = "post", pieces = pieces, material = "stone", floating = true }
  m:pressure { body = body, face = face, value = 1000 }
  m:run { duration = 0.01, dt = 1e-4 }
  local moment = body.mass/(m.time - 0.5*m.dt) -- a force applied at once has acted half a step less
  return body.vx*moment, body.vy*moment, body.vz*moment, math.abs(body.spin_x) + math.abs(body.spin_y)
end
do
  local post = { { hull = box(0, 0, 0, 1, 1, 0.2) }, { hull = box(0.3, 0.3, 0.2, 0.2, 0.2, 0.5) } }
  local _, _, up = pressed("top", post)
  near(up, -1000, 1e-6)
  local x, y, z, spin = pressed("all", post)
  near(math.abs(x) + math.abs(y) + math.abs(z), 0, 1e-9)
  near(spin, 0, 1e-12)
  -- under two halves, and under a round foot of many sides
  local _, _, halves = pressed("top", { post[1], { hull = box(0, 0, 0.2, 0.5, 1, 0.1) },
    { hull = box(0.5, 0, 0.2, 0.5, 1, 0.3) } })
  near(halves, -1000, 1e-6)
  local foot = {}
  for i = 1, 40 do
    local a = 2*math.pi*i/40
    foot[i], foot[40 + i] = { 0.5 + 0.3*math.cos(a), 0.5 + 0.3*math.sin(a), 0.2 },
      { 0.5 + 0.3*math.cos(a), 0.5 + 0.3*math.sin(a), 0.6 }
  end
  local _, _, round, lean = pressed("all", { post[1], { hull = foot } })
  near(round, 0, 1e-9)
  near(lean, 0, 1e-12)
end

-- A rigid body of mesh elements equals the body of its pieces: an L of bricks and wedges has the weight, penetration
-- and rest of one of three boxes.
do
  local function standing(shape)
    local m = trilith.model { dim = 3 }
    m:material { name = "stone", density = 2500 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-4 } }
    m:block { name = "ground", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
    shape.name, shape.material = "L", "stone"
    local body = m:body(shape)
    m:consolidate { rest = { ratio = 1e-6 } }
    return { body.mass, body.x, body.y, body.z, body.rotation_x, body.rotation_y, body.rotation_z }
  end
  -- Nodes 1 to 4 on the ground, 5 to 8 above them, 9 to 12 above those; 13 to 16 next to them.
  local nodes = {}
  for _, z in ipairs { 0, 0.3, 0.6 } do
    for _, p in ipairs { { 0, 0 }, { 0.4, 0 }, { 0.4, 0.4 }, { 0, 0.4 } } do nodes[#nodes + 1] = { p[1], p[2], z } end
  end
  for _, p in ipairs { { 0.8, 0, 0 }, { 0.8, 0.4, 0 }, { 0.8, 0, 0.3 }, { 0.8, 0.4, 0.3 } } do nodes[#nodes + 1] = p end
  local boxes = standing { pieces = { { hull = box(0, 0, 0, 0.4, 0.4, 0.3) }, { hull = box(0, 0, 0.3, 0.4, 0.4, 0.3) },
    { hull = box(0.4, 0, 0, 0.4, 0.4, 0.3) } } }
  local elements = standing { body = "rigid", mesh = { nodes = nodes, elements = { { 1, 2, 3, 5, 6, 7 },
    { 1, 3, 4, 5, 7, 8 }, { 5, 6, 7, 9, 10, 11 }, { 5, 7, 8, 9, 11, 12 }, { 2, 13, 14, 3, 6, 15, 16, 7 } } } }
  near(elements[1], 2500*3*0.4*0.4*0.3, 1e-9)
  assert(math.abs(boxes[6]) > 1e-6 and math.abs(boxes[6]) < 1e-3, boxes[6]) -- leans towards its foot
  for i = 1, 7 do near(elements[i], boxes[i], 1e-9) end
end
