-- Deformable bodies: one key switches a script between all kinds; rejected input.
local trilith = require "trilith"
local function near(a, b, share) assert(math.abs(a - b) <= share * math.abs(b), a .. " is not " .. b) end

local function column(kind)
  local m = trilith.model { name = "column", body = kind }
  m:material { name = "rock", density = 2400 }
  m:material { name = "stone", density = 2000, E = 1e9, nu = 0.2, beta = 1e-5 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-5 } }
  m:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "rock", support = "fixed",
            body = "rigid" }
  local low = m:block { name = "low", width = 1, height = 0.5, at = { -0.5, 0 }, material = "stone" }
  local top = m:block { name = "top", width = 1, height = 0.5, at = { -0.5, 0.5 }, material = "stone" }
  return m, low, top
end

for _, kind in ipairs { "rigid", "quad", { mesh = { 2, 2 } } } do
  local m, low, top = column(kind)
  near(low.mass, 1000, 1e-12)
  near(low.inertia, 1000 * (1 + 0.25) / 12, kind == "rigid" and 1e-12 or 2.1)  -- lumped masses lie farther out
  m:consolidate { duration = 5, rest = { speed = 1e-7 } }
  assert(low.kind == (type(kind) == "string" and kind or "mesh"))
  local weight = 2 * 1000 * 9.80665
  local contact = m:contacts { between = { "base", "low" } }
  local carried = 0
  for _, c in ipairs(contact) do carried = carried + c.normal end
  near(carried, weight, 1e-3)
  if kind ~= "rigid" then near(low.syy, -1.5 * 1000 * 9.80665, 1e-2) end
  local x, y = top:point { 0, 1 }
  assert(math.abs(x) < 1e-6 and math.abs(y - 1) < 1e-3)
  assert(#top.outline == (type(kind) == "string" and 4 or 8))
end

local function refused(pattern, f, ...)
  local ok, message = pcall(f, ...)
  assert(not ok and tostring(message):find(pattern), tostring(message))
end
local m = trilith.model {}
m:material { name = "rock", density = 2400 }
m:material { name = "stone", density = 2000, E = 1e9 }
local four = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }
refused("needs a material with a stiffness", m.body, m,
        { name = "a", outline = four, material = "rock", body = "quad" })
refused("must be \"rigid\", \"quad\" or", m.body, m, { name = "a", outline = four, material = "stone", body = "quda" })
refused("four corners, this one has 3", m.body, m,
  { name = "a", outline = { { 0, 0 }, { 1, 0 }, { 0, 1 } }, material = "stone", body = "quad" })
refused("must be 1 to 1000", m.body, m, { name = "a", outline = four, material = "stone", body = { mesh = { 0, 2 } } })
refused("names node 9", m.body, m,
        { name = "a", material = "stone", mesh = { nodes = four, elements = { { 1, 2, 9 } } } })
refused("cannot read mesh", m.body, m, { name = "a", material = "stone", mesh = { file = "none.msh" } })
local solid = m:block { name = "rigid", width = 1, height = 1, at = { 3, 0 }, material = "stone", floating = true }
refused("body 'rigid' is of kind 'rigid' and has no stress", function() return solid.sxx end)
refused("body 'rigid' is of kind 'rigid' and has no stress", m.history, m,
  { name = "h", body = "rigid", what = "plastic" })
refused("both E and solid", m.material, m, { name = "b", density = 1, E = 1, solid = trilith.j2 { E = 1, yield = 1 } })
refused("without E", m.material, m, { name = "b", density = 1, nu = 0.2 })
refused("dilation_angle is", trilith.mohr_coulomb,
  { E = 1e9, cohesion = 1, friction_angle = 0.1, dilation_angle = 0.2 })
local own = m:body { name = "own", material = "stone", floating = true,
  mesh = { nodes = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, elements = { { 1, 2, 3 }, { 1, 3, 4 } } } }
assert(own.kind == "mesh")
near(own.mass, 2000, 1e-12)

-- name patterns: '*' matches any text and '?' any letter, in a time that does not grow with the number of stars
local names, long = trilith.model {}, ("a"):rep(60)
for i, name in ipairs { "a", "ab", "abc", "S1.left", "S1.right", "S12.left", long } do
  names:block { name = name, width = 0.1, height = 0.1, at = { i, 0 }, mass = 1, floating = true }
end
for pattern, found in pairs {
  ["*"] = "a ab abc S1.left S1.right S12.left " .. long, ["*?"] = "a ab abc S1.left S1.right S12.left " .. long,
  ["a"] = "a", ["?"] = "a", ["??"] = "ab", ["a?*"] = "ab abc " .. long, ["*b"] = "ab", ["*b*"] = "ab abc",
  ["S*.left"] = "S1.left S12.left", ["S?.*"] = "S1.left S1.right", ["S1*left"] = "S1.left S12.left", ["**c"] = "abc",
  ["*.*t"] = "S1.left S1.right S12.left", ["a*b*c"] = "abc", ["*f?"] = "S1.left S12.left", [""] = "", ["abcd"] = "",
  ["b"] = "", [("*a"):rep(40) .. "b"] = "", [("*a"):rep(60)] = long, [("?*"):rep(60)] = long,
} do
  local got = table.concat(names:bodies { name = pattern }.names, " ")
  assert(got == found, ("%s: %s"):format(pattern, got))
end

-- Mass scaling: longer steps of meshes, reported with the added mass; afterwards the masses are restored.
do
  local two = trilith.model { name = "two meshes" }
  two:material { name = "stone", density = 2000, E = 10e9, nu = 0.2 }
  two:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 4e9, mu = 0.7, beta = 2e-5 } }
  two:block { name = "base", width = 2, height = 0.4, at = { -1, -0.4 }, material = "stone", support = "fixed" }
  two:block { name = "low", width = 0.4, height = 0.2, material = "stone", body = { mesh = { 2, 2 } } }
  two:block { name = "top", width = 0.4, height = 0.2, at = { 0, 0.2 }, material = "stone", body = { mesh = { 2, 2 } } }
  local plain = two:run { duration = 0.01, local_damping = 0.8 }
  assert(plain.mass_scaling == nil and plain.longest_dt < 2e-5)
  assert(two:explain_dt():find "element %d of 4, at ")
  local report = two:run { duration = 0.01, local_damping = 0.8, mass_scaling = { step = 4e-5 } }
  local scaled = report.mass_scaling
  assert(report.longest_dt == 4e-5 and scaled.before < 2e-5 and scaled.bodies == 2)
  assert(scaled.share > 0 and scaled.most < 30 and scaled.energy < scaled.kinetic)
  assert(two:run { duration = 0.01, local_damping = 0.8 }.longest_dt < 2e-5)
  local said = select(2, pcall(two.run, two, { duration = 0.01, mass_scaling = { step = 4e-5, bodies = "low" } }))
  assert(said:find "body 'top' %(mesh%), whose masses are not scaled", said)
  assert(two:run { duration = 0.001, mass_scaling = { step = 1e-6 } }.mass_scaling.bodies == 0)
end
