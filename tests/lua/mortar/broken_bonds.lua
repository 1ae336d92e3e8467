-- The event of a breaking bond: its governing limit, and the force, stress or couple.
local trilith = require "trilith"

local tension, cohesion <const> = 2e5, 3e5
local laws = {
  bonded = trilith.bonded { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4, tension = tension, cohesion = cohesion },
  cohesive = trilith.cohesive { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4, tension = tension, cohesion = cohesion,
                                energy_tension = 100, energy_shear = 300 },
  undamped = trilith.bonded { kn = 1e9, ks = 4e8, mu = 0.6, tension = tension, cohesion = cohesion },
}

-- A vector turned by `angle` about an axis (Rodrigues).
local function turned(v, turn)
  if turn == nil then return v end
  local k, n, c, s = {}, 0, math.cos(turn.angle), math.sin(turn.angle)
  for i = 1, 3 do n = n + turn.axis[i]^2 end
  for i = 1, 3 do k[i] = turn.axis[i]/math.sqrt(n) end
  local d, out = (k[1]*v[1] + k[2]*v[2] + k[3]*v[3])*(1 - c), {}
  local cross = { k[2]*v[3] - k[3]*v[2], k[3]*v[1] - k[1]*v[3], k[1]*v[2] - k[2]*v[1] }
  for i = 1, 3 do out[i] = v[i]*c + cross[i]*s + k[i]*d end
  return out
end

-- First event of a block on a base with a joint of 1 m2 while a load grows to `load` in 0.2 s.
local function first_event(dim, law, load, turn)
  local m = trilith.model { name = "joint", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = laws[law] }
  local function block(name, low, support, velocity)
    if dim == 2 then
      return m:block { name = name, width = 1, height = 0.5, at = { 0, low }, material = "stone", support = support,
                       floating = true, velocity = velocity and { velocity[1], velocity[3] } }
    end
    return m:block { name = name, size = { 1, 1, 0.5 }, at = turned({ 0, 0, low }, turn), turn = turn,
                     material = "stone", support = support, floating = true,
                     velocity = velocity and turned(velocity, turn) }
  end
  block("base", -0.5, "fixed")
  local top = block("top", 0, nil, load.velocity)
  if load.velocity then
    assert(top.speed == 3)
  elseif dim == 2 then
    m:point_load { body = top, force = load.force and { load.force[1], load.force[3] }, moment = load.couple,
                   at = { 0.5, 0 }, load_curve = { ramp = 0.2 } }
  else
    m:point_load { body = top, force = load.force and turned(load.force, turn), load_curve = { ramp = 0.2 },
                   moment = load.moment and turned(load.moment, turn), at = turned({ 0.5, 0.5, 0 }, turn) }
  end
  local first
  for _, kind in ipairs { "bond.broken", "bond.cracked" } do m:on(kind, function(e) first = first or e end) end
  m:run { duration = 0.25, dt = load.dt }
  m:close()
  return first
end

local function check(dim, law, load, mode, unit, expected, tolerance, turn)
  local e = first_event(dim, law, load, turn)
  local what = ("dim %d, %s: %s"):format(dim, law, e.text)
  assert(e.mode == mode, what)
  local figure, found = e.text:match(" in " .. mode .. " at ([%d.]+) (.+)$")
  assert(found == unit, what .. ", not in " .. unit)
  assert(math.abs(figure/expected - 1) < tolerance, what .. ", not " .. expected)
  -- A net force is reported if it is the cause; rounding of a zero force is not.
  assert((e.value > 1e3) == (unit == "kN") and (e.value == 0 or e.value > 1e-3), what .. ", with " .. e.value .. " N")
end

-- A couple shears off the outermost points of the patches, at 3/8 + 1/8/sqrt(3) m along both axes: c J/r [kN m]. Forces
-- and couples grow by a few per cent per step; the event reports the last carried value.
local twist <const> = 1e-3*cohesion/6/(math.sqrt(2)*(3/8 + 1/8/math.sqrt(3)))
for _, law in ipairs { "bonded", "cohesive" } do
  for _, turn in ipairs { false, { axis = { 1, -2, 3 }, angle = 0.7 }, { axis = { -3, 1, 0.4 }, angle = 2.1 } } do
    turn = turn or nil
    check(3, law, { force = { 0, 0, 3e5 } }, "tension", "kN", 200, 0.01, turn)
    check(3, law, { force = { 4e5, 4e5, 0 } }, "shear", "kN", 300, 0.01, turn)
    check(3, law, { moment = { 0, 6e4, 0 } }, "tension", "kPa", 200, 1e-3, turn)
    check(3, law, { moment = { 4e4, -5e4, 0 } }, "tension", "kPa", 200, 1e-3, turn)
    check(3, law, { moment = { 0, 0, 3e5 } }, "shear", "kN·m", twist, 0.01, turn)
  end
  check(2, law, { force = { 0, 0, 3e5 } }, "tension", "kN", 200, 0.01)
  check(2, law, { force = { 6e5, 0, 0 } }, "shear", "kN", 300, 0.01)
  check(2, law, { couple = 6e4 }, "tension", "kPa", 200, 1e-3)
end

-- Without a given step the bond reaches its strength before an impact breaks it. Within a given step the impact breaks
-- it before it carried load: the event then reports the strength if the tension limit was exceeded.
for _, dim in ipairs { 2, 3 } do
  check(dim, "undamped", { velocity = { 0, 0, 3 } }, "tension", "kN", 200, 0.02)
  check(dim, "undamped", { velocity = { 0, 0, 3 }, dt = 5e-4 }, "tension", "kPa", 200, 1e-3)
  local struck = first_event(dim, "undamped", { velocity = { 3, 0, 0 }, dt = 5e-4 })
  assert(struck.mode == "shear" and struck.text:find "in shear$", struck.text)
end
print "every assertion holds"
