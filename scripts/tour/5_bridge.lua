-- Two spans of 24 m over a valley 6 m deep; the right bank moves away until the second span loses its seat.
local trilith = require "trilith"
local p = trilith.params {
  seat = { 0.4, unit = "m", "length of the seats" },
  away = { 0.6, unit = "m", "displacement of the right bank" } }
local m = trilith.model { name = "two spans", thickness = 10 }
local concrete = m:material { name = "concrete", density = 2400 }
local function coulomb(mu) return trilith.frictional { kn = 5e10, ks = 2e10, mu = mu, beta = 5e-5 } end
m:contact { between = { "*", "*" }, law = coulomb(0.1), name = "seat" }
m:contact { between = { "*", "ground" }, law = coulomb(0.6), name = "concrete on concrete" }
local spring = trilith.linear { stiffness = 5e8, damping = 5e6 }

m:ground { name = "left bank", surface = { { -30, -6 }, { 23.7, -6 } }, base_level = -8, material = concrete,
           support = "fixed" }
m:ground { name = "right bank", surface = { { 23.7, -6 }, { 30, -6 } }, base_level = -8, material = concrete,
           support = "fixed" }
local pier = m:pier { name = "P", station = 0, ground_level = -6, height = 5.95, stem_width = 1.2, footing_width = 6,
                      footing_thickness = 1, material = concrete }
for i, side in ipairs { -1, 1 } do -- left and right of the pier
  local far = 24.3*side
  local edge = far - p.seat*side
  local abutment = m:abutment { name = "A" .. i, side = side < 0 and "left" or "right", x = edge, width = 4,
                                ground_level = -6, height = 6, material = concrete }
  local span = m:span { name = "S" .. i, x0 = math.min(0, far + 0.05*side), x1 = math.max(0, far + 0.05*side),
                        end_gap = 0.05, soffit_level = 0, depth = 1, material = concrete }
  m:bearing { name = span.name .. ".pier", between = { pier, span }, at = { 0.3*side, 0 },
              along = spring, axial = spring }
  m:seat { name = span.name .. ".seat", body = span, support = abutment, at_end = { far, 0 }, edge = { edge, 0 },
           inward = { side, 0 } }
end
m:results { file = "out/two_spans.h5", frames = 0.05, histories = 0.02 }
m:consolidate { duration = 20 }
m:story(function()
  local lost = m:wait "seat.lost"
  local struck = m:wait { "impact", body = "S2", above = 5 }
  print(("%s lost after %.2f s, ground struck %.2f s later"):format(lost.seat, lost.time, struck.time - lost.time))
end)
m:shake { body = "right bank", x = trilith.ramp { by = p.away, duration = 4 }, rest = { speed = 1e-4, hold = 0.5 } }
