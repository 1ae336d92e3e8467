-- Three plots of one quantity over another: the loop of a bearing, a capacity curve, base shear over drift.
--
-- A deck on two lead-rubber bearings in an earthquake; a small wall in a pushover; the same wall in an earthquake.
-- docs/guide/plots.md plots the results with `trilith plot RESULT HISTORY --against HISTORY`.
local trilith = require "trilith"
local p = trilith.params { pga = { 0.35, unit = "g", "peak ground acceleration" } }
local quake = trilith.motion "elcentro_1940_rest_ns.csv":scale { pga = p.pga }

local function deck_on_bearings()
  local m = trilith.model { name = "deck on bearings", thickness = 8 }
  m:material { name = "concrete", density = 2500 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 5e9, ks = 2e9, mu = 0.5, beta = 1e-4 } }
  local ground = m:block { name = "ground", width = 16, height = 1, at = { -8, -1.3 }, material = "concrete",
                           support = "fixed" }
  local deck = m:block { name = "deck", width = 12, height = 1, at = { -6, 0 }, material = "concrete",
                         floating = true }
  for side, x in pairs { left = -5, right = 5 } do
    m:bearing { name = side, between = { ground, deck }, from = { x, -0.3 }, to = { x, 0 },
                along = trilith.bouc_wen { stiffness = 2e7, yield = 1.2e5, hardening = 0.1, exponent = 1 },
                axial = trilith.linear { stiffness = 4e9, damping = 4e6 } }
  end
  m:history { name = "force", bearing = "left", what = "force_along" }
  m:history { name = "displacement", bearing = "left", what = "displacement_along" }
  m:results { file = "out/bearing_loop.h5", histories = 0.01 }
  m:consolidate { duration = 10 }
  m:shake { name = "shake", body = ground, x = quake, duration = 25 }
end

local function wall(name)
  local m = trilith.model { name = name, thickness = 0.3 }
  m:material { name = "brick", density = 1900 }
  m:contact { between = { "*", "*" }, law = trilith.bonded {
    kn = 5e9, ks = 2e9, mu = 0.6, beta = 1.5e-4, tension = 5e4, cohesion = 8e4 } }
  m:wall { name = "wall", length = 3, unit_length = 0.5, unit_height = 0.25, bond = "running", storeys = 1,
           storey_height = 2.75, slab_height = 0.25, base_height = 0.5, base_margin = 10, material = "brick",
           fixed = "base", body = "rigid", by_group = { slabs = { weight = 1.5e4*3 } },
           openings = { { storey = 1, x = 1, width = 1, height = 2 } }, lintel_bearing = 0.25 }
  m:history { name = "base shear", what = "base_shear" }
  m:history { name = "drift", what = "top_drift" }
  return m
end

local function pushed()
  local m = wall "pushed wall"
  m:history { name = "push", what = "push_force" }
  m:results { file = "out/capacity.h5", histories = 0.02 }
  m:consolidate { duration = 5, fresh = true }
  local report = m:pushover { name = "push", body = m:bodies { group = "slabs" }, rate = 5e-3, drift = 0.05 }
  print(("largest push %.1f kN at a drift of %.1f mm"):format(report.peak_force/1e3, report.drift_at_peak*1e3))
end

local function shaken()
  local m = wall "shaken wall"
  m:results { file = "out/shear_drift.h5", histories = 0.002 }
  m:consolidate { duration = 5, fresh = true }
  m:shake { name = "shake", body = "wall.base", x = quake, duration = 12 }
end

deck_on_bearings()
pushed()
shaken()
