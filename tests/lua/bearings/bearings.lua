-- Bearings, seats and their failures; events and causes.
local trilith = require "trilith"
local m = trilith.model { name = "span" }
m:material { name = "concrete", unit_weight = 24e3 }
m:contact { between = { "concrete", "concrete" },
  law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.3, beta = 1e-3 } }
m:ground { name = "ground", surface = { { -10, 0 }, { 30, 0 } }, base_level = -2, material = "concrete",
  support = "fixed" }
local P1 = m:pier { name = "P1", station = 0, height = 5, stem_width = 2, material = "concrete" }
local P2 = m:pier { name = "P2", station = 12, height = 5, stem_width = 2, material = "concrete" }
local span = m:span { name = "S1", x0 = 0, x1 = 12, soffit_level = 5, depth = 1, material = "concrete" }
local slide = trilith.frictional { name = "slide", kn = 1e9, ks = 5e8, mu = 0.05, beta = 1e-3 }
local fixed = trilith.linear { stiffness = 5e7, damping = 1e5 }
local left = m:bearing { name = "S1.left", between = { P1, span }, at = { 0.5, 5 }, along = fixed, axial = fixed,
  limit = { along = 0.001 }, becomes = slide }
local right = m:bearing { name = "S1.right", between = { "P2", "S1" }, at = { 11.5, 5 }, along = fixed, axial = fixed }
local seat = m:seat { name = "S1.seat", body = span, support = P1, at_end = { 0, 5 }, edge = { 1, 5 },
  inward = { -1, 0 } }
