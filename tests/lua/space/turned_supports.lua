-- A support in space that is driven about world axes: its final position, the reading of its rotation, bodies carried
-- along, and bodies whose rotation about world axes is fixed.
local trilith = require "trilith"

local function model(options)
  options.dim = 3
  local m = trilith.model(options)
  m:material { name = "stone", density = 2000 }
  return m
end

-- v rotated about a unit axis (Rodrigues).
local function turned(v, axis, angle)
  local c, s = math.cos(angle), math.sin(angle)
  local along = v[1]*axis[1] + v[2]*axis[2] + v[3]*axis[3]
  local cross = { axis[2]*v[3] - axis[3]*v[2], axis[3]*v[1] - axis[1]*v[3], axis[1]*v[2] - axis[2]*v[1] }
  local out = {}
  for k = 1, 3 do out[k] = c*v[k] + s*cross[k] + (1 - c)*along*axis[k] end
  return out
end

local bodies = {
  block = function(m) return m:block { name = "b", size = { 0.5, 0.4, 0.3 }, at = { 0, 0, 0 }, anchor = "centre",
    material = "stone", support = "fixed", floating = true } end,
  askew = function(m) return m:block { name = "b", size = { 0.5, 0.4, 0.3 }, at = { 0, 0, 0 }, anchor = "centre",
    turn = { axis = { 1, 2, 0 }, angle = 0.3 }, material = "stone", support = "fixed", floating = true } end,
  hull = function(m) return m:hull { name = "b", material = "stone", support = "fixed", floating = true,
    points = { { 0, 0, 0 }, { 0.5, 0.1, 0 }, { 0.2, 0.6, 0.1 }, { 0.3, 0.2, 0.7 }, { -0.2, 0.3, 0.3 } } } end
}

-- Largest distance of three points of a body from their positions after the rotations { axis, angle }, ... [m].
local function missed(b, turns, centre)
  local most = 0
  for _, arm in ipairs { { 0.1, 0, 0 }, { 0, 0.1, 0 }, { 0, 0, 0.1 } } do
    local x, y, z = b:point { centre[1] + arm[1], centre[2] + arm[2], centre[3] + arm[3] }
    local to = arm
    for _, turn in ipairs(turns) do to = turned(to, turn[1], turn[2]) end
    most = math.max(most, math.abs(x - centre[1] - to[1]), math.abs(y - centre[2] - to[2]),
      math.abs(z - centre[3] - to[3]))
  end
  return most
end

local function is_at(name, got, expected, off)
  assert(math.abs(got - expected) < off, ("%s: %.9g for %.9g"):format(name, got, expected))
end

local names = { "rotation_x", "rotation_y", "rotation_z" }
local units = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }
local schemes = { { integrator = "explicit", dt = 2e-3 }, { integrator = "implicit", dt = 0.02 } }

local function run(m, scheme, duration)
  m:run { duration = duration, integrator = scheme.integrator, dt = scheme.dt }
end

-- Every axis and scheme, by less and more than half a turn and by a full one, with weight and without a free body
-- nearby.
for name, make in pairs(bodies) do
  for k, axis in ipairs(units) do
    for _, scheme in ipairs(schemes) do
      for _, by in ipairs { 1, 3, -3.2, 4, 7 } do
        local m = model { name = "turning", gravity = 0 }
        m:contact { between = { "*", "*" }, law = "none" }
        local b = make(m)
        m:block { name = "free", size = { 1, 1, 1 }, at = { 9, 0, 0 }, material = "stone", floating = true }
        local centre = { b.x, b.y, b.z }
        m:drive { body = b, [names[k]] = trilith.ramp { by = by, duration = 0.4 } }
        run(m, scheme, 0.25)
        local half = b[names[k]]
        run(m, scheme, 0.25)
        local what = ("%s about %s by %g, %s"):format(name, names[k], by, scheme.integrator)
        assert(missed(b, { { axis, by } }, centre) < 1e-9, what)
        for j, other in ipairs(names) do is_at(what .. ": " .. other, b[other], j == k and by or 0, 1e-9) end
        assert(half/by > 0.5 and half/by < 0.85, what .. ": it goes on evenly")
        m:close()
      end
    end
  end
end

-- Slow and fast: 0.5 to 300 rad/s, with given and free steps, a clump of pieces that lies askew to its principal axes,
-- and a standing body nearby.
bodies.clump = function(m)
  return m:body { name = "b", material = "stone", support = "fixed", floating = true, pieces = {
    { hull = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } } },
    { hull = { { 0, 0, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, -1 } } } } }
