-- A steel portal under a share of its plastic limit load: it stands or collapses.
local trilith = require "trilith"
local p = trilith.params {
  factor = { 0.98, "factor on the collapse load" },
  integrator = { "implicit", "or explicit" } }
local m = trilith.model { name = "portal", mass_damping = 1 }
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.3, beta = 1e-4 } }
m:polygon { name = "floor", outline = { { -6, -1 }, { 12, -1 }, { 12, -0.5 }, { -6, -0.5 } }, material = "steel",
            support = "fixed" }

local section = trilith.rectangle_section { width = 0.15, depth = 0.25 }
local hinge = trilith.end_hinge { sagging = 100e3, hogging = 100e3, hardening = 1e4 }
local function member(name, from, to)
  return { name = name, from = from, to = to, section = section, hinge = hinge, divisions = 4 }
end
local portal = m:frame { name = "portal", material = "steel",
  joints = { a = { at = { 0, 0 }, support = "fixed" }, b = { 0, 4 }, middle = { 3, 4 }, c = { 6, 4 },
             d = { at = { 6, 0 }, support = "fixed" } },
  members = { member("left", "a", "b"), member("beam 1", "b", "middle"), member("beam 2", "middle", "c"),
              member("right", "d", "c") } }
local sway = m:modes { count = 1 }[1].frequency

-- virtual work of 6 hinges of 100 kN m, of the loads and of the beam's own weight
local weight = 7850*9.80665*0.15*0.25
local limit = (6*100e3 - weight*6^2/4)/(100e3*6/2 + 50e3*4)
local load, slowly = p.factor*limit, { smooth = 1.5 } -- time in which the load is applied [s]
m:point_load { body = portal, at = { 3, 4 }, force = { 0, -load*100e3 }, load_curve = slowly }
m:point_load { body = portal, at = { 0, 4 }, force = { load*50e3, 0 }, load_curve = slowly }
local hinges = 0
m:on("member.yielded", function() hinges = hinges + 1 end)
m:results { file = "out/portal.h5", frames = 0.05 }
m:run { name = "loaded", duration = 3, integrator = p.integrator }

print(("limit load factor %.4f; sway frequency %.2f Hz; %d member ends have yielded"):format(limit, sway, hinges))
print(math.abs(portal.ux) < 0.3 and "stands" or "collapses")
