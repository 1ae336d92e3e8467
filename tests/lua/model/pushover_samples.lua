-- m:pushover: `on_sample` gets the model and each sample of the curve, in time and by arc length, in the plane and in
-- space. The model is at the instant of the sample.
local trilith = require "trilith"

local function near(value, expected, share) return math.abs(value - expected) <= share*math.abs(expected) end

local function block_on_ground(dim)
  local m = trilith.model { dim = dim }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  if dim == 3 then
    m:block { name = "ground", size = { 4, 4, 1 }, at = { -2, -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", size = { 0.5, 0.5, 1 }, at = { 0, 0, 0 }, material = "stone" }
  else
    m:block { name = "ground", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
    m:block { name = "block", width = 0.5, height = 1, at = { 0, 0 }, material = "stone" }
  end
  m:consolidate { rest = { ratio = 1e-5 } }
  return m
end

--- Force at the centroid of a block of 0.5 by 1 m that rocks on a bed of springs without tension. The weight acts at a
--- third of the length c in contact, c^2 = 2 W/(kn thickness angle). Shear of this length adds to the displacement.
--- Small angles and a uniform shear: within 1 %.
local function rocking_force(sample, weight, thickness)
  local force, c = 0.5*weight, 0.07
  for _ = 1, 50 do
    local angle = (sample.displacement - force/(5e8*c*thickness))/0.5
    c = math.sqrt(2*weight/(1e9*thickness*angle))
    force = weight*(0.25 - c/3 - sample.displacement)/0.5
  end
  return force
end

for _, dim in ipairs { 2, 3 } do
  for _, control in ipairs { "time", "arc" } do
    local m, samples, places = block_on_ground(dim), {}, {}
    local push = m:pushover { body = "block", control = control, displacement = 2e-3,
      rate = control == "time" and 0.02 or nil, samples = 20,
      on_sample = function(model, sample)
        samples[#samples + 1], places[#places + 1] = sample, model.push_displacement
      end }
    local curve = push.curve
    -- In time the curve has its peak as a further point.
    assert(#samples == #curve.force - (control == "time" and 1 or 0))
    local at = 0
    for i, sample in ipairs(samples) do
      repeat at = at + 1 until curve.t[at] == sample.t
      assert(sample.force == curve.force[at] and sample.displacement == curve.displacement[at])
      assert(sample.drift == curve.drift[at])
      -- By arc length a sample is a state; in time it is the mean of an interval, at whose end the model is.
      if control == "arc" then assert(math.abs(places[i] - sample.displacement) < 1e-15) end
      if control == "time" then assert(places[i] > sample.displacement and places[i] - sample.displacement < 1e-4) end
    end
    if control == "arc" then
      local last = samples[#samples]
      assert(near(last.force, rocking_force(last, m:body("block").mass*9.80665, dim == 3 and 0.5 or 1), 0.01))
    end
  end
end

local m = block_on_ground(2)
local function refused(keys, pattern)
  local good, message = pcall(m.pushover, m, keys)
  assert(not good and tostring(message):find(pattern, 1, true), tostring(message))
end
refused({ body = "block", displacement = 1e-3, on_sample = 1 }, "'on_sample' is 1, must be a function")
refused({ body = "block", displacement = 1e-3, control = "arc", watch = false }, "'watch' is given, which is for")
refused({ body = "block", displacement = 1e-3, rate = 0.02, on_sample = function() error "mine" end }, "mine")

-- A function can end the stage; `watch` is known in time.
m = block_on_ground(2)
local count = 0
m:pushover { body = "block", displacement = 2e-3, rate = 0.02, samples = 20, watch = false, on_sample = function(model)
  count = count + 1
  if count == 5 then model:stop() end
end }
assert(count == 5)
