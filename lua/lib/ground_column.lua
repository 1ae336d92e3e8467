-- Vertical waves in a column of level layers on a half space, which absorbing boundaries take as the free field.
--
-- In each layer a wave rises and another one falls, both with the velocity c. Each arrives at the other end of the
-- layer after its travel time h/c. At a boundary between the layers 1 below and 2 above, with the impedances Z = rho c,
-- velocity and stress are continuous (Kramer 1996, Geotechnical Earthquake Engineering, section 5.4):
--
--     rise2 = (2 Z1 rise1 + (Z2 - Z1) fall2)/(Z1 + Z2),    fall1 = (2 Z2 fall2 + (Z1 - Z2) rise1)/(Z1 + Z2)
--
-- At the surface a wave returns unchanged. The waves are computed step by step from their values one travel time
-- before, with cubic interpolation in time, so that travel times need not be multiples of the step.
local _, core = ...
local steps_of_a_travel = 8    -- at least, in the thinnest layer
local steps_of_a_sample = 4    -- of the motion
local quiet = 1e-4             -- share of the largest velocity at which echoes are over
local most_echoes = 400        -- travel times through the whole column after the motion
local most_values = 4e6        -- of all layers
local close = 5e-3             -- share of the largest velocity that a line between two points may miss
local halvings = 6             -- at most, of the shortest step of a list, to become close

-- Step of points between which a straight line is close to the velocity at all times, although delayed waves have
-- their kinks between the points. `step`: the shortest one of the list.
local function step_of(list, velocity, step)
  local most = 0
  for _, p in ipairs(list) do most = math.max(most, math.abs(p[2])) end
  for _ = 1, halvings do
    local worst = 0
    for _, p in ipairs(list) do
      local t = p[1]
      worst = math.max(worst, math.abs(velocity(t) - 0.5*(velocity(t - 0.5*step) + velocity(t + 0.5*step))))
    end
    if worst <= close*most then break end
    step = 0.5*step
  end
  return step
end