end
for _, name in ipairs { "askew", "clump" } do
  for _, rate in ipairs { 0.5, 5, 50, 300 } do
    for k, axis in ipairs(units) do
      for _, scheme in ipairs { { integrator = "explicit" }, { integrator = "implicit" }, { integrator = "auto" },
                                { integrator = "explicit", dt = 1e-3 }, { integrator = "implicit", dt = 5e-3 } } do
        local m = model { name = "rates" }
        m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.6, beta = 1e-3 } }
        local b = bodies[name](m)
        m:block { name = "free", size = { 0.2, 0.2, 0.2 }, at = { 5, 5, 0 }, material = "stone", floating = true }
        local centre = { b.x, b.y, b.z }
        m:drive { body = b, [names[k]] = trilith.ramp { by = 0.2*rate, duration = 0.2 } }
        run(m, scheme, 0.21)
        local what = ("%s about %s at %g rad/s, %s, dt %s"):format(name, names[k], rate, scheme.integrator, scheme.dt)
        assert(m.verdict.sound, what)
        assert(missed(b, { { axis, 0.2*rate } }, centre) < 1e-9, what)
        for j, other in ipairs(names) do is_at(what .. ": " .. other, b[other], j == k and 0.2*rate or 0, 1e-9) end
        m:close()
      end
    end
  end
end

-- About a diagonal, and two drives after each other: about one axis, and about two.
for name, make in pairs(bodies) do
  for _, scheme in ipairs(schemes) do
    local m = model { name = "diagonal", gravity = 0 }
    m:contact { between = { "*", "*" }, law = "none" }
    local b = make(m)
    local centre = { b.x, b.y, b.z }
    local ramp, share = trilith.ramp { by = 2, duration = 0.4 }, 1/math.sqrt(3)
    m:drive { body = b, rotation_x = ramp, rotation_y = ramp, rotation_z = ramp }
    run(m, scheme, 0.5)
    local diagonal = { { share, share, share }, 2/share }
    local what = name .. ", " .. scheme.integrator
    assert(missed(b, { diagonal }, centre) < 1e-9, "diagonal: " .. what)
    m:drive { body = b, rotation_x = ramp }
    run(m, scheme, 0.5)
    m:drive { body = b, rotation_z = ramp }
    run(m, scheme, 0.5)
    assert(missed(b, { diagonal, { units[1], 2 }, { units[3], 2 } }, centre) < 1e-9, "one by one: " .. what)
    m:close()

    m = model { name = "twice", gravity = 0 }
    m:contact { between = { "*", "*" }, law = "none" }
    b = make(m)
    for _ = 1, 4 do
      m:drive { body = b, rotation_y = ramp }
      run(m, scheme, 0.5)
    end
    is_at("four drives: " .. what, b.rotation_y, 8, 1e-9)
    m:close()
  end
end

-- A rotating table carries a standing block along, through more than half a turn.
for _, scheme in ipairs { { integrator = "explicit" }, { integrator = "implicit", dt = 0.02 } } do
  local m = model { name = "table" }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.6, beta = 1e-3 } }
  local table_ = m:block { name = "table", size = { 2, 2, 0.5 }, at = { -1, -1, -0.5 }, material = "stone",
    support = "fixed" }
  local block = m:block { name = "block", size = { 0.4, 0.3, 0.3 }, at = { 0.3, -0.15, 0 }, material = "stone" }
  m:consolidate { integrator = "static" }
  local x, y = block.x, block.y
  m:drive { body = table_, rotation_z = trilith.ramp { by = 4, duration = 4 } }
  m:run { duration = 4.5, integrator = scheme.integrator, dt = scheme.dt }
  is_at("table", table_.rotation_z, 4, 1e-9)
  is_at("block: turn", block.rotation_z, 4, 2e-3)
  local to = turned({ x, y, 0 }, units[3], 4)
  assert(math.abs(block.x - to[1]) < 2e-3 and math.abs(block.y - to[2]) < 2e-3,
    ("%s: at %g, %g for %g, %g"):format(scheme.integrator, block.x, block.y, to[1], to[2]))
  m:close()
end

-- With one or two world axes of rotation fixed, a body that rotates freely about the rest keeps its energy at any step.
for _, held in ipairs { { "rotation_z" }, { "rotation_x" }, { "rotation_x", "rotation_y" } } do
  for _, keys in ipairs { { dt = 1e-3 }, { dt = 5e-3 }, { integrator = "implicit", dt = 5e-3, alpha = 0 } } do
    local m = model { name = "held", gravity = 0 }
    m:contact { between = { "*", "*" }, law = "none" }
    local support = {}
    for _, k in ipairs(held) do support[k] = "fixed" end
    m:block { name = "b", size = { 1, 0.6, 0.3 }, at = { 0, 0, 0 }, anchor = "centre", material = "stone",
      turn = { axis = { 1, 1, 0 }, angle = 0.4 }, support = support,
      spin = { support.rotation_x and 0 or 3, support.rotation_y and 0 or 1, support.rotation_z and 0 or 2 },
      floating = true }
    m:run { duration = 1e-6 }
    local before = m.energy.kinetic
    keys.duration = 8
    m:run(keys)
    is_at(("energy, held about %s"):format(table.concat(held, " and ")), m.energy.kinetic/before, 1, 1e-3)
    m:close()
  end
end
