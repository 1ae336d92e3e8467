-- Models in space: bodies, builders, stages, readings and messages.
local trilith = require "trilith"

local dry = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-5 }
local function model(options)
  options = options or {}
  options.dim = 3
  local m = trilith.model(options)
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = dry }
  m:block { name = "ground", size = { 8, 8, 1 }, at = { -4, -4, -1 }, support = "fixed", material = "stone" }
  return m
end

local function near(value, expected, share)
  assert(math.abs(value - expected) <= share * math.abs(expected), ("%g is not %g"):format(value, expected))
end

-- A dry wall whose stones just touch initially: head joints carry rounding alone, and almost no friction.
do
  local m = trilith.model { dim = 3 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 4e9, mu = 0.7, beta = 2e-5 } }
  m:block { name = "base", size = { 2.4, 0.2, 0.4 }, at = { 0, 0, -0.4 }, material = "stone", support = "fixed" }
  for course = 1, 6 do
    local half, x, n = course % 2 == 0, 0, 0
    while x < 2.4 - 1e-6 do
      local wide = half and (n == 0 or x > 2.1) and 0.2 or 0.4
      n = n + 1
      m:block { name = ("c%d.u%d"):format(course, n), size = { wide, 0.2, 0.2 }, at = { x, 0, (course - 1) * 0.2 },
        material = "stone" }
      x = (half and (n - 0.5) or n) * 0.4
    end
  end
  m:run { duration = 0.05, dt = 1e-4, local_damping = 0.8 }
  local residual = m.energy.residual
  assert(math.abs(residual) < 1e-3 * 2000 * 2.4 * 0.2 * 1.2 * 9.81 * 1e-4, residual)
end

-- Every builder returns the mass of its bodies.
do
  local m = model()
  near(m:block { name = "b", size = { 1, 2, 3 }, at = { 0, 0, 0 }, material = "stone" }.mass, 12000, 1e-12)
  near(m:extrusion { name = "e", outline = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } }, depth = 0.5,
    at = { 3, 0, 0 }, material = "stone" }.mass, 3000, 1e-12)
  near(m:hull { name = "h", points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, material = "stone" }.mass,
    2000 / 6, 1e-12)
  near(m:prism { name = "p", sides = 6, radius = 1, height = 2, material = "stone" }.mass,
    2000 * 2 * 6 / 2 * math.sin(math.pi / 3), 1e-12)
  near(m:column { name = "c", drums = 4, height = 2, radius = 0.25, material = "stone" }.mass,
    2000 * 2 * math.pi * 0.25 ^ 2, 1e-12)
  near(m:wall { name = "w", length = 4, courses = 5, material = "stone" }.mass, 2000 * 4 * 0.2 * 1, 1e-9)
  near(m:dome { name = "d", material = "stone" }.count, 8 * 16 + 1, 0)
  near(m:vault { name = "v", thickness = 0.2, radius = 1, stone_length = 0.5, stones = 3, abutments = false,
    material = "stone" }.count, 8 * 3 + 7 * 4, 0)
  near(m:rubble { name = "r", low = { 0, 0, 0 }, high = { 1, 1, 1 }, stones = 20, material = "stone" }.mass, 2000, 1e-9)
  near(m:body { name = "two", pieces = { { hull = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } },
    { hull = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 } } } }, material = "stone" }.mass, 2000 / 3, 1e-12)
  near(m:add(trilith.build.arch { name = "a", voussoirs = 9 }, { depth = 2, material = "stone" }).count, 11, 0)
end

