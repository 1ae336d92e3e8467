-- m:creep{...} and m:creep_process{...}: joints that creep under lasting forces. A Kelvin element stands behind the
-- spring of a bearing:
--
--     f = k (d - c),    T dc/dt + c = factor f/k
--
-- Under a constant force the displacement grows from f/k to (1 + factor) f/k; at constant displacement the force
-- relaxes to the share 1/(1 + factor) with the time T/(1 + factor). Findley, Lai and Onaran, "Creep and relaxation of
-- nonlinear viscoelastic materials", 1976.
--
-- In each step c is computed for the force at the beginning. After equilibrium it is computed again for a force that
-- changes linearly, and the equation is integrated exactly. With m:change c moves the origin of the bearing's law. This
-- law is part of the model, so a continued run repeats it.
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

function methods.creep(model, o)
  local owner = "creep"
  core.check_keys(owner, o, { "bearing", "direction", "stiffness", "factor", "time" })
  local bearing = bearing_of(model, owner, o.bearing)
  local row = { bearing = bearing, name = bearing.name, c = 0.0,
    direction = core.one_of(owner, "direction", o.direction, directions(model.dim)),
    k = core.positive(owner, "stiffness", o.stiffness, ", the stiffness of the bearing's linear law"),
    factor = core.positive(owner, "factor", o.factor, ""), time = core.positive(owner, "time", o.time, " s") }
  local rows = creeping[model] or {}
  for _, known in ipairs(rows) do
    if known.name == row.name and known.direction == row.direction then
      core.fail(("%s: bearing '%s' creeps in the direction %s already"):format(owner, row.name, row.direction))
    end
  end
  rows[#rows + 1], creeping[model] = row, rows
end

-- Creep displacement after `dt` in which the force goes linearly from `first` to `last`.
local function crept(row, first, last, dt)
  local x = dt/row.time
  local kept = exp(-x)
  local mean = x < 1e-4 and 1 - x/2*(1 - x/3*(1 - x/4)) or (1 - kept)/x
  return row.c*kept + row.factor/row.k*(first*(mean - kept) + last*(1 - mean))
end

local function is_live(row) return row.bearing.status == "intact" or row.bearing.status == "yielded" end
local function force_of(row) return row.bearing.force[row.direction] end

local function move_origin(model, row, c)
  local far = longest_displacement
  model:change { bearing = row.name,
    [row.direction] = trilith.table { points = { { c - far, -far*row.k }, { c + far, far*row.k } } } }
end

local function rest(model, s, dt)
  if s.heat then return model:process { duration = dt, step = dt, name = s.name } end
  return model:consolidate { integrator = "static", name = s.name, within = s.within, tolerance = s.tolerance }
end

local function step(model, rows, s, dt)
  local first = {}
  for i, row in ipairs(rows) do first[i] = is_live(row) and force_of(row) or nil end
  for pass = 1, 2 do
    local c = {}
    for i, row in ipairs(rows) do
      if first[i] and is_live(row) then c[i] = crept(row, first[i], pass == 1 and first[i] or force_of(row), dt) end
    end
    for i, row in ipairs(rows) do
      if c[i] then move_origin(model, row, c[i]) end
    end
    rest(model, pass == 1 and s or { name = s.name, within = s.within, tolerance = s.tolerance }, dt)
    if pass == 2 then
      for i, row in ipairs(rows) do row.c = c[i] or row.c end
    end
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
  for _, row in ipairs(rows) do
    local longest = row.time/(1 + row.factor)
    if dt > longest*(1 + 1e-9) then
      core.fail(("%s: 'step' is %g s, must be at most %g s for bearing '%s': its time over (1 + factor)"):format(owner,
        dt, longest, row.name))
    end
  end
  local s = { name = o.name or "creep", within = o.within, tolerance = o.tolerance, heat = o.heat }
  for _ = 1, count do
    step(model, rows, s, dt)
    clocks[model] = (clocks[model] or 0) + dt
    if o.each then o.each(clocks[model]) end
  end
  return clocks[model]
end
