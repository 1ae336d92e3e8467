-- The seven-span bridge through a year of temperature, then El Centro 1940: how much of its seats is left.
--
-- Physics: decks are beams with a temperature at the lower and the upper face of their sections. Air of a year warms
-- and cools them, and the sun warms the road in summer. A deck has a fixed bearing, which is an elastic spring, at one
-- end, and slides by friction at the other. Piers are elastic columns on springs of the soil. After each day of the
-- year the bridge is in static equilibrium. Then both sides of the valley shake, as in bridge.lua.
--
-- Expected at 0.5 g: decks of 80 ft move by 5.8 mm to either side of their place in spring, and the friction on
-- their seats leaves them about where they were. The earthquake takes the rest. Results: docs/gallery/bridge_year.md.
local trilith = require "trilith"
local ft, inch, kip, g, s = trilith.units "ft inch kip g s"
local day = 86400
local p = trilith.params {
  pga = { 0.5, unit = "g", "peak horizontal acceleration; 0: the year alone" },
  swing = { 20, "amplitude of the temperature of the air in a year [K]" },
  sun = { 8, "temperature of the road above the air on a summer day [K]" },
  years = { 1, "number of years" },
  mu = { 0.06, "friction coefficient of the sliding ends" },
  duration = { 20, unit = "s", "duration of the shaking" },
  out = { "out/bridge_year.h5", "results" },
}
local width, seat, gap, height = 32*ft, 15*inch, 4*inch, 2*inch
local dead_load, wall = 5.6*kip, 2.5*ft -- of a foot of deck; height of the back walls
local m = trilith.model { name = "seven-span bridge", thickness = width, mass_damping = 0.3 }
m:material { name = "concrete", density = 2400, E = 30e9, nu = 0.2 }
local kn = 40*dead_load/(seat*width*0.02*inch)
local beta = 0.3/math.sqrt(kn*seat*width*g/(40*dead_load))
m:contact { between = { "*", "*" }, name = "seat",
            law = trilith.frictional { kn = kn, ks = kn/2, mu = 0.1, beta = beta } }

-- Decks from the back wall of the left abutment on; the two sides of the valley; piers under the joints.
local lengths, depths = { 30, 60, 80, 80, 80, 60, 30 }, { 2.5, 4, 5, 5, 5, 4, 2.5 }
local heights = { 40*ft, 50*ft, 60*ft, 60*ft, 50*ft, 40*ft }
local from, to = {}, {}
for i, length in ipairs(lengths) do
  from[i] = i == 1 and gap or to[i - 1] + gap
  to[i] = from[i] + length*ft
end
m:ground { name = "left ground", base_level = -100*ft, material = "concrete", support = "fixed",
           steps = { { from = -40*ft, level = wall }, { from = 0, level = -height },
                     { from = gap + seat, level = -20*ft } }, to = 15*ft }
local steps = { { from = 17*ft, level = -heights[1] } }
for i = 2, 6 do steps[i] = { from = 0.5*(from[i] + to[i]), level = -heights[i] } end
steps[7] = { from = to[7] - seat, level = -height }
steps[8] = { from = to[7] + gap, level = wall }
m:ground { name = "right ground", base_level = -100*ft, material = "concrete", support = "fixed",
           steps = steps, to = to[7] + 40*ft }
local supports = { [0] = "left ground", [7] = "right ground" }
local function spring(k) return trilith.linear { stiffness = k, damping = 2e-3*k } end
local stem = trilith.rectangle_section { width = 64*ft^2/(2*seat + gap), depth = 2*seat + gap }
for i, h in ipairs(heights) do
  local x, foot, footing = to[i] + 0.5*gap, -h + 4*ft, 460*kip/g
  supports[i] = m:frame { name = "P" .. i, material = "concrete",
    joints = { foot = { at = { x, foot }, mass = footing, inertia = footing*(20*ft)^2/12 }, head = { x, -height } },
    members = { { name = "column", from = "foot", to = "head", divisions = 3, section = stem } } }
  m:bearing { name = "footing " .. i, between = { "right ground", supports[i] }, from = { x, -h }, to = { x, foot },
              along = spring(2e9), axial = spring(4e9), turning = spring(3e10) }
