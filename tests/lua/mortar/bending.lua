-- Bending of a softening joint: the largest moment of a square joint that is turned open, against the integral of the
-- law over its depth. In the plane and in space, by implicit and by explicit steps, with and without axial load, and
-- for a block added later.
local trilith = require "trilith"

local kn, strength, side <const> = 1e10, 3e5, 0.2
local peak <const> = strength/kn

-- Traction over the strength at an opening in units of the opening at the peak; `last`: the opening at which it ends.
local function stress(w, last)
  if w <= 1 then return w end
  return math.max(0, (last - w)/(last - 1))
end

-- Largest moment over the moment at which an elastic joint breaks at its edge. `axial`: mean stress over the strength.
local function capacity(last, axial, most_turn)
  local strips, turns, most = 400, 200, 0
  for i = 1, turns do
    local turn, moment = i*most_turn/turns, 0
    local low, high = axial - 1, axial + 0.5*turn + 1
    for _ = 1, 40 do
      local middle, force = (low + high)/2, 0
      moment = 0
      for k = 1, strips do
        local x = (k - 0.5)/strips - 0.5
        local s = stress(middle + turn*x, last)/strips
        force, moment = force + s, moment + s*x
      end
      if force < axial then low = middle else high = middle end
    end
    most = math.max(most, moment)
  end
  return 6*most
end

local function bent(dim, how, about, last, axial, later)
  local m = trilith.model { name = "bending", dim = dim, gravity = 0, thickness = dim == 2 and side or nil }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = kn, ks = kn, mu = 0.7, tension = strength,
    cohesion = 1e8, energy_tension = 0.5*strength*last*peak, energy_shear = 1e6, beta = 1e-6 } }
  local function block(name, at, support)
    if dim == 2 then
      return m:block { name = name, width = side, height = side, at = { 0, at }, material = "stone", support = support }
    end
    return m:block { name = name, size = { side, side, side }, at = { 0, 0, at }, material = "stone",
      support = support }
  end
  local turns = {}
  for _, key in ipairs(dim == 2 and { "rotation" } or { "rotation_x", "rotation_y", "rotation_z" }) do
    turns[key] = "fixed"
  end
  block("low", -side, "fixed")
  if later then m:run { duration = 1e-3, integrator = how } end
  local b = block("high", 0, turns)
  local pull = axial*strength*side*side
  if axial ~= 0 then
    m:point_load { body = b, force = dim == 2 and { 0, pull } or { 0, 0, pull } }
    m:consolidate { integrator = "static" }
  end
  local most_turn, most = 1.5*last + 8*math.abs(axial), 0
  local duration = how == "implicit" and 1 or 0.6
  m:drive { body = b, [about] = trilith.ramp { by = most_turn*peak/side, duration = duration } }
  local place = about == "rotation" and "m" or about == "rotation_x" and "mx" or "my"
  m:on_step(function() most = math.max(most, math.abs(b:reactions()[1][place])) end)
  m:run { duration = duration, integrator = how, dt = how == "implicit" and duration/200 or nil,
    local_damping = how == "explicit" and 0.7 or nil }
  assert(m.verdict.sound, m.verdict.text)
  m:close()
  return most/(strength*side^3/6), capacity(last, axial, most_turn)
end

for _, last in ipairs { 10, 50 } do
  for _, axial in ipairs { 0, -0.5 } do
    for _, about in ipairs { "rotation", "rotation_x", "rotation_y" } do
      local dim = about == "rotation" and 2 or 3
      local all = { { "implicit" }, { "explicit" } }
      if axial == 0 and last == 10 then all[3] = { "implicit", true } end
      for _, case in ipairs(all) do
        local found, expected = bent(dim, case[1], about, last, axial, case[2])
        local what = ("%s, %s, last opening %g, axial %g, %s"):format(about, case[1], last, axial,
          case[2] and "added later" or "from the start")
        assert(math.abs(found/expected - 1) < 0.01, ("%s: %.5g for %.5g"):format(what, found, expected))
      end
    end
  end
end
