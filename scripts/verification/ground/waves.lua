-- Waves in ground with absorbing boundaries: a pulse that passes a column, echoes of a layer, sides with a free field.
local trilith = require "trilith"

local density, cs, nu = 1800, 200, 0.25
local cp = cs*math.sqrt((2 - 2*nu)/(1 - 2*nu))
local shear = density*cs^2
local amplitude, pulse_time = 0.1, 0.1

local function half_sine(time, steps)
  local points = {}
  for i = 0, steps do points[i + 1] = { i*time/steps, i < steps and amplitude*math.sin(math.pi*i/steps) or 0 } end
  return points
end

-- A body of ground, `elements` over its height.
local function ground(dim, width, height, elements)
  local m = trilith.model { name = "ground", dim = dim, gravity = 0 }
  m:material { name = "soil", density = density, E = 2*shear*(1 + nu), nu = nu, plane = dim == 2 and "strain" or nil }
  m:contact { between = { "*", "*" }, law = "none" }
  local across = math.max(1, math.floor(width*elements/height + 0.5))
  if dim == 2 then
    return m, m:block { name = "soil", width = width, height = height, at = { 0, 0 }, material = "soil",
      body = { mesh = { across, elements } }, floating = true }
  end
  return m, m:block { name = "soil", size = { width, width, height }, at = { 0, 0, 0 }, material = "soil",
    body = { mesh = { across, across, elements } }, floating = true }
end

-- Velocity of a point along one axis, from its places.
local function velocities(history)
  local t, v = {}, {}
  for i = 2, #history.t do
    t[i - 1] = 0.5*(history.t[i] + history.t[i - 1])
    v[i - 1] = (history.values[i] - history.values[i - 1])/(history.t[i] - history.t[i - 1])
  end
  return t, v
end

local function peak(t, v, from, to)
  local most, at = 0, nil
  for i = 1, #t do
    if t[i] >= from and t[i] <= to and math.abs(v[i]) > math.abs(most) then most, at = v[i], t[i] end
  end
  return most, at
end

-- Time at which the velocity passes half of its peak, less the time at which the pulse at the base does so.
local function delay_of(t, v, most)
  for i = 1, #t do
    if v[i] > 0.5*most then return t[i] - pulse_time/6 end
  end
end

-- BO1: column on a base of the same ground. `kind`: "S" or "P" waves.
local function column(p)
  local height = 20
  local m, soil = ground(p.dim, height/p.elements, height, p.elements)
  local axis = p.kind == "S" and 1 or p.dim
  local names = { "x", "y", "z" }
  local motion = { [names[axis]] = half_sine(pulse_time, 100) }
  local size = height/p.elements
  local edge = m:absorbing_boundary { body = soil, edge = "bottom", density = density, cs = cs, cp = cp,
    motion = motion, directions = names[axis], from = p.dim == 3 and { 0, 0, 0 } or nil,
    to = p.dim == 3 and { size, size, 0 } or nil, divisions = p.dim == 3 and { 1, 1 } or nil }
  local held = ""
  for k = 1, p.dim do
    if k ~= axis then held = held .. names[k] end
  end
  m:fix(soil, held)
  local top = p.dim == 2 and { 0, height } or { 0, 0, height }
  local history = m:history { name = "top", every = 0.0005, of = function()
    return (select(axis, soil:point(top)))
  end }
  local stress = m:history { name = "base", every = 0.0005, of = function()
    local force = 0
    for _, bearing in ipairs(edge.bearings) do
      force = force + bearing.force[axis == 1 and "along" or "axial"]
    end
    return force/edge.area
  end }
  m:run { duration = 0.4, integrator = p.integrator }
  local t, v = velocities(history)
  local most, at = peak(t, v, 0, 1)
  local c = p.kind == "S" and cs or cp
  local passed = 2*height/c + pulse_time
  return { ["arrival at the surface"] = delay_of(t, v, most), ["peak velocity"] = most, ["time of the peak"] = at,
    ["displacement at the end"] = history.last - history.values[1],
    ["stress of the dashpots"] = stress.max, ["velocity after the pulse"] = (peak(t, v, passed + 0.02, 1)),
    ["residual of the energy balance"] = m.residual/m.energy.load }