end

-- Decks, fixed at alternate ends.
local decks, seats = {}, {}
for i, length in ipairs(lengths) do
  local box = trilith.box_section { width = width, depth = depths[i]*ft, webs = 4*ft, top = 0.6*ft, bottom = 0.5*ft }
  decks[i] = m:beam { name = "S" .. i, groups = { "decks" }, from = { from[i], box.below }, to = { to[i], box.below },
                      section = box, material = "concrete", weight = length*ft*dead_load, divisions = length//10 }
  for k, x in ipairs { from[i] + 0.5*seat, to[i] - 0.5*seat } do
    local is_fixed, size = (i % 2 == 1) == (k == 1), length/80
    m:bearing { name = ("S%d.%s"):format(i, k == 1 and "left" or "right"), between = { supports[i - 2 + k], decks[i] },
      from = { x, -height }, to = { x, 0 }, axial = spring(3000*size*kip/inch),
      along = is_fixed and spring(60*size*kip/inch) or trilith.friction { stiffness = 600*size*kip/inch, mu = p.mu },
      limit = { along = 10*inch }, becomes = "seat" }
    seats[#seats + 1] = m:seat { name = ("S%d.%s end"):format(i, k == 1 and "left" or "right"), body = decks[i],
      support = supports[i - 2 + k], at_end = { k == 1 and from[i] or to[i], 0 },
      edge = { k == 1 and from[i] + seat or to[i] - seat, -height }, inward = { k == 1 and -1 or 1, 0 } }
  end
end

-- Built in spring at 10 degC. The sun acts on the road from spring to autumn.
local function course(extra)
  local points = { period = 365*day }
  for k = 0, 72 do
    local wave = trilith.math.sin(2*math.pi*k/73)
    points[k + 1] = { k*5*day, 10 + p.swing*wave + math.max(0, extra*wave) }
  end
  return points
end
for i, deck in ipairs(decks) do
  m:heat { body = deck, conductivity = 2, heat_capacity = 900, expansion = 1.1e-5, temperature = 10,
           depth = depths[i]*ft }
end
m:heat_exchange { name = "air", body = "decks", side = "bottom", exchange = 15, temperature = course(0) }
m:heat_exchange { name = "road", body = "decks", side = "top", exchange = 15, temperature = course(p.sun) }

m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
m:history { name = "seat of span 4, left end", of = function() return seats[7].length end, unit = "m" }
m:history { name = "temperature of span 4", of = function() return (m:temperature(decks[4])) end, unit = "degC" }
m:consolidate { integrator = "static" }
local function lengths_left()
  local left = {}
  for i, one in ipairs(seats) do left[i] = 1e3*one.length end
  return left
end
local columns = { lengths_left() }
local marks = { "built" }
local begun = os.clock and os.clock() or 0
for _ = 1, p.years do
  for _, part in ipairs { { "summer", 91 }, { "winter", 183 }, { "spring", 91 } } do
    m:process { name = part[1], duration = part[2]*day, step = day }
    columns[#columns + 1], marks[#marks + 1] = lengths_left(), part[1]
  end
end
local took = (os.clock and os.clock() or 0) - begun
print(("a year of daily steps: friction %.1f kJ, computing time %.1f s"):format(1e-3*m.energy.bearing_inner,
  took/p.years))
if p.pga > 0 then
  local along = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
  local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(along)
  local function firm(motion) return motion:time_scale(0.8):delay(0.204*s) end
  m:shake { motions = { { body = "right ground", x = along, y = up },
                        { body = "left ground", x = firm(along), y = firm(up) } }, duration = p.duration }
  columns[#columns + 1], marks[#marks + 1] = lengths_left(), "El Centro"
end
print("seat length [mm]  " .. table.concat(marks, "  "))
for i, one in ipairs(seats) do
  local row = {}
  for k, column in ipairs(columns) do row[k] = ("%8.1f"):format(column[i]) end
  print(("%-14s %s"):format(one.name, table.concat(row)))
end
