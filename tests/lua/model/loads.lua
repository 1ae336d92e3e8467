-- Loads over time, ramps, quiet release and pushover from a script, and rejected input.
local trilith = require "trilith"
local g = 9.80665
local function near(a, b, share) assert(math.abs(a - b) <= share * math.abs(b), a .. " is not " .. b) end

local function block_on_base(mu, kn)
  local m = trilith.model { name = "m" }
  m:material { name = "stone", density = 2000 }
  local k = kn or 1e9
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = k, ks = k, mu = mu, beta = 1e-4 } }
  local base = m:block { name = "base", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
  local block = m:block { name = "block", width = 1, height = 0.5, at = { -0.5, 0 }, material = "stone" }
  m:consolidate { rest = { ratio = 1e-7 } }
  return m, block, base
end
local function rest(m) return m:run { duration = 5, local_damping = 0.8, rest = { ratio = 1e-6, from = 0.3 } } end

-- An eccentric load; after its removal the block stands as before.
local m, block = block_on_base(0.6)
local weight, y = block.mass * g, block.y
local name = m:point_load { body = block, at = "top right", force = { 0, -900 }, load_curve = { smooth = 0.2 } }
assert(name == "load 1")
rest(m)
near(y - block.y, 900 / 1e9, 1e-3)
near(block.rotation, -900 * 0.5 / (1e9 / 12), 1e-3)
m:set_load { name = name, factor = 0.5, duration = 0.1 }
rest(m)
near(y - block.y, 450 / 1e9, 1e-3)
m:release { load = name, fade = 0.2 }
rest(m)
assert(math.abs(block.y - y) < 1e-11 and math.abs(block.rotation) < 1e-11)

-- A pressure on the side appears as reaction of the base, in the ledger and as stress of the block.
local e = m.energy.load
local ux = block.ux
local p = m:pressure { name = "wind", body = block, face = "left", value = 2e3,
                       load_curve = { { 0, 0 }, { 0.1, 1.5 }, { 0.2, 1 } } }
assert(p == "wind")
rest(m)
near(m.base_shear, 2e3 * 0.5, 1e-3)
assert(m.energy.load > e and block.ux > ux)
m:pressure { name = "anchor", body = block, from = { 0.5, 0 }, to = { 0.5, 0.5 }, value = 2e3,
             load_curve = { ramp = 0.2 } }
rest(m)
assert(math.abs(m.base_shear) < 1)
near(m:stresses().block.xx, -2e3, 1e-2)

-- A ramp moves a driven body to its end and no farther.
local ramp = trilith.ramp { by = 0.01, duration = 0.4 }
assert(ramp.duration == 0.4 and select(2, ramp:at(0.5)) == 0)
m:drive { body = "base", x = ramp }
m:run { duration = 0.3 }
assert(m:body("base").ux < 0.01 and m:body("base").vx > 0)
m:run { duration = 0.2 }
near(m:body("base").ux, 0.01, 1e-12)
assert(m:body("base").vx == 0)

-- Pushover: friction in either direction; the same bits twice; drift limit; quiet end.
local hashes = {}
for i, direction in ipairs { "x", "-x", "x" } do
  local n, b = block_on_base(0.4)
  local r = n:pushover { body = b, direction = direction, rate = 1e-3, displacement = 4e-3 }
  near(r.curve.force[100], 0.4 * weight, 1e-3)
  near(r.peak_force, 0.4 * weight, 0.01)
  near(r.curve.displacement[#r.curve.t], 4e-3, 1e-2)
  near(n.base_shear, (direction == "x" and 1 or -1) * n.push_force, 1e-3)
  near(n.push_displacement, 4e-3, 1e-6)
  assert(r.limit == "displacement" and r.ending == "time" and #r.curve.t >= 200)
  hashes[i] = n.hash
  n:release { push = "pushover", fade = 0.2 }
  assert(rest(n).rests and math.abs(n.base_shear) < 1 and n.push_force == 0)
end
assert(hashes[1] == hashes[3] and hashes[1] ~= hashes[2])

-- A wall of two storeys, pushed at its slabs up to a drift of the top, then released quietly.
local w = trilith.model { name = "wall", thickness = 0.2 }
w:material { name = "brick", density = 1800 }
w:contact { between = { "*", "*" },
            law = trilith.bonded { kn = 1e10, ks = 4e9, mu = 0.6, cohesion = 2e5, tension = 1e5, beta = 2e-5 } }
w:wall { name = "w", length = 1.6, unit_length = 0.4, unit_height = 0.2, storeys = 2, storey_height = 0.8,
         slab_height = 0.2, base_height = 0.5, material = "brick", fixed = "base",
         by_group = { slabs = { weight = 1e4 } } }
local shear = w:history { name = "base shear", what = "base_shear" }
local pushed = w:history { name = "push", what = "push_force" }
w:consolidate { rest = { ratio = 1e-5 } }
local slabs = w:bodies { group = "slabs" }
local most, felt = 0, 0
w:on_step(function()
  if w.push_force > most then most, felt = w.push_force, w.base_shear end
end)
local r = w:pushover { body = slabs, pattern = "triangle", rate = 4e-3, drift = 2e-3 }
local mean = 0 -- the largest of the curve's mean forces, over all points except the peak
for _, force in ipairs(r.curve.force) do
  if force < r.peak_force then mean = math.max(mean, force) end
end
assert(r.limit == "drift" and r.ending == "stopped")
near(r.drift, 2e-3, 0.05)
assert(r.peak_force > 5e3 and r.drift_at_peak < 2e-3 and r.peak_force >= r.force)
near(shear.max, mean, 0.1)
assert(pushed.max > 0.9 * mean)
assert(most == r.peak_force and r.carried_at_peak <= felt*(1 + 1e-9))
w:release { push = "pushover", fade = 0.3 }
assert(rest(w).rests and math.abs(w.base_shear) < 5)
assert(math.abs(w.energy.residual) < 0.01 * w.energy.load)

-- A fixed body is released quietly: it settles on its springs without oscillation.
local q = trilith.model { name = "q" }
q:material { name = "stone", density = 2000 }
q:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e7, ks = 1e7, mu = 0.5, beta = 1e-6 } }
q:block { name = "base", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
local held = q:block { name = "held", width = 1, height = 0.5, at = { -0.5, 0 }, material = "stone", support = "fixed" }
q:run { duration = 0.01 }
q:release { body = held, fade = 1 }
local lowest = 0
q:on_step(function() lowest = math.min(lowest, held.uy) end)
q:run { duration = 1.5 }
near(held.uy, -1000 * g / 1e7, 1e-2)
near(lowest, -1000 * g / 1e7, 1e-2)

-- Loads within a stage, from a handler.
local h, stone = block_on_base(0.6)
h:story(function() h:wait(0.05) h:point_load { name = "late", body = stone, force = { 100, 0 } } end)
h:run { duration = 1, name = "with a load" }
assert(h.energy.load > 0)

-- Rejected input.
local function refused(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(text, 1, true), tostring(message))
end
local function load(o) o.body = o.body or "block" return m:point_load(o) end
local function press(o) o.body = o.body or "block" return m:pressure(o) end
refused("point_load: gives neither a force nor a moment", load, {})
refused("point_load 'P': body: there is no body or group 'blok'; did you mean 'block'?", load,
        { name = "P", body = "blok", force = { 1, 0 } })
refused("point_load: 'at' is 'topp', must be {x, y}, the name of a joint or one of centroid, top", load,
        { force = { 1, 0 }, at = "topp" })
refused("point_load: unknown key 'follows'; did you mean 'follow'?", load, { force = { 1, 0 }, follows = true })
refused("load_curve: give one of ramp = seconds, smooth = seconds, or points", load,
  { force = { 1, 0 }, load_curve = {} })
refused("load_curve: its duration is -1 s, must be above 0", load, { force = { 1, 0 }, load_curve = { ramp = -1 } })
refused("time 2 of the load curve is", load, { force = { 1, 0 }, load_curve = { { 1, 0 }, { 0, 1 } } })
refused("pressure: give either face = \"top\"", press, { value = 1 })
refused("'face' is 'topp', must be top, bottom, left, right or all; did you mean 'top'?", press,
        { value = 1, face = "topp" })
refused("pressure: 'value' is missing; give a number in Pa", press, { face = "top" })
refused("pressure: the point (7, 0) is", press, { value = 1, from = { 7, 0 }, to = { 0.5, 0.5 } })
refused("set_load: there is no load 'wimd'; did you mean 'wind'?", m.set_load, m, { name = "wimd", factor = 1 })
refused("release: give one of body, load (its name) and push (its name)", m.release, m, { fade = 1 })
refused("release: 'fade' is -1 s, must not be below 0", m.release, m, { body = "block", fade = -1 })
refused("ramp: the duration is 0 s", trilith.ramp, { by = 1, duration = 0 })
refused("ramp: the distance is 0, so nothing would move", trilith.ramp, { by = 0, duration = 1 })
refused("pushover: 'displacement' is missing; give a number in m", m.pushover, m, { body = "block", rate = 1 })
refused("pushover: 'rate' is -1 m/s, must be above 0; the direction sets the sign", m.pushover, m,
        { body = "block", rate = -1, displacement = 1 })
refused("push: body 'base' is held or driven in the direction in which it is to be pushed", m.pushover, m,
        { body = "base", rate = 1, displacement = 1 })
refused("pushover: 'drop' is 2, must be at least 0 and below 1", m.pushover, m,
        { body = "block", rate = 1, displacement = 1, drop = 2 })
refused("pushover: there are no storeys; leave 'storey' out", m.pushover, m,
        { body = "block", rate = 1, displacement = 1, storey = 1 })

-- A joint's name is accepted as the point of loads and pushes.
do
  local bits = {}
  for i, at in ipairs { "b", { 0, 2 } } do
    local s = trilith.model { name = "post", gravity = 0 }
    s:material { name = "steel", density = 7850, E = 2e11, nu = 0.3 }
    s:frame { name = "f", material = "steel", joints = { a = { at = { 0, 0 }, support = "fixed" }, b = { 0, 2 } },
      members = { { from = "a", to = "b", section = trilith.rectangle_section { width = 0.1, depth = 0.1 } } } }
    s:point_load { body = "f", at = at, force = { 1e3, 0 } }
    s:run { duration = 1e-3 }
    s:pushover { body = "f", at = at, rate = 1, displacement = 1e-3 }
    bits[i] = s.hash
    s:close()
  end
  assert(bits[1] == bits[2])
end

-- A point of a body can be pushed although a node next to it is fixed, if the node has no part in this point. A free
-- joint of a column is pushed with the column's stiffness, and so is a corner of a quad whose neighbour on the same
-- side is fixed.
do
  local height, E, I = 4, 2.1e11, 2e-5
  for divisions = 1, 2 do
    local c = trilith.model { name = "cantilever", gravity = 0 }
    c:material { name = "steel", density = 7850, E = E, nu = 0.3 }
    local column = c:frame { name = "f", material = "steel", floating = true,
      joints = { A = { at = { 0, 0 }, support = "fixed" }, B = { 0, height } },
      members = { { name = "c", from = "A", to = "B", divisions = divisions,
        section = trilith.section { area = 5e-3, inertia = I, depth = 0.2 } } } }
    local path = c:pushover { body = column, at = { 0, height }, control = "arc", displacement = 1e-3 }
    local steps = #path.curve.displacement
    near(path.curve.force[steps]/path.curve.displacement[steps], 3*E*I/height^3, 1e-3)
    c:close()
  end
  local panel = trilith.model { name = "quad", gravity = 0 }
  panel:material { name = "stone", density = 2400, E = 1e9, nu = 0.2 }
  local quad = panel:block { name = "q", width = 1, height = 2, material = "stone", body = "quad", floating = true,
    hold = { { from = { 0, 0 }, to = { 1, 0 } } } }
  refused("push: body 'q' is held or driven in the direction", panel.pushover, panel,
    { body = quad, at = { 0, 1 }, control = "arc", displacement = 1e-3 })
  assert(panel:pushover { body = quad, at = { 0, 2 }, control = "arc", displacement = 1e-3 }.limit == "displacement")
  panel:close()
end

-- Loads act alike in the plane and in space: between stages, from a handler, and after a rewind.
for _, dim in ipairs { 2, 3 } do
  local l = trilith.model { name = "loads", gravity = 0, dim = dim }
  l:material { name = "stone", density = 2000 }
  local a = dim == 2 and l:block { name = "a", width = 1, height = 0.5, material = "stone", floating = true }
    or l:block { name = "a", size = { 1, 1, 0.5 }, material = "stone", floating = true }
  l:point_load { name = "push", body = a, at = "centroid", force = dim == 2 and { 1e3, 0 } or { 1e3, 0, 0 } }
  l:pressure { name = "wind", body = a, face = "bottom", value = 1e3 }
  l:checkpoints { every = 0.05 }
  local up = dim == 2 and "vy" or "vz"
  l:run { duration = 0.1, dt = 1e-3 }
  local along, speed = a.vx, a[up]
  near(along, 1e3/a.mass*0.0995, 1e-9)
  refused("remove: there is no body or group 'pusch', and no bearing or load; did you mean 'push'?", l.remove, l,
    "pusch")
  refused("known: a, push, wind", l.remove, l, "nothing like it")
  refused("put_back: load 'push' is a load; apply a new one", l.put_back, l, "push")
  l:remove { "push", "push" }
  refused("there is no body or group 'push'", l.remove, l, "push")
  l:run { duration = 0.1 }
  near(a.vx, along, 1e-12)
  local steady = a.vx
  assert(a[up] > 1.8*speed)
  local gone = 0
  l:every(0.05, function(model)
    gone = gone + 1
    if gone == 1 then model:remove "wind" end
  end)
  l:run { duration = 0.2 }
  assert(gone > 1 and a.vx == steady, a.vx - steady)
  local coast = a[up]
  l:run { duration = 0.1 }
  assert(a[up] == coast)
  -- Restored with the earlier state.
  local hash
  for _ = 1, 2 do
    l:rewind(l.time - 0.04)
    local before, from = a.vx, l.time
    assert(from < 0.1)
    l:run { duration = 0.1, dt = 1e-3 }
    near(a.vx - before, 1e3/a.mass*(l.time - from), 1e-9)
    assert(not hash or l.hash == hash)
    hash = l.hash
  end
  l:pushover { name = "pushed", body = a, direction = "x", rate = 1, displacement = 0.01 }
  refused("remove: 'pushed' is a push; use m:release { push = \"pushed\" }", l.remove, l, "pushed")
  l:close()
end
