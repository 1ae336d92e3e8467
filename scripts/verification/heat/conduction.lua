-- Conduction in a slab and across a joint, in the plane and in space.
local trilith = require "trilith"
local h = 3600

-- Blocks of elements along x with these lengths; in space one element wide.
local function bar(dim, lengths, divisions, materials)
  local m = trilith.model { name = "bar", dim = dim, gravity = 0 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e11, ks = 1e11, mu = 0.6 } }
  local x, bodies = 0, {}
  for i, length in ipairs(lengths) do
    local k = materials[i]
    m:material { name = "m" .. i, density = k.density, E = 1e10 }
    local n, body = divisions[i]
    if dim == 2 then
      body = m:block { name = "b" .. i, width = length, height = 0.02, at = { x, 0 }, material = "m" .. i,
        body = { mesh = { n, 1 } }, floating = true }
    else
      body = m:block { name = "b" .. i, size = { length, 0.02, 0.02 }, at = { x, 0, 0 }, material = "m" .. i,
        body = { mesh = { n, 1, 1 } }, floating = true }
    end
    bodies[i], x = body, x + length
  end
  for i, body in ipairs(bodies) do
    m:heat { body = body, conductivity = materials[i].k, heat_capacity = materials[i].c,
      temperature = materials[i].start or 0 }
  end
  return m, bodies
end
local function at(dim, x) return dim == 2 and { x, 0 } or { x, 0, 0 } end
local slab = { k = 1.5, density = 2200, c = 900 }

