-- A model whose handlers change it, paused within its second stage: all that an instant can hold.
local trilith = require "trilith"
local m = trilith.model { name = "instant" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, name = "joint",
  law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4 } }
m:block { name = "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
m:block { name = "b", width = 0.5, height = 0.25, at = { 0, 0.1 }, material = "stone", floating = true }
m:bearing { name = "spring", between = { "base", "b" }, at = { 0.25, 0 }, arm = 1,
  along = trilith.elastic_plastic { stiffness = 1e4, yield = 50 } }
local state = m:keep { impacts = 0, latest = {}, b = m:body "b" }
m:on("impact", function(e)
  state.impacts = state.impacts + 1
  state.latest[1] = e.body
end)
m:every(0.05, function()
  if state.impacts ~= 1 then return end
  state.impacts = 2
  m:block { name = "c", width = 0.2, height = 0.2, at = { 1 + math.random(), 1 }, material = "stone", floating = true }
end)
m:history { name = "impacts", unit = "1", of = function() return state.impacts end }
m:history { name = "y", body = m:body "b", what = "y" }
m:run { duration = 0.3 }
m:every(0.05, function() if m.time > 0.39 then error "pause here" end end)
m:run { duration = 0.3 }
