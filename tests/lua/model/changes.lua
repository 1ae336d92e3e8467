-- Models changed by a script: parts are removed, reactivated and added, between stages and from handlers.
local trilith = require "trilith"
local g = 9.80665
local function near(a, b, share) assert(math.abs(a - b) <= share*math.abs(b), a .. " is not " .. b) end
local function fails(f, text)
  local ok, message = pcall(f)
  assert(not ok, "should fail: " .. text)
  assert(tostring(message):find(text, 1, true), tostring(message) .. " does not say: " .. text)
end

local function tower(out)
  local m = trilith.model { name = "tower" }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, name = "joint",
    law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 2e-4 } }
  m:block { name = "ground", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
  m:block { name = "lower", width = 1, height = 0.5, at = { -0.5, 0 }, material = "stone" }
  m:block { name = "upper", width = 1, height = 0.5, at = { -0.5, 0.5 }, material = "stone" }
  if out then m:results { file = out, frames = 0.05 } end
  return m
end
local function calm(m) return m:run { duration = 5, local_damping = 0.8, rest = { ratio = 1e-5, from = 0.1 } } end

-- Removed below another block, which falls by the removed height and comes to rest on the ground.
local out = os.tmpname()
os.remove(out)
local m = tower(out .. ".h5")
m:consolidate { rest = { ratio = 1e-6 } }
local lower, upper = m:body "lower", m:body "upper"
m:remove(lower)
assert(not lower.present and lower.removed_at == m.time)
assert(#m:bodies { name = "*er" } == 1)
fails(function() return lower.x end, "body 'lower' was removed at")
fails(function() m:remove(lower) end, "remove: body 'lower' was removed at")
fails(function() m:point_load { body = lower, force = { 0, 1 } } end, "was removed at")
fails(function() m:remove "lowest" end, "there is no body or group 'lowest'")
fails(function() m:remove {} end, "remove: nothing is given")
fails(function() m:put_back(upper) end, "put_back: body 'upper' is present")
calm(m)
near(upper.y, 0.25, 1e-3)
assert(m.energy.removed ~= 0)

-- New bodies, laws, histories, a bearing; rejected ones leave the model unchanged.
fails(function() m:block { name = "inside", width = 1, height = 0.5, at = { -0.4, 0.1 }, material = "stone" } end,
  "overlap by")
fails(function() m:block { name = "high", width = 1, height = 0.5, at = { -0.4, 3 }, material = "stone" } end,
  "has no support")
m:material { name = "lead", density = 11000 }
m:contact { between = { "lead", "stone" }, law = trilith.frictional { kn = 2e9, ks = 1e9, mu = 0.1, beta = 1e-4 } }
local weight = m:block { name = "weight", width = 0.5, height = 0.2, at = { -0.25, 0.5001 }, material = "lead" }
local h = m:history { name = "sinking", body = weight, what = "uy" }
calm(m)
near(weight.y, 0.6, 1e-3)
assert(h.values[1] ~= h.values[1] or #h.values > 0)
local held = m:contacts { between = { weight, upper } }
near(held[1].force[2], weight.mass*g, 1e-2)
local tie = m:bearing { name = "tie", between = { upper, weight }, at = { 0, 0.5 },
  along = trilith.linear { stiffness = 1e6 }, axial = trilith.linear { stiffness = 1e6 } }
assert(tie.status == "intact" and math.abs(tie.force_along) < 1)
m:change { bearing = "tie", along = trilith.linear { stiffness = 2e6 }, limit = { along = 0.1 } }
m:run { duration = 0.05 }
m:remove(tie)
assert(tie.status == "removed" and tie.force_along == 0)
fails(function() m:remove(tie) end, "bearing 'tie' was removed already")
m:put_back(tie)
assert(tie.status == "intact")
fails(function() m:put_back(tie) end, "bearing 'tie' is present")

-- From handlers: changes act at the step border and are reported as events; a handler removes itself; a function ends a
-- stage.
local seen, calls = {}, 0
m:on("body.removed", function(e) seen[#seen + 1] = e.body.name end)
m:on("bearing.removed", function(e) seen[#seen + 1] = e.bearing.name end)
local every
every = m:every(0.01, function()
  calls = calls + 1
  if calls ~= 3 then return end
  m:off(every)
  m:remove(weight)
  assert(weight.present) -- until the step border
  local late = m:block { name = "late", width = 0.5, height = 0.2, at = { 1, 0.0001 }, material = "lead" }
  assert(not late.present)
  fails(function() return late.x end, "is added at the next step border")
end)
local report = m:run { duration = 1, until_true = function() return m.time > 1 and not weight.present end }
assert(report.ending == "stopped" and report.reason == "until_true became true")
-- The removal between the stages was reported first, then the removal of the body together with its bearing.
assert(calls == 3 and table.concat(seen, " ") == "tie weight tie", table.concat(seen, " "))
fails(function() m:off(every) end, "is off already")
fails(function() m:off "x" end, "off: takes the handler")
calm(m)
near(m:body("late").y, 0.1, 1e-2)

-- Handlers of a single body, and with a threshold.
m:on({ "impact", above = 1e3 }, function() error "nothing hits that hard" end)
fails(function() m:on({ "impact", bodi = "late" }, print) end, "on: unknown key 'bodi'; did you mean 'body'?")
fails(function() m:on({ body = "late" }, print) end, "on: give an event first")
fails(function() m:on({ "impact", body = "lat" }, print) end, "there is no body 'lat'")

-- A body removed in its own event.
local dropped = m:block { name = "dropped", width = 0.3, height = 0.3, at = { -2, 0.5 }, material = "stone",
  floating = true }
local own, others = 0, 0
m:on({ "impact", body = dropped }, function() own = own + 1 end)
m:on({ "impact", body = upper }, function() others = others + 1 end)
m:on("impact", function(e) if e.body == dropped or e.bodies[2] == dropped then m:remove(dropped) end end)
m:run { duration = 0.6 }
assert(dropped.removed_at and not dropped.present)
assert(own == 1 and others == 0, own .. " " .. others)
m:close()

os.remove(out .. ".h5")

-- A stage ends as the tower collapses.
local t = tower()
t:consolidate { rest = { ratio = 1e-6 } }
t:every(0.1, function(model) if model:body("lower").present then model:remove "lower" end end)
local fall = t:run { duration = 5, until_collapse = { drop = 0.2 } }
assert(fall.ending == "stopped" and fall.collapsed == true and fall.reason:find "collapse", fall.reason)
assert(t:run { duration = 1e-3, until_collapse = { drop = 100 } }.collapsed == false)
fails(function() t:run { duration = 1, until_collapse = 3 } end, "until_collapse")
fails(function() t:run { duration = 1, until_true = 3 } end, "until_true")
fails(function() t:run { duration = 1, ["until"] = print } end, "'until' is a word of Lua; write until_true")
-- A second removal of the same body in one step is rejected at the border.
t:every(0.01, function(model) model:remove "upper"; model:remove "upper" end)
fails(function() t:run { duration = 1 } end, "body 'upper' was removed at")

-- Functions end a pushover too.
local p = tower()
p:consolidate { rest = { ratio = 1e-6 } }
local pushed = p:pushover { body = "upper", rate = 1e-3, displacement = 1, local_damping = 0.8,
  until_true = function(model) return model:body("upper").ux > 1e-3 end }
assert(pushed.ending == "stopped" and pushed.limit == "until" and pushed.reason == "until_true became true",
  pushed.limit)
near(p:body("upper").ux, 1e-3, 1e-2)

-- The same in space.
local file = os.tmpname()
os.remove(file)
local s = trilith.model { name = "space", dim = 3 }
s:material { name = "stone", density = 2000 }
s:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.6, beta = 1e-3 } }
s:block { name = "ground", size = { 6, 6, 1 }, at = { -3, -3, -1 }, material = "stone", support = "fixed" }
s:block { name = "lower", size = { 1, 1, 0.5 }, at = { -0.5, -0.5, 0 }, material = "stone" }
s:block { name = "upper", size = { 1, 1, 0.5 }, at = { -0.5, -0.5, 0.5 }, material = "stone" }
s:results { file = file .. ".h5" }
s:consolidate { rest = { ratio = 1e-4 } }
s:remove "lower"
fails(function() return s:body("lower").z end, "was removed at")
calm(s)
near(s:body("upper").z, 0.25, 1e-2)
local third = s:block { name = "third", size = { 1, 1, 0.5 }, at = { -0.5, -0.5, 0.5001 }, material = "stone" }
calm(s)
near(third.z, 0.75, 1e-2)
s:remove(third)
s:put_back(third)
assert(third.present and not third.removed_at)
s:run { duration = 0.1 }
near(third.z, 0.75, 1e-2)
s:close()
os.remove(file .. ".h5")

-- The successor of a bearing can be changed: a waiting bearing, a contact law, none again.
do
  local b = trilith.model { name = "spare" }
  b:material { name = "stone", density = 2400 }
  b:contact { between = { "*", "*" }, name = "rough",
    law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.6, beta = 1e-3 } }
  local post = b:block { name = "post", width = 0.2, height = 3, at = { -1, 0 }, material = "stone", support = "fixed" }
  local hung = b:block { name = "hung", width = 0.2, height = 0.2, at = { -0.1, 1 }, material = "stone",
    floating = true }
  local spring = trilith.linear { stiffness = 1e6, damping = 1e4 }
  local function hang(name, waiting)
    return b:bearing { name = name, between = { post, hung }, from = { -0.9, 1.1 }, to = { 0, 1.1 }, waiting = waiting,
      along = spring, axial = spring, turning = spring }
  end
  local first, spare = hang("first"), hang("spare", true)
  b:run { duration = 0.2 }
  fails(function() b:change { bearing = "first", becomes = "first" } end, "bearing 'first' does not wait")
  fails(function() b:change { bearing = "first", becomes = "smooth" } end, "no contact law and no bearing 'smooth'")
  fails(function() b:change { bearing = "first", becomes = true } end, "must be the name of a contact law")
  b:change { bearing = "first", becomes = "rough" }
  b:change { bearing = "first", becomes = false }
  b:change { bearing = "first", becomes = spare, limit = { axial = 1e-5 } }
  b:run { duration = 0.2 }
  assert(first.status ~= "intact" and spare.status == "intact", first.status .. " " .. spare.status)
  assert(hung.y > 1.09)
end

-- A body added after long steps falls as if the run began with it, and a flying body continues: both follow their
-- parabolas, which central differences reproduce at any step.
for _, dim in ipairs { 2, 3 } do
  local falling = trilith.model { name = "fall", dim = dim }
  falling:material { name = "stone", density = 2000 }
  falling:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5 } }
  local function stone(name, x, height)
    if dim == 2 then
      return falling:block { name = name, width = 1, height = 1, at = { x, height }, material = "stone",
        floating = true }
    end
    return falling:block { name = name, size = { 1, 1, 1 }, at = { x, 0, height }, material = "stone", floating = true }
  end
  local function height_of(b) return dim == 2 and b.y or b.z end
  local first = stone("first", 0, 100)
  local from = height_of(first)
  falling:run { duration = 0.5 }
  local second = stone("second", 5, 100)
  falling:run { duration = 0.7 }
  near(from - height_of(first), 0.5*g*1.2^2, 1e-10)
  near(from - height_of(second), 0.5*g*0.7^2, 1e-10)
  assert(math.abs(falling.energy.residual) < 1e-6*falling.energy.kinetic, falling.energy.residual)
end

-- A released body falls as if the run began with it: after long steps, in a handler, released or reactivated, by
-- explicit and implicit steps. A driven body continues at its speed at the release; the support has put in this energy.
-- Other flying bodies are not affected.
local function free_model(dim, gravity)
  local free = trilith.model { name = "free", dim = dim, gravity = gravity }
  free:contact { between = { "*", "*" }, law = "none" }
  free:material { name = "stone", density = 1000 }
  local function stone(name, x, how)
    how.name, how.material = name, "stone"
    if dim == 2 then
      how.width, how.height, how.at = 1, 1, { x, 0 }
    else
      how.size, how.at = { 1, 1, 1 }, { x, 0, 0 }
    end
    return free:block(how)
  end
  return free, stone
end
local function fallen(b, dim) return dim == 2 and -b.uy or -b.uz end
for _, dim in ipairs { 2, 3 } do
  for _, how in ipairs { "free", "release", "put back", "handler", "implicit" } do
    local free, stone = free_model(dim)
    local waits = stone("held", 0, { support = how ~= "put back" and "fixed" or nil, floating = how == "put back" })
    local flying = stone("flying", 5, { floating = true })
    local integrator = how == "implicit" and "implicit" or nil
    local from, lost = nil, 0
    if how == "put back" then free:remove(waits) end
    if how == "handler" then
      free:every(0.1, function()
        if from then return end
        from = free.time
        free:free(waits)
      end)
    else
      free:run { duration = 0.2, integrator = integrator }
      from = free.time
      if how ~= "put back" then lost = fallen(waits, dim) end
      if how == "release" then free:release { body = waits, fade = 0 }
      elseif how == "put back" then free:put_back(waits)
      else free:free(waits) end
    end
    local stage = free:run { duration = 0.7, integrator = integrator }
    assert(stage.ending == "time", how)
    near(fallen(waits, dim) - lost, 0.5*g*(free.time - from)^2, 1e-10)
    near(fallen(flying, dim), 0.5*g*free.time^2, 1e-10)
    assert(math.abs(free.energy.added) < 1e-9*free.energy.kinetic, free.energy.added)
    free:close()
  end

  -- The only body of its model, so the energies are its own.
  local lone, only = free_model(dim)
  local waits = only("held", 0, { support = "fixed" })
  lone:run { duration = 0.2 }
  lone:free(waits)
  assert(lone:run { duration = 1 }.ending == "time")
  near(fallen(waits, dim), 0.5*g, 1e-10)
  lone:close()

  for _, integrator in ipairs { "explicit", "implicit" } do
    -- From a motion with constant acceleration: x = a t^2/2 at 3 m/s2.
    local thrown, stone_of = free_model(dim, 0)
    local body = stone_of("thrown", 0, { support = "fixed" })
    thrown:drive { body = body, x = trilith.motion { dt = 1, acceleration = { 3, 3, 3 }, allow_drift = true } }
    thrown:run { duration = 0.5, integrator = integrator }
    near(thrown.time, 0.5, 1e-12)
    thrown:free(body)
    thrown:run { duration = 1, integrator = integrator }
    near(body.vx, 1.5, 1e-9)
    near(body.ux, 0.5*3*0.25 + 1.5, 1e-9)
    near(thrown.energy.support, 0.5*1000*1.5^2, 1e-9)
    near(thrown.energy.kinetic, 0.5*1000*1.5^2, 1e-9)
    assert(math.abs(thrown.residual) < 1e-9*thrown.energy.kinetic, thrown.residual)

    -- Fixing or driving a moving body removes its kinetic energy from the ledger, and releasing it at rest adds none.
    for _, by in ipairs { "fix", "drive" } do
      local stopped, make = free_model(dim, 0)
      local a = make("a", 0, { floating = true, velocity = dim == 2 and { 2, 0 } or { 2, 0, 0 } })
      make("b", 9, { floating = true })
      stopped:run { duration = 0.1, integrator = integrator }
      if by == "fix" then stopped:fix(a) end
      if by == "drive" then stopped:drive { body = a, x = trilith.ramp { by = 0.1, duration = 0.1 } } end
      stopped:run { duration = 0.2, integrator = integrator }
      near(stopped.energy.removed, 2000, 1e-9)
      assert(math.abs(stopped.residual) < 1e-6, stopped.residual)
      stopped:free(a)
      stopped:run { duration = 0.2, integrator = integrator }
      assert(math.abs(a.vx) < 1e-9 and math.abs(stopped.residual) < 1e-6, stopped.residual)
      stopped:close()
    end
  end
end

-- A body that has come to rest, is fixed and released again stays at rest: its contact sees no displacement, and the
-- contact's energy returns to the ledger.
do
  local bed = trilith.model { name = "bed" }
  bed:material { name = "stone", density = 2000 }
  bed:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5 } }
  local base = bed:block { name = "base", width = 10, height = 1, at = { -5, -1 }, material = "stone",
    support = "fixed" }
  local lying = bed:block { name = "lying", width = 1, height = 1, at = { -0.5, 0 }, material = "stone" }
  bed:consolidate { rest = { ratio = 1e-8 } }
  bed:fix(lying)
  bed:run { duration = 0.01 }
  local residual, y = bed.residual, lying.y
  bed:free(lying)
  bed:run { duration = 0.2 }
  assert(math.abs(lying.y - y) < 1e-9 and math.abs(lying.ux) < 1e-9)
  assert(math.abs(bed.residual - residual) < 1e-6, bed.residual - residual)
  assert(base.present)
