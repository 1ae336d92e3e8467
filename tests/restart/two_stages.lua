-- Two stages in the plane with statements between them, a handler, a timer with a table that is kept, and a history.
local trilith = require "trilith"
local p = trilith.params { out = { "out/two_stages.h5", "results" }, blocks = { 12, "blocks of the stack" },
                           duration = { 4, unit = "s", "of the shaking" } }
local m = trilith.model { name = "two stages" }
m:material { name = "stone", density = 2400 }
m:contact { between = { "stone", "stone" }, law = trilith.frictional { kn = 6e8, ks = 3e8, mu = 0.5, beta = 2e-4 } }
m:block { name = "base", width = 4, height = 0.2, at = { -2, -0.2 }, material = "stone", support = "fixed" }
for i = 1, p.blocks do
  m:block { name = "b" .. i, width = 0.5, height = 0.25, at = { -0.25 + 0.01 * (i % 3), 0.25 * (i - 1) },
            material = "stone" }
end
m:results { file = p.out, frames = 0.05, histories = 0.01, energy = 0.05 }
local state = m:keep { impacts = 0, ticks = 0, latest = {} }
m:on("impact", function(e)
  state.impacts = state.impacts + 1
  state.latest[#state.latest % 5 + 1] = e.body
end)
m:every(0.1, function() state.ticks = state.ticks + 1 end)
m:history { name = "impacts", unit = "1", of = function() return state.impacts end }
m:consolidate { rest = { ratio = 1e-4 } }
print(("at rest at %.6f s, top at %.9f m"):format(m.time, m:body("b" .. p.blocks).y))
local wave = {}
for i = 1, 400 do wave[i] = 4 * trilith.math.sin(0.05 * i) end
wave[401] = 0
local motion = trilith.motion { acceleration = wave, dt = 0.01, allow_drift = true }
m:shake { body = "base", x = motion, duration = p.duration }
print("hash " .. m.hash, state.impacts, state.ticks)
return { top = m:body("b" .. p.blocks).y, impacts = state.impacts, ticks = state.ticks }
