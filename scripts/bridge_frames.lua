-- Seven simple spans of beams on six slender piers and two abutments under El Centro 1940: the bridge of bridge.lua
-- as an engineer would model it for an assessment. Its decks bend, its piers yield at their feet, its footings are
-- flexible, its fixed bearings have a lead core.
--
-- Physics: decks and piers are beams. A pier is a concrete wall with a plastic hinge (or fibres) at its foot, on a
-- footing with soil springs. Both sides of the valley are rigid and follow the record, the left one with its time
-- axis times 0.8. A fixed bearing yields, and fails at 10 in; afterwards friction acts on the seat of 15 in.
-- integrator = "implicit" takes long steps.
--
-- Expected at 0.8 g: all bearings yield within 2.3 s of the shaking, all piers at their feet between 2.5 and 3.2 s;
-- none fails, and the largest drift is 225 mm. With columns = "fibres", which soften as their concrete crushes, a
-- bearing fails at 6.7 s and span 2 falls. The energy residual stays below 0.1 % of the input (0.013 %).
local trilith = require "trilith"
local ft, inch, kip, g, s = trilith.units "ft inch kip g s"
local p = trilith.params {
  pga = { 0.8, unit = "g", "peak horizontal acceleration" },
  sign = { 1, "sign of the record: 1 or -1" },
  columns = { "hinges", choices = { "elastic", "hinges", "fibres" }, "model of yielding in the piers" },
  integrator = { "explicit", choices = { "explicit", "implicit", "auto" }, "time integration" },
  dt = { 0.01, unit = "s", "longest step of the implicit integrator" },
  accuracy = { 1e-3, "allowed error of an implicit step, as a share of energies and velocities" },
  duration = { 30, unit = "s", "duration of the shaking" },
  gap = { 4, unit = "inch", "width of the joints" },
  mu = { 0.1, "friction coefficient of the seats" },
  out = { "out/bridge_frames.h5", "results" },
}
local width, seat, height = 32*ft, 15*inch, 2*inch -- of the deck; of a seat; of a fixed bearing
local dead_load = 5.6*kip                          -- of a foot of deck
local m = trilith.model { name = "seven-span bridge of beams", thickness = width, mass_damping = 0.3 }
m:material { name = "concrete", density = 2400, E = 30e9, nu = 0.2 }
local kn = 40*dead_load / (seat*width*0.02*inch)
local beta = 0.3 / math.sqrt(kn*seat*width*g/(40*dead_load))
m:contact { between = { "*", "*" }, name = "expansion bearing",
            law = trilith.frictional { kn = kn, ks = kn/2, mu = p.mu, beta = beta } }

-- Where the decks end, from the back wall of the left abutment; piers stand under the joints.
local spans = { 30*ft, 60*ft, 80*ft, 80*ft, 80*ft, 60*ft, 30*ft }
local depths = { 2.5*ft, 4*ft, 5*ft, 5*ft, 5*ft, 4*ft, 2.5*ft }
local heights = { 40*ft, 50*ft, 60*ft, 60*ft, 50*ft, 40*ft }
local from, to = {}, {}
for i, length in ipairs(spans) do
  from[i] = i == 1 and p.gap or to[i - 1] + p.gap
  to[i] = from[i] + length
end

-- The valley: abutments with a back wall at both ends, a step down to each pier.
local wall = 2.5*ft
m:ground { name = "left ground", base_level = -100*ft, material = "concrete", support = "fixed",
           steps = { { from = -40*ft, level = wall }, { from = 0, level = -height },
                     { from = p.gap + seat, level = -20*ft } }, to = 15*ft }