-- A block on a tilted table accelerates by the net friction law, and stops after the tilt ends.
do
  local m = model()
  local block = m:block { name = "block", size = { 0.4, 0.4, 0.1 }, at = { 0, 0, 0 }, material = "stone" }
  local height = m:history { name = "height", body = block, what = "z" }
  local hits = 0
  m:on("contact.made", function(e) hits = hits + 1; assert(e.z and e.bodies[1]) end)
  m:consolidate { duration = 5 }
  assert(hits >= 1 and #height > 10 and #m:contacts { between = { "block", "ground" } } == 1)
  local contact = m:contacts()[1]
  near(contact.normal, block.mass * 9.80665, 1e-3)
  near(contact.area, 0.16, 1e-6)
  m:tilt { rate = 0.5, by = math.rad(35), towards = math.pi / 2 }
  m:run { duration = 3 }
  assert(block.uy > 0.1 and math.abs(block.ux) < 1e-6, "it slides towards y")
  assert(math.abs(block.rotation_x) < 0.02 and m.ratio >= 0)
  assert(math.abs(m.energy.residual) < 1e-3 * m.energy.contact_friction)
end

-- A table that moves along three axes carries the bodies on it along; the same bits each time.
local function shaken()
  local m = model()
  local block = m:block { name = "block", size = { 0.4, 0.4, 0.4 }, material = "stone" }
  m:consolidate { duration = 5 }
  local pulse = trilith.motion { acceleration = { 0, 1, 0, -1, 0 }, dt = 0.1 }
  m:shake { body = "ground", x = pulse, y = pulse, z = pulse }
  return m.hash, block
end
local hash, block = shaken()
assert(hash == (shaken()), "the same bits")
assert(block.ux > 0.01 and math.abs(block.ux - block.uy) < 1e-6)

-- A base driven upwards hits a hovering body at the contact, and not later.
do
  local m = model { gravity = 0 }
  local b = m:block { name = "b", size = { 1, 1, 1 }, at = { 0, 0, 0.15 }, material = "stone", floating = true }
  local met
  m:on("impact", function(e) met = met or e.time end)
  local up = trilith.motion { acceleration = { 0, 10, 0, 0, -10, 0 }, dt = 0.1, allow_drift = true }
  m:shake { body = "ground", z = up }
  assert(met and met > 0.2 and met < 0.3, "it meets the base on its way up")
  assert(b.vz > 0.9 and b.vz < 2.1 and math.abs(m.energy.residual) < 0.02*m.energy.support) -- one impact
end

-- Supports about single axes.
do
  local m = model { gravity = 0 }
  local b = m:block { name = "b", size = { 1, 1, 1 }, at = { 0, 0, 2 }, material = "stone", floating = true,
    spin = { 0, 0, 1 }, velocity = { 1, 0, 0 }, support = { y = "fixed" } }
  m:run { duration = 0.1 }
  near(b.ux, 0.1, 1e-6)
  near(b.rotation_z, 0.1, 1e-3)
  m:fix(b, "xyzr")
  m:run { duration = 0.1 }
  near(b.ux, 0.1, 1e-3)
end

-- Loads at points: a growing off-centre one; a follower load; released again.
do
  local m = model { gravity = 0 }
  local function free(name, y)
    return m:block { name = name, size = { 1, 1, 1 }, at = { 0, y, 2 }, material = "stone", floating = true }
  end
  local b, c = free("b", 0), free("c", 3)
  local inertia = b.mass/6
  local push = m:point_load { body = b, force = { 0, 0, 300 }, at = { 1, 0.5, 2.5 }, load_curve = { ramp = 0.2 } }
  m:point_load { name = "screw", body = c, force = { 300, 0, 0 }, moment = { 0, 0, 200 }, follow = true }
  m:run { duration = 0.2, dt = 1e-4 }
  near(b.vz, 0.5*300*0.2/b.mass, 2e-3)
  near(b.spin_y, -0.5*0.5*300*0.2/inertia, 2e-3) -- (0.5, 0, 0) x (0, 0, 300)
  near(c.spin_z, 200*0.2/inertia, 2e-3)
  near(m.energy.load, m.energy.kinetic, 1e-3)
  m:set_load { name = push, factor = 0 }
  m:release { load = "screw", fade = 0 }
  m:run { duration = 0.1, dt = 1e-4 }
  local v = b.vz
  m:run { duration = 0.1, dt = 1e-4 }
  near(b.vz, v, 1e-12)
end

-- Messages.
local function says(text, f)
  local good, message = pcall(f)
  assert(not good and message:find(text, 1, true), text .. "\nwas: " .. tostring(message))
end
local m = model { name = "house" }
says("model 'house': 'dim' is 4, must be 2 (in the plane) or 3 (in space)",
  function() trilith.model { name = "house", dim = 4 } end)
says("'thickness' is for models in the plane, and dim is 3", function() trilith.model { dim = 3, thickness = 1 } end)
says("stack: is for models in the plane, but model 'house' has dim = 3; give its parts a depth with "
  .. "m:add(trilith.build.stack{...}, { depth = })", function() m:stack { blocks = {} } end)
says("span: is for models in the plane, but model 'house' has dim = 3", function() m:span {} end)
says("dome: is for models in space, but model is in the plane; give it dim = 3", function() trilith.model():dome {} end)
says("block 'b': 'size' is missing", function() m:block { name = "b" } end)
says("block 'b': 'size' is 1, must be {x, y, z}, three finite numbers", function() m:block { name = "b", size = 1 } end)
says("unknown key 'widht'", function() m:block { name = "b", size = { 1, 1, 1 }, widht = 2 } end)
says("'rotation'", function() return m:body "ground".rotation end)
says("history 'h': 'what' is 'rotation', which is not a reading of a body",
  function() m:history { name = "h", body = "ground", what = "rotation" } end)
says("support: 'y' is 'fixd', must be \"fixed\" or \"free\"",
  function() m:block { name = "b", size = { 1, 1, 1 }, material = "stone", support = { y = "fixd" } } end)
says("'far' has no support", function()
  local n = model()
  n:block { name = "far", size = { 1, 1, 1 }, at = { 0, 0, 5 }, material = "stone" }
  n:run { duration = 1 }
end)
says("'alpha' is -1, must be not below -0.333333 and at most 0",
  function() model():run { duration = 1, integrator = "implicit", alpha = -1 } end)

-- Implicit steps, statics and modes.
do
  local s = trilith.model { dim = 3, name = "implicit" }
  s:material { name = "stone", density = 2400 }
  s:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.7, beta = 2e-4 } }
  s:block { name = "base", size = { 2, 2, 0.5 }, at = { -1, -1, -0.5 }, material = "stone", support = "fixed" }
  s:block { name = "post", size = { 0.4, 0.4, 1.2 }, at = { -0.2, -0.2, 0 }, material = "stone" }
  local rest = s:consolidate { integrator = "static" }
  assert(rest.ending == "rest" and s.time == 0, tostring(rest))
  near(-s:body "post".uz, 2400*1.2*9.80665/1e9, 1e-6)
  local modes = s:modes { count = 6 }
  assert(#modes == 6 and modes.text:find("mass z [%]", 1, true))
  near(modes[1].frequency, 15.0359, 5e-4)
  near(modes[3].frequency, 59.3135, 5e-4)
  near(modes[4].mass_z, 0.4*0.4*1.2*2400, 1e-6)
  assert(math.abs(modes[3].shape.post.rotation_z) > 1)
  near(s:damping { count = 1 }[1].contacts, math.pi*2e-4*modes[1].frequency, 1e-2)
  local run = s:run { duration = 0.2, integrator = "implicit", dt = 5e-3 }
  assert(run.ending == "time" and run.steps < 100, tostring(run))
  assert(s:run { duration = 0.1, integrator = "auto" }.ending == "time")
  local pulse = trilith.motion { acceleration = { 0, 1, 0, -1, 0 }, dt = 0.1 }
  s:shake { body = "base", x = pulse, y = pulse, duration = 0.5, integrator = "implicit" }
  near(s:body "base".ux, 0.02, 1e-6)
  near(s:body "post".ux, 0.02, 0.05)
  assert(math.abs(s.energy.residual) < 0.1, s.energy.residual)
  s:close()
end

-- Messages in space use the terms of models in space.
do
  local s = trilith.model { dim = 3, name = "words" }
  s:material { name = "stone", density = 2400 }
  s:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.6, beta = 1e-3 } }
  local function refuses(f, text)
    local good, why = pcall(f)
    assert(not good and why:find(text, 1, true), why)
  end
  refuses(function() s:block { name = "a", width = 1, height = 2, at = { 0, 0, 0 }, material = "stone" } end,
    "'width' is for blocks in the plane; in space give size = {x, y, z}")
  local b = s:block { name = "b", size = { 1, 1, 1 }, at = { 0, 0, 1 }, material = "stone", floating = true,
    spin = { 0, 0, 1 } }
  local known = select(2, pcall(function() return s.nothing_like_it end))
  assert(known:find "vault" and known:find "gravity", known)
  assert(not known:find "running_bond" and not known:find "abutment", known)
  assert(s.gravity[3] == -9.80665 and s.tilted == 0)
  refuses(function() b:point { 1, 2 } end, "point: takes {x, y, z} or the name of a joint")
  local good, why = pcall(function() return b.nothing_like_it end)
  assert(not good and why:find "point" and not why:find "hinges" and not why:find "fibres", why)
  local x, y, z = b:point { 1, 0.5, 1 }
  assert(x == 1 and y == 0.5 and z == 1)
  s:run { duration = 0.1 } -- falls, and rotates about z by 0.1 rad
  x, y, z = b:point { 1, 0.5, 1 }
  local c, t = trilith.math.cos(0.1), trilith.math.sin(0.1)
  assert(math.abs(x - 0.5 - 0.5*c) < 1e-9 and math.abs(y - 0.5 - 0.5*t) < 1e-9)
  assert(math.abs(z - 1 - (b.z - 1.5)) < 1e-12 and b.z < 1.5)