end

-- Inconsistent numbers of a law are rejected, and the law is unchanged.
do
  local w = trilith.model { name = "mortar" }
  w:material { name = "stone", density = 2000 }
  w:contact { between = { "*", "*" }, name = "mortar", law = trilith.cohesive { kn = 1e9, ks = 5e8, mu = 0.5,
    cohesion = 1e5, tension = 5e4, energy_tension = 20, energy_shear = 50 } }
  w:block { name = "ground", width = 6, height = 1, at = { -3, -1 }, material = "stone", support = "fixed" }
  w:block { name = "b", width = 1, height = 1, material = "stone" }
  w:run { duration = 1e-3 }
  fails(function() w:change { law = "mortar", tension = 1e6 } end, "energy_tension is 20 J/m2, must be above")
  w:change { law = "mortar", mu = 0.6 } -- would be rejected as well if the tension had been changed
end

-- A part is not reactivated into occupied space: the change is rejected as for an added part, and the model is
-- unchanged.
for _, dim in ipairs { 2, 3 } do
  local taken = trilith.model { name = "taken", dim = dim }
  taken:material { name = "stone", density = 2400 }
  taken:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5, beta = 2e-4 } }
  local function block(name, x, size, support)
    if dim == 2 then
      return taken:block { name = name, width = size, height = size, at = { x, support and -size or 0 },
        material = "stone", support = support }
    end
    return taken:block { name = name, size = { size, size, size }, at = { x, x, support and -size or 0 },
      material = "stone", support = support }
  end
  block("ground", -2, 4, "fixed")
  local first = block("first", -0.5, 1)
  taken:run { duration = 0.01 }
  taken:remove(first)
  local second = block("second", -0.5, 1)
  taken:run { duration = 0.01 }
  local hash, kinetic = taken.hash, taken.energy.kinetic
  fails(function() taken:put_back(first) end,
    "put_back: bodies 'first' and 'second' overlap by 1 m at their new position")
  assert(not first.present and taken.hash == hash and taken.energy.kinetic == kinetic)
  taken:remove(second)
  taken:put_back(first)
  taken:run { duration = 0.1 }
  assert(first.present and math.abs(first.ux) < 1e-6)
  -- Two bodies reactivated together keep their positions.
  taken:remove(first)
  taken:put_back { first }
  assert(first.present)
end