local steps = { { from = 17*ft, level = -heights[1] } }
for i = 2, 6 do steps[i] = { from = 0.5*(from[i] + to[i]), level = -heights[i] } end
steps[#steps + 1] = { from = to[7] - seat, level = -height }
steps[#steps + 1] = { from = to[7] + p.gap, level = wall }
m:ground { name = "right ground", base_level = -100*ft, material = "concrete", support = "fixed",
           steps = steps, to = to[7] + 40*ft }

-- Piers: walls with 1 % of steel, 9.6 kip/ft. The moment of a hinge depends on its normal force as the moment of the
-- section does (ACI's stress block: largest where tension steel and concrete reach their strengths).
local depth = 2*seat + p.gap
local shape = trilith.rectangle_section { width = 64*ft^2/depth, depth = depth }
local steel, crushing = 0.01*shape.area*420e6, 0.85*30e6*shape.area
local balanced = steel*0.4*depth + 0.4*crushing*0.3*depth
local hinge = trilith.end_hinge {
  sagging = balanced, hardening = balanced, ultimate = 0.05,
  axial = { { -crushing - steel, 0 }, { -0.4*crushing, 1 }, { 0, steel*0.4*depth/balanced }, { steel, 0 } } }
local fibres = trilith.fibre_section {
  shape = shape, law = trilith.kent_park { strength = 30e6, confinement = 1.2, ultimate = 0.02 }, cover = 2*inch,
  cover_law = trilith.kent_park { strength = 30e6 }, layers = 16,
  bars = { { area = 0.005*shape.area, height = 3*inch }, { area = 0.005*shape.area, height = depth - 3*inch } },
  bar_law = trilith.menegotto_pinto { E = 2e11, yield = 420e6, hardening = 0.01 } }
local function spring(k) return trilith.linear { stiffness = k, damping = 2e-3*k } end
local piers = {}
for i, h in ipairs(heights) do
  local x, foot = to[i] + 0.5*p.gap, -h + 4*ft
  piers[i] = m:frame {
    name = "P" .. i, material = "concrete",
    joints = { foot = { at = { x, foot }, mass = 460*kip/g, inertia = 460*kip/g*(20*ft)^2/12 },
               head = { x, -height } },
    members = { { name = "column", from = "foot", to = "head", divisions = 6,
                  section = p.columns == "fibres" and fibres or shape,
                  from_hinge = p.columns == "hinges" and hinge or nil } } }
  m:bearing { name = "footing " .. i, between = { "right ground", piers[i] }, from = { x, -h }, to = { x, foot },
              along = spring(2e9), axial = spring(4e9), turning = spring(3e10) }
end

-- Decks; their fixed bearings: as stiff and high as in bridge.lua, yielding at a tenth of the weight.
local function deck(i, name, fixed)
  local box = trilith.box_section { width = width, depth = depths[i], webs = 4*ft, top = 0.6*ft, bottom = 0.5*ft }
  local body = m:beam { name = name, from = { from[i], box.below }, to = { to[i], box.below }, section = box,
                        material = "concrete", weight = spans[i]*dead_load,
                        divisions = math.floor(spans[i]/(5*ft) + 0.5) }
  local side, at, support
  if fixed == "left" then
    side, at, support = "left", from[i] + 0.5*seat, i == 1 and "left ground" or piers[i - 1]
  else
    side, at, support = "right", to[i] - 0.5*seat, i == 7 and "right ground" or piers[i]
  end
  local size = spans[i]/(80*ft)
  m:bearing { name = name .. "." .. side, between = { support, body }, from = { at, -height }, to = { at, 0 },
              along = trilith.lead_rubber { strength = 0.1*spans[i]*dead_load, post_stiffness = 6*size*kip/inch },
              axial = trilith.linear { stiffness = 3000*size*kip/inch }, limit = { along = 10*inch },
              becomes = "expansion bearing" }
  for _, seat_at in ipairs {
    { "left", from[i], from[i] + seat, { -1, 0 }, i == 1 and "left ground" or piers[i - 1] },
    { "right", to[i], to[i] - seat, { 1, 0 }, i == 7 and "right ground" or piers[i] } } do
    local end_name, tip, edge, inward, below = table.unpack(seat_at)
    m:seat { name = name .. "." .. end_name .. " end", body = body, support = below, at_end = { tip, 0 },
             edge = { edge, -height }, inward = inward }
  end
end
for i, fixed in ipairs { "left", "right", "left", "right", "left", "right", "left" } do deck(i, "S" .. i, fixed) end

m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
m:consolidate { duration = 60*s, rest = { ratio = 1e-5 } }
local first
m:on("bearing.failed", function(e) first = first or e end)
local drift = 0
m:every(0.01*s, function()
  for i, pier in ipairs(piers) do
    local x = to[i] + 0.5*p.gap
    drift = math.max(drift, math.abs(pier:point { x, -height } - pier:point { x, -heights[i] + 4*ft }))
  end
end)
local along = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }
along = along:scale { factor = p.sign }
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(along)
local function firm(motion) return motion:time_scale(0.8):delay(0.204*s) end
local t = m.time
m:shake {
  motions = { { body = "right ground", x = along, y = up }, { body = "left ground", x = firm(along), y = firm(up) } },
  duration = p.duration, integrator = p.integrator, accuracy = p.integrator ~= "explicit" and p.accuracy or nil,
  tolerance = p.integrator ~= "explicit" and 1e-5*p.accuracy or nil, dt = p.integrator == "implicit" and p.dt or nil }
print(first and ("first bearing to fail: %s, %.3f s into the shaking"):format(first.bearing.name, first.time - t)
      or "no bearing failed")
print(("piers: largest drift %.1f mm"):format(1000*drift))
if p.columns == "hinges" then
  for _, pier in ipairs(piers) do
    local at = pier:hinges()[1]
    print(("%s: %s, residual rotation %.2g rad"):format(pier.name, at.state, at.rotation))
  end
end
