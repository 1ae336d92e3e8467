-- Stress in joints of rigid blocks: at rest, under eccentric force, with a bond that breaks.
local trilith = require "trilith"
local g = 9.80665

local function pair(options)
  local m = trilith.model { name = "joint", gravity = options.gravity or 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = options.law or trilith.frictional { kn = options.kn or 1e8,
    ks = (options.kn or 1e8)/2, mu = 0.6, beta = 1e-3 } }
  m:block { name = "base", width = options.base or 4, height = 1, at = { -(options.base or 4)/2, -1 },
    material = "stone",
    support = "fixed" }
  local body = m:block { name = "block", width = options.width or 1, height = options.height or 1,
    at = { options.x or -(options.width or 1)/2, 0 }, mass = options.mass or 1000, material = "stone",
    support = options.support }
  return m, body
end

local function depth(body, x) return -select(2, body:point { x, 0 }) end

local cases = {
  {
    name = "overlap_at_rest", title = "block at rest under its weight",
    parameters = { { "mass", 1000, "kg" }, { "kn", 1e8, "Pa/m" } },
    checks = { { "overlap", unit = "m", exact = 1000*g/1e8, tolerance = 1e-4 } },
    run = function()
      local m, body = pair { gravity = g }
      m:consolidate { integrator = "static" }
      return depth(body, 0)
    end,
  },
}

for _, row in ipairs { { 0.10, 16e3, 1.2e-4 }, { 0.25, 26666.7, 3.5556e-4 } } do
  cases[#cases + 1] = {
    name = ("eccentric_%.0f"):format(100*row[1]), title = "eccentric force",
    parameters = { { "e", row[1], "m" }, { "N", 1e4, "N" }, { "B", 1, "m" }, { "kn", 1e8, "Pa/m" } },
    checks = { { "stress at the edge", unit = "Pa", exact = row[2], tolerance = 0.005 },
      { "rotation", unit = "rad", exact = row[3], tolerance = 0.005 } },
    run = function(p)
      local m, body = pair {}
      m:point_load { body = body, at = { p.e, 0.5 }, force = { 0, -p.N } }
      m:consolidate { integrator = "static", shares = 4 }
      return { ["stress at the edge"] = p.kn*depth(body, 0.5), rotation = math.abs(body.rotation) }
    end,
  }
end

for _, shift in ipairs { 0.2, 0.5 } do
  cases[#cases + 1] = {
    name = ("partial_overlap_%.0f"):format(100*shift),
      title = "block that overhangs, force through the middle of the overlap",
    parameters = { { "shift", shift, "m" }, { "N", 1e4, "N" } },
    checks = { { "stress", unit = "Pa", exact = 1e4/(1 - shift), tolerance = 0.005 },
      { "rotation", unit = "rad", exact = 0, within = 1e-8 } },
    run = function(p)
      local m, body = pair { base = 1, x = p.shift - 0.5 }
      m:point_load { body = body, at = { p.shift/2, 0.5 }, force = { 0, -p.N } }
      m:consolidate { integrator = "static" }
      return { stress = 1e8*depth(body, p.shift/2), rotation = body.rotation }
    end,
  }
end

cases[#cases + 1] = {
  name = "faces_that_do_not_match", title = "three blocks of 1/3 m on one of 1 m, uniform pressure",
  parameters = { { "pressure", 1e6, "Pa" } },
  checks = { { "least stress", unit = "Pa", exact = 1e6, tolerance = 0.001 },
    { "largest stress", unit = "Pa", exact = 1e6, tolerance = 0.001 },
    { "largest rotation", unit = "rad", exact = 0, within = 1e-8 } },
  run = function(p)
    local m = trilith.model { name = "patch", gravity = 0 }
    m:material { name = "stone", density = 2400 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 5e9, mu = 0.6, beta = 1e-4 } }
    m:block { name = "base", width = 1, height = 1, at = { 0, -1 }, material = "stone", support = "fixed" }
    local low = m:block { name = "low", width = 1, height = 0.5, at = { 0, 0 }, material = "stone" }
    local tops = {}
    for i = 1, 3 do
      tops[i] = m:block { name = "top " .. i, width = 1/3, height = 0.5, at = { (i - 1)/3, 0.5 }, material = "stone" }
      m:pressure { body = tops[i], face = "top", value = p.pressure }
    end
    m:consolidate { integrator = "static" }
    local least, most, turn = math.huge, 0, math.abs(low.rotation)
    for i, top in ipairs(tops) do
      turn = math.max(turn, math.abs(top.rotation))
      for _, x in ipairs { (i - 1)/3, i/3 } do
        local _, y = top:point { x, 0.5 }
        local _, below = low:point { x, 0.5 }
        least, most = math.min(least, 1e10*(below - y)), math.max(most, 1e10*(below - y))
      end
    end
    return { ["least stress"] = least, ["largest stress"] = most, ["largest rotation"] = turn }
  end,
}

