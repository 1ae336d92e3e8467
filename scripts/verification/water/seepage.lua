-- Flow through joints by the cubic law: tapered joints, networks, filling, squeeze film, and a front in a dry fissure.
local trilith = require "trilith"
local weight = 1000*9.80665
local long = 1e9 -- s, to the steady state

local function model(kn)
  local m = trilith.model { name = "seepage" }
  m:material { name = "concrete", density = 2400 }
  m:material { name = "light", density = 1 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn or 1e11, ks = kn or 1e11, mu = 0.6 } }
  m:block { name = "rock", width = 12, height = 1, at = { -2, -1 }, material = "concrete", support = "fixed" }
  return m
end

local function tapered(p)
  local m = model()
  m:block { name = "dam", width = p.length, height = 2, at = { 0, 0 }, material = "concrete" }
  m:seepage { name = "joint", upper = "dam", lower = "rock", aperture = { p.heel*1e-3, p.toe*1e-3 },
    divisions = p.divisions, from = "lake", to = "toe" }
  m:seepage_head { node = "lake", head = p.head }
  m:seepage_head { node = "toe", head = 0 }
  m:process { duration = long, step = long, mechanics = false }
  local s = m:seepage_state "joint"
  local half = p.divisions//2
  return { flow = s.inflow, ["flow out"] = s.outflow, ["head in the middle"] = 0.5*(s.head[half] + s.head[half + 1]),
    uplift = s.force[2]/1e3, ["distance from the heel"] = s.moment/s.force[2] }
end

local function network(fissures, heads)
  local m = model()
  for i, f in ipairs(fissures) do
    m:seepage { name = "f" .. i, from = f[1], to = f[2], aperture = f[3]*1e-3, length = f[4], divisions = 4 }
  end
  for node, head in pairs(heads) do m:seepage_head { node = node, head = head } end
  for _ = 1, 2 do m:process { duration = long, step = long, mechanics = false } end
  return m:seepage_state().nodes
end

