-- Rigid bodies in space that crack at planes: a rod that spins about an oblique axis, a chimney that falls over its
-- corner direction, and sections under bending about two axes and torsion.
local trilith = require "trilith"
local deg = trilith.units "deg"
local sin, cos, sqrt = trilith.math.sin, trilith.math.cos, math.sqrt

local function brittle(tension)
  return trilith.bonded { kn = 1e11, ks = 5e10, mu = 0.6, tension = tension, cohesion = 20*tension }
end

local function dot(a, b) return a[1]*b[1] + a[2]*b[2] + a[3]*b[3] end
local function cross(a, b)
  return { a[2]*b[3] - a[3]*b[2], a[3]*b[1] - a[1]*b[3], a[1]*b[2] - a[2]*b[1] }
end
local function scaled(s, a) return { s*a[1], s*a[2], s*a[3] } end
local function unit(a) return scaled(1/sqrt(dot(a, a)), a) end

-- Three axes at right angles, oblique to the axes of the model: along a rod, and across it.
local along = unit { 2, -1, 2 }
local across = unit(cross(along, { 0.3, 0.2, 1 }))
local third = cross(along, across)
local function at(r, s, t)
  local out = {}
  for k = 1, 3 do out[k] = r*along[k] + s*across[k] + t*third[k] end
  return out
end