-- A block that is pulled off, or sheared, under a slow motion; force by the reactions of the base.
local function driven(law, motion, duration, force)
  local m, body = pair { law = law, support = { rotation = "fixed" } }
  if force then
    m:point_load { body = body, force = { 0, -force } }
    m:consolidate { integrator = "static" }
  end
  motion.body = body
  m:drive(motion)
  local x0, y0, most, at, last = body.x, body.y, 0, 0, 0
  local base = m:body "base"
  m:run { duration = duration, until_true = function()
    local pull = math.abs(motion.x and base.reaction_x or base.reaction_y)
    if pull > most then most, at = pull, math.abs(motion.x and body.x - x0 or body.y - y0) end
    last = pull
    return false
  end }
  return most, at, last
end
cases[#cases + 1] = {
  name = "bond_pulled", title = "bond that is pulled apart",
  parameters = { { "tension", 19150, "Pa" }, { "kn", 1e8, "Pa/m" } },
  checks = { { "largest pull", unit = "N", exact = 19150, tolerance = 0.005 },
    { "separation there", unit = "m", exact = 1.915e-4, tolerance = 0.005 },
    { "pull at the end", unit = "N", exact = 0, within = 1 } },
  run = function(p)
    local most, at, last = driven(trilith.bonded { kn = p.kn, ks = p.kn/2, mu = 0.7, tension = p.tension,
      cohesion = 9768,
      beta = 1e-4 }, { y = trilith.ramp { by = 4e-4, duration = 2 } }, 2)
    return { ["largest pull"] = most, ["separation there"] = at, ["pull at the end"] = last }
  end,
}
cases[#cases + 1] = {
  name = "bond_sheared", title = "bond that is sheared under a normal stress",
  parameters = { { "cohesion", 9768, "Pa" }, { "mu", 0.7002075 }, { "sigma", 5e4, "Pa" }, { "ks", 5e7, "Pa/m" } },
  checks = { { "largest force", unit = "N", exact = 44778, tolerance = 0.005 },
    { "slip there", unit = "m", exact = 8.956e-4, tolerance = 0.005 },
    { "force at the end", unit = "N", exact = 35010, tolerance = 0.005 } },
  run = function(p)
    local most, at, last = driven(trilith.bonded { kn = 1e8, ks = p.ks, mu = p.mu, tension = 19150,
      cohesion = p.cohesion,
      beta = 1e-4 }, { x = trilith.ramp { by = 1.5e-3, duration = 2 } }, 2, p.sigma)
    return { ["largest force"] = most, ["slip there"] = at, ["force at the end"] = last }
  end,
}

return {
  title = "Stress in joints",
  source = "Derived: a normal stress in proportion to the overlap, without tension, in equilibrium with the force",
  formula = [[\sigma_\text{edge} = \frac{N}{B}\left(1 + \frac{6e}{B}\right) \;\left(e \le \tfrac{B}{6}\right), \qquad
\sigma_\text{edge} = \frac{2N}{3(B/2 - e)} \;\left(e > \tfrac{B}{6}\right), \qquad \tau_\text{max} = c + \mu\sigma]],
  text = "The stress is distributed over the part of a face that is in contact.",
  cases = cases,
}
