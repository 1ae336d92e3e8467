-- A portal of reinforced concrete with fixed feet is pushed sideways. Its members are fibres of concrete and bars.
-- Compare the peak with the mechanism of four hinges, H = 4 M / height, with the strength M of the column section.
local trilith = require "trilith"
local kN = trilith.units "kN"
local span, height, beam_load = 5, 3, 100*kN

local bars = trilith.menegotto_pinto { E = 2e11, yield = 420e6, hardening = 0.005 }
local concrete = trilith.kent_park { strength = 30e6, confinement = 1.2, ultimate = 0.02 }
local function section(width, depth, area)
  return trilith.fibre_section { shape = trilith.rectangle_section { width = width, depth = depth }, law = concrete,
    bars = { { area = area, height = 0.05 }, { area = area, height = depth - 0.05 } }, bar_law = bars }
end
local column, beam = section(0.35, 0.35, 8e-4), section(0.3, 0.5, 15e-4)

local m = trilith.model { name = "concrete portal", mass_damping = 1 }
m:material { name = "concrete", density = 2500, E = 3e10, nu = 0.2 }
local portal = m:frame { name = "portal", material = "concrete",
  joints = { a = { at = { 0, 0 }, support = "fixed" }, b = { 0, height }, c = { span, height },
             d = { at = { span, 0 }, support = "fixed" } },
  members = { { name = "left", from = "a", to = "b", section = column, divisions = 8 },
              { name = "beam", from = "b", to = "c", section = beam, divisions = 8 },
              { name = "right", from = "d", to = "c", section = column, divisions = 8 } } }
for _, joint in ipairs { { 0, height }, { span, height } } do
  m:point_load { body = portal, at = joint, force = { 0, -beam_load } }
end

m:results { file = "out/concrete_portal.h5", frames = 0.05, histories = 0.01 }
m:history { name = "force", what = "push_force" }
m:history { name = "displacement", what = "push_displacement" }
m:consolidate { integrator = "static" }
local push = m:pushover { body = portal, at = "b", direction = "x", control = "arc", displacement = 0.09 }

local moment = column:moment_curvature { normal = -beam_load }.peak_moment
local limit = 4*moment/height
print(("peak %.1f kN at %.0f mm; four hinges of %.1f kN m give %.1f kN"):format(push.peak_force/kN,
  1e3*push.displacement_at_peak, moment/kN, limit/kN))
column:plot { file = "out/column_section.png", normal = { 0, -beam_load } }
return { peak = push.peak_force, limit = limit }
