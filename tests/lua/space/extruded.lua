-- Models of the plane converted to space by m:extruded: fixed in their plane they move as in the plane.
local trilith = require "trilith"

local friction = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.5, beta = 1e-4 }

--- Whether `value` is within `share` of `size` of the expected value.
local function near(value, expected, share, size)
  local off = math.abs(value - expected)
  if off ~= off or off > share*(size or math.abs(expected)) then
    error(("%.9g, expected %.9g"):format(value, expected), 2)
  end
end
--- One period of a sine.
local function pulse(peak, period)
  local samples = {}
  for i = 0, 400 do
    local t = i*0.005
    samples[i + 1] = t < period and peak*math.sin(2*math.pi*t/period) or 0
  end
  return trilith.motion { acceleration = samples, dt = 0.005 }
end
--- Blocks { width, height }, stacked on a ground.
local function stack(law, blocks, options)
  options = options or {}
  options.name, options.thickness = "plane", options.thickness or 0.5
  local m = trilith.model(options)
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = law }
  m:block { name = "ground", width = 6, height = 0.5, at = { -3, -0.5 }, material = "stone", support = "fixed" }
  local y = 0
  for i, b in ipairs(blocks) do
    m:block { name = "b" .. i, width = b[1], height = b[2], at = { -b[1]/2, y }, material = "stone", groups = "top" }
    y = y + b[2]
  end
  return m
end
--- Results of `go` for both models; its arguments are the model and functions for the height and the rotation of a
--- body.
local function both(m, go)
  local space = m:extruded()
  return go(m, function(b) return b.y end, function(b) return b.rotation end),
    go(space, function(b) return b.z end, function(b) return -b.rotation_y end)
end

