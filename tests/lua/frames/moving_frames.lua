-- Implicit steps with an accuracy do not depend on the observer. A frame on a base with constant velocity, and two
-- masses on a spring that drift through space without support, oscillate as at rest and with the same number of steps.
local trilith = require "trilith"

local function frame_at(V)
  local m = trilith.model { name = "frame" }
  m:material { name = "steel", density = 2000, E = 5e8, nu = 0.2, beta = 1e-4 }
  m:contact { between = { "*", "*" }, law = "none" }
  local section = trilith.rectangle_section { width = 0.1, depth = 0.05 }
  local b = m:frame { name = "frame", material = "steel", velocity = { V, 0 },
    joints = { p = { at = { -0.5, 0 }, support = "fixed" }, q = { -0.5, 2 }, r = { 0.5, 2 },
               s = { at = { 0.5, 0 }, support = "fixed" } },
    members = { { from = "p", to = "q", section = section, divisions = 2 },
                { from = "q", to = "r", section = section, divisions = 2 },
                { from = "r", to = "s", section = section, divisions = 2 } } }
  if V ~= 0 then m:drive { body = b, x = trilith.motion { velocity = V, duration = 5 } } end
  m:point_load { name = "p", body = b, at = "q", force = { 20, 0 } }
  local path = {}
  m:every(0.02, function() path[#path + 1] = (b:point "q") - V*m.time end)
  local r = m:run { duration = 0.3, integrator = "implicit", dt = 5e-3, accuracy = 1e-3 }
  m:close()
  return path, r.steps
end

local function masses_at(V, dim)
  local m = trilith.model { name = "masses", dim = dim, gravity = 0 }
  m:material { name = "steel", density = 1000 }
  m:contact { between = { "*", "*" }, law = "none" }
  local function block(name, x, v)
    local velocity = dim == 2 and { V + v, 0 } or { V + v, 0, 0 }
    local o = { name = name, material = "steel", velocity = velocity, floating = true }
    if dim == 2 then o.width, o.height, o.at = 1, 1, { x, 0 } else o.size, o.at = { 1, 1, 1 }, { x, 0, 0 } end
    return m:block(o)
  end
  local a, b = block("a", 0, 0.1), block("b", 2, -0.1)
  local spring = trilith.linear { stiffness = 1e5 }
  local bearing = { name = "spring", between = { a, b }, at = dim == 2 and { 1.5, 0.5 } or { 1.5, 0.5, 0.5 },
                    along = spring, axial = spring }
  if dim == 3 then bearing.across = spring end
  m:bearing(bearing)
  local path, x0 = {}, a.x
  m:every(0.05, function() path[#path + 1] = a.x - x0 - V*m.time end)
  local r = m:run { duration = 0.6, integrator = "implicit", accuracy = 1e-3 }
  m:close()
  return path, r.steps
end

local function same(of, ...)
  local rest, steps = of(0, ...)
  local swing = 0
  for _, x in ipairs(rest) do swing = math.max(swing, math.abs(x - rest[1])) end
  assert(swing > 0)
  for _, V in ipairs { 1, 3, 30 } do
    local moving, n = of(V, ...)
    assert(n == steps, ("%d steps at %g m/s, %d at rest"):format(n, V, steps))
    for i, x in ipairs(rest) do
      assert(math.abs(moving[i] - x) < 1e-6*swing, ("at %g m/s off by %g of %g m"):format(V, moving[i] - x, swing))
    end
  end
end

same(frame_at)
same(masses_at, 2)
same(masses_at, 3)