-- The corners of a bar along the oblique axes, from `from` to `to` along it.
local function bar(from, to, width)
  local hull = {}
  for _, r in ipairs { from, to } do
    for _, s in ipairs { -width/2, width/2 } do
      for _, t in ipairs { -width/2, width/2 } do hull[#hull + 1] = at(r, s, t) end
    end
  end
  return hull
end

local function rod_limit(p) return sqrt(8*p.tension/2400) end

local function rod_spins(p)
  local m = trilith.model { name = "rod", dim = 3, gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = brittle(p.tension), name = "plane" }
  local spin = p.share*rod_limit(p)
  m:body { name = "rod", hull = bar(-0.5, 0.5, 0.1), material = "stone", spin = scaled(spin, across), floating = true,
    cracks = "mid", crack_law = "plane" }
  local cracks = 0
  m:on("unit.cracked", function() cracks = cracks + 1 end)
  m:run { duration = 0.01 }
  local out = { rod = cracks > 0 and "parts" or "holds" }
  if cracks == 0 then return out end
  local a, b = m:body "rod.a", m:body "rod.b"
  local sum = { a.vx + b.vx, a.vy + b.vy, a.vz + b.vz }
  out["speed of a half"] = b.speed/(spin/4)
  out["change of momentum"] = sqrt(dot(sum, sum))/(spin/4)
  return out
end

-- A chimney on a ball joint, which falls in a direction that is oblique to its sides.
local function chimney(p)
  local length, width, tilt = 6, 0.5, 2*deg
  local m = trilith.model { name = "chimney", dim = 3 }
  m:material { name = "brick", density = 2000 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:contact { between = { "shaft", "shaft" }, law = brittle(p.tension), name = "plane" }
  local fall = { cos(p.direction*deg), sin(p.direction*deg) }
  local up = { sin(tilt)*fall[1], sin(tilt)*fall[2], cos(tilt) }
  local out_of = { cos(tilt)*fall[1], cos(tilt)*fall[2], -sin(tilt) }
  local side = { -fall[2], fall[1], 0 }
  local turn = p.direction*deg
  local hull = {}
  for _, z in ipairs { 0, length } do
    for _, x in ipairs { -width/2, width/2 } do
      for _, y in ipairs { -width/2, width/2 } do
        local f, s = x*cos(turn) + y*sin(turn), -x*sin(turn) + y*cos(turn)
        local corner = {}
        for k = 1, 3 do corner[k] = z*up[k] + f*out_of[k] + s*side[k] end
        hull[#hull + 1] = corner
      end
    end
  end
  m:block { name = "ground", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "brick", support = "fixed" }
  local shaft = m:body { name = "shaft", hull = hull, material = "brick", floating = true, crack_law = "plane",
    cracks = { { point = scaled(2, up), normal = up } } }
  local stiff = trilith.linear { stiffness = 2e9, damping = 2e5 }
  m:bearing { name = "hinge", between = { "ground", "shaft" }, at = { 0, 0, 0 }, along = stiff, across = stiff,
    axial = stiff }
  local crack
  m:on("unit.cracked", function(e)
    local top, foot = { shaft:point(scaled(length, up)) }, { shaft:point { 0, 0, 0 } }
    crack = crack or { tilt = trilith.math.acos((top[3] - foot[3])/length), time = m.time, mode = e.mode }
  end)
  m:run { duration = 3, until_true = function() return crack ~= nil end }
  return { ["tilt at the crack"] = crack.tilt/deg, ["time of the crack"] = crack.time, mode = crack.mode }
end

-- A bar bonded by one end to a wall, with a force and a moment at its other end that grow through the limit.
local function loaded_bar(load)
  local m = trilith.model { name = "bar", dim = 3, gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, name = "glue",
    law = trilith.bonded { kn = 1e11, ks = 5e10, mu = 0.5, tension = 1e9, cohesion = 1e9, beta = 2e-5 } }
  m:contact { between = { "bar", "bar" }, name = "plane",
    law = trilith.bonded { kn = 1e11, ks = 5e10, mu = 0.6, tension = 1e6, cohesion = 1.5e6, beta = 2e-5 } }
  m:contact { between = { "*", "*" }, law = "glue" }
  m:block { name = "wall", size = { 0.5, 1, 1 }, at = { -0.5, -0.5, -0.5 }, material = "stone", support = "fixed" }
  m:block { name = "bar", size = { 0.8, 0.2, 0.1 }, at = { 0, -0.1, -0.05 }, material = "stone", floating = true,
    crack_law = "plane", cracks = { { point = { 0.3, 0, 0 }, normal = { 1, 0, 0 } } } }
  local ramp = { ramp = 1 }
  m:point_load { body = "bar", at = { 0.8, 0, 0 }, force = scaled(1.05*load.limit, load.force),
    moment = scaled(1.05*load.limit, load.moment), load_curve = ramp }
  local found
  m:on("unit.cracked", function(e) found = found or { share = 1.05*math.min(m.time, 1), e = e } end)
  m:run { duration = 1, until_true = function() return found ~= nil end }
  return { ["load at the crack"] = found and found.share or 0/0, mode = found and found.e.mode or "none" }
end

-- Section 0.2 m (y) by 0.1 m (z), 0.5 m from the loaded end.
local area, wy, wz, polar = 0.02, 0.2*0.1^2/6, 0.1*0.2^2/6, (0.2*0.1^3 + 0.1*0.2^3)/12
local function bar_case(name, title, force, moment, limit, mode)
  return { name = name, title = title, parameters = { { "limit", limit, moment[1] > 0 and "N m" or "N" } },
    checks = { { "load at the crack", unit = "of the limit", exact = 1, within = 0.01 }, { "mode", exact = mode } },
    run = function() return loaded_bar { force = force, moment = moment, limit = limit } end }
end

local function rod_case(share, outcome)
  local checks = { { "rod", exact = outcome } }
  if outcome == "parts" then
    checks[#checks + 1] = { "speed of a half", unit = "w L/4", exact = 1, within = 1e-9 }
    checks[#checks + 1] = { "change of momentum", exact = 0, within = 1e-9 }
  end
  return { name = ("oblique_rod_%.0f"):format(100*share), title = "a rod that spins about an oblique axis",
    parameters = { { "tension", 0.5e6, "Pa" }, { "share", share } }, checks = checks, run = rod_spins }
end

-- A chimney that falls at an angle to its sides bends about both axes of its section: the corner has the sum of both.
local function chimney_case(direction, tension)
  return { name = ("chimney_%.0f_deg"):format(direction), title = "a falling chimney in space",
    parameters = { { "direction", direction, "deg" }, { "tension", tension, "Pa" } },
    checks = { { "tilt at the crack", unit = "deg", exact = 35.875, within = 0.5 },
      { "time of the crack", unit = "s", exact = 2.2914, tolerance = 0.01 }, { "mode", exact = "tension" } },
    run = chimney }
end
-- Moment and thrust at 35.875 deg of the chimney in the plane, and the strength that its corner then needs.
local moment, thrust = 3831.3, -8475
local function corner_strength(direction)
  local shares = math.abs(cos(direction*deg)) + math.abs(sin(direction*deg))
  return thrust/0.25 + moment*shares/(0.5^3/6)
end

return {
  title = "Rigid bodies in space",
  source = "Equilibrium of one part under its inertia (d'Alembert); bending about both axes and torsion of a rectangle",
  formula = [[\sigma = \frac{N}{A} + \frac{M_y}{W_y} + \frac{M_z}{W_z}, \qquad
\tau = \frac{V}{A} + \frac{T \, r}{I_p}]],
  text = "The axes of the rod are oblique to the axes of the model. The chimney falls along its side and at 30 " ..
    "degrees to it. The bar is bonded to a wall by its end and loaded at the other one. Shear stress of torsion is " ..
    "linear, as in an intact joint of mortar.",
  cases = {
    rod_case(0.99, "holds"), rod_case(1.01, "parts"),
    chimney_case(0, 0.15e6), chimney_case(30, corner_strength(30)),
    bar_case("pull", "a bar that is pulled", { 1, 0, 0 }, { 0, 0, 0 }, 1e6*area, "tension"),
    bar_case("bend_y", "a bar bent about y", { 0, 0, -1 }, { 0, 0, 0 }, 1e6*wy/0.5, "tension"),
    bar_case("bend_z", "a bar bent about z", { 0, 1, 0 }, { 0, 0, 0 }, 1e6*wz/0.5, "tension"),
    bar_case("bend_both", "a bar bent about both axes", { 0, 1, -1 }, { 0, 0, 0 }, 1e6/(0.5/wy + 0.5/wz), "tension"),
    bar_case("twist", "a bar that is twisted", { 0, 0, 0 }, { 1, 0, 0 }, 1.5e6*polar/sqrt(0.1^2 + 0.05^2), "shear"),
  },
}