local function filling(p)
  local m = model()
  m:seepage { name = "joint", length = p.length, aperture = p.aperture*1e-3, stiffness = p.kn,
    divisions = p.divisions, from = "open", to = "shut" }
  m:seepage_head { node = "open", head = 1000/weight }
  local function state() return m:seepage_state("joint").pressure end
  local out, begun = {}, 0
  for _, t in ipairs { 0.37534, 0.75068, 1.87670, 3.75341 } do
    m:process { duration = t - begun, step = p.step, mechanics = false }
    begun = t
    out[("shut end at %.5f s"):format(t)] = state()[p.divisions]/1000
    if t == 0.37534 then out["middle at 0.37534 s"] = (state()[p.divisions//2] + state()[p.divisions//2 + 1])/2000 end
  end
  return out
end

local function plate(p, load)
  local m = model(p.kn)
  m:block { name = "plate", width = p.length, height = 0.5, at = { 0, 0 }, material = "light" }
  m:seepage { name = "joint", upper = "plate", lower = "rock", aperture = p.aperture*1e-3, divisions = p.divisions,
    from = "left", to = "right" }
  m:seepage_head { node = "left", head = 0 }
  m:seepage_head { node = "right", head = 0 }
  m:point_load { body = "plate", force = { 0, -load*p.length }, name = "load" }
  return m
end

local function squeezed(p)
  local m = plate(p, p.load*1e3)
  local out, begun, final = {}, 0, p.load*1e3/p.kn
  for _, t in ipairs { 0.00625, 0.0125, 0.025, 0.05, 0.075 } do
    m:process { duration = t - begun, step = (t - begun)/p.steps, tolerance = 1e-7 }
    begun = t
    out[("share of the closure at %g s"):format(t)] = -m:body("plate").uy/final
  end
  return out
end

local function squeezed_at_once(p)
  local m = plate(p, p.load*1e3)
  m:process { duration = 1e-10, step = 1e-10, tolerance = 1e-7 }
  local share = m:seepage_state("joint").force[2]/(p.load*1e3*p.length)
  m:process { duration = 2.5e-4, step = 2.5e-5, tolerance = 1e-7 }
  local s = m:seepage_state "joint"
  local half = p.divisions//2
  return { ["share of the water"] = share,
    ["pressure in the middle over the mean"] = (s.pressure[half] + s.pressure[half + 1])/2/(s.force[2]/p.length) }
end

local function front(p)
  local m = model()
  m:seepage { name = "fissure", length = 2, aperture = p.aperture*1e-3, divisions = p.divisions, from = "lake",
    filled = false }
  m:seepage_head { node = "lake", head = p.head }
  m:process { duration = 1, step = 0.01, mechanics = false }
  local first = m:seepage_state("fissure").wet_length
  m:process { duration = 9, step = 0.03, mechanics = false }
  return { ["front after 1 s"] = first, ["front after 10 s"] = m:seepage_state("fissure").wet_length }
end

local joint_parameters = { { "length", 8, "m" }, { "head", 9, "m" } }
local function taper_case(name, title, heel, toe, middle, uplift, at)
  return { name = name, title = title,
    parameters = { joint_parameters[1], joint_parameters[2], { "heel", heel, "mm" }, { "toe", toe, "mm" },
      { "divisions", 32 } },
    checks = { { "flow", unit = "m2/s", exact = 3.30974e-5, tolerance = 1e-3 },
      { "flow out", unit = "m2/s", exact = 3.30974e-5, tolerance = 1e-3 },
      { "head in the middle", unit = "m", exact = middle, tolerance = 0.005 },
      { "uplift", unit = "kN", exact = uplift, tolerance = 0.005 },
      { "distance from the heel", unit = "m", exact = at, tolerance = 0.005 } },
    run = tapered }
end

local function shares(times, values, tolerance)
  local checks = {}
  for i, name in ipairs(times) do checks[i] = { name, exact = values[i], tolerance = tolerance } end
  return checks
end

return {
  title = "Flow of water through joints",
  source = "Snow (1968) for the cubic law; Terzaghi (1925) for the filling; Reynolds (1886) for the squeeze film; " ..
    "Washburn (1921) for the front",
  formula = [[q = \frac{a^3 \rho g}{12 \mu} \frac{dh}{dx}, \qquad
D = \frac{a^3}{12\mu\,(a/K + 1/k_n)}, \qquad
k_n (a_0 - a) - \frac{\mu L^2 \dot a}{a^3} = p, \qquad
x_f = \sqrt{\frac{a^2 p\, t}{6 \mu}}]],
  text = "A joint with a tapered aperture, and networks of fissures, are compared in the steady state. A pressure " ..
    "that is raised at one end of a joint with elastic walls spreads by diffusion. A rigid plate that is loaded at " ..
    "once is carried by the water, which flows out at both ends: the flow and the equilibrium of the plate are " ..
    "solved together. In a dry fissure the front advances with the root of time.",
  cases = {
    taper_case("seepage_tapered", "joint that tapers from the heel to the toe", 0.6, 0.2, 7.59375, 529.559, 3.2958),
    taper_case("seepage_tapered_back", "joint that tapers from the toe to the heel", 0.2, 0.6, 1.40625, 176.520,
      1.8875),
    { name = "seepage_series", title = "two fissures in a row", parameters = { { "head", 3, "m" } },
      checks = { { "flow", unit = "m2/s", exact = 6.61949e-6, tolerance = 1e-3 },
        { "head between", unit = "m", exact = 2.4, tolerance = 1e-3 } },
      run = function(p)
        local n = network({ { "a", "b", 0.3, 2 }, { "b", "c", 0.15, 1 } }, { a = p.head, c = 0 })
        return { flow = n.a.inflow, ["head between"] = n.b.head }
      end },
    { name = "seepage_parallel", title = "two fissures side by side", parameters = { { "head", 3, "m" } },
      checks = { { "flow", unit = "m2/s", exact = 4.13718e-5, tolerance = 1e-3 } },
      run = function(p)
        local n = network({ { "a", "c", 0.3, 2 }, { "a", "c", 0.15, 1 } }, { a = p.head, c = 0 })
        return n.a.inflow
      end },
    { name = "seepage_loop", title = "network of seven fissures with loops", parameters = { { "head", 5, "m" } },
      checks = { { "head at node 1", unit = "m", exact = 3.344949, tolerance = 1e-3 },
        { "head at node 2", unit = "m", exact = 2.979282, tolerance = 1e-3 },
        { "head at node 3", unit = "m", exact = 1.661248, tolerance = 1e-3 },
        { "head at node 4", unit = "m", exact = 1.516614, tolerance = 1e-3 },
        { "flow", unit = "m2/s", exact = 1.082034e-5, tolerance = 1e-3 },
        { "balance at the nodes over the flow", exact = 0, within = 1e-12 } },
      run = function(p)
        local n = network({ { "0", "1", 0.2, 1 }, { "1", "2", 0.3, 1 }, { "1", "3", 0.1, 0.5 },
          { "2", "4", 0.15, 0.5 }, { "3", "4", 0.25, 1 }, { "4", "5", 0.2, 1 }, { "3", "5", 0.1, 1.5 } },
          { ["0"] = p.head, ["5"] = 0 })
        local worst = math.abs(n["0"].inflow + n["5"].inflow)
        for i = 1, 4 do worst = math.max(worst, math.abs(n[tostring(i)].inflow)) end
        local out = { flow = n["0"].inflow, ["balance at the nodes over the flow"] = worst/n["0"].inflow }
        for i = 1, 4 do out["head at node " .. i] = n[tostring(i)].head end
        return out
      end },
    { name = "seepage_filling", title = "pressure that spreads in a joint with elastic walls",
      parameters = { { "length", 5, "m" }, { "aperture", 0.2, "mm" }, { "kn", 1e10, "Pa/m" }, { "divisions", 50 },
        { "step", 0.0005, "s" } },
      checks = shares({ "shut end at 0.37534 s", "shut end at 0.75068 s", "shut end at 1.87670 s",
        "shut end at 3.75341 s", "middle at 0.37534 s" }, { 0.05069, 0.22769, 0.62922, 0.89202, 0.26435 }, 0.01),
      run = filling },
    { name = "seepage_plate", title = "rigid plate on a joint full of water, loaded at once",
      parameters = { { "length", 2, "m" }, { "aperture", 0.2, "mm" }, { "kn", 2e10, "Pa/m" }, { "load", 100, "kPa" },
        { "divisions", 50 }, { "steps", 50 } },
      checks = shares({ "share of the closure at 0.00625 s", "share of the closure at 0.0125 s",
        "share of the closure at 0.025 s", "share of the closure at 0.05 s", "share of the closure at 0.075 s" },
        { 0.21953, 0.38868, 0.62208, 0.85302, 0.94222 }, 0.01),
      run = squeezed },
    { name = "seepage_plate_begins", title = "the same plate, just after it was loaded",
      parameters = { { "length", 2, "m" }, { "aperture", 0.2, "mm" }, { "kn", 2e10, "Pa/m" }, { "load", 100, "kPa" },
        { "divisions", 50 } },
      checks = { { "share of the water", exact = 0.9982, tolerance = 0.001 },
        { "pressure in the middle over the mean", exact = 1.5, tolerance = 0.01 } },
      run = squeezed_at_once },
    { name = "seepage_front", title = "front of the water in a dry fissure",
      parameters = { { "aperture", 0.3, "mm" }, { "head", 2, "m" }, { "divisions", 50 } },
      checks = { { "front after 1 s", unit = "m", exact = 0.5424, tolerance = 0.03 },
        { "front after 10 s", unit = "m", exact = 1.71522, tolerance = 0.03 } },
      run = front },
  },
}
