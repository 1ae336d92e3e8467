-- Histories, events and times of a pushover by arc length: the path is a stage like others, in the plane and in space.
local trilith = require "trilith"
local near = dofile "near_expected.lua"

local function post(dim)
  local m = trilith.model { name = "cantilever", dim = dim }
  m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
  local hinge = trilith.end_hinge { sagging = 1e5, hardening = 1e5, across = dim == 3 and 2e5 or nil }
  local body = m:beam { name = "post", from = dim == 2 and { 0, 0 } or { 0, 0, 0 },
    to = dim == 2 and { 0, 3 } or { 0, 0, 3 }, material = "steel", from_support = "fixed",
    section = trilith.rectangle_section { width = 0.1, depth = 0.2 }, from_hinge = hinge }
  return m, body, dim == 2 and { 0, 3 } or { 0, 0, 3 }
end

-- A load in the middle of its ramp, and a motion too, are unchanged afterwards: the path takes no model time.
local function waits(m)
  m:contact { between = { "*", "*" }, law = "none" }
  local other = m:block { name = "other", width = 1, height = 1, at = { 20, 0 }, material = "steel", support = "fixed" }
  m:drive { body = other, x = trilith.ramp { by = 0.2, duration = 4 } }
  m:run { duration = 2, local_damping = 0.8 }
  return other
end

for _, dim in ipairs { 2, 3 } do
  for _, driven in ipairs { false, true } do
    if dim == 2 or not driven then
      local m, body, top = post(dim)
      local other = driven and waits(m)
      local seen, stepped = {}, {}
      m:on("member.yielded", function(e)
        seen[#seen + 1] = { time = e.time, cause = e.cause, force = m.push_force }
      end)
      local push = m:history { name = "push", what = "push_force" }
      local moved = m:history { name = "moved", what = "push_displacement" }
      m:consolidate { integrator = "static" }
      m:on_step(function() stepped[#stepped + 1] = m.time end)
      local begun, place, speed = m.time, other and other.ux, other and other.vx
      local samples = #push.values
      local r = m:pushover { body = body, at = top, control = "arc", displacement = 0.1 }
      near("duration", r.ended - r.begun, 1, 1e-12)
      assert(r.begun == begun and m.time == r.ended)
      -- Histories contain the curve: in the same order, at increasing times.
      local curve = r.curve
      assert(#push.values - samples == #curve.force + 1, #push.values - samples .. " samples")
      for i, force in ipairs(curve.force) do
        near("force", push.values[samples + i], force, 1e-9)
        assert(math.abs(moved.values[samples + i] - curve.displacement[i]) < 1e-9)
        assert(math.abs(push.t[samples + i] - curve.t[i]) < 1e-9)
        assert(i == 1 or curve.t[i] > curve.t[i - 1])
      end
      for i = samples + 2, #push.t do assert(push.t[i] > push.t[i - 1]) end
      near("force at the end", m.push_force, r.force, 1e-6)
      near("displacement at the end", m.push_displacement, r.displacement, 1e-6)
      near("largest in the history", push.max, r.peak_force, 1e-6)
      -- The event is at the yielding of the hinge: at M/L, between the adjacent points, during the path, caused by the
      -- stage.
      assert(#seen == 1, #seen .. " events")
      near("force as it yields", seen[1].force, 1e5/3, 0.1)
      assert(seen[1].time > begun and seen[1].time < r.ended and seen[1].cause)
      assert(#stepped > #curve.force)
      if other then
        near("motion", other.ux, place, 1e-9)
        near("speed", other.vx, speed, 1e-9)
        local said = table.concat(m.notes, "; ")
        assert(said:find("motions and loads in progress are suspended for the 1 s", 1, true), said)
        m:release { load = "pushover", fade = 0.1 }
        m:run { duration = 2.1, local_damping = 0.8 }
        near("motion at its end", other.ux, 0.2, 1e-9)
        assert(math.abs(m.push_force) < 1e-6)
      end
      m:remove "pushover"
      assert(m.push_force == 0 and m.push_displacement == 0)
      m:close()
    end
  end
end

-- A handler's requests take effect after the stage; a handler that fails leaves the model at the path's end.
local m, body, top = post(2)
m:contact { between = { "*", "*" }, law = "none" }
local extra = m:block { name = "extra", width = 1, height = 1, at = { 20, 0 }, material = "steel", support = "fixed" }
m:consolidate { integrator = "static" }
m:on("member.yielded", function() m:remove(extra) end)
m:pushover { body = body, at = top, control = "arc", displacement = 0.05 }
assert(not extra.present)
m:on_step(function() error "no more" end)
local ok = pcall(m.pushover, m, { name = "further", body = body, at = top, control = "arc", displacement = 0.01 })
assert(not ok and math.abs(m.push_displacement) > 0.009)
