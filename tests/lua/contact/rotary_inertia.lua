-- A body of one element rotates with the inertia of the body, not with the inertia of masses at its corners.
local trilith = require "trilith"

local g = 9.80665
local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.9g for %.9g"):format(what or "", a, b))
end
local function free(dim, gravity)
  local m = trilith.model { name = "free", dim = dim, gravity = gravity or 0 }
  m:material { name = "s", density = 2000, E = 2e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = "none" }
  return m
end

-- Energy of a spin, and the work of a couple: shapes in the plane, by their second moments about the centroid.
local shapes = {
  rectangle = { { 0, 0 }, { 2, 0 }, { 2, 0.5 }, { 0, 0.5 } },
  trapezium = { { 0, 0 }, { 2, 0 }, { 1.5, 1 }, { 0.7, 1 } },
  triangle = { { 0, 0 }, { 2, 0 }, { 0.3, 1 } },
}
local function second_moment(p)
  local area, cx, cy, sum = 0, 0, 0, 0
  for i = 1, #p do
    local a, b = p[i], p[i % #p + 1]
    local c = a[1]*b[2] - a[2]*b[1]
    area, cx, cy = area + c/2, cx + c*(a[1] + b[1])/6, cy + c*(a[2] + b[2])/6
    sum = sum + c*(a[1]^2 + a[1]*b[1] + b[1]^2 + a[2]^2 + a[2]*b[2] + b[2]^2)/12
  end
  return sum - (cx^2 + cy^2)/area, area
end
local function element(m, points, options)
  options.name, options.material, options.floating = "b", "s", true
  local numbers = {}
  for i = 1, #points do numbers[i] = i end
  options.mesh = { nodes = points, elements = { numbers } }
  return m:body(options)
end
for name, points in pairs(shapes) do
  local second, area = second_moment(points)
  local m = free(2)
  local b = element(m, points, { spin = 3 })
  near(b.mass, 2000*area, 1e-12)
  near(m.energy.kinetic, 0.5*2000*second*9, 1e-9, name)
  m:run { duration = 0.2, integrator = "explicit" }
  near(b.spin, 3, 1e-3, "spin kept")
  assert(math.abs(m.energy.residual) < 1e-4*m.energy.kinetic, m.energy.residual)
  -- a couple of 5 kN m for 0.1 s
  for _, integrator in ipairs { "explicit", "implicit" } do
    m = free(2)
    b = element(m, points, {})
    m:point_load { body = "b", moment = 5e3, at = { b.x, b.y } }
    m:run { duration = 0.1, integrator = integrator, dt = integrator == "implicit" and 1e-3 or nil }
    near(b.spin, 5e3*0.1/(2000*second), 2e-3, name .. " " .. integrator)
    near(m.energy.kinetic, 0.5*2000*second*b.spin^2, 5e-3, name)
    assert(math.abs(m.energy.residual) < 1e-3*m.energy.kinetic, m.energy.residual)
  end
end

-- In space a brick about each axis.
for axis = 1, 3 do
  local sides = { 1, 2, 0.5 }
  local spin = { 0, 0, 0 }
  spin[axis] = 2
  local m = free(3)
  local b = m:block { name = "b", size = sides, at = { 0, 0, 0 }, material = "s", body = "brick", floating = true,
    spin = spin }
  local inertia = b.mass/12*(sides[axis % 3 + 1]^2 + sides[(axis + 1) % 3 + 1]^2)
  near(m.energy.kinetic, 0.5*inertia*4, 1e-9, "brick")
  m:run { duration = 0.1, integrator = "explicit" }
  near(m.energy.kinetic, 0.5*inertia*4, 2e-3, "brick")
  assert(math.abs(m.energy.residual) < 1e-3*m.energy.kinetic, m.energy.residual)
end

-- A mesh of one element reads and moves with the same inertia, whatever the order of its nodes.
for _, points in ipairs {
  { { 0, 0 }, { 2, 0 }, { 2, 0.5 }, { 0, 0.5 } }, { { 2, 0.5 }, { 0, 0.5 }, { 0, 0 }, { 2, 0 } } } do
  local m = free(2)
  local b = element(m, points, { spin = 3 })
  near(b.inertia, b.mass*(2^2 + 0.5^2)/12, 1e-12, "inertia")
  near(m.energy.kinetic, 0.5*b.inertia*3^2, 1e-9, "energy of its inertia")
  m:close()
end

-- A soft square or cube that spins fast stretches by the centrifugal force of its own mass. Angular momentum and energy
-- are kept: J0 w^2/2 = J0 (J0/J) w^2/2 + E e^2 V at the largest stretch e of both sides, with J = J0 (1 + e)^2.
local function spinning(dim, spin, integrator, dt)
  local E, side = 1e6, 1
  local m = trilith.model { name = "spinning", dim = dim, gravity = 0 }
  m:material { name = "soft", density = 2000, E = E, nu = 0, plane = dim == 2 and "stress" or nil }
  m:contact { between = { "*", "*" }, law = "none" }
  local b
  if dim == 2 then
    b = m:block { name = "b", width = side, height = side, at = { 0, 0 }, material = "soft", body = "quad",
      floating = true, spin = spin }
  else
    b = m:block { name = "b", size = { side, side, side }, at = { 0, 0, 0 }, material = "soft", body = "brick",
      floating = true, spin = { 0, 0, spin } }
  end
  local energy, most, off = m.energy.kinetic, 0, 0
  m:on_step(function()
    local ax, ay = b:point(dim == 2 and { 0, 0 } or { 0, 0, 0 })
    local bx, by = b:point(dim == 2 and { side, side } or { side, side, 0 })
    most = math.max(most, math.sqrt(((bx - ax)^2 + (by - ay)^2)/2)/side - 1)
    off = math.max(off, math.abs(m.energy.residual), math.abs(m.energy.numerical))
  end)
  m:run { duration = 0.3, integrator = integrator, dt = dt, alpha = integrator == "implicit" and 0 or nil }
  local low, high = 0, 3
  for _ = 1, 60 do
    local e = (low + high)/2
    if energy*(1 - (1 + e)^-2) > E*e*e then low = e else high = e end
  end
  local what = ("%dD, %s, %g rad/s"):format(dim, integrator, spin)
  near(most, low, 0.01, "stretch of " .. what)
  assert(off < 2e-3*energy, ("%s: %g of %g J"):format(what, off, energy))
  m:close()
  return low
end
for _, dim in ipairs { 2, 3 } do
  for _, spin in ipairs { 4, 16, 30 } do
    spinning(dim, spin, "explicit", 5e-5)
    spinning(dim, spin, "implicit", 5e-4)
  end
end
assert(spinning(2, 30, "explicit", 5e-5) > 0.2)

-- General quadrilaterals keep their energy at large strains. As bricks of the same outline in space they move as in
-- the plane.
local quads = {
  trapezium = { { 0, 0 }, { 1.2, 0 }, { 0.9, 1 }, { 0.2, 1 } },
  kite = { { 0, 0 }, { 1, 0.2 }, { 1.3, 1.1 }, { 0.1, 0.8 } },
}
local function soft_quad(points, options)
  local m = trilith.model { name = "soft", gravity = options.gravity or 0, thickness = 1 }
  m:material { name = "s", density = 2000, E = 2e6, nu = 0 }
  m:contact { between = { "*", "*" }, law = "none" }
  local numbers = { 1, 2, 3, 4 }
  m:body { name = "b", material = "s", floating = true, spin = options.spin, hold = options.hold,
    mesh = { nodes = points, elements = { numbers } } }
  return m
end
local function most_strain(m, b, points, go)
  local space, most, off = m.dim == 3, 0, 0
  local begun = m.energy.kinetic
  local function place(p)
    local x, y, z = b:point(space and { p[1], 0, p[2] } or p)
    return x, space and z or y
  end
  local ax, ay = place(points[1])
  local bx, by = place(points[3])
  local first = math.sqrt((bx - ax)^2 + (by - ay)^2)
  m:on_step(function()
    ax, ay = place(points[1])
    bx, by = place(points[3])
    most = math.max(most, math.abs(math.sqrt((bx - ax)^2 + (by - ay)^2)/first - 1))
    off = math.max(off, math.abs(m.energy.residual), math.abs(m.energy.numerical))
  end)
  m:run(go)
  return most, off/math.max(begun, 1e-3), bx, by
end
for name, points in pairs(quads) do
  for _, spin in ipairs { 5, 20 } do
    for _, go in ipairs { { duration = 0.2, integrator = "explicit", dt = 5e-5 },
                          { duration = 0.2, integrator = "implicit", dt = 4e-4, alpha = 0 } } do
      local what = ("%s, %s, %g rad/s"):format(name, go.integrator, spin)
      local m = soft_quad(points, { spin = spin })
      local space = m:extruded()
      local most, off, x, y = most_strain(m, m:body "b", points, go)
      assert(off < 2e-3, ("%s: misses %g of its energy"):format(what, off))
      assert(spin < 20 or most > 0.05, most)
      local in_space, off_space, x_space, y_space = most_strain(space, space:body "b", points, go)
      near(in_space, most, 1e-4, "strain in space of " .. what)
      assert(off_space < 2e-3, ("in space %s: misses %g of its energy"):format(what, off_space))
      assert(math.abs(x_space - x) < 1e-4 and math.abs(y_space - y) < 1e-4, what)
      m:close()
      space:close()
    end
  end
end

-- Pinned at one corner it swings as a compound pendulum: only some of its nodes are fixed.
do
  local w, h = 1, 2
  for _, integrator in ipairs { "explicit", "implicit" } do
    local m = free(2, g)

    local diagonal = math.atan(w/h)
    local function turned(x, y) -- hangs by its corner, its diagonal 0.05 rad from the vertical
      local a = 0.05 - diagonal
      return { math.cos(a)*x - math.sin(a)*y, math.sin(a)*x + math.cos(a)*y }
    end
    local points = { turned(0, -h), turned(w, -h), turned(w, 0), turned(0, 0) }
    local b = element(m, points, { hold = { { from = { -1e-6, -1e-6 }, to = { 1e-6, 1e-6 } } } })
    local d = math.sqrt(w^2 + h^2)/2
    local period = 2*math.pi*math.sqrt((b.mass*(w^2 + h^2)/12 + b.mass*d^2)/(b.mass*g*d))
    local start, back, last = b.x, nil, nil
    local sense = start > 0 and 1 or -1
    m:on_step(function()
      local x = sense*b.x
      if last and last > 0 and x <= 0 then back = back or m.time end
      last = x
    end)
    assert(math.abs(start) > 0.01, start)
    m:run { duration = period/2, integrator = integrator, dt = integrator == "implicit" and 2e-3 or nil }
    near(back, period/4, 1e-2, "quarter of a period " .. integrator)

  end
end

-- A slender tilted block falls back on its other foot as a rigid block does (Housner).
local function first_blow(body)
  local bw, hh = 0.5, 2
  local alpha, far = math.atan(bw/hh), math.sqrt(bw^2 + hh^2)/2
  local lean = 0.4*alpha
  local m = trilith.model { name = "rock" }
  m:material { name = "s", density = 2000, E = 2e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 5e10, mu = 1, beta = 2e-6 } }
  local c, s = math.cos(lean), math.sin(lean)
  local function at(x, y) return { c*x + s*y, -s*x + c*y } end
  m:block { name = "floor", width = 8, height = 0.5, at = { -4, -0.5 }, material = "s", support = "fixed",
    body = "rigid" }
  local b = m:polygon { name = "b", outline = { at(-bw, 0), at(0, 0), at(0, hh), at(-bw, hh) }, material = "s",
    body = body, floating = true }
  local p = math.sqrt(b.mass*g*far/(4/3*b.mass*far^2))
  local x = 1/(1 - lean/alpha)
  local expected, first = math.log(x + math.sqrt(x*x - 1))/p, nil
  m:on_step(function() if not first and b.x <= -bw/2 + 2e-3 then first = m.time end end)
  m:run { duration = 1.2*expected }
  return first, expected
end
local rigid, expected = first_blow "rigid"
near(rigid, expected, 2e-2, "rigid")
near(first_blow "quad", rigid, 2e-2, "quad")