--- A velocity over time, from a ground motion or a list of { time, velocity }: function of t [s], end, and step of its
--- points. `key` is its name in messages.
function core.velocity_of(value, key, fail)
  if type(value) == "userdata" and core.kind_of(value) == "motion" then
    return function(t)
      if t <= 0 then return 0 end
      local _, v = value:at(t)
      return v
    end, value.end_time, value.dt
  end
  local wanted = "must be a motion or a list of { time, velocity } with increasing times"
  if type(value) ~= "table" or #value < 2 then fail("%s is %s, %s", key, core.what_is(value), wanted) end
  local step = math.huge
  for i, p in ipairs(value) do
    if type(p) ~= "table" or type(p[1]) ~= "number" or type(p[2]) ~= "number" then
      fail("entry %d of %s is %s, %s", i, key, core.what_is(p), wanted)
    end
    if i > 1 then
      local by = p[1] - value[i - 1][1]
      if by <= 0 or by ~= by then fail("entry %d of %s is at %g s, after %g s; times must increase", i, key, p[1],
        value[i - 1][1]) end
      step = math.min(step, by)
    end
  end
  if value[1][2] ~= 0 then fail("%s begins with %g m/s; a wave begins with 0 m/s", key, value[1][2]) end
  local row = 1
  local function velocity(t)
    if t <= value[1][1] then return 0 end
    if t >= value[#value][1] then return value[#value][2] end
    if t < value[row][1] then row = 1 end
    while value[row + 1][1] < t do row = row + 1 end
    local p, q = value[row], value[row + 1]
    return p[2] + (q[2] - p[2])*(t - p[1])/(q[1] - p[1])
  end
  return velocity, value[#value][1], step_of(value, velocity, step)
end

-- Value of a list at the index x, which need not be whole: cubic polynomial through four points (Lagrange); 0 before
-- the first one.
local function between(list, x)
  local j = math.floor(x)
  local s, a, b, c, d = x - j, list[j - 1] or 0, list[j] or 0, list[j + 1] or 0, list[j + 2] or 0
  if s == 0 then return b end
  return -s*(s - 1)*(s - 2)/6*a + (s + 1)*(s - 1)*(s - 2)/2*b - (s + 1)*s*(s - 2)/2*c + (s + 1)*s*(s - 1)/6*d
end

-- Waves that leave the boundaries of the layers at index n. `rise[i]` leaves the lower, `fall[i]` the upper end of
-- layer i.
local function advance(column, n, input)
  local layers = column.layers
  local from_below, z_below = input, column.z_below
  for i, layer in ipairs(layers) do
    local z, arriving = layer.z, between(layer.fall, n - layer.travel)
    layer.rise[n] = (2*z_below*from_below + (z - z_below)*arriving)/(z + z_below)
    if i > 1 then
      local under = layers[i - 1]
      under.fall[n] = (2*z*arriving + (under.z - z)*from_below)/(z + under.z)
    end
    from_below, z_below = between(layer.rise, n - layer.travel), z
  end
  layers[#layers].fall[n] = from_below
end

-- True if from index n - back to n all waves are within `least` of the velocity at the end of the motion.
local function is_quiet(column, n, back, last, least)
  for i = n - back, n do
    for _, layer in ipairs(column.layers) do
      if math.abs(layer.rise[i] - last) > least or math.abs(layer.fall[i] - last) > least then return false end
    end
  end
  return true
end

-- Fills the lists of all layers until the echoes are over. Gives the number of steps.
local function fill(column, motion, fail)
  local dt, whole, most = column.dt, 0, 0
  for _, layer in ipairs(column.layers) do whole = whole + layer.travel end
  local shaken, back = math.ceil(motion.last/dt), math.ceil(2*whole) + 1
  local last, n = motion.v(motion.last), 0
  while true do
    if n*#column.layers > most_values then
      fail("the free field needs more than %d values in %d layers; resample the motion with a longer step, or join "
        .. "thin layers", most_values, #column.layers)
    end
    local input = motion.v(math.min(n*dt, motion.last))
    most = math.max(most, math.abs(input))
    advance(column, n, input)
    if n >= shaken + back and (n - shaken) % back == 0 then
      if is_quiet(column, n, back, last, quiet*most) then return n end
      if n - shaken > most_echoes*back then
        fail("the free field still moves %d travel times after the end of the motion, as its half space is almost "
          .. "rigid; give a softer half_space", most_echoes)
      end
    end
    n = n + 1
  end
end

--- Motion of the free field for waves of one kind. `layers` from the lowest one upwards: `from` and `to` [m], the
--- velocity `c` [m/s] and the impedance `z` [N s/m3]. `z_below`: impedance of the half space. `motion`: velocity `v(t)`
--- of the wave that rises in it, half of that at a free surface, its end `last` and the `step` of its points [s].
--- Gives a function of height [m] and time [s], whose results are the velocity [m/s] and the stress [Pa], and the time
--- at which the echoes are over [s].
function core.ground_column(layers, z_below, motion, fail)
  local shortest = math.huge
  for _, layer in ipairs(layers) do shortest = math.min(shortest, (layer.to - layer.from)/layer.c) end
  -- The step divides the shortest travel time: a single layer is exact at its ends.
  local wanted = math.min(shortest/steps_of_a_travel, motion.step/steps_of_a_sample)
  local column = { layers = {}, z_below = z_below, dt = shortest/math.ceil(shortest/wanted) }
  for i, layer in ipairs(layers) do
    column.layers[i] = { from = layer.from, to = layer.to, c = layer.c, z = layer.z,
      travel = (layer.to - layer.from)/layer.c/column.dt, rise = {}, fall = {} }
  end
  local over = (fill(column, motion, fail) - 2)*column.dt
  local function waves(level, t)
    t = math.min(t, over) -- all waves are constant from then on
    local at = column.layers[#column.layers]
    for _, layer in ipairs(column.layers) do
      if level <= layer.to then
        at = layer
        break
      end
    end
    local rise = between(at.rise, t/column.dt - (level - at.from)/(at.c*column.dt))
    local fall = between(at.fall, t/column.dt - (at.to - level)/(at.c*column.dt))
    return rise + fall, at.z*(fall - rise)
  end
  return waves, over
end