-- The model in space has the input of the plane: bodies by name, with groups, materials, mass and position; the plane
-- model stays usable.
do
  local m = stack(friction, { { 1, 0.4 }, { 0.5, 0.3 } }, { thickness = 0.3 })
  m:bearing { name = "link", between = { "b1", "b2" }, at = { 0, 0.4 }, along = trilith.linear { stiffness = 1e5 } }
  local s = m:extruded { name = "deep" }
  assert(s.name == "deep" and s.dim == 3 and m.dim == 2)
  assert(#s:bodies() == #m:bodies() and #s:bodies { group = "top" } == 2)
  assert(m:extruded().name == "plane" and #s.bearings == 1 and s.bearings.link.bodies[2] == s:body "b2")
  for _, name in ipairs { "b1", "b2" } do
    local flat, solid = m:body(name), s:body(name)
    near(solid.mass, flat.mass, 1e-12)
    near(solid.x, flat.x, 1e-12, 1)
    near(solid.y, 0, 1e-12, 1)
    near(solid.z, flat.y, 1e-12)
  end
  s:block { name = "more", size = { 1, 1, 1 }, at = { 2, -0.5, 0 }, material = "stone" }
  s:run { duration = 0.01 }
  m:run { duration = 0.01 }
  near(s.time, m.time, 1e-9)
end

-- Sliding and rocking as in the plane.
do
  local flat, space = both(stack(friction, { { 1, 0.4 } }), function(m, height)
    m:consolidate { rest = { ratio = 1e-6 } }
    local most, block, ground = 0, m:body "b1", m:body "ground"
    m:on_step(function() most = math.max(most, math.abs(block.x - ground.x)) end)
    m:shake { body = "ground", x = pulse(8, 1), duration = 1 }
    return { most, height(block) }
  end)
  assert(flat[1] > 0.1)
  near(space[1], flat[1], 1e-3)
  near(space[2], flat[2], 1e-9)

  flat, space = both(stack(friction, { { 0.5, 2 } }), function(m, _, turn)
    m:consolidate { rest = { ratio = 1e-6 } }
    local most, tower = 0, m:body "b1"
    m:on_step(function() most = math.max(most, math.abs(turn(tower))) end)
    m:shake { body = "ground", x = pulse(3.4, 0.6), duration = 1.2 }
    return { most, tower.x }
  end)
  assert(flat[1] > 0.05)
  near(space[1], flat[1], 2e-3)
  near(space[2], flat[2], 1e-3)
end

-- A bearing acts as in the plane, also with rotated axes and while it rotates; it fails at the same time.
for _, angle in ipairs { 0, 0.4 } do
  local m = stack(friction, { { 1, 0.4 } })
  local slab = m:block { name = "slab", width = 2, height = 0.2, at = { -1, 0.6 }, material = "stone" }
  for i, x in ipairs { -0.6, 0.7 } do
    m:bearing { name = "n" .. i, between = { "ground", slab }, from = { x, 0 }, to = { x, 0.6 }, angle = angle,
      along = trilith.bouc_wen { stiffness = 2e5, yield = 2e3, hardening = 0.1 },
      axial = trilith.linear { stiffness = 2e6, damping = 1e3 }, turning = trilith.linear { stiffness = 1e5 },
      limit = { along = 0.06 } }
  end
  local flat, space = both(m, function(model, height, turn)
    model:consolidate { rest = { ratio = 1e-4 }, duration = 5 }
    local failed, start = nil, model.time
    model:on("bearing.failed", function(e) failed = failed or e.time - start end)
    model:shake { body = "ground", x = pulse(6, 0.6), duration = 0.3 }
    local b, moved = model.bearings.n1, model:body "slab"
    return { moved.x, height(moved), turn(moved), b.displacement_along, failed or 0 }
  end)
  for i = 1, 5 do near(space[i], flat[i], 1e-5, math.max(math.abs(flat[i]), 1e-3)) end
end

-- Mortar holds and breaks as in the plane.
do
  local law = trilith.bonded { kn = 1e9, ks = 4e8, mu = 0.5, beta = 1e-4, tension = 2e4, cohesion = 3e4 }
  local flat, space = both(stack(law, { { 0.5, 0.6 }, { 0.5, 0.6 }, { 0.5, 0.6 } }), function(m, height)
    m:consolidate { rest = { ratio = 1e-6 }, fresh = true }
    local broken, first, start = 0, nil, m.time
    m:on("bond.broken", function(e) broken, first = broken + 1, first or e.time - start end)
    m:shake { body = "ground", x = pulse(4.5, 0.6), duration = 1 }
    return { first, broken, m:body("b3").x, height(m:body "b3") }
  end)
  near(space[1], flat[1], 0.01)
  assert(space[2] == flat[2])
  near(space[3], flat[3], 5e-3)
  near(space[4], flat[4], 5e-3)
end

-- Elements: a tower under its weight and a lateral pull swings as in the plane, in plane strain and in plane stress. In
-- plane stress the model in space is thin enough to thicken freely. Its foot is fixed, because friction under a soft
-- face is a single spring in space and one per half in the plane.
for _, plane in ipairs { "stress", "strain" } do
  for _, kind in ipairs { "quad", "mesh" } do
    local m = stack(friction, {}, { gravity = { 3, -9.81 }, thickness = 0.1 })
    m:material { name = "soft", density = 2400, E = 5e6, nu = 0.3, plane = plane }
    m:block { name = "tower", width = 0.6, height = 1.2, at = { 1, 0 }, material = "soft",
      body = kind == "quad" and "quad" or { mesh = { 2, 4 } }, hold = { { from = { 1, 0 }, to = { 1.6, 0 } } } }
    local flat, space = both(m, function(model, height)
      local b, up = model:body "tower", model.dim == 3
      local low, most, shear = height(b), b.x, 0
      model:on_step(function()
        low, most = math.min(low, height(b)), math.max(most, b.x)
        shear = math.max(shear, math.abs(up and b.szx or b.sxy))
      end)
      model:run { duration = 0.2 }
      return { 0.6 - low, most - 1.3, shear }
    end)
    assert(flat[1] > 1e-3 and flat[2] > 5e-3)
    local share = plane == "strain" and 1e-4 or 6e-3
    for i = 1, 3 do near(space[i], flat[i], share) end
  end
end

-- With free out-of-plane motion it leaves its plane under a load across.
do
  local m = stack(trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.1, beta = 1e-4 }, { { 1, 0.4 } })
  for _, held in ipairs { true, false } do
    local s = m:extruded { held = held }
    s:consolidate { rest = { ratio = 1e-5 } }
    s:point_load { body = "b1", force = { 0, 4e3, 0 } }
    s:run { duration = 0.2 }
    local y = s:body("b1").y
    assert(held and math.abs(y) < 1e-12 or not held and y > 0.02)
  end
end

-- Input that does not exist in space, or needs other keys.
local function refused(expected, f, ...)
  local fine, message = pcall(f, ...)
  if fine or message:gsub("^[^:]*:%d+: ", "") ~= expected then error(tostring(message), 2) end
end
do
  local m = stack(friction, { { 1, 1 } })
  refused("extruded: model 'plane' is in space already", function() m:extruded():extruded() end)
  refused("extruded: unknown key 'hold'; did you mean 'held'?", function() m:extruded { hold = true } end)
end
