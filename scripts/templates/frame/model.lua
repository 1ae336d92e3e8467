-- A steel portal with fixed feet is pushed sideways past its yield point: capacity curve, hinges, member forces.
-- Set a parameter on the command line: trilith run model.lua Mp=150
local trilith = require "trilith"

-- 1. Parameters.
local p = trilith.params {
  span = { 6, unit = "m", "span of the beam" }, height = { 4, unit = "m", "height of the columns" },
  Mp = { 100e3, unit = "N m", "plastic moment of every member" },
  drift = { 0.12, unit = "m", "displacement of the top at the end of the push" } }

-- 2. Material and section. `mass_damping` damps the motion as a whole [1/s].
local m = trilith.model { name = "portal", mass_damping = 1 }
m:material { name = "steel", density = 7850, E = 2.1e11, nu = 0.3 }
local section = trilith.rectangle_section { width = 0.15, depth = 0.25 }
local hinge = trilith.end_hinge { sagging = p.Mp, hogging = p.Mp, hardening = 1e4 }

-- 3. Geometry: joints, and members between them with hinges at both ends.
local function member(name, from, to)
  return { name = name, from = from, to = to, section = section, hinge = hinge, divisions = 4 }
end
local portal = m:frame { name = "portal", material = "steel",
  joints = { a = { at = { 0, 0 }, support = "fixed" }, b = { 0, p.height },
             c = { p.span, p.height }, d = { at = { p.span, 0 }, support = "fixed" } },
  members = { member("left", "a", "b"), member("beam", "b", "c"), member("right", "d", "c") } }

-- 4. Results.
m:results { file = "out/frame.h5", frames = 0.05, histories = 0.01, energy = 0.05 }
m:history { name = "force", what = "push_force" }
m:history { name = "displacement", what = "push_displacement" }
local hinges = 0
m:on("member.yielded", function() hinges = hinges + 1 end)

-- 5. Natural frequency, weight, then a slow push at the left corner.
local frequency = m:modes { count = 1 }[1].frequency
m:consolidate { duration = 5 }
local push = m:pushover { body = portal, at = "b", direction = "x", control = "arc", displacement = p.drift }

-- 6. Figures. Four hinges of Mp make the sway mechanism: H = 4 Mp / height.
print(("sway frequency %.2f Hz; %d member ends have yielded"):format(frequency, hinges))
print(("peak force %.1f kN; the plastic limit is 4 Mp / height = %.1f kN"):format(1e-3*push.peak_force,
  4e-3*p.Mp/p.height))
return { peak = push.peak_force, hinges = hinges }
