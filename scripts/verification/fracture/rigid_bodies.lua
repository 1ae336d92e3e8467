-- Rigid bodies that crack at a plane: a rod that spins too fast, and a chimney that breaks as it falls.
local trilith = require "trilith"
local deg = trilith.units "deg"
local sin, cos = trilith.math.sin, trilith.math.cos

-- The law of a plane; without damping, and much stronger in shear than in tension.
local function brittle(tension)
  return trilith.bonded { kn = 1e11, ks = 5e10, mu = 0.6, tension = tension, cohesion = 20*tension }
end

-- Momentum, angular momentum about the origin, and kinetic energy of all bodies that are present.
local function motion_of(m)
  local px, py, l, e = 0, 0, 0, 0
  for _, b in ipairs(m:bodies {}) do
    px, py = px + b.mass*b.vx, py + b.mass*b.vy
    l = l + b.inertia*b.spin + b.mass*(b.x*b.vy - b.y*b.vx)
    e = e + b.inertia*b.spin^2/2 + b.mass*(b.vx^2 + b.vy^2)/2
  end
  return { px = px, py = py, l = l, e = e }
end

local function rod(ft, spin)
  local m = trilith.model { name = "rod", thickness = 0.1, gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = brittle(ft), name = "plane" }
  local body = m:block { name = "rod", width = 1, height = 0.1, at = { -0.5, -0.05 }, material = "stone", spin = spin,
    floating = true, cracks = "mid", crack_law = "plane" }
  return m, body
end

local function rod_limit(p) return math.sqrt(8*p.tension/2400) end

-- Spins at a share of the limit from the start.
local function rod_spins(p)
  local m = rod(p.tension, p.share*rod_limit(p))
  local before = motion_of(m)
  m:run { duration = 0.01 }
  local cracks, after = 0, motion_of(m)
  for _, e in ipairs(m.events) do cracks = cracks + (e.type == "unit.cracked" and 1 or 0) end
  local out = { rod = cracks > 0 and "parts" or "holds" }
  if cracks == 0 then return out end
  local half, speed = m:body "rod.b", p.share*rod_limit(p)/4
  out["speed of a half"] = half.speed/speed
  out["spin of a half"] = half.spin/(4*speed)
  out["change of momentum"] = math.sqrt((after.px - before.px)^2 + (after.py - before.py)^2)/(half.mass*speed)
  out["change of angular momentum"] = after.l/before.l - 1
  out["change of kinetic energy"] = after.e/before.e - 1
  return out
end

-- A small couple raises the spin slowly through the limit.
local function rod_speeds_up(p)
  local limit = rod_limit(p)
  local m, body = rod(p.tension, 0.995*limit)
  m:point_load { body = body, moment = body.inertia*0.01*limit }
  local found
  m:on("unit.cracked", function() found = found or body.spin end)
  m:run { duration = 1, until_true = function() return found ~= nil end }
  return found or 0/0
end

