-- A column of marble drums with a capital, on a base that moves as a sine of 1 Hz. The drums rock and wobble in space.
-- Read how far the capital has moved, and whether the column still stands.
local trilith = require "trilith"
local g = trilith.units "g"

local m = trilith.model { name = "drums", dim = 3 }
m:material { name = "marble", density = 2700 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 2e10, ks = 1e10, mu = 0.7, beta = 1e-5 } }
local column = m:column { name = "column", drums = 4, height = 4, radius = 0.4, top_radius = 0.34, sides = 12,
  base = { width = 1.6, height = 0.3 }, capital = { width = 1, height = 0.3 }, material = "marble", fixed = "base" }
local capital = column[#column]

m:results { file = "out/drums.h5", frames = 0.02, histories = 0.01 }
m:history { name = "capital", body = capital, what = "ux" }
m:consolidate {}

-- Three periods of a sine that begins and ends at rest.
local samples = {}
for i = 0, 300 do samples[i + 1] = 0.3*g*math.sin(2*math.pi*i/100)*math.sin(math.pi*i/300)^2 end
local shaking = trilith.motion { acceleration = samples, dt = 0.01, name = "sine of 1 Hz" }
m:shake { body = column[1], x = shaking, duration = 4 }

local moved = math.sqrt(capital.ux^2 + capital.uy^2)
print(("%d bodies; the capital has moved by %.0f mm and risen by %.1f mm"):format(#column, 1e3*moved,
  1e3*capital.uz))
print(capital.uz > -0.3 and "the column stands" or "the column has fallen")
return { moved = moved, stands = capital.uz > -0.3 }
