-- m:creep{...} and m:creep_process{...}: joints that creep under lasting forces. A chain of Kelvin elements stands
-- behind the spring of a bearing:
--
--     f = k (d - c),    c = sum of c_j,    T_j dc_j/dt + c_j = factor_j f/k
--
-- Under a constant force the displacement grows from f/k to (1 + sum of factors) f/k. At constant displacement the
-- force of a single element relaxes to the share 1/(1 + factor) with the time T/(1 + factor). Findley, Lai and Onaran,
-- "Creep and relaxation of nonlinear viscoelastic materials", 1976.
--
-- The force is linear over a step, so the equations are integrated exactly (the exponential algorithm of Bazant, 1971).
-- At the end c is a + b f with known a and b. Equilibrium is therefore found with a spring of the stiffness 1/(1/k + b)
-- and the origin a. Then the bearing has its stiffness k again, with the origin c, and the same force. With m:change
-- these laws are part of the model, so a continued run repeats them.
local trilith, core = ...
local methods = core.members "model"
local exp = trilith.math.exp
local creeping = setmetatable({}, { __mode = "k" }) -- rows by model
local clocks = setmetatable({}, { __mode = "k" })   -- time of the processes by model [s]
local longest_displacement = 1e3                    -- of the tables of the laws [m] or [rad]

local function directions(dim)
  return dim == 2 and { "along", "axial", "turning" }
    or { "along", "across", "axial", "turning_along", "turning_across", "turning_axial" }
end

local function bearing_of(model, owner, given)
  if type(given) ~= "userdata" and type(given) ~= "string" then
    core.fail(("%s: 'bearing' is %s, must be a bearing or its name"):format(owner,
      given == nil and "missing" or core.what_is(given)))
  end
  return model.bearings[core.name_of(model, "bearing", given, owner)]
end

local most_elements = 20