end

-- lint reports doubtful solids, next to a sound one.
do
  local thin = trilith.model { name = "thin", dim = 3 }
  thin:material { name = "stone", density = 2400 }
  thin:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.5, beta = 1e-4 } }
  thin:block { name = "ground", size = { 2, 2, 1 }, at = { 0, 0, -1 }, material = "stone", support = "fixed" }
  thin:block { name = "sheet", size = { 1, 1, 1e-4 }, at = { 0.5, 0.5, 0 }, material = "stone" }
  local text = thin:lint().text
  assert(text:find("solid 'sheet'", 1, true) and not text:find("solid 'ground'", 1, true), text)
end

-- A free spinning body, with nothing stiff in the model: its axis precesses about its angular momentum at L/I1, with
-- steps that resolve its rotation.
do
  local free = trilith.model { name = "spun", dim = 3, gravity = 0 }
  free:material { name = "stone", density = 1500 }
  local plate = free:block { name = "plate", size = { 0.6, 0.6, 0.2 }, at = { -0.3, -0.3, -0.1 }, material = "stone",
                          floating = true, spin = { 0.7, 0, 14 } }
  local across, along = (0.6^2 + 0.2^2)/12*0.7, 2*0.6^2/12*14
  free:run { duration = 2.3 }
  local size = math.sqrt(across^2 + along^2)
  local turned, cone = size/((0.6^2 + 0.2^2)/12)*free.time, across/size
  local x, y = plate:point { 0, 0, 0.1 }
  -- Seen along the angular momentum, which is inclined by the cone's angle from z towards x, the axis starts at -x.
  local lean = math.atan(across, along)
  local _, _, z = plate:point { 0, 0, 0.1 }
  local aside = x*math.cos(lean) - z*math.sin(lean)
  local phase = (math.atan(-y, -aside) - turned + math.pi) % (2*math.pi) - math.pi
  assert(math.abs(phase) < 5e-4*turned, "the axis is out by " .. phase .. " of " .. turned .. " rad")
  near(math.sqrt(aside^2 + y^2), 0.1*cone, 5e-4)
end