end

local function column_case(kind, dim, integrator)
  local c = kind == "S" and cs or cp
  return { name = ("column_%s_%s_%s"):format(kind, dim == 2 and "plane" or "space", integrator),
    title = ("pulse of %s waves in a column"):format(kind),
    parameters = { { "kind", kind }, { "dim", dim }, { "elements", 40 }, { "integrator", integrator } },
    checks = { { "arrival at the surface", unit = "s", exact = 20/c, tolerance = 0.02 },
      { "peak velocity", unit = "m/s", exact = 2*amplitude, tolerance = 0.02 },
      { "time of the peak", unit = "s", exact = 20/c + pulse_time/2, tolerance = 0.02 },
      { "displacement at the end", unit = "m", exact = 4*amplitude*pulse_time/math.pi, tolerance = 0.01 },
      { "stress of the dashpots", unit = "Pa", exact = density*c*amplitude, tolerance = 0.02 },
      { "velocity after the pulse", unit = "m/s", exact = 0, within = 0.01*amplitude },
      { "residual of the energy balance", unit = "of the work of the wave", exact = 0, within = 1e-6 } },
    run = column }
end

-- Size of the Fourier transform at a frequency [Hz].
local function transform(times, values, f)
  local re, im = 0, 0
  for i = 1, #times - 1 do
    local step, angle = times[i + 1] - times[i], 2*math.pi*f*times[i]
    re, im = re + values[i]*math.cos(angle)*step, im - values[i]*math.sin(angle)*step
  end
  return math.sqrt(re^2 + im^2)
end

-- BO2: layer on a stiffer half space. Surface over outcrop by Fourier integrals, and echoes.
local function layer(p)
  local height, duration = 10, 0.04
  local m, soil = ground(2, height/p.elements, height, p.elements)
  local points = {}
  for i = 0, 80 do points[i + 1] = { i*duration/80, amplitude*math.sin(math.pi*i/80)^2 } end
  points[81][2] = 0
  m:absorbing_boundary { body = soil, edge = "bottom", density = 2200, cs = 800, cp = 1500, directions = "x",
    motion = points }
  m:fix(soil, "y")
  local history = m:history { name = "top", every = 0.0005, of = function() return (soil:point { 0, height }) end }
  m:run { duration = 2 }
  local t, v = velocities(history)
  local fine_t, fine_v = {}, {}
  for i = 0, 4000 do
    fine_t[i + 1], fine_v[i + 1] = i*1e-5, amplitude*math.sin(math.pi*i*1e-5/duration)^2
  end
  local out = {}
  for _, f in ipairs { 2.5, 5, 10, 15 } do
    out[("surface over outcrop at %g Hz"):format(f)] = transform(t, v, f)/(2*transform(fine_t, fine_v, f))
  end
  local first, second = peak(t, v, 0.05, 0.11), peak(t, v, 0.15, 0.21)
  out["echo"] = second/first
  out["residual of the energy balance"] = m.residual/m.energy.load
  return out
end

-- Ground with a free field at both sides against the column alone: `pulse(with_sides)` gives the history of the surface
-- and the model. Results of the case, and both histories.
local function against_column(pulse)
  local with, m = pulse(true)
  local alone = pulse(false)
  local t1, v1 = velocities(with)
  local t2, v2 = velocities(alone)
  return { ["peak over the peak of the column"] = peak(t1, v1, 0, 1)/peak(t2, v2, 0, 1),
    ["residual of the energy balance"] = m.residual/m.energy.load }, with, alone
end