-- The elements of a chain, from `factor` and `time` or from `chain`.
local function elements_of(owner, o)
  if o.chain == nil then
    return { { factor = core.positive(owner, "factor", o.factor, ""), time = core.positive(owner, "time", o.time, " s"),
      c = 0.0 } }
  end
  if o.factor ~= nil or o.time ~= nil then
    core.fail(owner .. ": 'chain' and 'factor' or 'time' are given; keep 'chain', or 'factor' and 'time'")
  end
  if type(o.chain) ~= "table" or #o.chain == 0 or #o.chain > most_elements then
    core.fail(("%s: 'chain' is %s, must be a list of 1 to %d elements { factor = , time = }"):format(owner,
      type(o.chain) == "table" and ("a list of %d"):format(#o.chain) or core.what_is(o.chain), most_elements))
  end
  local out = {}
  for i, element in ipairs(o.chain) do
    local place = ("%s: element %d of 'chain'"):format(owner, i)
    core.check_keys(place, element, { "factor", "time" })
    out[i] = { factor = core.positive(place, "factor", element.factor, ""),
      time = core.positive(place, "time", element.time, " s"), c = 0.0 }
  end
  return out
end

function methods.creep(model, o)
  local owner = "creep"
  core.check_keys(owner, o, { "bearing", "direction", "stiffness", "factor", "time", "chain" })
  local bearing = bearing_of(model, owner, o.bearing)
  local row = { bearing = bearing, name = bearing.name,
    direction = core.one_of(owner, "direction", o.direction, directions(model.dim)),
    k = core.positive(owner, "stiffness", o.stiffness, ", the stiffness of the bearing's linear law"),
    elements = elements_of(owner, o) }
  local rows = creeping[model] or {}
  for _, known in ipairs(rows) do
    if known.name == row.name and known.direction == row.direction then
      core.fail(("%s: bearing '%s' creeps in the direction %s already"):format(owner, row.name, row.direction))
    end
  end
  rows[#rows + 1], creeping[model] = row, rows
end

-- The share of its displacement that an element keeps after `dt`, and its creep per force at the beginning and at the
-- end of the step, for a force that is linear in between.
local function shares(row, element, dt)
  local x = dt/element.time
  local kept = exp(-x)
  local mean = x < 1e-4 and 1 - x/2*(1 - x/3*(1 - x/4)) or (1 - kept)/x
  local per_force = element.factor/row.k
  return kept, per_force*(mean - kept), per_force*(1 - mean)
end

local function is_live(row) return row.bearing.status == "intact" or row.bearing.status == "yielded" end
local function force_of(row) return row.bearing.force[row.direction] end

local function set_spring(model, row, origin, k)
  local far = longest_displacement
  model:change { bearing = row.name,
    [row.direction] = trilith.table { points = { { origin - far, -far*k }, { origin + far, far*k } } } }
end

-- The spring of a step that begins with the force `first`.
local function soften(model, row, first, dt)
  local origin, compliance = 0, 1/row.k
  for _, element in ipairs(row.elements) do
    local kept, by_first, by_last = shares(row, element, dt)
    origin, compliance = origin + element.c*kept + by_first*first, compliance + by_last
  end
  set_spring(model, row, origin, 1/compliance)
end

-- The elements after the step, and the elastic spring again.
local function harden(model, row, first, dt)
  local last, origin = force_of(row), 0
  for _, element in ipairs(row.elements) do
    local kept, by_first, by_last = shares(row, element, dt)
    element.c = element.c*kept + by_first*first + by_last*last
    origin = origin + element.c
  end
  set_spring(model, row, origin, row.k)
end

local function step(model, rows, s, dt)
  local first = {}
  for i, row in ipairs(rows) do
    if is_live(row) then
      first[i] = force_of(row)
      soften(model, row, first[i], dt)
    end
  end
  if s.heat then
    model:process { duration = dt, step = dt, name = s.name }
  else
    model:consolidate { integrator = "static", name = s.name, within = s.within, tolerance = s.tolerance }
  end
  for i, row in ipairs(rows) do
    if first[i] and is_live(row) then harden(model, row, first[i], dt) end
  end
end

function methods.creep_process(model, o)
  local owner, rows = "creep_process", creeping[model]
  core.check_keys(owner, o, { "duration", "step", "heat", "within", "tolerance", "each", "name" })
  if not rows then core.fail(owner .. ": no bearing creeps; declare m:creep first") end
  local duration, dt = core.positive(owner, "duration", o.duration, " s"), core.positive(owner, "step", o.step, " s")
  if o.each ~= nil and type(o.each) ~= "function" then
    core.fail(("%s: 'each' is %s, must be a function of the clock in s"):format(owner, core.what_is(o.each)))
  end
  local count = math.max(1, math.ceil(duration/dt - 1e-9))
  if count > 100000 then
    core.fail(("%s: 'step' is %g s in a duration of %g s, more than 100000 steps; give a longer step"):format(owner, dt,
      duration))
  end
  dt = duration/count
  local s = { name = o.name or "creep", within = o.within, tolerance = o.tolerance, heat = o.heat }
  for _ = 1, count do
    step(model, rows, s, dt)
    clocks[model] = (clocks[model] or 0) + dt
    if o.each then o.each(clocks[model]) end
  end
  return clocks[model]
end

-- trilith.concrete_creep{...}: the creep coefficient of EN 1992-1-1:2004, annex B.1, as a chain. The chain follows the
-- coefficient within 0.3 % from one day to 100 years after loading.
local day = 86400.0
local first_time, per_decade, elements = 0.2, 1.5, 8 -- [d]
local ageing = { S = -1, N = 0, R = 1 }             -- exponent of equation B.9
local function power(x, y) return exp(y*trilith.math.log(x)) end

-- Notional coefficient (B.2 to B.5) and beta_H [d] (B.8); strength in MPa, size in mm, age in days.
local function annex_b(strength, humidity, size, age)
  local of_humidity = (1 - humidity)/(0.1*power(size, 1/3))
  local shift = 250
  if strength > 35 then
    of_humidity = (1 + of_humidity*power(35/strength, 0.7))*power(35/strength, 0.2)
    shift = 250*power(35/strength, 0.5)
  else
    of_humidity = 1 + of_humidity
  end
  local scale = math.min(1.5*(1 + power(1.2*humidity, 18))*size + shift, 6*shift)
  return of_humidity*16.8/math.sqrt(strength)/(0.1 + power(age, 0.2)), scale
end

-- Factors of the elements, none negative, that fit the coefficient best (coordinate descent for the least squares of
-- relative errors).
local function fitted(coefficient)
  local times, square, right, factors = {}, {}, {}, {}
  for i = 1, elements do
    times[i], square[i], right[i], factors[i] = first_time*power(10, (i - 1)/per_decade), {}, 0, 0
    for j = 1, elements do square[i][j] = 0 end
  end
  for sample = 0, 80 do
    local t = power(36525, sample/80)
    local row = {}
    for i = 1, elements do row[i] = (1 - exp(-t/times[i]))/coefficient(t) end
    for i = 1, elements do
      right[i] = right[i] + row[i]
      for j = 1, elements do square[i][j] = square[i][j] + row[i]*row[j] end
    end
  end
  for _ = 1, 500 do
    for i = 1, elements do
      local rest = right[i]
      for j = 1, elements do rest = rest - square[i][j]*factors[j] end
      factors[i] = math.max(0, factors[i] + rest/square[i][i])
    end
  end
  local chain = {}
  for i = 1, elements do
    if factors[i] > 0 then chain[#chain + 1] = { factor = factors[i], time = times[i]*day } end
  end
  return chain
end

local function within(owner, key, value, unit, low, high)
  local number = core.positive(owner, key, value, unit)
  if number >= low and number <= high then return number end
  core.fail(("%s: '%s' is %g%s, must be %g to %g"):format(owner, key, number, unit, low, high))
end

function trilith.concrete_creep(o)
  local owner = "concrete_creep"
  core.check_keys(owner, o, { "strength", "humidity", "size", "age", "cement" })
  local strength = within(owner, "strength", o.strength, " Pa", 10e6, 120e6)/1e6
  local humidity = within(owner, "humidity", o.humidity, "", 0.4, 1)
  local size = within(owner, "size", o.size, " m", 0.05, 3)*1e3
  local age = within(owner, "age", o.age, " s", 0.5*day, 36525*day)/day
  local cement = core.one_of(owner, "cement", o.cement or "N", { "S", "N", "R" })
  age = math.max(0.5, age*power(9/(2 + power(age, 1.2)) + 1, ageing[cement]))
  local notional, scale = annex_b(strength, humidity, size, age)
  local function coefficient(t) return notional*power(t/(scale + t), 0.3) end
  return { notional = notional, chain = fitted(coefficient),
    coefficient = function(seconds)
      return seconds > 0 and coefficient(seconds/day) or 0.0
    end }
end
