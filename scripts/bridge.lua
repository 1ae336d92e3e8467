-- Seven spans on six piers and two abutments, on two ground blocks that move differently: to the last rest.
-- R. Barbosa, "Discontinuous structural analysis", first example; what it leaves open: docs/gallery/bridge.md.
-- Expected (defaults): spans 1, 2 and 3 come down, the other four stand; energy residual below 1 % of the input.
local trilith = require "trilith"
local ft, inch, kip, g, s = trilith.units "ft inch kip g s"
local p = trilith.params {
  pga = { 0.8, unit = "g", "peak horizontal acceleration" },
  sign = { -1, "sense of the motion: 1 as the agency gives it, or -1" },
  gap = { 2, unit = "inch", "joint between decks, and between deck and back wall" },
  mu = { 0.2, "friction of the expansion bearings" },
  footing = { 0.6, "width of footings, share of 20 ft (piers of 40 ft) and 24 ft (50 and 60 ft)" },
  base = { "rocking", choices = { "rocking", "bonded" }, "how footings sit on the ground" },
  out = { "out/bridge.h5", "results file" },
}
local spans, heights = { 30, 60, 80, 80, 80, 60, 30 }, { [0] = 20, 40, 50, 60, 60, 50, 40, 20 } -- ft; support 0 to 7
local width, seat, rise, w = 32*ft, 15*inch, 2*inch, 5.6*kip -- deck width, seat, height of a fixed bearing, load per ft
local m = trilith.model { name = "seven-span bridge", thickness = width, still_speed = 1e-5*inch/s }
m:material { name = "concrete", density = 2400 }

local x = { [0] = 0 } -- of the supports
for i, L in ipairs(spans) do x[i] = x[i - 1] + L*ft end
local function step(from, level) return { from = from*ft, level = -level*ft } end
m:ground { name = "left ground", material = "concrete", support = "fixed", base_level = -100*ft,
           surface = { { -150*ft, -20*ft }, { 14.9*ft, -20*ft } } }
m:ground { name = "right ground", material = "concrete", support = "fixed", base_level = -100*ft, to = 570*ft,
           steps = { step(17, 40), step(60, 50), step(130, 60), step(290, 50), step(360, 40), step(404, 20) } }
for i = 0, 7 do
  local h, bearing = heights[i], i % 2 == 0 and rise or 0 -- supports 0, 2, 4, 6 carry fixed bearings
  if i == 0 or i == 7 then
    m:abutment { name = "A" .. i, side = i == 0 and "left" or "right", x = x[i] + (i == 0 and 1 or -1)*(p.gap/2 + seat),
                 ground_level = -20*ft, height = h*ft - bearing, width = 12*ft, material = "concrete",
                 back_wall_height = 2.5*ft + bearing, back_wall_width = 12*ft - seat - p.gap }
  else
    m:pier { name = "P" .. i, x = x[i], ground_level = -h*ft, height = h*ft - bearing, stem_width = 2*seat + p.gap,
             footing_width = (h > 40 and 24 or 20)*ft*p.footing, footing_thickness = 4*ft, material = "concrete",
             weight = (9.6*(h - 4) + 460)*kip }
  end
end
for i, L in ipairs(spans) do
  m:span { name = "S" .. i, x0 = x[i - 1], x1 = x[i], end_gap = p.gap/2, soffit_level = 0, material = "concrete",
           depth = (L == 80 and 5 or L == 60 and 4 or 2.5)*ft, weight = L*w }
end

local kn = 40*w / (seat*width*0.02*inch) -- 0.02 in under the dead load of an 80 ft span
local beta = 0.3 / math.sqrt(kn*seat*width*g/(40*w)) -- 15 % of critical for half a span on its seat
local function coulomb(mu) return trilith.frictional { kn = kn, ks = kn/2, mu = mu, beta = beta } end
m:contact { between = { "*", "*" }, law = coulomb(0.6), name = "concrete on concrete" }
m:contact { between = { "spans", "piers" }, law = coulomb(p.mu), name = "expansion bearing" }
m:contact { between = { "spans", "abutments" }, law = "expansion bearing" }
m:contact { between = { p.base == "bonded" and "*" or "abutments", "ground" }, name = "bond",
            law = trilith.bonded { kn = kn, ks = kn/2, mu = 0.6, beta = beta, cohesion = 1e9, tension = 1e9 } }
for i, L in ipairs(spans) do
  for side, k in pairs { left = i - 1, right = i } do
    local into, name = side == "left" and 1 or -1, "S" .. i .. "." .. side
    local support, stop = (k == 0 or k == 7) and "A" .. k or "P" .. k, x[k] + into*p.gap/2
    m:seat { name = name, body = "S" .. i, support = support, at_end = { stop, 0 }, edge = { stop + into*seat, 0 }, inward = { -into, 0 } }
    if k % 2 == 0 then
      local kh, kv = 60*kip/inch*L/80, 3000*kip/inch*L/80
      m:bearing { name = name, between = { support, "S" .. i }, at = { stop + into*seat/2, 0 }, limit = { along = 10*inch },
                  along = trilith.linear { stiffness = kh, damping = 0.04*math.sqrt(kh*L*w/g) },
                  axial = trilith.linear { stiffness = kv, damping = 0.1*math.sqrt(kv*L*w/2/g) }, becomes = "expansion bearing" }
    end
  end
end

m:results { file = p.out, frames = 0.05*s, histories = 0.02*s, energy = 0.05*s }
m:consolidate { duration = 60*s, ratio = 1e-5, speed = 1e-5*inch/s }
local ns = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }:scale { factor = p.sign }
local up = trilith.motion "elcentro_1940_rest_up.csv":scale_as(ns)
local function early(motion) return motion:time_scale(0.8):delay(1.02*0.2*s) end -- firmer ground; one start of shaking
local report = m:shake { motions = { { body = "right ground", x = ns, y = up }, { body = "left ground", x = early(ns), y = early(up) } },
                         duration = 150*s, still = { speed = 1e-5*inch/s, hold = 1*s, from = 55.9*s } }
print(("%s after %.1f s of shaking and falling"):format(report.ending, report.ended - report.begun))
