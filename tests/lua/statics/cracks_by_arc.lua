-- Load paths by arc length on which bodies crack: bars that snap back against their closed form, a notched beam, and
-- brittle bars. L > 2 E Gf/ft^2 = 0.667 m snaps back.
local trilith, bars = require "trilith", dofile "bars_along_x.lua"

local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.10g is not %.10g"):format(what or "", a, b))
end

local E, ft, Gf, kn, b = 30e9, 3e6, 100, 1e13, 0.1
local function concrete(t)
  local m = trilith.model { name = "paths of cracks", dim = t.dim, thickness = t.dim == 2 and b or nil, gravity = 0 }
  m:material { name = "concrete", density = 2400, E = E, nu = t.nu or 0 }
  local strengths = { kn = kn, ks = kn/2, mu = 0.5, tension = ft, cohesion = 2*ft }
  if not t.brittle then strengths.energy_tension, strengths.energy_shear = t.Gf or Gf, 4*Gf end
  m:contact { between = { "*", "*" }, name = "plane",
    law = t.brittle and trilith.bonded(strengths) or trilith.cohesive(strengths) }
  return m
end
local at, guided = bars.at, bars.guided
local function sized(dim, x, more) return bars.sized(dim, x, b, more) end

-- A bar is held at its left end, or bonded to a block there, and pulled at its right end by a guided block. The rigid
-- bar has its compliance in the spring between both.
local function pulled(t)
  local dim, L, A = t.dim, t.L, 0.01
  local m = concrete(t)
  m:contact { between = { "block", "bar" }, name = "glue", law = trilith.bonded { kn = 1e14, ks = 5e13, mu = 0.5,
    tension = 1e9, cohesion = 1e9 } }
  local bar = { name = "bar", material = "concrete", at = at(dim, 0, 0), cracks = t.cracks, crack_law = "plane" }
  if t.cracks == false then bar.crack_law = nil end
  local block = { name = "block", material = "concrete", support = guided(dim) }
  if t.rigid then
    m:contact { between = { "wall", "bar" }, law = "glue" }
    m:block(sized(dim, 0.1, { name = "wall", material = "concrete", at = at(dim, -0.1, 0), support = "fixed" }))
    m:block(sized(dim, 0.5, bar))
    block.at = at(dim, 0.7, 0)
    m:block(sized(dim, 0.1, block))
    local spring = trilith.linear { stiffness = E*A/L }
    m:bearing { name = "spring", between = { "bar", "block" }, from = at(dim, 0.5, b/2), to = at(dim, 0.7, b/2),
      along = spring, axial = spring, across = dim == 3 and spring or nil }
  else
    bar.body = { mesh = dim == 3 and { 12, 2, 2 } or { 12, 2 } }
    bar.hold = { { from = at(dim, 0, 0), to = at(dim, 0, b), x = "fixed", y = "fixed",
      z = dim == 3 and "fixed" or nil } }
    m:block(sized(dim, L, bar))
    block.at = at(dim, L, 0)
    m:block(sized(dim, 0.1, block))
  end
  local cracked = {}
  m:on("unit.cracked", function(e) cracked[#cracked + 1] = e end)
  local r = m:pushover { name = "pull", body = "block", direction = "x", displacement = t.to or 1.5e-4,
    control = "arc", arc = 2e-6, samples = 400, drop = t.drop or 1e-3 }
  return m, r, cracked
end

-- u = F L/(E A) + w - w0 on the branch of the crack, F = ft A (wc - w)/(wc - w0); the glue adds its opening.
local function check_branch(r, t)
  local w0, wc, A = ft/kn, 2*Gf/ft, 0.01
  local glues = t.rigid and 2 or 1
  local softening, backwards = 0, false
  for i, F in ipairs(r.curve.force) do
    local share, u = F/(ft*A), r.curve.displacement[i]
    local elastic = share*ft*t.L/E + glues*F/(1e14*A)
    if i > 1 and F < r.curve.force[i - 1] and share > 0.02 and share < 0.98 then
      softening = softening + 1
      near(u, elastic + (1 - share)*(wc - w0), 0.005, "displacement on the branch")
      backwards = backwards or u < r.curve.displacement[i - 1]
    end
  end
  assert(softening >= 5, softening)
  assert(backwards == (t.L > 2*E*Gf/ft^2), "snap-back")
end

for _, t in ipairs { { dim = 2, L = 1, cracks = "mid" }, { dim = 2, L = 0.5, cracks = "mid" },
  { dim = 3, L = 1, cracks = "mid" },
  { dim = 2, L = 1, cracks = "mid", rigid = true }, { dim = 3, L = 1, cracks = "mid", rigid = true } } do
  local m, r, cracked = pulled(t)
  assert(#cracked >= 1 and cracked[1].body.name == "bar" and cracked[1].mode == "tension")
  near(cracked[1].value, ft, 1.1e-3, "stress at the crack")
  near(r.peak_force, ft*0.01, 2e-3, "peak")
  check_branch(r, t)
  near(m.energy.contact_fracture, (Gf - ft^2/(2*kn))*0.01, 0.02, "fracture energy")
  assert(math.abs(m.residual) < 1e-9)
  assert(#r.happened >= 1 and r.happened[1]:find("cracked in tension"))
  for i = 2, #r.curve.t do assert(r.curve.t[i] > r.curve.t[i - 1], "time") end
end

-- Planes that do not crack change no hash.
do
  local with, a = pulled { dim = 2, L = 1, cracks = "mid", to = 5e-5 }
  local without, c = pulled { dim = 2, L = 1, cracks = false, to = 5e-5 }
  assert(with.hash == without.hash and #a.curve.force == #c.curve.force)
end

-- A brittle bar carries its strength, and parts.
for _, rigid in ipairs { false, true } do
  local m, r, cracked = pulled { dim = 2, L = 1, cracks = "mid", brittle = true, rigid = rigid }
  assert(#cracked == 1)
  near(r.peak_force, ft*0.01, 2e-3, "strength of a brittle bar")
  assert(math.abs(r.force) < 1e-3*r.peak_force, r.force)
  assert(m:body "bar.a".present and m:body "bar.b".present)
end
