-- Load paths of a double cantilever whose softening joint cracks: through the limit point and the snap-backs of coarse
-- meshes until the arms rotate about its end. The energy is balanced, and the force agrees with linear fracture
-- mechanics.
local trilith = require "trilith"
local near = dofile "near_expected.lua"
local depth, length, crack, E, toughness = 0.1, 1.5, 0.5, 1e10, 100

-- One arm of quadrilaterals; the faces along the crack are set back, so that they start without a bond.
local function arm(m, name, side, size)
  local across, along = 2, math.floor(length/size + 0.5)
  local nodes, elements = {}, {}
  local function id(i, j) return j*(along + 1) + i + 1 end
  for j = 0, across do
    for i = 0, along do
      local open = j == 0 and i*size < crack - 1e-9
      nodes[#nodes + 1] = { i*size, side*(open and 2e-3 or j*depth/across) }
    end
  end
  for j = 0, across - 1 do
    for i = 0, along - 1 do
      local e = { id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1) }
      elements[#elements + 1] = side > 0 and e or { e[4], e[3], e[2], e[1] }
    end
  end
  return m:body { name = name, material = "stone", mesh = { nodes = nodes, elements = elements }, hold = side < 0 and {
    { from = { 0, -depth }, to = { 0, -depth }, x = "fixed", y = "fixed" },
    { from = { length, -depth }, to = { length, -depth }, x = "free", y = "fixed" } } or nil }
end

local function path(size, tension, displacement)
  local m = trilith.model { name = "double cantilever", thickness = 1, gravity = 0 }
  m:material { name = "stone", density = 2000, E = E, nu = 0, plane = "stress" }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = 1e11, ks = 5e10, mu = 0.5, cohesion = 2*tension,
    tension = tension, energy_tension = toughness, energy_shear = 10*toughness } }
  arm(m, "lower", -1, size)
  local upper = arm(m, "upper", 1, size)
  m:consolidate { integrator = "static" }
  local r = m:pushover { body = upper, at = { 0, depth }, direction = "y", control = "arc", displacement = displacement,
    samples = 1000 }
  local energy = m.energy
  -- The work of the load along the path is the stored energy plus the fracture energy of the crack.
  near("work", energy.load, energy.strain + energy.contact_elastic + energy.contact_fracture, 0.01)
  m:close()
  return r
end

-- Up to the end. The arms rotate by v = u/length about the end of the joint: its points soften over w/v, with the last
-- opening w, and press over c, the pull being T = f w/(2 v) = kn v c^2/2. Their moment is T (w/v/3 + 2 c/3).
for _, case in ipairs { { 0.05, 1e6 }, { 0.05, 3e6 }, { 0.025, 3e6 } } do
  local r = path(case[1], case[2], 0.02)
  assert(r.limit == "displacement", r.limit)
  local v, w = r.displacement/length, 2*toughness/case[2]
  local pull = case[2]*w/(2*v)
  local moment = pull*(w/v + 2*math.sqrt(2*pull/(1e11*v)))/3
  assert(r.force < 0.005*r.peak_force, r.force)
  near("force of the last points, on few parts of a face", r.force, moment/length, 0.5)
end

-- F(u) of the growing crack by beam theory: F = c/a, u = k a^2 with c^2 = G E h^3/12 and k = 8 c/(E h^3).
local c = math.sqrt(toughness*E*depth^3/12)
local function grown(u) return c/math.sqrt(u*E*depth^3/(8*c)) end
local function force_at(r, u)
  local x, f = r.curve.displacement, r.curve.force
  for i = #x, 2, -1 do
    if x[i - 1] <= u and u < x[i] then return f[i - 1] + (f[i] - f[i - 1])*(u - x[i - 1])/(x[i] - x[i - 1]) end
  end
end
local u = 6e-3
for _, size in ipairs { 0.025, 0.0125 } do
  near("force as the crack grows", force_at(path(size, 1e6, 6.5e-3), u), grown(u), 0.015)
end
