-- A notched beam in three-point bending: its load path by arc length against the same beam under a given displacement.
-- Both have the same peak, the same branch and the same energy of the crack, and the path has the same bits for any
-- number of threads.
local trilith = require "trilith"

local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.10g is not %.10g"):format(what or "", a, b))
end

local E, ft, Gf, b, d, rows = 30e9, 3e6, 100, 0.1, 0.1, 6
local S, K = 4*d, 3e8

-- Columns of elements grow away from the middle, which has a notch up to d/2. The ends stand on bearings. A block that
-- moves up and down alone presses on the middle of the top by a spring K. `held`: a stiff spring holds this block, so
-- that a force on it is a displacement.
local function beam(held, threads)
  local h, half = d/rows, { 0 }
  local size = h
  while half[#half] < S/2 do half[#half + 1], size = half[#half] + size, math.min(1.35*size, d/4) end
  local nodes, elements, number, mid = {}, {}, {}, #half
  local columns = 2*mid - 1
  local function place(i)
    local away = half[math.abs(i - mid) + 1]*(S/2)/half[mid]
    return S/2 + (i < mid and -away or away)
  end
  local function key(i, side, j) return (2*i + side)*(rows + 1) + j end
  for i = 1, columns do
    for side = 0, i == mid and 1 or 0 do
      for j = 0, rows do
        if side == 1 and 2*j >= rows then
          number[key(i, 1, j)] = number[key(i, 0, j)]
        else
          nodes[#nodes + 1] = { place(i), j*h }
          number[key(i, side, j)] = #nodes
        end
      end
    end
  end
  for i = 1, columns - 1 do
    for j = 0, rows - 1 do
      local right = i == mid and 1 or 0
      local function n(di, dj) return number[key(i + di, di == 0 and right or 0, j + dj)] end
      elements[#elements + 1] = { n(0, 0), n(1, 0), n(1, 1), n(0, 1) }
    end
  end
  local m = trilith.model { name = "notched beam", thickness = b, gravity = 0, threads = threads }
  m:material { name = "concrete", density = 2400, E = E, nu = 0.2 }
  m:contact { between = { "*", "*" }, name = "plane", law = trilith.cohesive { kn = 1e13, ks = 5e12, mu = 0.5,
    tension = ft, cohesion = 2*ft, energy_tension = Gf, energy_shear = 4*Gf } }
  m:body { name = "beam", material = "concrete", mesh = { nodes = nodes, elements = elements },
    hold = { { from = { S/2, d }, to = { S/2, d }, x = "fixed", y = "free" } },
    cracks = { { { S/2, 0 }, { 1, 0 } } }, crack_law = "plane" }
  local soft, stiff, press = trilith.linear { stiffness = 1 }, trilith.linear { stiffness = 1e10 },
    trilith.linear { stiffness = K }
  local function block(name, x, y, support)
    m:block { name = name, material = "concrete", width = 0.05, height = 0.05, at = { x - 0.025, y - 0.025 },
      support = support }
  end
  for i, x in ipairs { 0, S } do
    block("support " .. i, x, -0.5, "fixed")
    m:bearing { name = "end " .. i, between = { "support " .. i, "beam" }, from = { x, -0.5 }, to = { x, 0 },
      along = soft, axial = stiff }
  end
  block("press", S/2, 0.5, { x = "fixed", rotation = "fixed" })
  local spring = m:bearing { name = "spring", between = { "beam", "press" }, from = { S/2, d }, to = { S/2, 0.5 },
    along = soft, axial = press }
  if held then
    block("frame", S/2, 1, "fixed")
    m:bearing { name = "hold", between = { "press", "frame" }, from = { S/2, 0.5 }, to = { S/2, 1 }, along = soft,
      axial = trilith.linear { stiffness = held } }
  end
  return m, spring
end

-- A curve of displacements of the press, forces and energies of the crack.
local function by_displacement()
  local stiffness, step, curve = 1e10, 1e-6, { { u = 0, force = 0, energy = 0 } }
  local m, spring = beam(stiffness)
  for k = 1, 240 do
    m:point_load { name = "P" .. k, body = "press", force = { 0, -stiffness*step } }
    m:consolidate { integrator = "static" }
    curve[k + 1] = { u = -m:body("press").uy, force = math.abs(spring.force_axial), energy = m.energy.contact_fracture }
  end
  return curve
end
local function by_arc(threads, to)
  local m = beam(nil, threads)
  local r = m:pushover { name = "press", body = "press", direction = "-y", control = "arc", arc = 2e-6,
    displacement = to, samples = 600 }
  assert(m:body "beam.a".present and math.abs(m.residual) < 1e-9)
  return m, r
end
local function interpolated(curve, u, what)
  for i = 2, #curve do
    if curve[i].u >= u then
      local p, q = curve[i - 1], curve[i]
      return p[what] + (u - p.u)/(q.u - p.u)*(q[what] - p[what])
    end
  end
end

local curve = by_displacement()
local m, r = by_arc(1, 0.95*curve[#curve].u)
local peak = 0
for _, point in ipairs(curve) do peak = math.max(peak, point.force) end
near(r.peak_force, peak, 5e-4, "peak")
near(peak, 2294, 0.03, "peak by condensed finite elements")
-- The path divides the beam just before its strength, steps of displacement just above it: most at the first points.
local beyond = 0
for i, force in ipairs(r.curve.force) do
  near(force, interpolated(curve, r.curve.displacement[i], "force"), 5e-3, "force on the branch")
  if force < 0.8*peak and r.curve.displacement[i] > 1e-4 then beyond = beyond + 1 end
end
assert(beyond >= 3, "the branch goes down")
near(m.energy.contact_fracture, interpolated(curve, r.displacement, "energy"), 1e-3, "energy of the crack")

for threads = 2, 4, 2 do
  local own, path = by_arc(threads, 0.95*curve[#curve].u)
  assert(own.hash == m.hash, "same bits")
  for i, force in ipairs(r.curve.force) do assert(path.curve.force[i] == force) end
end
