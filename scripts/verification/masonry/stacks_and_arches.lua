-- Stacks and arches of rigid blocks without tension, on both sides of their limits.
local trilith = require "trilith"
local deg = trilith.units "deg"
local g = 9.80665

-- Joints so stiff that a hinge near the limit turns by less than 1e-3, damped by a share of the critical damping of a
-- stone of `length` between its two joints.
local function model(name, mu, length, kn, share)
  kn = kn or 4e12
  local m = trilith.model { name = name }
  m:material { name = "stone", density = 2000 }
  local frequency = math.sqrt(2*kn/(2000*length))
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = mu,
    beta = 2*(share or 0.2)/frequency } }
  return m
end

-- Lays the stones down under damping, then lets them go.
local function fate(m, stones)
  local function down() return stones.drift > 0.01 end
  m:consolidate { rest = { ratio = 1e-5, speed = 1e-5, hold = 0.02 }, duration = 1.5, grow = 0.001, or_go_on = true,
    within = 10, until_true = down }
  if down() then return "falls" end
  local report = m:run { duration = 0.5, rest = { speed = 1e-5, ratio = 1e-4, hold = 0.1 }, until_true = down }
  if down() then return "falls" end
  return report.ending == "rest" and "stands" or "neither"
end

local cases = {}
for count = 1, 5 do
  for _, factor in ipairs { 0.98, 1.02 } do
    cases[#cases + 1] = {
      name = ("harmonic_stack_%.0f_%.0f"):format(count, 100*factor), title = "harmonic stack",
      parameters = { { "count", count }, { "factor", factor } },
      checks = { { "stack", exact = factor < 1 and "stands" or "falls" } },
      run = function(p)
        local m = model("stack", 0.7, 0.2)
        return fate(m, m:harmonic_stack { name = "s", count = p.count, factor = p.factor, table_height = 0.5,
          material = "stone", fixed = "table" })
      end,
    }
  end
end

local function arch(p, kn)
  local half = (p.half_angle or 90)*deg
  local m = model("arch", p.mu or 10, 2*half/p.voussoirs, kn)
  return m, m:arch { name = "a", voussoirs = p.voussoirs, radius = 1, thickness = p.thickness, half_angle = half,
    sub_edges = p.voussoirs < 100 and 4 or 1, material = "stone", fixed = "abutments" }
end

local function both_sides(name, title, least, low, high, parameters)
  for _, share in ipairs { low, high } do
    local list = { table.unpack(parameters) }
    list[#list + 1] = { "thickness", share*least, "m" }
    cases[#cases + 1] = {
      name = ("%s_%.0f"):format(name, 100*share),
      title = ("%s, %s of the least thickness %s m"):format(title, share, least),
      parameters = list,
      checks = { { "arch", exact = share < 1 and "falls" or "stands" } },
      run = function(p)
        local m, stones = arch(p)
        return fate(m, stones)
      end,
    }
  end
end
for _, row in ipairs { { 7, .09624 }, { 11, .10491 } } do
  both_sides("arch_" .. row[1], "semicircle", row[2], 0.97, 1.03, { { "voussoirs", row[1] } })
end

-- Thrust of an arch that stands, between the least and the largest that equilibrium allows.
for _, row in ipairs { { 0.12, .1907, .2073 }, { 0.15, .1756, .2271 }, { 0.20, .1540, .2546 } } do
  cases[#cases + 1] = {
    name = ("thrust_%.0f"):format(100*row[1]), title = "thrust of a semicircle, found by statics",
    parameters = { { "voussoirs", 30 }, { "thickness", row[1], "m" } },
    checks = { { "thrust over weight", between = { row[2], row[3] } },
      { "unbalanced force over weight", exact = 0, within = 1e-8 } },
    run = function(p)
      local m, stones = arch(p, 1e11)
      local report = m:consolidate { integrator = "static", shares = 10 }
      local thrust, weight = 0, 0
      for _, c in ipairs(m:contacts { between = { "a.v15", "a.v16" } }) do thrust = thrust + math.abs(c.force[1]) end
      for body in stones do
        if body.name:find "^a%.v" then weight = weight + body.mass*g end
      end
      return { ["thrust over weight"] = thrust/weight, ["unbalanced force over weight"] = report.ratio }
    end,
  }
end
cases[#cases + 1] = {
  name = "thin_arch_static", title = "semicircle too thin to stand: statics finds no equilibrium",
  parameters = { { "voussoirs", 30 }, { "thickness", 0.10, "m" } },
  checks = { { "equilibrium", exact = "none" } },
  run = function(p)
    local m = arch(p, 1e11)
    local found = m:consolidate { integrator = "static", shares = 10, or_go_on = true }
    return found.rests and "found" or "none"
  end,
}

return {
  title = "Stacks and arches of rigid blocks",
  source = "Heyman (1966), The stone skeleton, International Journal of Solids and Structures 2, for the method. " ..
    "Couplet (1730) and Milankovitch (1907), Zeitschrift fuer Mathematik und Physik 55, for the semicircle. " ..
    "Limits of " ..
    "arches of equal voussoirs by linear programming with exact weights",
  formula = [[\frac{t}{R} \ge 0.10748 \;\text{(semicircle, radial joints, continuous)}, \qquad
d_n = \sum_{k=1}^{n}\frac{1}{2k}]],
  text = "Blocks without tension stand where a thrust line lies within them (Heyman's safe theorem). Each limit is " ..
    "tested on both sides: the stones settle under damping, and then without it.",
  cases = cases,
}
