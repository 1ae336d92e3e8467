-- Fracture of a body along a plane given in advance: a bar, a double cantilever and a beam in bending.
local trilith = require "trilith"

local E, ft, toughness, width = 30e9, 3e6, 100, 0.1

local function model(dim, kn, nu)
  local m = trilith.model { name = "fracture", dim = dim, gravity = 0, thickness = dim == 2 and width or nil }
  m:material { name = "stone", density = 2400, E = E, nu = nu, plane = dim == 2 and "stress" or nil }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = kn, ks = kn/2, mu = 0.5, cohesion = 2*ft,
    tension = ft, energy_tension = toughness, energy_shear = 10*toughness } }
  return m
end

-- A mesh of nx by nz elements, one element wide in space; place(i, j) gives the corner {x, z}. `flip` where z falls
-- with j.
local function mesh(dim, nx, nz, place, flip)
  local nodes, elements, wide = {}, {}, dim == 2 and 1 or 2
  for j = 0, nz do for k = 1, wide do for i = 0, nx do
    local at = place(i, j)
    nodes[#nodes + 1] = dim == 2 and at or { at[1], (k - 1.5)*width, at[2] }
  end end end
  local function id(i, k, j) return (j*wide + k)*(nx + 1) + i + 1 end
  for j = 0, nz - 1 do for i = 0, nx - 1 do
    local low, high = flip and j + 1 or j, flip and j or j + 1
    if dim == 2 then
      elements[#elements + 1] = { id(i, 0, low), id(i + 1, 0, low), id(i + 1, 0, high), id(i, 0, high) }
    else
      elements[#elements + 1] = { id(i, 0, low), id(i + 1, 0, low), id(i + 1, 1, low), id(i, 1, low),
        id(i, 0, high), id(i + 1, 0, high), id(i + 1, 1, high), id(i, 1, high) }
    end
  end end
  return { nodes = nodes, elements = elements }
end

local function hold(dim, x, z, along)
  local free = along and "free" or "fixed"
  if dim == 2 then return { from = { x, z }, to = { x, z }, x = free, y = "fixed" } end
  return { from = { x, -width/2, z }, to = { x, width/2, z }, x = free, y = "fixed", z = "fixed" }
end

-- Displacement at which the force has fallen to a value, and force at a displacement, on the last branch.
local function where(x, y, value)
  for i = #y, 2, -1 do
    if (y[i - 1] - value)*(y[i] - value) <= 0 then
      return x[i - 1] + (x[i] - x[i - 1])*(value - y[i - 1])/(y[i] - y[i - 1])
    end
  end
  return 0/0
end

local cases = {}

-- A bar of two halves, pulled at its end: u = L s/E + w(s).
for dim = 2, 3 do
  for _, length in ipairs { 0.5, 1 } do
    local function at(share) return length*share*ft/E + 2*toughness/ft - share*(2*toughness/ft - ft/1e13) end
    local checks = { { "largest pull", unit = "N", exact = ft*width*width, tolerance = 0.005 },
      { "end displacement then", unit = "m", exact = at(1), tolerance = 0.005 } }
    for _, share in ipairs { 0.75, 0.5, 0.25 } do
      checks[#checks + 1] = { ("displacement at %g of the strength"):format(share), unit = "m", exact = at(share),
        tolerance = 0.01 }
    end
    checks[#checks + 1] = { "energy spent", unit = "J", exact = toughness*width*width, tolerance = 0.02 }
    cases[#cases + 1] = {
      name = ("bar_torn_%s_%d"):format(length == 1 and "long" or "short", dim),
      title = ("bar of %g m that is torn in its middle, dim = %d%s"):format(length, dim,
        length == 1 and ", with snap-back" or ""),
      parameters = { { "length", length, "m" }, { "dim", dim } }, checks = checks,
      run = function(p)
        local m, half, ends = model(p.dim, 1e13, 0), p.length/2, nil
        for i, name in ipairs { "left", "right" } do
          local x = (i - 1)*half
          local box = p.dim == 2 and { width = half, height = width, at = { x, 0 }, body = { mesh = { 5, 1 } } }
            or { size = { half, width, width }, at = { x, 0, 0 }, body = { mesh = { 5, 1, 1 } } }
          box.name, box.material = name, "stone"
          if i == 1 then
            box.hold = { p.dim == 2 and { from = { 0, 0 }, to = { 0, width }, x = "fixed", y = "fixed" }
              or { from = { 0, 0, 0 }, to = { 0, width, width }, x = "fixed", y = "fixed", z = "fixed" } }
          end
          ends = m:block(box)
        end
        m:consolidate { integrator = "static" }
        local r = m:pushover { body = ends, control = "arc", direction = "x", displacement = 2e-4, samples = 1000,
          at = p.dim == 2 and { p.length, width/2 } or { p.length, width/2, width/2 } }
        local found = { ["largest pull"] = r.peak_force, ["end displacement then"] = r.displacement_at_peak,
          ["energy spent"] = m.energy.contact_fracture }
        for _, share in ipairs { 0.75, 0.5, 0.25 } do
          found[("displacement at %g of the strength"):format(share)] =
            where(r.curve.displacement, r.curve.force, share*ft*width*width)
        end
        return found
      end,
    }
  end
end

-- Two arms on a joint that is opened at one end.
local function arms(p)
  local depth, length, crack = 0.1, 1.3, 0.5
  local m, upper = model(p.dim, 1e12, 0.2), nil
  local along = math.floor(length/p.size + 0.5)
  for _, side in ipairs { -1, 1 } do
    local function place(i, j)
      local open = j == 0 and i*p.size < crack - 1e-9
      return { i*p.size, side*(open and 2e-3 or j*depth/2) }
    end
    upper = m:body { name = side < 0 and "lower" or "upper", material = "stone",
      mesh = mesh(p.dim, along, 2, place, side < 0),
      hold = side < 0 and { hold(p.dim, 0, -depth), hold(p.dim, length, -depth, true) } or nil }
  end
  m:consolidate { integrator = "static" }
  local r = m:pushover { body = upper, at = p.dim == 2 and { 0, depth } or { 0, 0, depth },
    direction = p.dim == 2 and "y" or "z", control = "arc", displacement = 4.1e-3, samples = 1000 }
  local found, energy = { ["largest force"] = r.peak_force }, m.energy
  for _, u in ipairs { 2, 3, 4 } do
    found[("force at %d mm"):format(u)] = where(r.curve.force, r.curve.displacement, 1e-3*u)
  end
  found["energy missing"] = 1 - (energy.strain + energy.contact_elastic + energy.contact_fracture)/energy.load
  return found
end
for dim = 2, 3 do
  local checks = { { "largest force", unit = "N", exact = 2583, tolerance = 0.03 } }
  for u = 2, 4 do
    local inertia = width*0.1^3/12
    checks[#checks + 1] = { ("force at %d mm"):format(u), unit = "N", tolerance = 0.03,
      exact = math.sqrt(2*(toughness*width)^1.5*math.sqrt(E*inertia)/(3*u*1e-3)) }
  end
  checks[#checks + 1] = { "energy missing", exact = 0, within = 0.002 }
  cases[#cases + 1] = {
    name = dim == 2 and "double_cantilever" or "double_cantilever_in_space",
    title = ("double cantilever whose joint cracks, dim = %d"):format(dim),
    parameters = { { "size", dim == 2 and 0.0125 or 0.025, "m" }, { "dim", dim } }, checks = checks, slow = dim == 3,
    run = arms,
  }
end

-- Half of a beam in three-point bending, against its plane of symmetry: twice the stiffness, half of the energy.
local function bent(p)
  local d = p.depth
  local m = trilith.model { name = "bent", dim = p.dim, gravity = 0, thickness = p.dim == 2 and width or nil }
  m:material { name = "stone", density = 2400, E = E, nu = 0.2, plane = p.dim == 2 and "stress" or nil }
  m:contact { between = { "*", "*" }, law = trilith.cohesive { kn = 2e13, ks = 1e4, mu = 0, cohesion = 1e5,
    tension = ft, energy_tension = toughness/2, energy_shear = 9e6 } }
  local wall = p.dim == 2 and { width = d, height = 2*d, at = { -d, -d/2 } }
    or { size = { d, 2*width, 2*d }, at = { -d, -width, -d/2 } }
  wall.name, wall.material, wall.support, wall.body = "wall", "stone", "fixed", "rigid"
  m:block(wall)
  local nx = 2*p.elements
  local function place(i, j)
    local s, z = i/nx, d*j/p.elements
    local open = i == 0 and z < p.notch*d - 1e-9
    return { open and 1e-3*d or 2*d*(0.25*s + 0.75*s*s), z }
  end
  local beam = m:body { name = "beam", material = "stone", mesh = mesh(p.dim, nx, p.elements, place),
    hold = { hold(p.dim, 2*d, 0, true) } }
  m:consolidate { integrator = "static" }
  local r = m:pushover { body = beam, at = p.dim == 2 and { 0, d } or { 0, 0, d },
    direction = p.dim == 2 and "-y" or "-z", control = "arc", displacement = 1e-3, drop = 0.9, samples = 1000 }
  return 2*r.peak_force
end
for dim = 2, 3 do
  for _, row in ipairs { { 0.05, 0, 4772 }, { 0.1, 0, 8539 }, { 0.8, 0, 48715 }, { 0.1, 0.5, 2294 } } do
    if dim == 3 or row[1] == 0.1 and row[2] == 0 then
      cases[#cases + 1] = {
        name = ("bent_beam_%g%s_%d"):format(1000*row[1], row[2] > 0 and "_notched" or "", dim),
        title = ("beam in three-point bending, depth %g m%s, dim = %d"):format(row[1],
          row[2] > 0 and ", notched to the half" or "", dim),
        parameters = { { "depth", row[1], "m" }, { "notch", row[2] }, { "elements", 16 }, { "dim", dim } },
        checks = { { "largest load", unit = "N", exact = row[3], tolerance = 0.03 } }, slow = dim == 3,
        run = bent,
      }
    end
  end
end

return {
  title = "Fracture along a plane",
  source = "Hillerborg, Modeer and Petersson (1976), Cement and Concrete Research 6, for the linear softening",
  formula = [[u(\sigma) = \frac{\sigma L}{E} + w(\sigma), \qquad
P(u) = \sqrt{\frac{2\,(G_f b)^{3/2}\,(E I)^{1/2}}{3\,u}}]],
  text = "The bar and the growing crack have closed forms. The peaks of the double cantilever and of the bent beams " ..
    "are by condensed finite elements, 80 to 160 over the depth. A push by arc length follows each path past its " ..
    "peak. The bar of 1 m snaps back: under a given displacement, half a joule of it would become vibration.",
  cases = cases,
}
