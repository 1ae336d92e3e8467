-- A facade from a DXF drawing: capacity curve with limit states, and records matched to a design spectrum.
-- Set a parameter on the command line: trilith run model.lua record=1 ag=0.35
local trilith = require "trilith"
local g = trilith.units "g"

-- 1. Parameters.
local p = trilith.params {
  record = { 0, "0: pushover; 1, 2 or 3: shaking by this record" },
  ag = { 0.25, unit = "g", "peak acceleration on rock" },
  duration = { 8, unit = "s", "duration of the shaking" } }

-- 2. Materials and contact: dry joints. `thickness` is the thickness of the wall [m].
local m = trilith.model { name = "facade", thickness = 0.4 }
m:material { name = "stone", density = 2200 }
m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 2e9, ks = 8e8, mu = 0.6, beta = 5e-5 } }

-- 3. Geometry: each closed outline of the drawing is a body, its layer is its group.
local facade = m:add(trilith.dxf { file = "facade.dxf" }, { material = "stone", fixed = "ground",
  by_group = { beams = { density = 8000 } } }) -- the beams carry floors
local free, top = facade - "ground.1", m:body "beams.2"

-- 4. Results.
m:results { file = ("out/facade_%d.h5"):format(p.record), frames = 0.02, histories = 0.01, energy = 0.05 }
m:history { name = "top", body = top, what = "ux" }

-- 5. Weight, then a slow push or an earthquake.
m:consolidate {}
local spectrum = trilith.spectrum { code = "eurocode8", type = 1, ground = "C", ag = p.ag }
if p.record == 0 then
  m:history { name = "force", what = "push_force" }
  m:history { name = "displacement", what = "push_displacement" }
  local push = m:pushover { body = free, displacement = 0.05, drop = 0.5 }
  local b = trilith.bilinear { curve = push, code = "ntc2018", mass = free.mass, spectrum = spectrum }
  print(("capacity %.1f kN, weight %.1f kN"):format(1e-3*b.yield_force, 1e-3*free.mass*g))
  print(("target displacement %.1f mm, ultimate %.1f mm"):format(1e3*b.target, 1e3*b.ultimate_displacement))
  return { capacity = b.yield_force, target = b.target }
end
local ns, ew = trilith.motion "elcentro_1940_rest_ns.csv", trilith.motion "elcentro_1940_rest_ew.csv"
local records = { ns, ew, ns:rotate(ew, math.pi/4) } -- the third one is the motion at 45 degrees between both
local motion = records[p.record]:match { spectrum = spectrum, from = 0.2, to = 2 }
m:shake { body = "ground.1", x = motion, duration = p.duration }
print(("peak %.2f g, the top has moved by %.1f mm"):format(motion.pga/g, 1e3*math.abs(top.ux)))
return { pga = motion.pga, top = math.abs(top.ux) }
