-- Meshes that crack in statics, in the plane and in space: a bar in tension against its closed form, and beams in
-- three-point bending. Springs next to the specimen keep its softening stable under loads that only grow.
local trilith = require "trilith"

local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.10g is not %.10g"):format(what or "", a, b))
end

local E, ft, Gf, kn, b = 30e9, 3e6, 100, 1e13, 0.1
local function concrete(dim, nu)
  local m = trilith.model { name = "statics of cracks", dim = dim, thickness = dim == 2 and b or nil, gravity = 0 }
  m:material { name = "concrete", density = 2400, E = E, nu = nu }
  m:contact { between = { "*", "*" }, name = "plane", law = trilith.cohesive { kn = kn, ks = kn/2, mu = 0.5,
    tension = ft, cohesion = 2*ft, energy_tension = Gf, energy_shear = 4*Gf } }
  return m
end
local function fixed(dim, more)
  more.x, more.y, more.z = "fixed", "fixed", dim == 3 and "fixed" or nil
  return more
end
local function anchor(m, dim, name, at)
  local low = {}
  for i, x in ipairs(at) do low[i] = x - 0.05 end
  m:block { name = name, size = dim == 3 and { 0.1, 0.1, 0.1 } or nil, width = dim == 2 and 0.1 or nil,
    height = dim == 2 and 0.1 or nil, at = low, material = "concrete", support = "fixed" }
end

-- A bar of 0.5 m is bonded to a rigid block, which a spring K holds. From the crack on its bond opens by w:
-- u = F L/(E A) + w - w0, F = ft A (wc - w)/(wc - w0), with w0 = ft/kn and wc = 2 Gf/ft.
local function bar(dim, divisions)
  local m, L, A, K = concrete(dim, 0), 0.5, 0.01, 3e9
  m:contact { between = { "block", "bar" }, name = "glue", law = trilith.bonded { kn = 1e14, ks = 5e13, mu = 0.5,
    tension = 1e9, cohesion = 1e9 } }
  local at3 = function(x, y) return dim == 3 and { x, y, y } or { x, y } end
  local sizes = function(x) return dim == 3 and { x, b, b } or nil end
  m:block { name = "bar", size = sizes(L), width = dim == 2 and L or nil, height = dim == 2 and b or nil,
    at = at3(0, 0), material = "concrete", body = { mesh = divisions }, cracks = "mid", crack_law = "plane",
    hold = { fixed(dim, { from = at3(0, 0), to = at3(0, b) }) } }
  local block = m:block { name = "block", size = sizes(0.1), width = dim == 2 and 0.1 or nil,
    height = dim == 2 and b or nil, at = at3(L, 0), material = "concrete",
    support = dim == 3 and { y = "fixed", z = "fixed", rotation_x = "fixed", rotation_y = "fixed",
      rotation_z = "fixed" } or { y = "fixed", rotation = "fixed" } }
  anchor(m, dim, "anchor", at3(L + 0.3, b/2))
  local spring = trilith.linear { stiffness = K }
  m:bearing { name = "spring", between = { "anchor", "block" }, from = at3(L + 0.3, b/2), to = at3(L + 0.1, b/2),
    along = spring, axial = spring, across = dim == 3 and spring or nil }
  local cracked, total, w0, wc = 0, 0, ft/kn, 2*Gf/ft
  m:on("unit.cracked", function() cracked = cracked + 1 end)
  for _, share in ipairs { 0.9999, 1.0005, 0.95, 0.5, 0 } do
    local w = share < 0.99 and (1 - share)*(wc - w0) or 0
    local F = share*ft*A
    local u = F*L/(E*A) + w + F/(1e14*A)
    local force = at3(F + K*u - total, 0)
    if dim == 3 then force[3] = 0 end
    m:point_load { name = "load " .. share, body = "block", at = at3(L + 0.1, b/2), force = force }
    total = F + K*u
    m:consolidate { integrator = "static" }
    assert(cracked == (share == 0.9999 and 0 or 1), cracked)
    if share ~= 1.0005 then -- there the bar has just cracked, and is on its way to the softening branch
      assert(math.abs(total - K*block.ux - F) < 1e-4*ft*A, total - K*block.ux)
      near(block.ux, u, 1e-5, "displacement")
    end
  end
  near(m.energy.contact_fracture, (Gf - ft^2/(2*kn))*A, 1e-4, "energy")
  assert(m:body "bar.a".kind == "mesh" and m:body "bar.b".kind == "mesh") -- also of one element
  assert(math.abs(m.residual) < 1e-9)
end
bar(2, { 10, 2 })
bar(2, { 4, 1 })
bar(3, { 10, 2, 2 })
bar(3, { 2, 1, 1 }) -- into two parts of one element