assert(m.bearings["S1.left"] == left and m.bearings[2] == right and #m.bearings == 2 and m.seats[1] == seat)

local report = m:consolidate { duration = 20 }
assert(report.rests and left.status == "intact" and left.bodies[2] == span)
local weight = 24e3 * 12
local carried = -left.force_axial - right.force_axial
for _, contact in ipairs(m:contacts { between = { span, P1 + P2 } }) do carried = carried + contact.normal end
assert(math.abs(carried - weight) < 1e-3 * weight, carried)
assert(math.abs(left.displacement.axial - left.displacement_axial) == 0 and left.force.along == left.force_along)
assert(math.abs(seat.length - 1) < 0.01 and not seat.lost)

local seen = {}
m:on("bearing.failed", function(e)
  seen.failed = e
  assert(e.bearing == left and e.body == P1 and e.bodies[2] == span and e.value > 0.001)
  assert(tostring(e):find "S1.left failed")
end)
m:on("bearing.changed", function(e) seen.changed = e end)
m:on("*", function(e) seen[#seen + 1] = e.type end)
local share = m:history { name = "share", bearing = "S1.left", what = "share" }
m:drive { body = P1, x = trilith.motion { velocity = -0.5, duration = 1 } }
m:run { duration = 1.5 }
assert(left.status == "changed", left.status)
assert(seen.failed and seen.changed and seen.changed.id > seen.failed.id and seen.changed.cause == seen.failed.id)
assert(seen[1] == "stage.begun" and seen[#seen] == "stage.ended")
assert(share.max > 0.9)

-- A seat without `inward` starts at the edge and points to the body's end, on either side, also in space.
for _, side in ipairs { -1, 1 } do
  local w = trilith.model { name = "seats" }
  w:material { name = "s", density = 2500 }
  w:contact { between = { "*", "*" }, law = slide }
  w:block { name = "a", width = 2, height = 2, at = { side - 1, -2 }, material = "s", support = "fixed" }
  w:block { name = "b", width = 1, height = 1, at = { side*0.2 - 0.5, 0.01 }, material = "s", floating = true }
  local own = w:seat { name = "L", body = "b", support = "a", at_end = { side*0.3, 0.01 }, edge = { 0, 0 } }
  w:run { duration = 1e-3 }
  assert(math.abs(own.length - 0.3) < 1e-5 and not own.lost, own.length)
  local u = trilith.model { name = "seats", dim = 3 }
  u:material { name = "s", density = 2500 }
  u:contact { between = { "*", "*" }, law = slide }
  u:block { name = "a", size = { 2, 2, 2 }, at = { -1, side - 1, -2 }, material = "s", support = "fixed" }
  u:block { name = "b", size = { 1, 1, 1 }, at = { -0.5, side*0.2 - 0.5, 0.01 }, material = "s", floating = true }
  own = u:seat { name = "L", body = "b", support = "a", at_end = { 0, side*0.3, 0.01 }, edge = { 0, 0, 0 } }
  u:run { duration = 1e-3 }
  assert(math.abs(own.length - 0.3) < 1e-5 and not own.lost, own.length)
end

-- The successor of a bearing must be able to act: not the bearing itself, no bearing that already acts, no cycle.
-- Checked in the plane, in space, and for bearings added to a model that has run.
local function rejects(text, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(text, 1, true), tostring(message) .. " does not say: " .. text)
end
for _, dim in ipairs { 2, 3 } do
  for _, later in ipairs { false, true } do
    for _, case in ipairs { "itself", "one that is live", "ring", "chain" } do
      local b = trilith.model { name = case, dim = dim, gravity = 0 }
      b:contact { between = { "*", "*" }, law = "none" }
      b:material { name = "s", density = 1000 }
      local function stone(name, x, support)
        if dim == 2 then
          return b:block { name = name, width = 1, height = 1, at = { x, 0 }, material = "s", support = support,
            floating = not support }
        end
        return b:block { name = name, size = { 1, 1, 1 }, at = { x, 0, 0 }, material = "s", support = support,
          floating = not support }
      end
      local pair = { stone("a", -2, "fixed"), stone("b", 0) }
      if later then b:run { duration = 0.01 } end
      local function link(name, becomes, waiting)
        return b:bearing { name = name, between = pair, at = dim == 2 and { -0.5, 0.5 } or { -0.5, 0.5, 0.5 },
          along = trilith.linear { stiffness = 1e4 }, limit = becomes and { along = 0.01 }, becomes = becomes,
          waiting = waiting }
      end
      local function go()
        if case == "one that is live" then link "y" end
        if case == "ring" then link("y", "z", true) link("z", "y", true) end
        if case == "chain" then link("y", "z", true) link("z", nil, true) end
        link("x", case == "itself" and "x" or "y")
        b:run { duration = 0.01 }
      end
      if case == "chain" then
        if not later then go() end
      elseif later and case ~= "one that is live" then
        rejects("bearing '", go)
      else
        rejects(case == "itself" and "bearing 'x': becomes itself, which has failed by then"
          or case == "ring" and "bearing 'y': becomes 'z', which leads back to 'y'"
          or "bearing 'x': becomes 'y', which is active from the start", go)
      end
      b:close()
    end
  end
end

-- A bearing that replaces the flat contact of its bodies must carry load instead of it; a note reports a missing law.
for _, axial in ipairs { false, true } do
  local b = trilith.model { name = "stood for" }
  b:material { name = "stone", density = 2000 }
  b:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.5, beta = 1e-4 } }
  b:block { name = "base", width = 1, height = 1, at = { 0, -1 }, material = "stone", support = "fixed" }
  b:block { name = "top", width = 1, height = 1, material = "stone" }
  b:bearing { name = "k", between = { "base", "top" }, at = { 0.5, 0 }, along = trilith.linear { stiffness = 1e7 },
    axial = axial and trilith.linear { stiffness = 1e8 } or nil, replaces_contact = true }
  b:run { duration = 1e-3 }
  local said = #b.notes > 0 and b.notes[1]:find("bearing 'k': replaces_contact removes", 1, true) ~= nil
  assert(said == not axial, table.concat(b.notes, "\n"))
  b:close()
end