-- Free field at both sides: the ground moves like a column.
local function wide(p)
  local height, width = 20, 10
  local function pulse(with_sides)
    local m, soil = ground(2, with_sides and width or height/p.elements, height, p.elements)
    local axis = p.kind == "S" and "x" or "y"
    local other = axis == "x" and "y" or "x"
    local motion = { [axis] = half_sine(pulse_time, 100) }
    m:absorbing_boundary { body = soil, edge = "bottom", density = density, cs = cs, cp = cp, motion = motion,
      directions = with_sides and "xy" or axis }
    if with_sides then
      for _, side in ipairs { "left", "right" } do
        m:absorbing_boundary { body = soil, edge = side, density = density, cs = cs, cp = cp,
          free_field = { base = 0, surface = height, motion = motion } }
      end
    else
      m:fix(soil, other)
    end
    local x = with_sides and 0.5*width or 0
    local k = axis == "x" and 1 or 2
    local history = m:history { name = "top", every = 0.0005, of = function()
      return (select(k, soil:point { x, height }))
    end }
    m:run { duration = 0.4 }
    return history, m
  end
  local out, with, alone = against_column(pulse)
  out["displacement over the displacement of the column"] = (with.last - with.values[1])/(alone.last - alone.values[1])
  return out
end

local function wide_case(kind)
  return { name = "free_field_" .. kind, title = ("ground with a free field at both sides, %s waves"):format(kind),
    parameters = { { "kind", kind }, { "elements", 20 } },
    checks = { { "peak over the peak of the column", exact = 1, tolerance = 0.01 },
      { "displacement over the displacement of the column", exact = 1, tolerance = 0.01 },
      { "residual of the energy balance", unit = "of the work of the waves", exact = 0, within = 1e-6 } },
    run = wide }
end

-- Two layers on a half space, between free fields: surface over outcrop, and the peak of the column alone.
local lower = { from = 0, to = 12, density = 2000, cs = 300 }
local upper = { from = 12, to = 20, density = 1800, cs = 150 }
local rock = { density = 2200, cs = 800, cp = 1500 }

local function layered()
  local function pulse(with_sides)
    local m = trilith.model { name = "layers", gravity = 0 }
    local width = with_sides and 10 or 0.5
    m:contact { between = { "*", "*" }, law = trilith.bonded { kn = 1e12, ks = 1e12, mu = 1, tension = 1e12,
      cohesion = 1e12 } }
    local motion = {}
    for i = 0, 80 do motion[i + 1] = { i*0.001, amplitude*math.sin(math.pi*i/80)^2 } end
    motion[81][2] = 0
    local field = { base = 0, motion = motion, half_space = rock, layers = {} }
    local top
    for i, part in ipairs { lower, upper } do
      local name = i == 1 and "lower" or "upper"
      m:material { name = name, density = part.density, E = 2*part.density*part.cs^2*(1 + nu), nu = nu,
        plane = "strain" }
      top = m:block { name = name, width = width, height = part.to - part.from, at = { 0, part.from },
        material = name, body = { mesh = { with_sides and 20 or 1, 2*(part.to - part.from) } }, floating = true }
      field.layers[i] = { top = part.to, density = part.density, cs = part.cs, cp = part.cs*cp/cs }
      if not with_sides then m:fix(top, "y") end
    end
    m:absorbing_boundary { body = "lower", edge = "bottom", density = rock.density, cs = rock.cs, cp = rock.cp,
      motion = motion, directions = with_sides and "xy" or "x" }
    for _, body in ipairs(with_sides and { "lower", "upper" } or {}) do
      for _, side in ipairs { "left", "right" } do
        m:absorbing_boundary { body = body, edge = side, free_field = field }
      end
    end
    local history = m:history { name = "top", every = 0.0005, of = function()
      return (top:point { 0.5*width, upper.to })
    end }
    m:run { duration = 1.5, integrator = "implicit", dt = 0.0005 }
    return history, m
  end
  local out, with = against_column(pulse)
  local t, v = velocities(with)
  local input_t, input_v = {}, {}
  for i = 0, 800 do input_t[i + 1], input_v[i + 1] = i*1e-4, amplitude*math.sin(math.pi*i/800)^2 end
  for _, f in ipairs { 3, 6, 10 } do
    out[("surface over outcrop at %g Hz"):format(f)] = transform(t, v, f)/(2*transform(input_t, input_v, f))
  end
  return out
