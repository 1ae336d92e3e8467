-- Mortar that softens: pulled, sheared and bent between rigid blocks.
local trilith = require "trilith"

local tension, cohesion, energy_tension, energy_shear = 3e6, 4e6, 100, 400

local function law(kn)
  return trilith.cohesive { kn = kn, ks = kn/2, mu = 0.5, tension = tension, cohesion = cohesion,
    energy_tension = energy_tension, energy_shear = energy_shear, beta = 1e-5 }
end

-- Two rigid blocks with a joint of 1 m2; the upper one follows a motion and does not turn, or turns alone.
local function joint(kn, support)
  local m = trilith.model { name = "mortar", gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = law(kn) }
  m:block { name = "below", width = 1, height = 0.5, at = { 0, -0.5 }, material = "stone", support = "fixed" }
  local above = m:block { name = "above", width = 1, height = 0.5, at = { 0, 0 }, material = "stone",
    support = support }
  return m, above
end

-- Largest reaction of the block below, the work that the block above has done against it, and the last reaction.
local function led(motion, support, read, moved)
  local m, above = joint(1e12, support)
  motion.body = above
  m:drive(motion)
  local below, most, work, before, u_before, last = m:body "below", 0, 0, 0, 0, 0
  m:run { duration = 1, until_true = function()
    local f, u = math.abs(read(below)), math.abs(moved(above))
    most, work = math.max(most, f), work + (f + before)/2*(u - u_before)
    before, u_before, last = f, u, f
    return false
  end }
  return most, work, last
end

local cases = {
  {
    name = "mortar_pulled", title = "joint of 1 m2 that is pulled apart",
    parameters = { { "tension", tension, "Pa" }, { "energy", energy_tension, "J/m2" } },
    checks = { { "largest pull", unit = "N", exact = tension, tolerance = 0.005 },
      { "work to pull it apart", unit = "J", exact = energy_tension, tolerance = 0.01 },
      { "pull at the end", unit = "N", exact = 0, within = 1 } },
    run = function()
      local most, work, last = led({ y = trilith.ramp { by = 1e-4, duration = 1 } }, { rotation = "fixed" },
        function(b) return b.reaction_y end, function(b) return b.uy end)
      return { ["largest pull"] = most, ["work to pull it apart"] = work, ["pull at the end"] = last }
    end,
  },
  {
    name = "mortar_sheared", title = "joint of 1 m2 that is sheared without normal stress",
    parameters = { { "cohesion", cohesion, "Pa" }, { "energy", energy_shear, "J/m2" } },
    checks = { { "largest force", unit = "N", exact = cohesion, tolerance = 0.005 },
      { "work to shear it off", unit = "J", exact = energy_shear, tolerance = 0.01 },
      { "force at the end", unit = "N", exact = 0, within = 1 } },
    run = function()
      local most, work, last = led({ x = trilith.ramp { by = 4e-4, duration = 1 } }, { rotation = "fixed" },
        function(b) return b.reaction_x end, function(b) return b.ux end)
      return { ["largest force"] = most, ["work to shear it off"] = work, ["force at the end"] = last }
    end,
  },
}

-- A joint that is bent: the upper block turns, and is free otherwise.
local function bent(p)
  local m, above
  if p.dim == 2 then
    m, above = joint(p.kn)
  else
    m = trilith.model { name = "mortar", gravity = 0, dim = 3 }
    m:material { name = "stone", density = 2400 }
    m:contact { between = { "*", "*" }, law = law(p.kn) }
    m:block { name = "below", size = { 1, 1, 0.5 }, at = { 0, 0, -0.5 }, material = "stone", support = "fixed" }
    above = m:block { name = "above", size = { 1, 1, 0.5 }, at = { 0, 0, 0 }, material = "stone",
      support = { rotation_x = "fixed", rotation_z = "fixed" } }
  end
  m:drive { body = above, [p.dim == 2 and "rotation" or "rotation_y"] = trilith.ramp { by = 2e-4, duration = 0.5 } }
  local most = 0
  m:run { duration = 0.4, until_true = function()
    local moment = 0
    for _, r in ipairs(above:reactions()) do moment = moment + (r.m or r.my) end
    most = math.max(most, math.abs(moment))
    return false
  end }
  return most/(tension/6)
end
for dim = 2, 3 do
  cases[#cases + 1] = {
    name = dim == 2 and "mortar_bent" or "mortar_bent_in_space",
    title = ("joint of 1 m between rigid halves that is bent, dim = %d"):format(dim),
    parameters = { { "kn", 1e13, "Pa/m" }, { "dim", dim } },
    checks = { { "largest moment over f b d^2/6", exact = 2.3472, tolerance = 0.01 } },
    run = bent,
  }
end

return {
  title = "Mortar that softens",
  source = "Hillerborg, Modeer and Petersson (1976), Cement and Concrete Research 6, for the fracture energy; the " ..
    "moment of the " ..
    "joint by integration of the linear softening law over its depth",
  formula = [[G_f = \int_0^{w_c} \sigma\,dw = \frac{f_t w_c}{2}, \qquad
M = \max_\varphi \int_0^d \sigma(\varphi z)\,z\,b\,dz]],
  cases = cases,
}
