-- Two spans on friction pendulums, shaken by a record of your own: a file of two columns, time and acceleration.
-- Read the period of the deck, 2 pi sqrt(R / g), and the displacement of its dishes at most and at the end.
local trilith = require "trilith"
local g, kN = trilith.units "g kN"
local radius, mu = 2, 0.05

local m = trilith.model { name = "pendulum bridge", thickness = 10 } -- width of the deck [m]
local concrete = m:material { name = "concrete", density = 2400 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5e9, ks = 2.5e9, mu = 0.6, beta = 2e-3 } }
m:ground { name = "ground", surface = { { -20, -8 }, { 80, -8 } }, base_level = -10, material = concrete,
           support = "fixed" }
local pendulum = m:bearing_type { name = "pendulum", height = 0.2, axial = trilith.linear { stiffness = 2e9 },
  along = trilith.pendulum { radius = radius, mu = mu, stiffness = 1e8, damping = 2e4 }, limit = { along = 0.5 } }
local bridge = m:bridge { gap = 0.6, seat = 1, material = concrete,
  abutment = { height = 8, width = 5, back_wall_height = 1.7 },
  pier = { height = 8, footing_width = 6, footing_thickness = 1 },
  span = { length = 25, depth = 1.5, weight_per_length = 150*kN, left = pendulum, right = pendulum },
  supports = { { name = "A0" }, { name = "P1" }, { name = "A2" } }, spans = { { name = "S1" }, { name = "S2" } } }

m:results { file = "out/pendulum_bridge.h5", frames = 0.05, histories = 0.01, energy = 0.05 }
local dish, deck = bridge.spans[1].bearings.left, bridge.spans[1]
m:history { name = "displacement", bearing = dish, what = "displacement_along" }
m:history { name = "force", bearing = dish, what = "force_along" }

m:consolidate {}
local largest = 0
m:on_step(function() largest = math.max(largest, math.abs(dish.displacement.along)) end)
m:shake { body = "ground", x = trilith.motion { file = "station7.txt", unit = "cm/s2" }, duration = 8 }

print(("period of the deck on its dishes: %.2f s"):format(2*math.pi*math.sqrt(radius/g)))
print(("largest displacement of a dish %.0f mm, at the end %.0f mm; friction holds up to %.0f mm"):format(1e3*largest,
  1e3*dish.displacement.along, 1e3*mu*radius))
print(("%s weighs %.0f kN"):format(deck.name, deck.mass*g/kN))
return { largest = largest, rest = dish.displacement.along }
