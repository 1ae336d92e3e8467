-- trilith.bilinear{...}: bilinear idealisation of a capacity curve by code, limit states and target displacement.
-- trilith.drift_limit{...}: drift limits of masonry walls.
local trilith, core = ...

local code_names = { "eurocode8", "ntc2018" }

--- The points of a curve { displacement = {}, force = {} } with increasing displacement, from 0.
local function read_curve(owner, given)
  local curve = type(given) == "table" and (given.curve or given) or nil
  local d, f = curve and curve.displacement, curve and curve.force
  if type(d) ~= "table" or type(f) ~= "table" or #d ~= #f then
    core.fail(("%s: 'curve' is %s, must be the report of m:pushover, or its curve: lists 'displacement' and 'force' "
      .. "of one length"):format(owner, given == nil and "missing" or core.what_is(given)))
  end
  local points = { { 0, 0 } }
  for i = 1, #d do
    local number = type(d[i]) == "number" and type(f[i]) == "number" and d[i] == d[i] and f[i] == f[i]
    if not number then core.fail(("%s: point %d of 'curve' must be two numbers"):format(owner, i)) end
    -- A path that turns back is read up to its furthest displacement so far.
    if d[i] > points[#points][1] then points[#points + 1] = { d[i], f[i] } end
  end
  if #points < 3 then
    core.fail(("%s: 'curve' has %d points with increasing displacement above 0, needs 2; push in the positive "
      .. "direction"):format(owner, #points - 1))
  end
  return points
end

local function highest(points)
  local best = 1
  for i, p in ipairs(points) do
    if p[2] > points[best][2] then best = i end
  end
  return best
end

local function between(a, b, force)
  return a[1] + (b[1] - a[1])*(force - a[2])/(b[2] - a[2])
end

--- Displacement at which the force has fallen to `share` of the peak, or the last one, and false.
local function drop_at(points, peak, share)
  local level = share*points[peak][2]
  for i = peak + 1, #points do
    if points[i][2] <= level then return between(points[i - 1], points[i], level), true end
  end
  return points[#points][1], false
end

--- Displacement at which the force first reaches `level` on the way to the peak.
local function reach_at(points, peak, level)
  for i = 2, peak do
    if points[i][2] >= level then return between(points[i - 1], points[i], level) end
  end
  return points[peak][1]
end

--- Area below the curve up to a displacement.
local function area_to(points, displacement)
  local area = 0
  for i = 2, #points do
    local a, b = points[i - 1], points[i]
    if b[1] >= displacement then
      local f = a[2] + (b[2] - a[2])*(displacement - a[1])/(b[1] - a[1])
      return area + 0.5*(a[2] + f)*(displacement - a[1])
    end
    area = area + 0.5*(a[2] + b[2])*(b[1] - a[1])
  end
  return area
end

--- EN 1998-1 annex B.3: yield force = force at the mechanism (the peak), equal areas up to its displacement.
local function eurocode8(owner, points, peak)
  local force, last = points[peak][2], points[peak][1]
  local yield = 2*(last - area_to(points, last)/force)
  if yield > last*(1 + 1e-9) then
    core.fail(("%s: the curve lies below a straight line to its peak; the idealisation of eurocode8 needs a curve "
      .. "that bends, give code = \"ntc2018\""):format(owner))
  end
  return force, yield
end

--- Circolare 7/2019, C7.3.4.2: secant stiffness at a share of the peak, equal areas up to the ultimate displacement.
local function ntc2018(owner, points, peak, ultimate, elastic)
  local level = elastic*points[peak][2]
  local stiffness = level/reach_at(points, peak, level)
  local rest = ultimate^2 - 2*area_to(points, ultimate)/stiffness
  if rest < -1e-9*ultimate^2 then
    core.fail(("%s: no bilinear curve has the area of this curve and its stiffness at %g of the peak; give a larger or "
      .. "smaller share with 'elastic'"):format(owner, elastic))
  end
  local force = stiffness*(ultimate - math.sqrt(math.max(0, rest)))
  return force, force/stiffness
end

--- EN 1998-1 annex B.5: displacement under a spectrum with equal energy or equal displacement.
local function target(owner, spectrum, period, strength)
  local function at(T) return spectrum.at(T) end
  if type(spectrum) ~= "table" or type(spectrum.at) ~= "function" then
    core.fail(("%s: 'spectrum' is %s, must come from trilith.spectrum{...}"):format(owner, core.what_is(spectrum)))
  end
  local demand = at(period)
  local elastic = demand*(period/(2*math.pi))^2
  local ratio = demand/strength
  if period >= spectrum.TC or ratio <= 1 then return elastic end
  return math.max(elastic, elastic/ratio*(1 + (ratio - 1)*spectrum.TC/period))
end

local function share(owner, options, key, preset)
  local value = options[key] == nil and preset or options[key]
  if type(value) ~= "number" or not (value > 0 and value < 1) then
    core.fail(("%s: '%s' is %s, must be a share between 0 and 1"):format(owner, key, core.what_is(value)))
  end
  return value
end

--- Sets period, target and safety where a mass is given; without a spectrum the period only.
local function add_oscillator(owner, result, options)
  if options.mass == nil then
    for _, key in ipairs { "spectrum", "participation" } do
      if options[key] ~= nil then
        core.fail(("%s: '%s' needs 'mass', the mass that the push moves"):format(owner, key))
      end
    end
    return
  end
  local mass = core.positive(owner, "mass", options.mass, " kg")
  local part = options.participation == nil and 1 or core.positive(owner, "participation", options.participation, "")
  -- The equivalent oscillator has mass m*, force F/part and displacement d/part, so that the stiffness stays.
  result.period = 2*math.pi*math.sqrt(mass/result.stiffness)
  if not options.spectrum then return end
  result.target = part*target(owner, options.spectrum, result.period, result.yield_force/(part*mass))
  result.demand_to_capacity = result.target/result.ultimate_displacement
end

function trilith.bilinear(options)
  local owner = "bilinear"
  core.check_keys(owner, options, { "curve", "code", "drop", "elastic", "mass", "participation", "spectrum" })
  local code = core.one_of(owner, "code", options.code, code_names, "eurocode8")
  local points = read_curve(owner, options.curve)
  local peak = highest(points)
  if points[peak][2] <= 0 then core.fail(("%s: the largest force of 'curve' is not above 0"):format(owner)) end
  local drop = share(owner, options, "drop", code == "eurocode8" and 0.2 or 0.15)
  local elastic = share(owner, options, "elastic", 0.6)
  local ultimate, reached = drop_at(points, peak, 1 - drop)
  local force, yield
  if code == "eurocode8" then
    force, yield = eurocode8(owner, points, peak)
  else
    force, yield = ntc2018(owner, points, peak, ultimate, elastic)
  end
  local result = { code = code, peak_force = points[peak][2], displacement_at_peak = points[peak][1],
    yield_force = force, yield_displacement = yield, stiffness = force/yield, ultimate_displacement = ultimate,
    reached_drop = reached, ductility = ultimate/yield, energy = area_to(points, ultimate),
    -- EN 1998-3, C.3: yield point, 3/4 of the ultimate displacement, ultimate displacement
    damage_limitation = yield, significant_damage = 0.75*ultimate, near_collapse = ultimate }
  add_oscillator(owner, result, options)
  return result
end

--- EN 1998-3, C.4: drift capacity of walls in their plane, as a share of the height.
local wall_limits = {
  shear = function(primary) return primary and 0.004 or 0.006 end,
  flexure = function(primary, slenderness) return (primary and 0.008 or 0.012)*slenderness end,
}

function trilith.drift_limit(options)
  local owner = "drift_limit"
  core.check_keys(owner, options, { "mode", "state", "secondary", "height", "depth" })
  local mode = core.one_of(owner, "mode", options.mode, { "flexure", "shear" })
  local state = core.one_of(owner, "state", options.state, { "significant damage", "near collapse" },
    "significant damage")
  if options.secondary ~= nil and type(options.secondary) ~= "boolean" then
    core.fail(("%s: 'secondary' is %s, must be true or false"):format(owner, core.what_is(options.secondary)))
  end
  local slenderness = 1
  if mode == "flexure" then
    local height = core.positive(owner, "height", options.height, " m")
    slenderness = height/core.positive(owner, "depth", options.depth, " m")
  end
  local limit = wall_limits[mode](not options.secondary, slenderness)
  return state == "near collapse" and 4/3*limit or limit
end
