-- Pushes, pressures and quiet release in space from a script, and rejected input.
local trilith = require "trilith"
local g = 9.80665
local function near(a, b, share) assert(math.abs(a - b) <= share * math.abs(b), a .. " is not " .. b) end

local function block_on_ground(mu, kn, size)
  local m = trilith.model { name = "m", dim = 3 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn, mu = mu, beta = 1e-4 } }
  local ground =
    m:block { name = "ground", size = { 6, 6, 1 }, at = { -3, -3, -1 }, material = "stone", support = "fixed" }
  local block = m:block { name = "block", size = size, at = { 0, 0, size[3]/2 }, anchor = "centre", material = "stone" }
  m:consolidate { rest = { ratio = 1e-6 } }
  return m, block, ground
end
local function rest(m) return m:run { duration = 5, local_damping = 0.8, rest = { ratio = 1e-6, from = 0.3 } } end

-- A flat block on friction resists mu W, whatever the direction of the push; the same push twice has the same bits.
local hashes = {}
for i, direction in ipairs { "x", "-y", "x" } do
  local m, block = block_on_ground(0.4, 1e9, { 1, 0.8, 0.1 })
  local weight = block.mass*g
  local r = m:pushover { body = block, direction = direction, rate = 2e-3, displacement = 2e-3, samples = 40 }
  near(r.curve.force[35], 0.4*weight, 2e-3)
  near(m.push_displacement, 2e-3, 1e-6)
  near((direction == "x" and 1 or -1)*block[direction == "x" and "ux" or "uy"], 2e-3, 2e-2)
  assert(r.limit == "displacement", r.limit)
  hashes[i] = m.hash
  m:release { push = "pushover", fade = 0.2 }
  assert(rest(m).rests and m.push_force == 0)
end
assert(hashes[1] == hashes[3] and hashes[1] ~= hashes[2])

-- A slender block, pushed at its top, rocks on an edge of springs. With the pressure over a width c and at the current
-- angle it resists
--     F = W (r cos - H/2 sin)/(a cos + r sin), r = b/2 - c/3, c = sqrt(2 W/(kn d sin)).
do
  local kn, b, d, h = 1e10, 0.4, 0.6, 1.2
  local m, block = block_on_ground(0.9, kn, { b, d, h })
  local r = m:pushover { body = block, at = { 0, 0, h }, direction = "-x", rate = 4e-3, displacement = 4e-3 }
  local weight, turn = block.mass*g, math.abs(block.rotation_y)
  local c = math.sqrt(2*weight/(kn*d*math.sin(turn)))
  local arm = b/2 - c/3
  local force = weight*(arm*math.cos(turn) - h/2*math.sin(turn))/(h*math.cos(turn) + arm*math.sin(turn))
  near(r.peak_force, force, 2e-3) -- it still grows at this point
  assert(r.peak_force < weight*b/(2*h), r.peak_force)
end

-- Uniform pressure on a side is carried by friction; pressure on all sides is in equilibrium.
do
  local m, block = block_on_ground(0.6, 1e9, { 1, 0.8, 0.5 })
  local z = block.z
  assert(m:pressure { name = "wind", body = block, face = "front", value = 2e3, load_curve = { ramp = 0.1 } } == "wind")
  rest(m)
  -- The shear springs of the face carry it: p A = ks A_face u, and the block tilts slightly.
  local most = 2e3*0.5*1/(1e9*1*0.8)
  assert(block.uy > 0.99*most and block.uy < 3*most, block.uy)
  m:release { load = "wind", fade = 0.2 }
  m:pressure { name = "water", body = block, face = "all", value = 5e3, load_curve = { ramp = 0.1 } }
  rest(m)
  assert(math.abs(block.uy) < 1e-10 and math.abs(block.z - z) < 1e-10, block.uy)
  m:pressure { name = "snow", body = block, face = "top", value = 3e3, direction = { 0, 0, -1 },
    load_curve = { ramp = 0.1 } }
  rest(m)
  near(z - block.z, 3e3/1e9, 1e-3)
end

-- A fixed body is released quietly: it settles on its springs without oscillation.
do
  local m = trilith.model { name = "q", dim = 3 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e7, ks = 1e7, mu = 0.5, beta = 1e-6 } }
  m:block { name = "ground", size = { 6, 6, 1 }, at = { -3, -3, -1 }, material = "stone", support = "fixed" }
  local held = m:block { name = "held", size = { 1, 1, 0.5 }, material = "stone", support = "fixed" }
  m:run { duration = 0.01 }
  m:release { body = held, fade = 1 }
  local lowest = 0
  m:on_step(function() lowest = math.min(lowest, held.uz) end)
  m:run { duration = 1.5 }
  near(held.uz, -1000*g/1e7, 1e-2)
  near(lowest, -1000*g/1e7, 1e-2)
