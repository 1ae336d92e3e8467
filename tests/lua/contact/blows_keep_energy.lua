-- Automatic steps keep the energy of an undamped impact to 2 % either way. Cases: fixed and moving bodies, in the plane
-- and in space, rigid and of one element, with and without weight, and a gap. With an accuracy the first contact keeps
-- it too, because the step's prediction includes the speed gained by the weight.
local trilith = require "trilith"
local g = 9.80665

--- A block that hits another one, or falls on it, and rebounds: kinetic energy at the same height after the impact over
--- before.
local function blow(c)
  local m = trilith.model { name = "blow", dim = c.dim, gravity = c.weight and g or 0, overlap_allowed = 1e-3 }
  m:material { name = "stone", density = c.density or 2000, E = c.body and 3e10, nu = c.body and 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = c.kn, ks = 0, mu = 0 } }
  local speed = c.weight and 0 or math.sqrt(2*g*c.height)
  local function block(name, low, high, options)
    options.name, options.material = name, "stone"
    if c.dim == 3 then
      options.size, options.at = { 1, 1, high - low }, { -0.5, -0.5, low }
      if options.velocity then options.velocity = { 0, 0, options.velocity } end
    else
      options.width, options.height, options.at = 1, high - low, { -0.5, low }
      if options.velocity then options.velocity = { 0, options.velocity } end
    end
    return m:block(options)
  end
  block("base", -1, 0, c.free and { floating = true, velocity = 0 } or { support = "fixed" })
  local upper = block("upper", c.height, c.height + 0.5, { floating = true, velocity = -speed, body = c.body })
  local start = 0.5*upper.mass*speed*speed
  local before = c.weight and upper.mass*g*c.height or start
  local fall = c.weight and math.sqrt(2*c.height/g) or c.height/speed
  -- Long after the impact, on the way back.
  m:run { duration = 1.6*fall + 0.02, accuracy = c.accuracy, safety = c.safety }
  -- The kinetic energy of a leapfrog step under weight is m (g dt)^2 / 8 too small: a short step makes this error
  -- negligible.
  m:run { duration = 1e-4 }
  local e = m.energy
  local after = e.kinetic + e.strain
  if c.weight then after = after + upper.mass*g*(c.height + (c.dim == 3 and upper.uz or upper.uy)) end
  local moved = c.dim == 3 and upper.vz or upper.vy
  m:close()
  return after/before, moved
end

local worst = 0
local function check(c)
  local kept, speed = blow(c)
  local what = ("dim %d, kn %g, height %g, density %g, %s, %s, %s, accuracy %s"):format(c.dim, c.kn, c.height,
    c.density or 2000, c.free and "free" or "fixed", c.weight and "weight" or "no weight", c.body or "rigid",
    c.accuracy or "usual")
  local most = c.accuracy and 2*c.accuracy or 0.02
  assert(c.free or speed > 0, what .. ": it is not back yet")
  assert(math.abs(kept - 1) <= most, ("%s: %g of the energy is left"):format(what, kept))
  worst = math.max(worst, c.accuracy and 0 or math.abs(kept - 1))
end

for _, dim in ipairs { 2, 3 } do
  for _, kn in ipairs { 1e7, 1e8, 1e10 } do
    for _, height in ipairs { 0.05, 0.2, 0.47 } do
      check { dim = dim, kn = kn, height = height }
      check { dim = dim, kn = kn, height = height, free = true }
      check { dim = dim, kn = kn, height = height, weight = true, density = 400 }
    end
  end
  for _, accuracy in ipairs { 1e-3, 1e-4 } do
    check { dim = dim, kn = 1e6, height = 0.2, weight = true, density = 400, accuracy = accuracy }
    check { dim = dim, kn = 1e8, height = 0.3, weight = true, accuracy = accuracy }
  end
end
for _, kn in ipairs { 1e8, 1e9 } do check { dim = 2, kn = kn, height = 0.2, body = "quad", weight = true } end

-- Through a gap that closes by the weight: the prediction includes the speed gained.
for _, dim in ipairs { 2, 3 } do
  for _, keys in ipairs { {}, { accuracy = 1e-3 } } do
    local m = trilith.model { name = "gap", dim = dim }
    m:material { name = "stone", density = 1000 }
    m:contact { between = { "*", "*" }, law = "none" }
    local size = dim == 3 and { size = { 1, 1, 1 } } or { width = 1, height = 1 }
    local function block(name, low, options)
      for key, value in pairs(size) do options[key] = value end
      options.name, options.material, options.at = name, "stone", dim == 3 and { 0, 0, low } or { 0, low }
      return m:block(options)
    end
    block("base", -4, { support = "fixed" })
    local upper = block("upper", 0, { floating = true })
    local function at(height) return dim == 3 and { 0.5, 0.5, height } or { 0.5, height } end
    m:bearing { name = "stop", between = { "base", "upper" }, from = at(-3), to = at(0),
                axial = trilith.gap { stiffness = 1e6, opening = 0.3, side = -1 } }
    keys.duration = 0.45
    m:run(keys)
    m:run { duration = 1e-4 }
    local e = m.energy
    assert((dim == 3 and upper.vz or upper.vy) > 0, "the gap has not closed and opened")
    local residual = math.abs(e.kinetic + e.gravity)/(1000*g*0.3)
    assert(residual <= 2*(keys.accuracy or 0.01), ("dim %d: the gap's blow is out by %g"):format(dim, residual))
    m:close()
  end
end
if os.getenv "TRILITH_SHOW" then print("worst of the usual steps", worst) end

-- A given step whose energy error exceeds a twentieth of the input gets a note; a fine step does not.
for dt, notes in pairs { [1e-3] = 1, [5e-5] = 0 } do
  local m = trilith.model { name = "told" }
  m:material { name = "stone", density = 400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 0, mu = 0 } }
  m:block { name = "base", width = 3, height = 1, at = { -1.5, -1 }, material = "stone", support = "fixed" }
  m:block { name = "block", width = 1, height = 0.5, at = { -0.5, 0.2 }, material = "stone", floating = true }
  m:run { duration = 0.4, dt = dt }
  assert(#m.notes == notes, ("a step of %g s: %d notes"):format(dt, #m.notes))
  m:close()
end
