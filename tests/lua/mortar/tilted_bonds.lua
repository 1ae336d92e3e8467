-- A bond holds when its faces tilt, whenever the candidate pairs are searched again. A strong joint is opened about its
-- end by a motion, and carries kn times its mean opening. A tough joint spends its fracture energy in full.
local trilith = require "trilith"

local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.10g is not %.10g"):format(what, a, b))
end

local kn, L, b, h = 1e8, 1, 0.1, 0.2
local function opened(law, tilt, searches)
  local m = trilith.model { name = "tilted bonds", thickness = b, gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, name = "mortar", law = law }
  m:block { name = "low", width = L, height = h, at = { 0, 0 }, material = "stone", support = "fixed" }
  local top = m:block { name = "top", width = L, height = h, at = { 0, h }, material = "stone",
    support = { y = "fixed", rotation = "fixed" } }
  m:drive { body = top, y = trilith.ramp { by = L/2*tilt, duration = 0.1 },
    rotation = trilith.ramp { by = tilt, duration = 0.1 } }
  local forces = {}
  for k = 1, 10 do
    m:run { duration = 0.01, dt = 1e-4 }
    forces[k] = { lift = top.uy, force = top.reaction_y }
    if searches then -- a body that is added has all pairs searched again
      m:block { name = "far " .. k, width = 0.1, height = 0.1, at = { 20 + k, 0 }, material = "stone",
        support = "fixed" }
    end
  end
  return m, forces
end

local strong = trilith.bonded { kn = kn, ks = 5e7, mu = 0.5, tension = 1e8, cohesion = 2e8 }
local _, kept = opened(strong, 0.15, false)
local _, searched = opened(strong, 0.15, true)
for k = 3, 10 do
  assert(kept[k].force == searched[k].force, "bits depend on the search of pairs")
  -- The block turns about its middle, h/2 above the joint.
  near(kept[k].force, 1e8*L*b*kept[k].lift, 0.03, "force of the joint")
end

-- Opened linearly from 0 to 0.06 m, beyond the last opening of 0.04 m.
kn = 1e9
local ft, Gf = 1e6, 2e4
local tough = trilith.cohesive { kn = kn, ks = 5e8, mu = 0.5, tension = ft, cohesion = 2*ft, energy_tension = Gf,
  energy_shear = 4*Gf }
local m = opened(tough, 0.06, true)
local last = 2*Gf/ft
-- An opening w < last has spent the area below the softening line, without the elastic energy.
local w0, spent = ft/kn, 0
local n = 20000
for i = 1, n do
  local w = 0.06*(i - 0.5)/n
  if w >= last then
    spent = spent + Gf/n
  elseif w > w0 then
    local stress = ft*(last - w)/(last - w0)
    spent = spent + (Gf - 0.5*stress*(last - w) - 0.5*stress*w)/n
  end
end
near(m.energy.contact_fracture, spent*L*b, 0.02, "fracture energy")