end

local function says(text, f)
  local ok, message = pcall(f)
  assert(not ok and tostring(message):find(text, 1, true), tostring(message) .. "\nbut not: " .. text)
end
local m, block = block_on_ground(0.4, 1e9, { 1, 0.8, 0.1 })
says("pushover: 'direction' is 'up', must be one of x, -x, y, -y, z, -z",
  function() m:pushover { body = block, direction = "up", rate = 1e-3, displacement = 1e-3 } end)
says("push: body 'ground' is held or driven in the direction in which it is to be pushed",
  function() m:pushover { body = "ground", rate = 1e-3, displacement = 1e-3 } end)
says("pressure: 'face' is missing; give top, bottom, left, right, front, back or all",
  function() m:pressure { body = block, value = 1 } end)
says("pressure: 'face' is 'side', must be", function() m:pressure { body = block, face = "side", value = 1 } end)
says("pressure: unknown key 'from'",
  function() m:pressure { body = block, face = "top", from = { 0, 0 }, value = 1 } end)
says("release: body 'block' is free already in z, so there is nothing to release",
  function() m:release { body = block, z = true } end)
local ball = m:sphere { name = "ball", radius = 0.1, at = { 2, 2, 1 }, material = "stone", floating = true }
says("pressure: no plane face of 'ball' points to the top within 45 degrees",
  function() m:pressure { body = ball, face = "top", value = 1 } end)