-- A beam of span 4 d, with columns of elements that grow away from its middle, and a notch up to d/2. Its middle is
-- held at the top; forces and springs K act upwards at its ends. `angle`: of its axis, in space in plan.
local function beam(t)
  local dim, d, h, S, K = t.dim, t.d, t.d/t.rows, 4*t.d, 3e8
  local c, s = math.cos(t.angle or 0), math.sin(t.angle or 0)
  local function at(x, z, y)
    if dim == 2 then return { c*x - s*z, s*x + c*z } end
    return { c*x - s*(y or b/2), s*x + c*(y or b/2), z }
  end
  local half, size = { 0 }, h
  while half[#half] < S/2 do half[#half + 1], size = half[#half] + size, math.min(1.35*size, d/4) end
  local nodes, elements, number, mid = {}, {}, {}, #half
  local columns, layers = 2*mid - 1, dim == 3 and 1 or 0
  local function place(i)
    local away = half[math.abs(i - mid) + 1]*(S/2)/half[mid]
    return S/2 + (i < mid and -away or away)
  end
  local function key(i, side, j, k) return ((2*i + side)*(t.rows + 1) + j)*2 + k end
  for i = 1, columns do
    for side = 0, i == mid and 1 or 0 do
      for j = 0, t.rows do
        local notched = i == mid and t.notch and 2*j < t.rows
        for k = 0, layers do
          if side == 1 and not notched then
            number[key(i, 1, j, k)] = number[key(i, 0, j, k)]
          else
            nodes[#nodes + 1] = at(place(i) + (notched and dim == 3 and (2*side - 1)*1e-3*h or 0), j*h, k*b)
            number[key(i, side, j, k)] = #nodes
          end
        end
      end
    end
  end
  for i = 1, columns - 1 do
    for j = 0, t.rows - 1 do
      local right = i == mid and 1 or 0
      local function n(di, dj, k) return number[key(i + di, di == 0 and right or 0, j + dj, k)] end
      elements[#elements + 1] = dim == 2 and { n(0, 0, 0), n(1, 0, 0), n(1, 1, 0), n(0, 1, 0) } or
        { n(0, 0, 0), n(1, 0, 0), n(1, 0, 1), n(0, 0, 1), n(0, 1, 0), n(1, 1, 0), n(1, 1, 1), n(0, 1, 1) }
    end
  end
  local m = concrete(dim, 0.2)
  m:body { name = "beam", material = "concrete", mesh = { nodes = nodes, elements = elements },
    hold = { fixed(dim, { from = at(S/2, d, 0), to = at(S/2, d, b) }) },
    cracks = { { at(S/2, 0), dim == 3 and { c, s, 0 } or { c, s } } }, crack_law = "plane" }
  local soft, stiff, springs = trilith.linear { stiffness = 1 }, trilith.linear { stiffness = K }, {}
  for i, x in ipairs { 0, S } do
    anchor(m, dim, "anchor" .. i, at(x, -0.5))
    springs[i] = m:bearing { name = "spring" .. i, between = { "anchor" .. i, "beam" }, from = at(x, -0.5),
      to = at(x, 0), angle = t.angle, along = soft, axial = stiff, across = dim == 3 and soft or nil }
  end
  local up = dim == 3 and { 0, 0, 1 } or { -s, c }
  local most, cracked = 0, false
  m:on("unit.cracked", function() cracked = true end)
  for k = 1, t.steps do
    for i, x in ipairs { 0, S } do
      local force = {}
      for a, share in ipairs(up) do force[a] = share*K*t.du end
      m:point_load { name = "P" .. i .. "." .. k, body = cracked and (i == 1 and "beam.a" or "beam.b") or "beam",
        at = at(x, 0), force = force }
    end
    m:consolidate { integrator = "static" }
    local load = 0
    for i = 1, 2 do load = load + K*t.du*k - math.abs(springs[i].force_axial) end
    most = math.max(most, load)
  end
  assert(cracked and m.energy.contact_fracture > 0)
  return most
end
-- FR3: peak loads by condensed finite elements. The mesh does not decide, nor its rotation.
local notched = { dim = 2, d = 0.1, rows = 6, notch = true, steps = 25, du = 4e-6 }
local peak = beam(notched)
near(peak, 2294, 0.03, "notched beam")
notched.angle = math.rad(30)
near(beam(notched), peak, 1e-6, "turned beam")
near(beam { dim = 2, d = 0.1, rows = 10, notch = true, steps = 25, du = 4e-6 }, 2294, 0.03, "finer beam")
for _, angle in ipairs { 0, math.rad(30) } do
  near(beam { dim = 3, d = 0.1, rows = 6, notch = true, steps = 25, du = 4e-6, angle = angle }, 2294, 0.03, "in space")
end
