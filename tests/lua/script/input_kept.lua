-- Each key of a body or law has an effect, or a note reports that it has none.
local trilith = require "trilith"

local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.max(math.abs(a), math.abs(b)), ("%s: %.12g and %.12g"):format(what or "", a, b))
end
local function fails(f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok, "it is accepted")
  return tostring(message)
end

-- A rigid body in the plane whose pieces are mesh elements: three elements of an L, and one non-convex outline. Mass,
-- inertia and motion equal the outline's.
local nodes = { { 0, 0 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 0, 1 }, { 0, 2 }, { 1, 2 } }
local elements = { { 1, 2, 5, 6 }, { 2, 3, 4, 5 }, { 6, 5, 8, 7 } }
local outline = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } }
local function raised(points, by)
  local out = {}
  for i, p in ipairs(points) do out[i] = { p[1], p[2] + by } end
  return out
end
local function plane(options)
  local m = trilith.model { name = "plane", body = options.model }
  m:material { name = "stone", density = 2000, E = options.E, nu = options.E and 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  m:block { name = "floor", width = 8, height = 0.5, at = { -3, -0.5 }, material = "stone", support = "fixed",
    body = "rigid" }
  return m
end
local function ell(m, body, height)
  return m:body { name = "ell", mesh = { nodes = raised(nodes, height), elements = elements }, material = "stone",
    floating = true, body = body }
end
local reference
do
  local m = plane {}
  local b = m:body { name = "ell", outline = raised(outline, 0.05), material = "stone", floating = true }
  reference = { mass = b.mass, inertia = b.inertia, area = b.area, x = b.x, y = b.y }
  m:run { duration = 0.09 }
  reference.falling = b.uy
  m:consolidate { rest = { ratio = 1e-5 } }
  reference.fallen, reference.turned = b.uy, b.rotation
end
for _, how in ipairs { { body = "rigid" }, { body = "rigid", E = 1e9 }, { model = "rigid", E = 1e9 } } do
  local m = plane(how)
  local b = ell(m, how.body, 0.05)
  assert(b.kind == "rigid", b.kind)
  for _, key in ipairs { "mass", "inertia", "area", "x", "y" } do near(b[key], reference[key], 1e-12, key) end
  m:run { duration = 0.09 }
  near(b.uy, reference.falling, 1e-3, "fall")
  m:consolidate { rest = { ratio = 1e-5 } }
  near(b.uy, reference.fallen, 1e-4, "rest")
  assert(math.abs(b.rotation - reference.turned) < 1e-5, b.rotation)
end
do -- without `body` the mesh deforms, and so with body = "quad"; a body added later is read the same way
  local m = plane { E = 1e9 }
  local b = ell(m, nil, 0.05)
  assert(b.kind == "mesh" and #m.notes == 0, b.kind)
  m:run { duration = 0.01 }
  local late = m:body { name = "late", mesh = { nodes = raised(nodes, 4), elements = elements }, material = "stone",
    floating = true, body = "rigid" }
  assert(late.kind == "rigid", late.kind)
  near(late.inertia, reference.inertia, 1e-12)
  local quad = m:body { name = "own", mesh = { nodes = raised(nodes, 8), elements = elements }, material = "stone",
    floating = true, body = "quad" }
  assert(quad.kind == "mesh" and m.notes[1]:find("its mesh already has elements", 1, true), m.notes[1])
end
do -- a hole has no mass: a frame of eight squares
  local m = plane {}
  local points, cells = {}, {}
  for j = 0, 3 do for i = 0, 3 do points[#points + 1] = { i, j + 0.1 } end end
  for j = 0, 2 do
    for i = 0, 2 do
      local n = 4*j + i + 1
      if not (i == 1 and j == 1) then cells[#cells + 1] = { n, n + 1, n + 5, n + 4 } end
    end
  end
  local b = m:body { name = "frame", mesh = { nodes = points, elements = cells }, material = "stone", floating = true,
    body = "rigid" }
  near(b.mass, 8*2000, 1e-12)
  near(b.inertia, 2000*(9*9 - 1)/6, 1e-12)
end

-- A rigid body of curved ten-node tetrahedra has the mass of the curved elements, checked against integrals over their
-- curved faces: an octahedron of eight elements whose outer edges bulge to a sphere.
local gauss = {}
do
  local a, b = math.sqrt(5 - 2*math.sqrt(10/7))/3, math.sqrt(5 + 2*math.sqrt(10/7))/3
  local wa, wb = (322 + 13*math.sqrt(70))/900, (322 - 13*math.sqrt(70))/900
  for _, p in ipairs { { -b, wb }, { -a, wa }, { 0, 128/225 }, { a, wa }, { b, wb } } do
    gauss[#gauss + 1] = { (1 + p[1])/2, p[2]/2 }
  end
end
local function ball(bulge, at)
  local corners = { { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } }
  local points, cells, middle, faces = { { 0, 0, 0 } }, {}, {}, {}
  for i, c in ipairs(corners) do points[i + 1] = c end
  local function between(i, j)
    local key = math.min(i, j)*100 + math.max(i, j)
    if not middle[key] then
      local a, b = points[i], points[j]
      local x = { (a[1] + b[1])/2, (a[2] + b[2])/2, (a[3] + b[3])/2 }
      local size = math.sqrt(x[1]^2 + x[2]^2 + x[3]^2)
      local by = i > 1 and j > 1 and 1 + bulge*(1/size - 1) or 1
      points[#points + 1] = { x[1]*by, x[2]*by, x[3]*by }
      middle[key] = #points
    end
    return middle[key]
  end
  for i = 1, 4 do
    for _, top in ipairs { true, false } do
      local a, b, c = i + 1, i % 4 + 2, top and 6 or 7
      if not top then a, b = b, a end
      cells[#cells + 1] = { 1, a, b, c, between(1, a), between(a, b), between(1, b), between(1, c), between(b, c),
        between(a, c) }
      faces[#faces + 1] = { a, b, c, between(a, b), between(b, c), between(a, c) }
    end
  end
  -- 1/3 of x . n, and x^3/3 along x, over a face of six nodes
  local volume, second = 0, 0
  for _, f in ipairs(faces) do
    for _, p in ipairs(gauss) do
      for _, q in ipairs(gauss) do
        local u, v = p[1], q[1]*(1 - p[1])
        local l = { 1 - u - v, u, v }
        local n = { l[1]*(2*l[1] - 1), l[2]*(2*l[2] - 1), l[3]*(2*l[3] - 1), 4*l[1]*l[2], 4*l[2]*l[3], 4*l[3]*l[1] }
        local du = { 1 - 4*l[1], 4*l[2] - 1, 0, 4*(l[1] - l[2]), 4*l[3], -4*l[3] }
        local dv = { 1 - 4*l[1], 0, 4*l[3] - 1, -4*l[2], 4*l[2], 4*(l[1] - l[3]) }
        local x, a, b = { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }
        for i = 1, 6 do
          for k = 1, 3 do
            local at_node = points[f[i]][k]
            x[k], a[k], b[k] = x[k] + n[i]*at_node, a[k] + du[i]*at_node, b[k] + dv[i]*at_node
          end
        end
        local nx, ny, nz = a[2]*b[3] - a[3]*b[2], a[3]*b[1] - a[1]*b[3], a[1]*b[2] - a[2]*b[1]
        local w = p[2]*q[2]*(1 - p[1])
        volume = volume + w*(x[1]*nx + x[2]*ny + x[3]*nz)/3
        second = second + w*x[1]^3*nx/3
      end
    end
  end
  local placed = {}
  for i, x in ipairs(points) do placed[i] = { x[1] + at[1], x[2] + at[2], x[3] + at[3] } end
  return placed, cells, volume, 2*second -- the moment of inertia about an axis is the sum over the other two directions
end
for _, bulge in ipairs { 0, 0.5, 1 } do
  local m = trilith.model { name = "ball", dim = 3, gravity = 0 }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = "none" }
  local at = { 1, 2, 3 }
  local points, cells, volume, second = ball(bulge, at)
  local b = m:body { name = "ball", mesh = { nodes = points, elements = cells }, material = "stone", body = "rigid",
    floating = true, spin = { 0, 0, 2 } }
  near(b.mass, 2000*volume, 1e-12, "volume")
  near(m.energy.kinetic, 0.5*2000*second*2^2, 1e-10, "inertia")
  for k, key in ipairs { "x", "y", "z" } do near(b[key], at[k], 1e-12, key) end
  local told = m.notes[1] and m.notes[1]:find("8 of its elements have curved edges", 1, true)
  assert((told ~= nil) == (bulge > 0), m.notes[1])
end

-- A deforming body of the same elements has the same mass, also where edges are curved unevenly. It is checked as the
-- body falls and by its weight in statics.
local function uneven(points, by)
  local out = {}
  for i, p in ipairs(points) do
    local bent = i > 7 and by*math.sin(7*i) or 0
    out[i] = { p[1] + bent, p[2] - 0.5*bent, p[3] + 0.3*bent }
  end
  return out
end
for _, bulge in ipairs { 0, 0.5, 1 } do
  for _, off in ipairs { 0, 0.05 } do
    local points, cells, volume = ball(bulge, { 1, 2, 3 })
    points = uneven(points, off)
    local function make(body, more)
      local m = trilith.model { name = "ball", dim = 3 }
      m:material { name = "stone", density = 2000, E = 1e9, nu = 0.2 }
      m:contact { between = { "*", "*" }, law = "none" }
      local call = { name = "ball", mesh = { nodes = points, elements = cells }, material = "stone", body = body,
        floating = true }
      for key, value in pairs(more) do call[key] = value end
      return m, m:body(call)
    end
    local m, b = make("rigid", {})
    local mass = b.mass
    m:close()
    if off == 0 then near(mass, 2000*volume, 1e-12, "rigid") end
    m, b = make(nil, {})
    near(b.mass, mass, 1e-12, "deforming")
    for _, integrator in ipairs { "explicit", "implicit" } do
      local z, vz = b.z, b.vz
      m:run { duration = 0.1, integrator = integrator, dt = integrator == "implicit" and 0.01 or nil }
      near(b.vz, vz - 9.80665*0.1, 1e-3, "speed of the fall, " .. integrator) -- leapfrog speeds are half a step old
      near(b.z - z, 0.1*vz - 9.80665*0.1^2/2, 1e-2, "fall, " .. integrator)
    end
    m:close()
    m, b = make(nil, { hold = { { from = { -9, -9, 3 }, to = { 9, 9, 9 } } } })
    m:consolidate { integrator = "static" }
    near(b.reaction_z, mass*9.80665, 1e-6, "held in statics")
    m:close()
  end
end

-- Bonds, softening and crushing on spheres get a note with law, body and remedy; friction and other bodies do not.
local function with_sphere(law, shape)
  local m = trilith.model { name = "spheres", dim = 3 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = law }
  m:block { name = "ground", size = { 4, 4, 0.5 }, at = { -2, -2, -0.5 }, material = "stone", support = "fixed" }
  if shape == "block" then
    m:block { name = "s", size = { 0.2, 0.2, 0.2 }, material = "stone", at = { 0, 0, 0 } }
  else
    m:sphere { name = "s", radius = 0.2, at = { 0, 0, 0.2 }, material = "stone" }
  end
  m:run { duration = 0.001 }
  return m
end
local bonded = trilith.bonded { kn = 1e9, ks = 5e8, mu = 0.6, tension = 1e6, cohesion = 1e6 }
local cohesive = trilith.cohesive { kn = 1e9, ks = 5e8, mu = 0.6, tension = 1e5, cohesion = 1e5, energy_tension = 10,
  energy_shear = 50, compression = 5e6 }
local rubbing = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6 }
for law, keys in pairs { [bonded] = { "tension", "cohesion" }, [cohesive] = { "energy_tension", "compression" } } do
  local note = with_sphere(law, "sphere").notes[1]
  for _, word in ipairs(keys) do assert(note:find(word, 1, true), note) end
  assert(note:find("'s'", 1, true) and note:find("trilith.frictional", 1, true), note)
  assert(#with_sphere(law, "block").notes == 0)
end
assert(#with_sphere(rubbing, "sphere").notes == 0)
do -- a body added later
  local m = with_sphere(bonded, "block")
  m:sphere { name = "late", radius = 0.1, at = { 1, 1, 0.1 }, material = "stone" }
  assert(#m.notes == 1 and m.notes[1]:find("'late'", 1, true), m.notes[1])
end

-- A small bob on a long arm swings about a hinge as a compound pendulum; without the arm its point is rejected.
local length, side = 5, 0.2
local function hinge(dim, arm)
  local m = trilith.model { name = "bob", dim = dim }
  m:material { name = "steel", density = 7800 }
  m:contact { between = { "*", "*" }, law = "none" }
  local tilt = 0.05
  local c, s = math.cos(tilt), math.sin(tilt)
  local stiff = trilith.linear { stiffness = 5e8 }
  if dim == 2 then
    m:block { name = "beam", width = 1, height = 0.2, at = { -0.5, 0 }, material = "steel", support = "fixed" }
    local corners = {}
    for i, p in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
      local x, y = p[1]*side/2, p[2]*side/2 - length
      corners[i] = { c*x - s*y, s*x + c*y }
    end
    local b = m:polygon { name = "bob", outline = corners, material = "steel", floating = true }
    m:bearing { name = "hinge", between = { "beam", "bob" }, at = { 0, 0 }, arm = arm, along = stiff, axial = stiff }
    return m, b, b.inertia
  end
  m:block { name = "beam", size = { 1, 1, 0.2 }, at = { -0.5, -0.5, 0 }, material = "steel", support = "fixed" }
  local b = m:block { name = "bob", size = { side, side, side }, material = "steel", floating = true,
    at = { s*length - side/2, -side/2, -c*length - side/2 }, inertia = { 50, 60, 70 } }
  m:bearing { name = "hinge", between = { "beam", "bob" }, at = { 0, 0, 0 }, arm = arm, along = stiff, across = stiff,
    axial = stiff }
  return m, b, 60
end
for _, dim in ipairs { 2, 3 } do
  local message = fails(hinge, dim, nil)
  assert(message:find("give arm = ", 1, true), message)
  message = fails(hinge, dim, 4)
  assert(message:find("and arm is 4 m", 1, true), message)
  local m, b, inertia = hinge(dim, 5)
  local period = 2*math.pi*math.sqrt((inertia + b.mass*length^2)/(b.mass*9.80665*length))*(1 + 0.05^2/16)
  m:run { duration = period }
  -- back at its start, within 0.001 of the full path
  assert(math.abs(b.ux) < 1e-3*4*length*0.05, b.ux)
  assert(math.abs(m.energy.residual) < 1e-3*b.mass*9.8*length*0.05^2/2, m.energy.residual)
end

-- Given moments of inertia in space, and impossible ones.
do
  local m = trilith.model { name = "inertia", dim = 3, gravity = 0 }
  m:material { name = "steel", density = 7800 }
  m:contact { between = { "*", "*" }, law = "none" }
  local function block(name, inertia, spin)
    return m:block { name = name, size = { 1, 1, 1 }, material = "steel", floating = true, at = { 3*m.time, 0, 0 },
      inertia = inertia, spin = spin }
  end
  block("a", { 300, 200, 400 }, { 1, 2, 3 })
  near(m.energy.kinetic, 0.5*(300 + 200*4 + 400*9), 1e-12)
  assert(fails(block, "b", { 100, 100, 300 }):find("exceed the sum of the other two", 1, true))
  assert(fails(block, "c", -1):find("inertia", 1, true))
end