-- Equilibrium path of two bars that snap through (von Mises truss), rotated about the vertical. The force has its
-- extremes at the maximum of 2 EA (L - l)/L h/l over the height h, and at the opposite value.
for _, angle in ipairs { 0, 0.7 } do
  local s = trilith.model { name = "toggle", dim = 3, gravity = 0 }
  s:material { name = "steel", density = 7850, E = 2e11, nu = 0 }
  local x, y, section = math.cos(angle), math.sin(angle), trilith.rectangle_section { width = 0.02, depth = 0.02 }
  local foot = { x = "fixed", y = "fixed", z = "fixed" }
  s:frame { name = "toggle", material = "steel",
    joints = { a = { at = { -x, -y, 0 }, support = foot }, c = { at = { x, y, 0 }, support = foot },
      b = { at = { 0, 0, 0.1 },
        support = { x = "fixed", y = "fixed", rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" } } },
    members = { { from = "a", to = "b", section = section, pinned = { "from", "to" }, divisions = 2 },
      { from = "c", to = "b", section = section, pinned = { "from", "to" }, divisions = 2 } } }
  local r = s:pushover { body = "toggle", at = { 0, 0, 0.1 }, direction = "-z", control = "arc", arc = 2e-4,
    displacement = 0.21, samples = 2000 }
  local length, highest = math.sqrt(1.01), 0
  for i = 0, 1000 do
    local h = 1e-4*i
    local l = math.sqrt(1 + h*h)
    highest = math.max(highest, 2*2e11*4e-4*(length - l)/length*h/l)
  end
  assert(#r.limits == 2 and r.limits[1].highest and not r.limits[2].highest)
  assert(math.abs(r.limits[1].force/highest - 1) < 1e-3, r.limits[1].force)
  assert(math.abs(r.limits[2].force/highest + 1) < 1e-3, r.limits[2].force)
  local _, _, z = s:body "toggle":point "b"
  assert(r.limit == "displacement" and z < -0.1, z)
  s:close()
end

-- A force on a meshed body without `at`, or at its "centroid", is distributed as its mass: a free body moves by F
-- t^2/2m without strain.
do
  local bits = {}
  for i, at in ipairs { "none", "centroid" } do
    local s = trilith.model { name = "spread", dim = 3, gravity = 0 }
    s:material { name = "soft", density = 2000, E = 1e8, nu = 0.2 }
    local b = s:block { name = "b", size = { 1, 0.6, 0.4 }, material = "soft", floating = true,
      body = { mesh = { 3, 2, 2 } } }
    s:point_load { body = b, force = { 30, -20, 10 }, at = at ~= "none" and at or nil }
    s:run { duration = 0.1 }
    local t = s.time
    near(b.ux, 30*t^2/2/b.mass, 1e-2)
    near(b.uy, -20*t^2/2/b.mass, 1e-2)
    assert(math.abs(b.ux/b.uy + 1.5) < 1e-9 and math.abs(b.uz/b.ux - 1/3) < 1e-9)
    local x = b:point { 1, 0.3, 0.2 }
    assert(math.abs(x - 1 - b.ux) < 1e-9, x - 1 - b.ux) -- no strain
    bits[i] = s.hash
    s:close()
  end
  assert(bits[1] == bits[2])
end

-- A joint's name is accepted as the point of loads and pushes.
do
  local bits = {}
  for i, at in ipairs { "b", { 0, 0, 2 } } do
    local s = trilith.model { name = "post", dim = 3, gravity = 0 }
    s:material { name = "steel", density = 7850, E = 2e11, nu = 0.3 }
    s:frame { name = "f", material = "steel", joints = { a = { at = { 0, 0, 0 }, support = "fixed" }, b = { 0, 0, 2 } },
      members = { { from = "a", to = "b", section = trilith.rectangle_section { width = 0.1, depth = 0.1 } } } }
    s:point_load { body = "f", at = at, force = { 1e3, 0, 0 } }
    s:run { duration = 1e-3 }
    s:pushover { body = "f", at = at, direction = "y", rate = 1, displacement = 1e-3 }
    bits[i] = s.hash
    s:close()
  end
  assert(bits[1] == bits[2])
end

-- A force at a point of a meshed body is distributed to the nodes of the element that contains it. On the axis of a bar
-- it causes no lateral displacement; displacements are reciprocal (Betti); a point outside of the body is rejected.
local function bar(at, force)
  local s = trilith.model { name = "bar", dim = 3, gravity = 0 }
  s:material { name = "soft", density = 2000, E = 1e9, nu = 0 }
  local b = s:block { name = "bar", material = "soft", size = { 1, 1, 4 }, floating = true,
    body = { mesh = { 2, 2, 8 } }, hold = { { from = { 0, 0, 0 }, to = { 1, 1, 0 } } } }
  s:point_load { body = b, at = at, force = force }
  s:consolidate { integrator = "static" }
  return b, s
end
local function moved(b, at)
  local x, y, z = b:point(at)
  return { x - at[1], y - at[2], z - at[3] }
end
do
  local b, s = bar({ 0.5, 0.5, 2 }, { 0, 0, 1e4 })
  local here, left, right = moved(b, { 0.5, 0.5, 2 }), moved(b, { 0, 0.5, 2 }), moved(b, { 1, 0.5, 2 })
  assert(math.abs(here[1]) < 1e-9*here[3] and math.abs(here[2]) < 1e-9*here[3])
  near(left[3], right[3], 1e-6)
  near(moved(b, { 0.5, 0.5, 4 })[3], 1e4*2/1e9, 0.02) -- F z/EA of the part below the load
  s:close()
  local one, other = { 0.2, 0.1, 3.9 }, { 1, 0.6, 2.3 }
  b, s = bar(one, { 0, 0, 100 })
  local there = moved(b, other)[1]
  s:close()
  b, s = bar(other, { 100, 0, 0 })
  near(moved(b, one)[3], there, 1e-4)
  s:close()
  local good, message = pcall(bar, { 100, 0, 0 }, { 0, 0, 1e4 })
  assert(not good and message:find("the point (100, 0, 0) is not in 'bar', which deforms", 1, true), message)
end

-- A push at a point of this body as well: at the middle of a free end it causes no twist.
for _, control in ipairs { "time", "arc" } do
  local s = trilith.model { name = "bar", dim = 3, gravity = 0 }
  s:material { name = "soft", density = 2000, E = 1e9, nu = 0, beta = 1e-3 }
  local b = s:block { name = "bar", material = "soft", size = { 1, 1, 4 }, floating = true,
    body = { mesh = { 1, 1, 4 } }, hold = { { from = { 0, 0, 0 }, to = { 1, 1, 0 } } } }
  s:pushover { body = b, at = { 0.5, 0.5, 4 }, direction = "x", control = control, displacement = 4e-3,
    rate = control == "time" and 0.02 or nil }
  local left, right = moved(b, { 0, 0, 4 }), moved(b, { 1, 0, 4 })
  assert(math.abs(left[2] - right[2]) < 1e-9, left[2] - right[2])
  local way = moved(b, { 0.5, 0.5, 4 })[1]
  assert(way > 4e-3 - 1e-9 and way < 5e-3, way) -- by arc length up to the first point beyond
  local good, message = pcall(s.pushover, s, { body = b, at = { 100, 0, 0 }, direction = "x", rate = 1,
    displacement = 1e-3 })
  assert(not good and message:find("the point (100, 0, 0) is not in 'bar'", 1, true), message)
  s:close()
end
