-- Bearings and seats of models in space: by single direction and for both horizontal directions at once; failures;
-- readings.
local trilith = require "trilith"

local function near(value, expected, relative)
  if math.abs(value - expected) > relative*math.abs(expected) then
    error(("%.9g, expected %.9g"):format(value, expected), 2)
  end
end

--- A block of 1000 kg on a bearing 0.1 m high over a fixed base.
local function isolated(bearing, contact)
  local m = trilith.model { name = "isolated", dim = 3 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:material { name = "stone", density = 1000 }
  if contact then m:contact { between = { "*", "*" }, law = contact } end
  local base = m:block { name = "base", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
  local top = m:block { name = "top", size = { 1, 1, 1 }, at = { -0.5, -0.5, 0.1 }, material = "stone",
    support = { rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" } }
  bearing.name, bearing.between = bearing.name or "b", { base, "top" }
  if not bearing.at then bearing.from, bearing.to = { 0, 0, 0 }, { 0, 0, 0.1 } end
  return m, m:bearing(bearing), top
end
local stiff = trilith.linear { stiffness = 1e7, damping = 1e4 }

-- Names, numbers, histories. At rest it carries the weight; its axes may be rotated.
do
  local m, b, top = isolated { along = trilith.linear { stiffness = 2e5 }, across = trilith.linear { stiffness = 1e5 },
    axial = stiff, angle = math.pi/2, limit = { along = 0.3, horizontal = 0.4 } }
  m:seat { name = "edge", body = top, support = "base", at_end = { 0, 0, 0.1 }, edge = { 0, 2, 0 },
    inward = { 0, -1, 0 } }
  local h = m:history { name = "h", bearing = b, what = "force_horizontal" }
  m:history { name = "t", bearing = "b", what = "turning_axial" }
  m:consolidate { rest = { ratio = 1e-6 } }
  assert(m.bearings.b == b and m.bearings[1] == b and #m.bearings == 1 and b.status == "intact" and b.limited)
  assert(b.bodies[1].name == "base" and b.bodies[2] == top)
  near(-b.force_axial, 1000*9.80665, 1e-4)
  near(m.seats.edge.length, 2, 1e-9)
  m:drive { body = top, x = trilith.ramp { by = 0.02, duration = 1 }, y = trilith.ramp { by = 0.01, duration = 1 } }
  m:run { duration = 1 }
  -- Rotated by 90 degrees: along is y and across is -x.
  near(b.displacement_along, 0.01, 1e-3)
  near(b.displacement_across, -0.02, 1e-3)
  near(b.force_along, 2e5*0.01, 1e-3)
  near(b.force_across, -1e5*0.02, 1e-3)
  near(b.force.across, b.force_across, 0)
  near(b.displacement.along, b.displacement_along, 0)
  near(b.force_horizontal, 2e3*2^0.5, 1e-3)
  near(b.displacement_horizontal, 0.01*5^0.5, 1e-3)
  near(b.share, 0.01*5^0.5/0.4, 1e-3)
  assert(b.displacement.turning_along == 0 and b.moment_across == 0)
  near(h.values[#h.values], b.force_horizontal, 2e-2)
  assert(not pcall(function() return b.turning end) and not pcall(function() return b.moment end))
end

-- A friction circle: pulled at 45 degrees the slider carries mu N, and each component its share.
do
  local m, b, top = isolated { horizontal = trilith.friction { mu = 0.1, stiffness = 1e7 }, axial = stiff }
  local yielded
  m:on("bearing.yielded", function(e) yielded = e.bearing == b and e.z end)
  m:consolidate { rest = { ratio = 1e-6 } }
  m:drive { body = top, x = trilith.ramp { by = 0.1, duration = 1 }, y = trilith.ramp { by = 0.1, duration = 1 } }
  m:run { duration = 1 }
  near(b.force_horizontal, 0.1*1000*9.80665, 1e-3)
  near(b.force_along, b.force_across, 1e-6)
  assert(yielded and b.status == "yielded")
end

-- A bearing without a limit gets a note, one with a limit of the resultant does not.
do
  local endless = isolated { horizontal = trilith.linear { stiffness = 1e5 }, axial = stiff }
  assert(endless:lint().text:find "bearing 'b' has no limit, so it never fails", endless:lint().text)
  local ended = isolated { horizontal = trilith.linear { stiffness = 1e5 }, axial = stiff, limit = { horizontal = 1 } }
  assert(not ended:lint().text:find "has no limit", ended:lint().text)
end

-- Past the limit of the resultant it fails; the block drops onto the base and slides on by the successor law.
do
  local slide = trilith.frictional { name = "slide", kn = 1e8, ks = 5e7, mu = 0.1, beta = 1e-3 }
  local m, b, top = isolated({ horizontal = trilith.linear { stiffness = 1e5 }, axial = stiff,
    limit = { horizontal = 0.05 }, becomes = slide },
    trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 1e-3 })
  local failed, changed
  m:on("bearing.failed", function(e) failed = e end)
  m:on("bearing.changed", function(e) changed = e end)
  m:consolidate { rest = { ratio = 1e-6 } }
  m:drive { body = top, x = trilith.ramp { by = 0.06, duration = 1 }, y = trilith.ramp { by = 0.06, duration = 1 } }
  m:run { duration = 2 }
  near(failed.value, 0.05, 1e-2)
  assert(failed.bearing == b and changed and changed.text:find "base and top touch by slide", changed and changed.text)
  assert(b.status == "changed" and b.force_horizontal == 0)
  local contacts = m:contacts()
  assert(#contacts == 1, #contacts)
  near(contacts[1].normal, 1000*9.80665, 1e-2)
  near(top.uz, -0.1, 1e-2)
end

-- An event reports the displacement in the direction that yielded, for each direction.
for _, case in ipairs {
  { "horizontal", 0 }, { "horizontal", 30 }, { "horizontal", 90 }, { "across", 90 }, { "axial" },
} do
  local direction, azimuth = table.unpack(case)
  local s = trilith.model { name = "pulled", dim = 3, gravity = 0 }
  s:material { name = "stone", density = 1000 }
  s:contact { between = { "*", "*" }, law = "none" }
  s:block { name = "g", size = { 1, 1, 1 }, material = "stone", support = "fixed" }
  s:block { name = "b", size = { 1, 1, 1 }, at = { 0, 0, 2 }, material = "stone", support = "fixed" }
  s:bearing { name = "q", between = { "g", "b" }, at = { 0.5, 0.5, 1.5 },
    [direction] = trilith.elastic_plastic { stiffness = 1e6, yield = 2e4, hardening = 0.1 } }
  local value
  s:on("bearing.yielded", function(e) value = e.value end)
  local a = math.rad(azimuth or 0)
  local way = azimuth and { math.cos(a), math.sin(a), 0 } or { 0, 0, 1 }
  local function ramp(k)
    if math.abs(way[k]) > 1e-9 then return trilith.ramp { by = 0.1*way[k], duration = 1 } end
  end
  s:drive { body = "b", x = ramp(1), y = ramp(2), z = ramp(3) }
  s:run { duration = 1, dt = 1e-3 }
  assert(value and math.abs(value - 0.02) < 3e-4, ("%s, %s: %s"):format(direction, azimuth, value))
  s:close()
end

-- A bearing may be changed between stages: twice the stiffness gives half the displacement, also for the horizontal
-- directions together, and a limit ends it.
for _, direction in ipairs { "along", "horizontal" } do
  local s = trilith.model { name = "hung", dim = 3, gravity = 0 }
  s:material { name = "stone", density = 1000 }
  s:contact { between = { "*", "*" }, law = "none" }
  s:block { name = "g", size = { 1, 1, 1 }, material = "stone", support = "fixed" }
  local b = s:block { name = "b", size = { 1, 1, 1 }, at = { 0, 0, 2 }, material = "stone", support = {
    y = "fixed", z = "fixed", rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" } }
  local q = s:bearing { name = "q", between = { "g", "b" }, at = { 0.5, 0.5, 1.5 },
    [direction] = trilith.linear { stiffness = 1e5 } }
  s:point_load { body = b, force = { 1e3, 0, 0 } }
  s:consolidate { integrator = "static" }
  near(b.ux, 1e-2, 1e-6)
  s:change { bearing = "q", [direction] = trilith.linear { stiffness = 2e5 } }
  s:consolidate { integrator = "static" }
  near(b.ux, 5e-3, 1e-6)
  s:change { bearing = "q", limit = { [direction] = 4e-3 } }
  s:run { duration = 0.01 }
  assert(q.status == "failed", q.status)
  local good, message = pcall(s.change, s, { bearing = "q", limit = { [direction] = -1 } })
  assert(not good and message:find("change: bearing 'q': limit displacement is -1, must be above 0", 1, true), message)
  s:close()
end

-- Messages.
local function says(text, f)
  local good, message = pcall(f)
  assert(not good and message:find(text, 1, true), text .. "\nwas: " .. tostring(message))
end
local function refused(text, bearing)
  says(text, function() isolated(bearing) end)
end
local soft = trilith.linear { stiffness = 1e5 }
refused("bearing 'b': has no law, so it transfers no force; give along, across, horizontal or axial a law", {})
refused("unknown key 'turning'; known: name, between", { along = soft, turning = soft })
refused("friction slides under the compression of the axial law, which is missing",
  { horizontal = trilith.friction { mu = 0.1, stiffness = 1e6 } })
refused("'horizontal' is 5, must be a direction law", { horizontal = 5 })
refused("horizontal is gap, which has no circular form for both directions",
  { horizontal = trilith.gap { stiffness = 1e5, opening = 0 } })
refused("both horizontal and along or across are given", { horizontal = soft, across = soft })
refused("limit displacement is -1, must be above 0", { along = soft, limit = { across = -1 } })
refused("unknown key 'turning'", { along = soft, limit = { turning = 1 } })
refused("both angle and turn are given", { along = soft, angle = 1, turn = { axis = { 1, 0, 0 }, angle = 1 } })
refused("must be {x, y, z}, three finite numbers", { along = soft, at = { 1, 2 } })
refused("its point (0, 0, 90) is", { along = soft, at = { 0, 0, 90 } })
refused("becomes 'next' at its limit, but has none", { along = soft, becomes = "next" })
says("seat 's': length of the inward direction", function()
  local m = isolated { along = soft, axial = stiff }
  m:seat { name = "s", body = "top", support = "base", at_end = { 0, 0, 0.1 }, edge = { 0, 2, 0 },
    inward = { 0, 0, 0 } }
end)
