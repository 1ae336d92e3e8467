-- Head-on collisions: restitution, duration and depth of a damped contact; pounding of two masses.
local trilith = require "trilith"

-- Restitution of a contact whose total stress is never a tension.
local function clipped(zeta)
  local s = math.sqrt(1 - zeta^2)
  return math.exp(-zeta/s*(math.pi - math.atan(2*zeta*s, 1 - 2*zeta^2)))
end

local function bounce(p)
  local mass = p.other and p.mass*p.other/(p.mass + p.other) or p.mass
  local kn = 1e8
  local w = math.sqrt(kn/mass)
  local m = trilith.model { name = "bounce", gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = 0, mu = 0, beta = 2*p.zeta/w } }
  local below = m:block { name = "below", width = 1, height = 1, at = { 0, -1 }, mass = p.other or 1000,
    material = "stone", support = not p.other and "fixed" or nil, floating = p.other and true or nil }
  local above = m:block { name = "above", width = 1, height = 1, at = { 0, 0 }, mass = p.mass, velocity = { 0, -1 },
    material = "stone", floating = true }
  local loaded, deepest, speed = 0, 0, -1
  m:run { duration = 4/w, dt = 5e-4/w, until_true = function()
    if above.vy ~= speed then loaded = loaded + m.dt end
    speed = above.vy
    deepest = math.max(deepest, below.uy - above.uy)
    return false
  end }
  return above, below, w*loaded, w*deepest
end

local cases = {}
for _, row in ipairs { { 0.02, 3.1022, 0.96945 }, { 0.05, 3.0454, 0.92669 }, { 0.1, 2.9561, 0.86260 },
  { 0.2, 2.7954, 0.75613 }, { 0.3, 2.6545, 0.67155 }, { 0.5, 2.4184, 0.54629 } } do
  cases[#cases + 1] = {
    name = ("bounce_%.0f"):format(100*row[1]), title = "block on a fixed base",
    parameters = { { "zeta", row[1] }, { "mass", 1000, "kg" } },
    checks = { { "restitution", exact = clipped(row[1]), tolerance = 0.005 },
      { "duration times omega", exact = row[2], tolerance = 0.005 },
      { "depth times omega over speed", exact = row[3], tolerance = 0.005 } },
    run = function(p)
      local above, _, duration, deepest = bounce(p)
      return { restitution = above.vy, ["duration times omega"] = duration, ["depth times omega over speed"] = deepest }
    end,
  }
end
cases[1].plot = function()
  local zeta, e, ours, at = {}, {}, {}, {}
  for i = 0, 50 do zeta[i + 1], e[i + 1] = i*0.01, clipped(i*0.01) end
  for i = 0, 5 do
    at[i + 1] = i*0.1
    ours[i + 1] = bounce { zeta = i*0.1, mass = 1000 }.vy
  end
  return { title = "Restitution of a damped contact", x_label = "damping ratio", y_label = "restitution",
    { name = "exact", kind = "dashed", x = zeta, y = e }, { name = "computed", kind = "points", x = at, y = ours } }
end

for _, row in ipairs { { 1, 0, -1/3, 2/3 }, { 0.65, 0.149939, -0.10, 0.55 } } do
  cases[#cases + 1] = {
    name = ("collision_%.0f"):format(100*row[1]), title = "1 t at 1 m/s on 2 t at rest",
    parameters = { { "restitution", row[1] }, { "zeta", row[2] }, { "mass", 1000, "kg" }, { "other", 2000, "kg" } },
    checks = { { "speed of 1 t", unit = "m/s", exact = row[3], tolerance = 0.01 },
      { "speed of 2 t", unit = "m/s", exact = row[4], tolerance = 0.01 } },
    run = function(p)
      local above, below = bounce(p)
      return { ["speed of 1 t"] = -above.vy, ["speed of 2 t"] = -below.vy }
    end,
  }
end

