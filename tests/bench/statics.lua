-- Equilibrium of the masonry wall of the gallery (scripts/wall.lua) by statics and by damped time steps: seconds of
-- both, and the difference of their joint forces. `trilith run tests/bench/statics.lua`.
local trilith = require "trilith"
local ft, inch, kip, g, pcf, psi, psf = trilith.units "ft inch kip g pcf psi psf"
local p = trilith.params { body = { "quad", "type of a unit: quad or rigid" },
                           ratio = { 1e-5, "unbalanced force at which steps of time end" } }
local sill, side = 2*ft + 8*inch, 4*ft
local function window(storey, x) return { storey = storey, x = x, sill = sill, width = side, height = side } end
local kn, mass = 1e5*psi/inch, 120*pcf*16*inch*(8*inch)^2/g
local function build()
  local m = trilith.model { name = "masonry wall", thickness = 8*inch }
  m:material { name = "brick", unit_weight = 120*pcf, E = 1.5e6*psi, nu = 0.2 }
  m:material { name = "concrete", unit_weight = 150*pcf }
  m:contact { between = { "*", "*" }, name = "mortar", law = trilith.bonded {
    kn = kn, ks = 0.4*kn, mu = trilith.math.tan(35*math.pi/180),
    beta = 2*0.1/math.sqrt(kn*16*8*inch^2/mass), tension = 400*psf, cohesion = 204*psf } }
  m:wall {
    name = "wall", length = 16*ft, unit_length = 16*inch, unit_height = 8*inch, bond = "running",
    storeys = 3, storey_height = 8*ft, slab_height = 8*inch, base_height = 2*ft, base_margin = 100*ft,
    openings = { { storey = 1, x = 2*ft + 8*inch, width = side, height = sill + side }, window(1, 9*ft + 4*inch),
                 window({ 2, 3 }, 2*ft + 8*inch), window({ 2, 3 }, 10*ft + 8*inch) },
    lintel_bearing = 8*inch, material = "brick", fixed = "base", body = p.body,
    by_group = { slabs = { weight = 1.2*kip/ft*16*ft, body = "rigid" },
                 base = { material = "concrete", body = "rigid" } } }
  return m
end

--- Seconds until rest, and the force of each joint.
local function settle(how)
  local m = build()
  local began = os.clock()
  local report = m:consolidate(how)
  local seconds, forces = os.clock() - began, {}
  assert(report.rests, tostring(report))
  for _, c in ipairs(m:contacts()) do
    local pair = c.a.name .. " " .. c.b.name
    local sum = forces[pair] or { n = 0, t = 0 }
    forces[pair] = { n = sum.n + c.normal, t = sum.t + c.shear }
  end
  m:close()
  return seconds, forces, report
end

local slow, in_time, report = settle {
  duration = 60, rest = { ratio = p.ratio, speed = 1e-7 }, safety = 0.8, fresh = true }
local fast, at_once = settle { integrator = "static", fresh = true }
local worst, most, where = 0, 0, "-"
for _, f in pairs(in_time) do most = math.max(most, f.n) end
for pair, f in pairs(in_time) do
  local other = at_once[pair] or { n = 0, t = 0 }
  local off = math.max(math.abs(f.n - other.n), math.abs(f.t - other.t))
  if off > worst then worst, where = off, pair end
end
print(("set down by statics in %.2f s, in %d steps of time in %.2f s: %.1f times as long"):format(fast, report.steps,
  slow, slow/fast))
print(("joint forces differ by %.2g %% of the largest at most, between %s"):format(100*worst/most, where))
