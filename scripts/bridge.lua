-- Seven spans on six piers and two abutments, to the last rest. Source and figures chosen: docs/gallery/bridge.md.
-- Expected: spans 1, 3, 4 and 5 come down, the other three stand; energy residual below 1 % of the input.
local trilith = require "trilith"
local ft, inch, kip, g, s = trilith.units "ft inch kip g s"
local p = trilith.params {
  pga = { 0.8, unit = "g", "peak horizontal acceleration" }, sign = { 1, "1: as the agency gives it, or -1" },
  gap = { 4, unit = "inch", "joints" }, mu = { 0.1, "friction of seats" }, zeta = { 0.15, "damping of contact" },
  base = { "bonded", choices = { "rocking", "bonded" }, "how footings sit" }, out = { "out/bridge.h5", "results" } }
local spans, heights = { 30, 60, 80, 80, 80, 60, 30 }, { [0] = 20, 40, 50, 60, 60, 50, 40, 20 } -- ft; support 0 to 7
local width, seat, rise, w = 32*ft, 15*inch, 2*inch, 5.6*kip -- deck width, seat, height of a fixed bearing, load per ft
local m = trilith.model { name = "seven-span bridge", thickness = width, still_speed = 1e-5*inch/s }
local concrete = m:material { name = "concrete", density = 2400 }
local function ground(name, to, steps)
  for k, st in ipairs(steps) do steps[k] = { from = st[1]*ft, level = -st[2]*ft } end
  m:ground { name = name, to = to*ft, steps = steps, base_level = -100*ft, material = concrete, support = "fixed" }
end
ground("left ground", 14.9, { { -150, 20 } })
ground("right ground", 570, { { 17, 40 }, { 60, 50 }, { 130, 60 }, { 290, 50 }, { 360, 40 }, { 404, 20 } })
local x, support = {}, {}
for i = 0, 7 do
  local h, low = heights[i], i % 2 == 0 and rise or 0 -- supports 0, 2, 4, 6 carry fixed bearings, `rise` high
  x[i] = i == 0 and 0 or x[i - 1] + spans[i]*ft
  support[i] = (i == 0 or i == 7)
    and m:abutment { name = "A" .. i, side = i == 0 and "left" or "right", material = concrete,
                     x = x[i] + (i == 0 and 1 or -1)*(p.gap/2 + seat), ground_level = -20*ft, height = h*ft - low,
                     width = 12*ft, back_wall_height = 2.5*ft + low, back_wall_width = 12*ft - seat - p.gap }
    or m:pier { name = "P" .. i, x = x[i], ground_level = -h*ft, height = h*ft - low, stem_width = 2*seat + p.gap,
                footing_width = (h > 40 and 24 or 20)*ft, footing_thickness = 4*ft,
                weight = (9.6*(h - 4) + 460)*kip, material = concrete }
end
local kn = 40*w / (seat*width*0.02*inch) -- 0.02 in under the dead load of an 80 ft span
local beta = 2*p.zeta / math.sqrt(kn*seat*width*g/(40*w)) -- for half a span on its seat
local function coulomb(mu) return trilith.frictional { kn = kn, ks = kn/2, mu = mu, beta = beta } end
local function spring(k) return trilith.linear { stiffness = k*kip/inch } end
local bond = trilith.bonded { kn = kn, ks = kn/2, mu = 0.6, beta = beta, cohesion = 1e9, tension = 1e9 }
m:contact { between = { "*", "*" }, law = coulomb(p.mu), name = "expansion bearing" }
m:contact { between = { "*", "ground" }, law = coulomb(0.6), name = "concrete on concrete" }
m:contact { between = { p.base == "bonded" and "*" or "abutments", "ground" }, law = bond, name = "bond" }
for i, L in ipairs(spans) do
  local deck = m:span { name = "S" .. i, x0 = x[i - 1], x1 = x[i], end_gap = p.gap/2, soffit_level = 0, weight = L*w,
                        depth = (L == 80 and 5 or L == 60 and 4 or 2.5)*ft, material = concrete }
  for e, side in ipairs { "left", "right" } do
    local name, k, into = deck.name .. "." .. side, i - 2 + e, 3 - 2*e
    local stop, on = x[k] + into*p.gap/2, support[k]
    m:seat { name = name, body = deck, support = on, inward = { -into, 0 },
             at_end = { stop, 0 }, edge = { stop + into*seat, 0 } }
    if k % 2 == 0 then
      m:bearing { name = name, between = { on, deck }, at = { stop + into*seat/2, 0 }, limit = { along = 10*inch },
                  along = spring(60*L/80), axial = spring(3000*L/80),
                  becomes = "expansion bearing" }
    end
  end
end
m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
m:consolidate { duration = 60*s, ratio = 1e-5, speed = 1e-5*inch/s }
local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }:scale { factor = p.sign }
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(ns)
local function firm(motion) return motion:time_scale(0.8):delay(0.204*s) end -- both records start together
m:shake { motions = { { body = "right ground", x = ns, y = up }, { body = "left ground", x = firm(ns), y = firm(up) } },
          duration = 150*s, still = { speed = 1e-5*inch/s, hold = 1*s, from = 55.9*s } }
