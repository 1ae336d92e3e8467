-- Equilibrium is searched for near the given configuration. Below its limit each model rests in place; beyond it the
-- search ends as unstable and names a body, by statics and by explicit consolidation, in the plane and in space.
local trilith = require "trilith"

local function model(dim, mu, law)
  local m = trilith.model { name = "near", dim = dim }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = law
    or trilith.frictional { kn = 2e9, ks = 1e9, mu = mu, beta = 2e-4 } }
  return m
end

-- A convex outline {x, z}; in space 0.5 m deep.
local function body(m, name, outline, support)
  if m.dim == 2 then return m:polygon { name = name, outline = outline, material = "stone", support = support } end
  local corners = {}
  for _, at in ipairs(outline) do
    corners[#corners + 1] = { at[1], -0.25, at[2] }
    corners[#corners + 1] = { at[1], 0.25, at[2] }
  end
  return m:body { name = name, material = "stone", support = support, pieces = { { hull = corners } } }
end
local function box(m, name, x0, z0, x1, z1, support)
  return body(m, name, { { x0, z0 }, { x1, z0 }, { x1, z1 }, { x0, z1 } }, support)
end

-- Each case returns a model that is stable if `good`, and the bodies of which the message must name one.
local cases = {}

function cases.overhang(dim, good) -- limit 0.5 of its length
  local m, over = model(dim, 0.7), good and -0.02 or 0.02
  box(m, "floor", -4, -0.5, 4, 0, "fixed")
  box(m, "low", -1, 0, 0, 0.5)
  box(m, "top", over - 0.5, 0.5, over + 0.5, 0.8)
  return m, { top = true }
end

function cases.slope(dim, good) -- a block of 0.3 by 1 m topples above 16.7 degrees
  local m, a = model(dim, 0.9), math.rad(good and 15 or 18)
  local function at(x, z) return { math.cos(a)*x - math.sin(a)*z, math.sin(a)*x + math.cos(a)*z } end
  body(m, "ramp", { at(-6, -1), at(3, -1), at(3, 0), at(-6, 0) }, "fixed")
  body(m, "block", { at(-0.15, 0), at(0.15, 0), at(0.15, 1), at(-0.15, 1) })
  return m, { block = true }
end

function cases.plank(dim, good) -- on a smooth wall at 60 degrees; limit 0.2412
  local m, mu = model(dim, 0, nil), good and 0.26 or 0.22
  m:material { name = "rough", density = 2400 }
  m:contact { between = { "stone", "rough" },
    law = trilith.frictional { kn = 2e9, ks = 1e9, mu = mu, beta = 1e-4 } }
  local x0, h, e = 1.5, 3*math.sin(math.rad(60)), 0.005
  local floor = { { -1, -0.5 }, { 5, -0.5 }, { 5, 0 }, { -1, 0 } }
  if dim == 2 then m:polygon { name = "floor", outline = floor, material = "rough", support = "fixed" }
  else
    m:block { name = "floor", size = { 6, 2, 0.5 }, at = { -1, -1, -0.5 }, material = "rough", support = "fixed" }
  end
  box(m, "wall", -0.5, 0.001, 0, 5, "fixed")
  body(m, "plank", { { x0 - e, 0 }, { x0 + e, 0 }, { x0 + e, 0.01 }, { 0, h + e }, { 0, h - e } })
  return m, { plank = true }
end

function cases.corbel(dim, good) -- 0.4 m of stone bonded to a wall by 0.2 m: s = M/(h^2/6) = 56.5 kPa
  local tension = good and 1e5 or 3e4
  local m = model(dim, nil, trilith.bonded { kn = 5e9, ks = 2.5e9, mu = 0.7, cohesion = 1e6, tension = tension,
    beta = 2e-4 })
  box(m, "floor", -4, -2.5, 4, -2, "fixed")
  box(m, "wall", -1, -2, 0, 1, "fixed")
  box(m, "brick", 0, 0, 0.4, 0.2)
  return m, { brick = true }
end

function cases.arch(dim, good) -- semicircle, least t/R 0.107
  local m, names = model(dim, 0.7), {}
  box(m, "floor", -4, -0.5, 4, 0, "fixed")
  local t, n = good and 0.13 or 0.09, 21
  for i = 1, n do
    local a, b = math.pi*(i - 1)/n, math.pi*i/n
    local function at(r, c) return { r*math.cos(c), r*math.sin(c) } end
    body(m, "v" .. i, { at(1 - t/2, a), at(1 + t/2, a), at(1 + t/2, b), at(1 - t/2, b) })
    names["v" .. i] = true
  end
  return m, names
end

local function named(text, names)
  local name = text:match "unstable: (%S+) moved by"
  return name and names[name]
end

for name, make in pairs(cases) do
  for _, dim in ipairs { 2, 3 } do
    for _, good in ipairs { true, false } do
      for _, how in ipairs { "static", "explicit" } do
        local m, names = make(dim, good)
        local what = ("%s, dim %d, %s, %s"):format(name, dim, good and "below its limit" or "beyond its limit", how)
        local ok, report = pcall(m.consolidate, m, how == "static" and { integrator = "static" }
          or { duration = 15, rest = { ratio = 1e-4, speed = 1e-4, hold = 0.1 } })
        if good then
          assert(ok and report.rests, what .. ": " .. tostring(report))
          assert(m.verdict.sound and #m.notes == 0, what)
        elseif how == "static" then
          assert(not ok and named(tostring(report), names), what .. ": " .. tostring(report))
          assert(m.verdict.sound, what) -- the state is unchanged
          for body_name in pairs(names) do assert(m:body(body_name).ux == 0, what) end
        else
          assert(ok and report.ending == "unstable" and not report.rests, what .. ": " .. tostring(report))
          assert(named(report.reason, names), what .. ": " .. report.reason)
          assert(not m.verdict.sound and m.verdict.text:find("unstable", 1, true) and #m.notes == 1, what)
        end
        m:close()
      end
    end
  end
end
-- Related cases, by both methods: a body of elements, a body added later, a wider limit, a continued run, and a body
-- given in the air, which moves to its place.
local function tower(dim)
  local m = model(dim, 0.7)
  box(m, "floor", -4, -0.5, 4, 0, "fixed")
  box(m, "low", -1, 0, 0, 0.5)
  return m
end
for _, how in ipairs { "static", "explicit" } do
  local function rest(m, more)
    local o = how == "static" and { integrator = "static" }
      or { duration = 8, rest = { ratio = 1e-3, speed = 1e-3, hold = 0.1 } }
    for key, value in pairs(more or {}) do o[key] = value end
    local ok, report = pcall(m.consolidate, m, o)
    return ok and report.ending or tostring(report):match "unstable" or tostring(report), m
  end
  for _, dim in ipairs { 2, 3 } do
    local m = tower(dim)
    assert(rest(m) == "rest", how)
    box(m, "top", -0.46, 0.5, 0.54, 0.8)
    local ending = rest(m, { or_go_on = true })
    assert(ending == "unstable" and m.verdict.sound and #m.notes == 1, how .. ", added later: " .. ending)
    m:close()
    m = tower(dim)
    box(m, "top", -0.46, 0.5, 0.54, 0.8)
    assert(rest(m, { within = 5 }) == "rest", how .. ", a wider limit")
    m:close()
  end
  for _, over in ipairs { -0.04, 0.04 } do
    local m = trilith.model { name = "mesh" }
    m:material { name = "stone", density = 2400, E = 1e9, nu = 0.2 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.7, beta = 2e-4 } }
    box(m, "floor", -4, -0.5, 4, 0, "fixed")
    box(m, "low", -1, 0, 0, 0.5)
    m:block { name = "top", width = 1, height = 0.3, at = { over - 0.5, 0.5 }, material = "stone",
      body = { mesh = { 4, 2 } } }
    local ending = rest(m)
    assert(ending == (over < 0 and "rest" or "unstable"), how .. ", of elements: " .. ending)
    m:close()
  end
end
-- Overhangs from far below to far above the limit of half the length, and a support that is taken away.
for _, how in ipairs { "static", "explicit" } do
  local keys = how == "static" and { integrator = "static", or_go_on = true }
    or { duration = 12, rest = { ratio = 1e-3, speed = 1e-3, hold = 0.1 } }
  for _, dim in ipairs { 2, 3 } do
    for _, over in ipairs { 0.3, 0.45, 0.49, 0.51, 0.55, 0.7 } do
      local m = tower(dim)
      box(m, "top", over - 1, 0.5, over, 0.8)
      local ending = m:consolidate(keys).ending
      assert(ending == (over < 0.5 and "rest" or "unstable"), ("%s, dim %d, overhang %g: %s"):format(how, dim, over,
        ending))
      m:close()
    end
    local m = tower(dim)
    box(m, "top", -0.55, 0.5, 0.65, 0.8)
    box(m, "weight", -0.55, 0.8, -0.05, 1.2)
    assert(m:consolidate { integrator = "static" }.ending == "rest", "held by a weight")
    m:remove "weight"
    local ending = m:consolidate(keys).ending
    assert(ending == "unstable", ("%s, dim %d, its weight removed: %s"):format(how, dim, ending))
    m:close()
  end
end
do
  local m = model(2, 0.7)
  box(m, "floor", -4, -0.5, 4, 0, "fixed")
  m:block { name = "loose", width = 0.3, height = 0.3, at = { 0, 1 }, material = "stone", floating = true }
  assert(m:consolidate { duration = 8, rest = { ratio = 1e-3, speed = 1e-3, hold = 0.1 } }.rests and m.verdict.sound)
  m:close()
end
print "every assertion holds"
