-- Thermal strain: restrained blocks, bars with a gap, girders with a gradient, struts.
local trilith = require "trilith"

-- Bodies in the plane, 1 m thick, of elements; in space as deep as they are high.
local function model(dim, kn, E, nu)
  local m = trilith.model { name = "bars", dim = dim, gravity = 0 }
  m:material { name = "stone", density = 2400, E = E, nu = nu or 0 }
  m:material { name = "wall", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn, mu = 0.6 } }
  return m
end
local function block(m, name, x, length, depth, n, material, keys)
  local t = { name = name, material = material or "stone" }
  if m.dim == 2 then
    t.width, t.height, t.at = length, depth, { x, 0 }
    t.body = n and { mesh = { n, 1 } } or "rigid"
  else
    t.size, t.at = { length, depth, depth }, { x, 0, 0 }
    t.body = n and { mesh = { n, 1, 1 } } or "rigid"
  end
  for k, v in pairs(keys or {}) do t[k] = v end
  return m:block(t)
end
local function properties(body, expansion)
  return { body = body, conductivity = 2, heat_capacity = 900, expansion = expansion }
end
-- Compression of a body along x [Pa].
local function pressed(body) return -body.sxx end

local cases = {}
for _, dim in ipairs { 2, 3 } do
  local place = dim == 2 and "plane" or "space"
  cases[#cases + 1] = { name = "restrained_blocks_" .. place, title = "five blocks between walls, in " .. place,
    parameters = { { "dim", dim }, { "kn", 5e10, "Pa/m" }, { "rise", 25, "K" } },
    checks = { { "stress", unit = "MPa", exact = 1.81818, tolerance = 0.001 } },
    run = function(p)
      local m = model(p.dim, p.kn, 20e9)
      block(m, "left", -0.5, 0.5, 0.4, nil, "wall", { support = "fixed" })
      block(m, "right", 2, 0.5, 0.4, nil, "wall", { support = "fixed" })
      local blocks = {}
      for i = 1, 5 do blocks[i] = block(m, "b" .. i, 0.4*(i - 1), 0.4, 0.4, 1, nil, { floating = true }) end
      m:heat(properties(blocks, 8e-6))
      m:set_temperature { body = blocks, temperature = p.rise }
      m:consolidate { integrator = "static" }
      return pressed(blocks[3])/1e6
    end }
  cases[#cases + 1] = { name = "bars_with_gap_" .. place, title = "two bars held outside, with a gap, in " .. place,
    parameters = { { "dim", dim }, { "gap", 0.4e-3, "m" }, { "kn", 1e11, "Pa/m" } },
    checks = { { "stress at 9.9 K", unit = "MPa", exact = 0, within = 1e-6 },
      { "contacts at 9.9 K", exact = 0, within = 0.5 }, { "contacts at 10.1 K", exact = "some" },
      { "stress at 20 K", unit = "MPa", exact = 2.7907, tolerance = 0.001 },
      { "stress at 40 K", unit = "MPa", exact = 8.3721, tolerance = 0.001 },
      { "stress without the other bar", unit = "MPa", exact = 0, within = 1.2e-8 } },
    run = function(p)
      local function bars(count)
        local m = model(p.dim, p.kn, 30e9)
        local far = p.dim == 2 and function(x) return { { x - 0.01, -1 }, { x + 0.01, 1 } } end
          or function(x) return { { x - 0.01, -1, -1 }, { x + 0.01, 1, 1 } } end
        local all = {}
        for i = 1, count do
          local x = i == 1 and 0 or 2 + p.gap
          local at = far(i == 1 and 0 or 4 + p.gap)
          all[i] = block(m, "bar" .. i, x, 2, 0.1, 4, nil, { floating = true,
            hold = { { from = at[1], to = at[2], x = "fixed", y = "free", z = p.dim == 3 and "free" or nil } } })
        end
        m:heat(properties(all, 1e-5))
        return m, all
      end
      local out = {}
      local m, all = bars(2)
      local function warm(t)
        m:set_temperature { body = all[1], temperature = t }
        m:set_temperature { body = all[2], temperature = t }
        m:consolidate { integrator = "static" }
      end
      warm(9.9)
      out["stress at 9.9 K"], out["contacts at 9.9 K"] = pressed(all[1])/1e6, #m:contacts()
      warm(10.1)
      out["contacts at 10.1 K"] = #m:contacts() > 0 and "some" or "none"
      for _, t in ipairs { 20, 40 } do
        warm(t)
        out[("stress at %d K"):format(t)] = pressed(all[1])/1e6
      end
      local alone, one = bars(1)
      alone:set_temperature { body = one[1], temperature = 40 }
      alone:consolidate { integrator = "static", tolerance = 1e-12 }
      out["stress without the other bar"] = pressed(one[1])/1e6
      return out
    end }