end

-- Surface over outcrop of both layers, from the waves at each of their boundaries (Kramer 1996, equation 7.33).
local function amplification(f)
  local rise, fall = { 1, 0 }, { 1, 0 }
  local function turned(x, angle)
    local c, s = math.cos(angle), math.sin(angle)
    return { x[1]*c - x[2]*s, x[1]*s + x[2]*c }
  end
  for _, pair in ipairs { { upper, lower }, { lower, rock } } do
    local part, below = pair[1], pair[2]
    local angle = 2*math.pi*f*(part.to - part.from)/part.cs
    local ratio = part.density*part.cs/(below.density*below.cs)
    local up, down = turned(rise, angle), turned(fall, -angle)
    for k = 1, 2 do
      rise[k], fall[k] = 0.5*((1 + ratio)*up[k] + (1 - ratio)*down[k]), 0.5*((1 - ratio)*up[k] + (1 + ratio)*down[k])
    end
  end
  return 1/math.sqrt(rise[1]^2 + rise[2]^2)
end

local layered_checks = { { "peak over the peak of the column", exact = 1, tolerance = 0.01 },
  { "residual of the energy balance", unit = "of the work of the waves", exact = 0, within = 1e-6 } }
for _, f in ipairs { 3, 6, 10 } do
  layered_checks[#layered_checks + 1] = { ("surface over outcrop at %g Hz"):format(f), exact = amplification(f),
    tolerance = 0.02 }
end

local function echoes(f)
  local a, x = density*cs/(2200*800), 2*math.pi*f*10/cs
  return 1/math.sqrt(math.cos(x)^2 + a^2*math.sin(x)^2)
end
local layer_checks = {}
for _, f in ipairs { 2.5, 5, 10, 15 } do
  layer_checks[#layer_checks + 1] = { ("surface over outcrop at %g Hz"):format(f), exact = echoes(f), tolerance = 0.02 }
end
local ratio = density*cs/(2200*800)
layer_checks[#layer_checks + 1] = { "echo", exact = -(1 - ratio)/(1 + ratio), tolerance = 0.02 }
layer_checks[#layer_checks + 1] = { "residual of the energy balance", unit = "of the work of the wave", exact = 0,
  within = 1e-6 }

return {
  title = "Waves in ground with absorbing boundaries",
  source = "Lysmer and Kuhlemeyer (1969), Journal of the Engineering Mechanics Division 95(4); Joyner and Chen " ..
    "(1975); Kramer (1996), Geotechnical Earthquake Engineering, section 7.2",
  formula = [[\tau = 2 \rho c_s v - \rho c_s \dot u, \qquad
\frac{\text{surface}}{\text{outcrop}} = \frac{1}{\sqrt{\cos^2 kH + \alpha^2 \sin^2 kH}}, \qquad
r = -\frac{1 - \alpha}{1 + \alpha}]],
  text = "A half sine of 0.1 m/s enters a column of 20 m from below. The surface moves with twice its velocity, and " ..
    "nothing is left when it has passed the base again. A layer of 10 m on a stiffer half space has the " ..
    "amplification and the echoes of one-dimensional theory. Ground of 10 m by 20 m with a free field at both sides " ..
    "moves like the column of the same elements, also where it has two layers.",
  cases = { column_case("S", 2, "explicit"), column_case("S", 2, "implicit"), column_case("P", 2, "explicit"),
    column_case("S", 3, "explicit"), column_case("S", 3, "implicit"),
    { name = "layer_on_half_space", title = "layer of 10 m on a half space", parameters = { { "elements", 40 } },
      checks = layer_checks, run = layer },
    wide_case "S", wide_case "P",
    { name = "layered_field", title = "two layers on a half space between free fields", parameters = {},
      checks = layered_checks, run = layered } },
}