-- A pounding element between two masses, with a gap.
local function pounding(p, pull)
  local m = trilith.model { name = "pounding", gravity = 0 }
  m:material { name = "steel", density = 7850 }
  m:contact { between = { "*", "*" }, law = "none" }
  local left = m:block { name = "left", width = 1, height = 1, at = { -2, 0 }, mass = 2e5, material = "steel",
    velocity = { 0.6, 0 }, support = { y = "fixed", rotation = "fixed" }, floating = true }
  local right = m:block { name = "right", width = 1, height = 1, at = { 1, 0 }, mass = 1e5, material = "steel",
    velocity = { -0.2, 0 }, support = { y = "fixed", rotation = "fixed" }, floating = true }
  local law = p.zeta and trilith.gap { stiffness = 2e8, opening = 0.01, damping = 2*p.zeta*math.sqrt(2e8*2e5/3),
      side = -1, pull = pull }
    or trilith.pounding { stiffness = 2e8, opening = 0.01, restitution = p.restitution, mass = 2e5/3, pull = pull }
  m:bearing { name = "bumper", between = { "left", "right" }, from = { -1, 0.5 }, to = { 1, 0.5 }, along = law }
  local touched, left_at, deepest, force, force_at
  deepest, force = 0, 0
  m:run { duration = 0.1, dt = 2e-6, until_true = function()
    local depth = left.ux - right.ux - 0.01
    if depth > 0 then
      touched, left_at = touched or m.time, m.time
    end
    local f = math.abs(m.bearings.bumper.force_along)
    if f > force then force, force_at = f, m.time end
    deepest = math.max(deepest, depth)
    return false
  end }
  return { ["first touch"] = touched, ["duration"] = left_at and left_at - touched, ["deepest"] = deepest,
    ["largest force"] = force, ["time of the largest force"] = force_at and force_at - touched,
    ["left after"] = left.vx, ["right after"] = right.vx }
end
cases[#cases + 1] = {
  name = "pounding_pull", title = "200 t at 0.6 m/s on 100 t at -0.2 m/s; the dashpot may pull",
  parameters = { { "zeta", 0.135851 }, { "gap", 0.01, "m" }, { "k", 2e8, "N/m" } },
  checks = { { "first touch", unit = "s", exact = 0.0125, tolerance = 0.005 },
    { "duration", unit = "s", exact = 0.057894, tolerance = 0.005 },
    { "deepest", unit = "m", exact = 0.0119978, tolerance = 0.005 },
    { "largest force", unit = "N", exact = 2.4909e6, tolerance = 0.005 },
    { "time of the largest force", unit = "s", exact = 0.02141, tolerance = 0.01 },
    { "left after", unit = "m/s", exact = 0.16, tolerance = 0.005 },
    { "right after", unit = "m/s", exact = 0.68, tolerance = 0.005 } },
  run = function(p) return pounding(p, 1) end,
}
for _, e in ipairs { 0.4, 0.5, 0.65, 0.8 } do
  cases[#cases + 1] = {
    name = ("pounding_%.0f"):format(100*e), title = "trilith.pounding of a given restitution",
    parameters = { { "restitution", e } },
    checks = { { "restitution found", exact = e, tolerance = 0.005 } },
    run = function(p)
      local found = pounding(p, 0)
      return (found["right after"] - found["left after"])/0.8
    end,
  }
end
for _, row in ipairs { { 0.354508, 0.4 }, { 0.074355, 0.8 } } do
  cases[#cases + 1] = {
    name = ("pounding_zeta_%.0f"):format(100*row[2]), title = "gap with a dashpot that does not pull",
    parameters = { { "zeta", row[1] } },
    checks = { { "restitution found", exact = row[2], tolerance = 0.005 } },
    run = function(p)
      local found = pounding(p, 0)
      return (found["right after"] - found["left after"])/0.8
    end,
  }
end

return {
  title = "Collisions and pounding",
  source = "Derived: a mass on a spring and a dashpot that part when the total force is zero; Anagnostopoulos " ..
    "(1988), " ..
    "Earthquake Engineering and Structural Dynamics 16, for the element that may pull",
  formula = [[e = \exp\left[-\frac{\zeta}{s}\left(\pi - \operatorname{atan2}(2\zeta s, 1 - 2\zeta^2)\right)\right],
\quad
s = \sqrt{1 - \zeta^2}, \qquad e_\text{pull} = \exp\left(-\frac{\pi\zeta}{s}\right)]],
  text = "Contact laws reduce the total stress to zero at most. The element `trilith.gap` may also pull.",
  cases = cases,
}