end

-- A girder of one or two spans on seats that do not pull. `rise`: upper less lower face [K].
local function girder(spans, rise, weight)
  local m = trilith.model { name = "girder" }
  m:material { name = "concrete", density = weight/1.2/9.80665, E = 35e9 }
  m:material { name = "pier", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e12, ks = 0, mu = 0 } }
  local joints, members = {}, {}
  for i = 0, spans do
    joints["J" .. i] = { at = { 20*i, 0.6 }, support = i == 0 and { x = "fixed" } or nil }
    if i > 0 then
      members[i] = { from = "J" .. i - 1, to = "J" .. i, divisions = 16,
        section = trilith.rectangle_section { width = 1, depth = 1.2 } }
    end
  end
  local body = m:frame { name = "girder", material = "concrete", joints = joints, members = members, floating = true }
  local seats = {}
  for i = 0, spans do
    seats[i] = m:block { name = "seat" .. i, width = 1, height = 1, at = { 20*i - 0.5, -1.5 }, material = "pier",
      support = "fixed" }
    m:bearing { name = "bearing" .. i, between = { seats[i], body }, from = { 20*i, -0.5 }, to = { 20*i, 0.6 },
      axial = trilith.gap { stiffness = 1e13, opening = 0, side = -1 } }
  end
  m:heat { body = body, conductivity = 2, heat_capacity = 900, expansion = 1e-5, depth = 1.2 }
  m:set_temperature { body = body, temperature = 0, gradient = rise/1.2 }
  m:consolidate { integrator = "static" }
  return m, body, seats
end

-- Vertical force on a seat without its own weight, and height of a joint above its place [N], [m].
local function reading(seats, body, i)
  return seats[i].reaction_y - seats[i].mass*9.80665, select(2, body:point("J" .. i)) - 0.6
end
local function bow(body) return select(2, body:point { 10, 0.6 }) - 0.6 end

cases[#cases + 1] = { name = "gradient_one_span", title = "simple girder, linear temperature over the depth",
  parameters = { { "span", 20, "m" }, { "depth", 1.2, "m" }, { "difference", 15, "K" } },
  checks = { { "rise of the middle", unit = "mm", exact = 6.25, tolerance = 0.005 },
    { "moment by temperature", unit = "kN m", exact = 0, within = 0.01 } },
  run = function(p)
    local _, cold = girder(1, 0, 15e3)
    local _, warm = girder(1, p.difference, 15e3)
    local function moment(body)
      for _, row in ipairs(body:forces "J0-J1") do
        if math.abs(row.x - 10) < 1e-2 then return row.moment end
      end
    end
    return { ["rise of the middle"] = 1e3*(bow(warm) - bow(cold)),
      ["moment by temperature"] = (moment(warm) - moment(cold))/1e3 }
  end }