local cases = {}
for _, dim in ipairs { 2, 3 } do
  local place = dim == 2 and "plane" or "space"
  local step = { { 1, 0.013537, 0.175783 }, { 2, 0.111022, 0.342425 }, { 4, 0.351371, 0.539944 } }
  local checks = {}
  for _, row in ipairs(step) do
    checks[#checks + 1] = { ("insulated face after %d h"):format(row[1]), unit = "degC", exact = row[2],
      tolerance = 0.005 }
    checks[#checks + 1] = { ("middle after %d h"):format(row[1]), unit = "degC", exact = row[3], tolerance = 0.005 }
  end
  cases[#cases + 1] = { name = "heat_step_" .. place, title = "slab with a stepped face, in " .. place,
    parameters = { { "dim", dim }, { "length", 0.2, "m" }, { "elements", 20 }, { "step", 60, "s" } },
    checks = checks,
    run = function(p)
      local m, b = bar(p.dim, { p.length }, { p.elements }, { slab })
      m:heat_exchange { body = b[1], side = "left", temperature = 1 }
      local out, hours = {}, 0
      for _, row in ipairs(step) do
        m:process { duration = (row[1] - hours)*h, step = p.step, mechanics = false }
        hours = row[1]
        out[("insulated face after %d h"):format(row[1])] = m:temperature(b[1], at(p.dim, p.length))
        out[("middle after %d h"):format(row[1])] = m:temperature(b[1], at(p.dim, p.length/2))
      end
      return out
    end }
  local air = { { 1, 0.998218, 0.702674 }, { 4, 0.886924, 0.524921 }, { 12, 0.545429, 0.316766 } }
  local air_checks = {}
  for _, row in ipairs(air) do
    air_checks[#air_checks + 1] = { ("insulated face after %d h"):format(row[1]), exact = row[2], tolerance = 0.005 }
    air_checks[#air_checks + 1] = { ("exposed face after %d h"):format(row[1]), exact = row[3], tolerance = 0.005 }
  end
  cases[#cases + 1] = { name = "heat_air_" .. place, title = "slab in air, in " .. place,
    parameters = { { "dim", dim }, { "length", 0.2, "m" }, { "elements", 20 }, { "step", 120, "s" },
      { "exchange", 10, "W/(m2 K)" } },
    checks = air_checks,
    run = function(p)
      local m, b = bar(p.dim, { p.length }, { p.elements }, { { k = 1.5, density = 2200, c = 900, start = 1 } })
      m:heat_exchange { body = b[1], side = "left", temperature = 0, exchange = p.exchange }
      local out, hours = {}, 0
      for _, row in ipairs(air) do
        m:process { duration = (row[1] - hours)*h, step = p.step, mechanics = false }
        hours = row[1]
        out[("insulated face after %d h"):format(row[1])] = m:temperature(b[1], at(p.dim, p.length))
        out[("exposed face after %d h"):format(row[1])] = m:temperature(b[1], at(p.dim, 0))
      end
      return out
    end }
  cases[#cases + 1] = { name = "heat_two_layers_" .. place, title = "two layers with a joint, steady, in " .. place,
    parameters = { { "dim", dim }, { "conductance", 25, "W/(m2 K)" } },
    checks = { { "flow", unit = "W/m2", exact = 80.35714, tolerance = 0.001 },
      { "warm side of the joint", unit = "degC", exact = 19.28571, tolerance = 0.001 },
      { "cold side of the joint", unit = "degC", exact = 16.07143, tolerance = 0.001 },
      { "flow with a perfect joint", unit = "W/m2", exact = 90, tolerance = 0.001 } },
    run = function(p)
      local function layers(conductance)
        local m, b = bar(p.dim, { 0.2, 0.1 }, { 8, 4 }, { slab, { k = 0.5, density = 2200, c = 900 } })
        m:heat_exchange { name = "warm", body = b[1], side = "left", temperature = 30 }
        m:heat_exchange { name = "cold", body = b[2], side = "right", temperature = 0 }
        m:heat_contact { conductance = conductance }
        m:process { duration = 400*h, step = 2*h, mechanics = false }
        local before = m:heat_state().surroundings.cold.supplied
        m:process { duration = h, step = h, mechanics = false }
        local area = p.dim == 2 and 0.02 or 0.02*0.02
        return m, b, (before - m:heat_state().surroundings.cold.supplied)/(h*area)
      end
      local m, b, flow = layers(p.conductance)
      local _, _, perfect = layers(1e9)
      return { flow = flow, ["warm side of the joint"] = m:temperature(b[1], at(p.dim, 0.2)),
        ["cold side of the joint"] = m:temperature(b[2], at(p.dim, 0.2)), ["flow with a perfect joint"] = perfect }
    end }
  local pair = { { 600, 0.625277, 0.998904, 0.915680 }, { 3600, 0.375292, 0.784956, 0.644020 },
    { 14400, 0.111291, 0.234751, 0.191938 } }
  local pair_checks = {}
  for _, row in ipairs(pair) do
    for k, name in ipairs { "joint", "outer faces", "means" } do
      pair_checks[#pair_checks + 1] = { ("%s after %d s"):format(name, row[1]), exact = row[k + 1], tolerance = 0.005 }
    end
  end
  pair_checks[#pair_checks + 1] = { "change of the heat content over it", exact = 0, within = 1e-12 }
  cases[#cases + 1] = { name = "heat_two_blocks_" .. place, title = "two blocks that exchange heat, in " .. place,
    parameters = { { "dim", dim }, { "conductance", 20, "W/(m2 K)" }, { "elements", 20 }, { "step", 10, "s" } },
    checks = pair_checks,
    run = function(p)
      local k = { k = 2, density = 2300, c = 900, start = 10 }
      local m, b = bar(p.dim, { 0.1, 0.1 }, { p.elements, p.elements }, { k, { k = 2, density = 2300, c = 900 } })
      m:heat_contact { conductance = p.conductance }
      local content, seconds, out = m:heat_state().content, 0, {}
      local function difference(x0, x1) return (m:temperature(b[1], x0) - m:temperature(b[2], x1))/10 end
      for _, row in ipairs(pair) do
        m:process { duration = row[1] - seconds, step = p.step, mechanics = false }
        seconds = row[1]
        out[("joint after %d s"):format(row[1])] = difference(at(p.dim, 0.1), at(p.dim, 0.1))
        out[("outer faces after %d s"):format(row[1])] = difference(at(p.dim, 0), at(p.dim, 0.2))
        out[("means after %d s"):format(row[1])] = difference()
      end
      out["change of the heat content over it"] = m:heat_state().content/content - 1
      return out
    end }
end

return {
  title = "Conduction and exchange",
  source = "Carslaw and Jaeger (1959), Conduction of Heat in Solids, chapters 3 and 11; series solutions",
  formula = [[\rho c\,\dot T = k\,T'' , \qquad q = h\,(T_\text{air} - T), \qquad q = h_c\,(T_a - T_b)]],
  text = "A slab whose face is stepped or exposed to air, two layers with a joint in the steady state, and two " ..
    "insulated blocks that exchange heat across a joint. A joint that is open carries no heat.",
  cases = cases,
}
