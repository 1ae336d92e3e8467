-- Any number of models in one process: they share no state, and the same input gives the same bits.
local trilith = require "trilith"
local function block(height)
  local m = trilith.model { name = "block" }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 6e9, ks = 3e9, mu = 0.6, beta = 2e-4 } }
  m:block { name = "base", width = 2, height = 0.2, at = { -1, -0.2 }, material = "stone", support = "fixed" }
  m:block { name = "block", width = 0.5, height = 0.3, at = { -0.25, height }, angle = 0.1, material = "stone",
    floating = true }
  return m
end
local a, b, c = block(0.2), block(0.2), block(0.3)
for _ = 1, 5 do
  a:run { duration = 0.2 }
  c:run { duration = 0.2 }
end
for _ = 1, 5 do b:run { duration = 0.2 } end
assert(a.hash == b.hash and a.hash ~= c.hash)
assert(a:body "block" ~= b:body "block" and a:body "block" == a:body "block")

-- reading between stages does not change the results
local d = block(0.2)
for _ = 1, 5 do
  d:run { duration = 0.2 }
  assert(#d:contacts() >= 0 and d.energy.kinetic >= 0 and d.ratio >= 0)
end
assert(a.hash == d.hash)

-- a law may be used by several models, whatever their other laws: it is identified by its numbers
local rough = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.9 }
local e, f = trilith.model {}, trilith.model {}
e:contact { between = { "*", "*" }, law = rough }
f:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.1 } }
f:contact { between = { "left", "*" }, law = rough }
for name, mass in pairs { left = 1, right = 2 } do
  f:block { name = name, width = 1, height = 1, at = { mass, 0 }, mass = mass, support = "fixed" }
end
f:block { name = "top", width = 2, height = 1, at = { 1, 1 }, mass = 1, groups = "top" }
f:run { duration = 0.01 }
local laws = {}
for _, contact in ipairs(f:contacts { between = { "top", "left" } }) do laws[#laws + 1] = contact.law end
assert(laws[1] == "frictional 2", laws[1])

-- handles may outlive their model; reading a closed model raises an error
local body = c:body "block"
c:close()
local good, message = pcall(function() return body.x end)
assert(not good and message:find "the model is closed")
assert(tostring(body) == "body of a closed model")
collectgarbage()