cases[#cases + 1] = { name = "gradient_two_spans", title = "girder of two spans, linear temperature over the depth",
  parameters = { { "span", 20, "m" }, { "depth", 1.2, "m" }, { "difference", 15, "K" }, { "weight", 15e3, "N/m" } },
  checks = { { "moment over the middle seat", unit = "kN m", exact = 945, tolerance = 0.005 },
    { "reaction at the ends", unit = "kN", exact = 47.25, tolerance = 0.005 },
    { "reaction in the middle", unit = "kN", exact = 94.5, tolerance = 0.005 },
    { "ends with the top 35 K colder", exact = "rest" }, { "ends with the top 36.4 K colder", exact = "lift" },
    { "middle with the top 59 K hotter", exact = "rests" }, { "middle with the top 60 K hotter", exact = "lifts" } },
  run = function(p)
    local _, cold, seats_cold = girder(2, 0, p.weight)
    local _, warm, seats_warm = girder(2, p.difference, p.weight)
    local function moment(body)
      for _, row in ipairs(body:forces "J0-J1") do
        if math.abs(row.x - p.span) < 1e-2 then return row.moment end
      end
    end
    local function change(i)
      return math.abs(reading(seats_warm, warm, i) - reading(seats_cold, cold, i))/1e3
    end
    local function lifts(difference, i)
      local _, body, seats = girder(2, difference, p.weight)
      local _, above = reading(seats, body, i)
      return above > 1e-7
    end
    return { ["moment over the middle seat"] = math.abs(moment(warm) - moment(cold))/1e3,
      ["reaction at the ends"] = change(0), ["reaction in the middle"] = change(1),
      ["ends with the top 35 K colder"] = lifts(-35, 0) and "lift" or "rest",
      ["ends with the top 36.4 K colder"] = lifts(-36.4, 0) and "lift" or "rest",
      ["middle with the top 59 K hotter"] = lifts(59, 1) and "lifts" or "rests",
      ["middle with the top 60 K hotter"] = lifts(60, 1) and "lifts" or "rests" }
  end }

cases[#cases + 1] = { name = "warm_struts", title = "two struts that carry no load",
  parameters = { { "half_span", 5, "m" }, { "rise", 2, "m" }, { "difference", 30, "K" } },
  checks = { { "apex up", unit = "mm", exact = 4.3459, tolerance = 0.001 },
    { "normal force over E A alpha T", exact = 0, within = 0.001 } },
  run = function(p)
    local m = trilith.model { name = "struts", gravity = 0 }
    m:material { name = "steel", density = 7850, E = 2.1e11 }
    local section = trilith.rectangle_section { width = 0.05, depth = 0.05 }
    local pin = { x = "fixed", y = "fixed" }
    local body = m:frame { name = "struts", material = "steel", floating = true,
      joints = { A = { at = { 0, 0 }, support = pin }, B = { p.half_span, p.rise },
        C = { at = { 2*p.half_span, 0 }, support = pin } },
      members = { { from = "A", to = "B", section = section, divisions = 4 },
        { from = "B", to = "C", section = section, divisions = 4 } } }
    m:heat { body = body, conductivity = 50, heat_capacity = 450, expansion = 1e-5, depth = 0.05 }
    m:set_temperature { body = body, temperature = p.difference }
    m:consolidate { integrator = "static" }
    return { ["apex up"] = 1e3*(select(2, body:point "B") - p.rise),
      ["normal force over E A alpha T"] = body:forces("A-B")[1].normal/(2.1e11*0.0025*1e-5*p.difference) }
  end }

return {
  title = "Thermal strain",
  source = "Timoshenko (1955), Strength of Materials, part I; Boley and Weiner (1960), Theory of Thermal Stresses",
  formula = [[\sigma = \frac{\alpha\,\Delta T\,L}{L/E + n/k_n}, \qquad
w = \frac{\alpha\,\Delta T\,L^2}{8 h}]],
  text = "Blocks and bars that cannot expand, a gap that closes, and a bar that can expand, which has no " ..
    "stress. A girder whose top is warmer bows upwards; over three seats it is restrained, and lifts off seats that " ..
    "do not pull.",
  cases = cases,
}
