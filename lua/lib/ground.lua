-- m:level_ground{ level = 0, ... }, also m:ground{ level = 0, ... }: level ground under the whole model, in the plane
-- and in space: one fixed body, so large that no body of the model reaches its end.
local _, core = ...
local methods = core.members "model"
local with_profile = methods.ground

-- Density of a ground without material [kg/m3], as of dense sand. The ground is fixed, so no result depends on it.
local density = 2000

-- The ground extends beyond the model by this number of times its size.
local times = 10

--- Smallest and largest coordinates along each axis of the bodies so far: of their outlines in the plane, of their
--- centroids in space.
local function extent_of(model)
  local axes, low, high = model.dim == 3 and { "x", "y", "z" } or { "x", "y" }, {}, {}
  local function add(k, value)
    low[k], high[k] = math.min(low[k] or value, value), math.max(high[k] or value, value)
  end
  for _, body in ipairs(model:bodies {}) do
    if model.dim == 2 then
      for _, corner in ipairs(body.outline) do add(1, corner[1]) add(2, corner[2]) end
    else
      for k, axis in ipairs(axes) do add(k, body[axis]) end
    end
  end
  return low, high
end

local function number(owner, key, value)
  if type(value) ~= "number" or value ~= value or math.abs(value) == math.huge then
    core.fail(("%s: '%s' is %s, must be a number in m"):format(owner, key,
      value == nil and "missing" or core.what_is(value)))
  end
  return value
end

--- `owner`: the name by which the script calls it, for messages.
local function level_ground(owner, model, options)
  core.check_keys(owner, options, { "level", "material", "name", "groups", "reach" })
  local level, low, high = number(owner, "level", options.level), extent_of(model)
  if not low[1] then
    core.fail(owner .. ": the model has no body yet, and the ground is sized by it; call it after the bodies are made")
  end
  local size = 0
  for k = 1, model.dim do size = math.max(size, high[k] - low[k]) end
  size = math.max(size, math.abs(high[model.dim] - level))
  local reach = options.reach == nil and math.max(10, times*size) or core.positive(owner, "reach", options.reach, " m")
  local name, deep = options.name or "ground", 0.5*reach
  local groups = options.groups or { "ground" }
  local x0, x1 = low[1] - reach, high[1] + reach
  local own_density = options.material == nil and density or nil
  if model.dim == 2 then
    return model:polygon { name = name, material = options.material, density = own_density, groups = groups,
      support = "fixed", outline = { { x0, level - deep }, { x1, level - deep }, { x1, level }, { x0, level } } }
  end
  return model:block { name = name, material = options.material, density = own_density, groups = groups,
    support = "fixed", at = { x0, low[2] - reach, level - deep }, size = { x1 - x0, high[2] - low[2] + 2*reach, deep } }
end

function methods.level_ground(model, options) return level_ground("level_ground", model, options) end

function methods.ground(model, options)
  if type(options) == "table" and options.level ~= nil then return level_ground("ground", model, options) end
  return with_profile(model, options)
end