-- A chimney on a hinge, released from rest at a small tilt.
local function chimney(p)
  local length, width, tilt = 6, 0.5, 2*deg
  local m = trilith.model { name = "chimney", thickness = width }
  m:material { name = "brick", density = 2000 }
  m:contact { between = { "*", "*" }, law = "none" }
  m:contact { between = { "shaft", "shaft" }, law = brittle(0.15e6), name = "plane" }
  local along, across = { sin(tilt), cos(tilt) }, { cos(tilt), -sin(tilt) }
  local function at(s, t) return { s*along[1] + t*across[1], s*along[2] + t*across[2] } end
  m:block { name = "ground", width = 4, height = 1, at = { -2, -1 }, material = "brick", support = "fixed" }
  local cracks = p.planes > 1 and p.planes or { { point = at(2, 0), normal = along } }
  local shaft = m:body { name = "shaft", material = "brick", floating = true, cracks = cracks, crack_law = "plane",
    outline = { at(0, -width/2), at(0, width/2), at(length, width/2), at(length, -width/2) } }
  local stiff = trilith.linear { stiffness = 2e9, damping = 2e5 }
  m:bearing { name = "hinge", between = { "ground", "shaft" }, at = { 0, 0 }, along = stiff, axial = stiff }
  local crack
  m:on("unit.cracked", function(e)
    crack = crack or { tilt = tilt + math.abs(shaft.rotation), time = m.time, spin = math.abs(shaft.spin),
      plane = e.plane, mode = e.mode, parts = motion_of(m) }
  end)
  local before
  m:run { duration = 3, until_true = function()
    if not crack then before = motion_of(m) end
    return crack ~= nil
  end }
  return { ["tilt at the crack"] = crack.tilt/deg, ["time of the crack"] = crack.time,
    ["spin at the crack"] = crack.spin, ["height of the crack"] = p.planes > 1 and 0.1*crack.plane or 2,
    mode = crack.mode,
    ["change of angular momentum in the step"] = crack.parts.l/before.l - 1 }
end

local rod_parameters = { { "tension", 0.5e6, "Pa" } }
local function rod_case(share, outcome)
  local checks = { { "rod", exact = outcome } }
  if outcome == "parts" then
    checks[#checks + 1] = { "speed of a half", unit = "w L/4", exact = 1, within = 1e-9 }
    checks[#checks + 1] = { "spin of a half", unit = "w", exact = 1, within = 1e-9 }
    checks[#checks + 1] = { "change of momentum", exact = 0, within = 1e-9 }
    checks[#checks + 1] = { "change of angular momentum", exact = 0, within = 1e-9 }
    checks[#checks + 1] = { "change of kinetic energy", exact = 0, within = 1e-9 }
  end
  return { name = ("spinning_rod_%.0f"):format(100*share), title = "a rod that spins at a share of its limit",
    parameters = { rod_parameters[1], { "share", share } }, checks = checks, run = rod_spins }
end

return {
  title = "Rigid bodies that break by their own inertia",
  source = "Equilibrium of one part under its inertia (d'Alembert). The chimney: section moment, thrust and spin of " ..
    "a falling rod; time by integration of the pendulum equation",
  formula = [[\omega = \frac{1}{L}\sqrt{\frac{8 f_t}{\rho}}, \qquad
M(x) = W \sin\theta \, \frac{x (L - x)^2}{4 L^2}, \qquad
N(x) = m g \frac{L - x}{L} \cos\theta - \frac{m \omega^2 (L^2 - x^2)}{2 L}]],
  text = "Each body has brittle planes and is rigid until it cracks, so that its section forces are exact at each " ..
    "instant. The rod is tested on both sides of its limit. The chimney breaks at the plane of largest stress.",
  cases = {
    rod_case(0.99, "holds"), rod_case(1.01, "parts"),
    { name = "spinning_rod_speeds_up", title = "a rod that is spun up slowly", parameters = rod_parameters,
      checks = { { "spin at the crack", unit = "rad/s", exact = 40.8248, tolerance = 0.01 } }, run = rod_speeds_up },
    { name = "falling_chimney_one_plane", title = "a falling chimney with one plane",
      parameters = { { "planes", 1 } },
      checks = { { "tilt at the crack", unit = "deg", exact = 35.875, within = 0.5 },
        { "time of the crack", unit = "s", exact = 2.2914, tolerance = 0.01 },
        { "spin at the crack", unit = "rad/s", exact = 0.96291, tolerance = 0.01 }, { "mode", exact = "tension" } },
      run = chimney },
    { name = "falling_chimney_59_planes", title = "a falling chimney with a plane at each 0.1 m",
      parameters = { { "planes", 59 } },
      checks = { { "tilt at the crack", unit = "deg", exact = 35.715, within = 0.5 },
        { "height of the crack", unit = "m", exact = 2.2, within = 0.101 }, { "mode", exact = "tension" } },
      run = chimney },
  },
}
