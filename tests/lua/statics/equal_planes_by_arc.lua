-- Load paths by arc length through equal planes at the same stress: one opens, the others unload. Bars of one body with
-- several planes, and bars of several bodies in series, against the closed form of one crack. L > 2 E Gf/ft^2 = 0.667 m
-- snaps back.
local trilith, bars = require "trilith", dofile "bars_along_x.lua"

local function near(a, b, share, what)
  assert(math.abs(a - b) <= share*math.abs(b), ("%s: %.10g is not %.10g"):format(what or "", a, b))
end

local E, ft, Gf, kn, b, glue_kn = 30e9, 3e6, 100, 1e13, 0.1, 1e14
local A = b*b
local function concrete(t)
  local m = trilith.model { name = "equal planes", dim = t.dim, thickness = t.dim == 2 and b or nil, gravity = 0 }
  m:material { name = "concrete", density = 2400, E = E, nu = 0 }
  for i, name in ipairs { "plane", "stronger" } do
    local strength = i == 1 and ft or ft*(1 + (t.stronger or 0))
    m:contact { between = { "*", "*" }, name = name, law = trilith.cohesive { kn = kn, ks = kn/2, mu = 0.5,
      tension = strength, cohesion = 2*strength, energy_tension = Gf, energy_shear = 4*Gf } }
  end
  m:contact { between = { "*", "*" }, name = "crack", law = "plane" }
  return m
end
local at, guided = bars.at, bars.guided
local function sized(dim, x, more) return bars.sized(dim, x, b, more) end

-- `bodies` bars in series between a wall and a guided block, bonded by a glue that does not crack. Rigid bars have
-- their compliance in a spring at the block.
local function pulled(t)
  local dim, n = t.dim, t.bodies or 1
  local m = concrete(t)
  local glue = trilith.bonded { kn = glue_kn, ks = glue_kn/2, mu = 0.5, tension = 1e8, cohesion = 1e8 }
  m:contact { between = { "wall", "bar1" }, name = "glue", law = glue }
  for i = 1, n do m:contact { between = { "bar"..i, i < n and "bar"..i + 1 or "block" }, law = "glue" } end
  m:block(sized(dim, 0.1, { name = "wall", material = "concrete", at = at(dim, -0.1, 0), support = "fixed" }))
  local length = t.L/n
  for i = 1, n do
    local bar = { name = "bar"..i, material = "concrete", at = at(dim, (i - 1)*length, 0), cracks = t.cracks,
      crack_law = t.stronger and i > 1 and "stronger" or "plane" }
    if not t.rigid then bar.body = { mesh = dim == 3 and { 4, 2, 2 } or { 8, 2 } } end
    m:block(sized(dim, length, bar))
  end
  local block = { name = "block", material = "concrete", support = guided(dim), at = at(dim, t.L, 0) }
  if t.rigid then
    block.at = at(dim, t.L + 0.2, 0)
    local spring = trilith.linear { stiffness = E*A/t.L }
    m:block(sized(dim, 0.1, block))
    m:bearing { name = "spring", between = { "bar"..n, "block" }, from = at(dim, t.L, b/2),
      to = at(dim, t.L + 0.2, b/2), along = spring, axial = spring, across = dim == 3 and spring or nil }
  else
    m:block(sized(dim, 0.1, block))
  end
  local cracked = {}
  m:on("unit.cracked", function(e) cracked[#cracked + 1] = e end)
  local r = m:pushover { name = "pull", body = "block", direction = "x", displacement = 1.5e-4, control = "arc",
    arc = 2e-6, samples = 400, drop = 1e-3 }
  return m, r, cracked
end

-- u = F L/(E A) + w - w0 on the branch of one crack, F = ft A (wc - w)/(wc - w0); each glued joint adds its opening.
local function check_branch(r, t)
  local w0, wc = ft/kn, 2*Gf/ft
  local glues = (t.bodies or 1) + (t.rigid and 0 or 1)
  local force, displacement = r.curve.force, r.curve.displacement
  local softening, backwards = 0, false
  for i = 2, #force do
    local share, u = force[i]/(ft*A), displacement[i]
    if force[i] < force[i - 1] and share > 0.02 and share < 0.98 then
      softening = softening + 1
      local elastic = share*ft*t.L/E + glues*force[i]/(glue_kn*A)
      near(u, elastic + (1 - share)*(wc - w0), 0.005, "displacement on the branch")
      backwards = backwards or u < displacement[i - 1]
    end
  end
  assert(softening >= 5, softening)
  assert(backwards == (t.L > 2*E*Gf/ft^2), "snap-back")
end

for _, t in ipairs {
  { dim = 2, L = 1, cracks = 3 }, { dim = 2, L = 1, cracks = 7 }, { dim = 2, L = 0.5, cracks = 3 },
  { dim = 3, L = 1, cracks = 3 }, { dim = 2, L = 1, cracks = 7, rigid = true },
  { dim = 3, L = 1, cracks = 7, rigid = true }, { dim = 2, L = 0.5, cracks = 3, rigid = true },
  { dim = 2, L = 1, cracks = "mid", bodies = 3 }, { dim = 3, L = 1, cracks = "mid", bodies = 3 },
  { dim = 2, L = 1, cracks = "mid", bodies = 8, rigid = true },
  { dim = 2, L = 1, cracks = 3, bodies = 4, rigid = true },
  { dim = 3, L = 1, cracks = "mid", bodies = 4, rigid = true },
  -- Planes that are nearly equal: the weakest one opens.
  { dim = 2, L = 1, cracks = "mid", bodies = 3, rigid = true, stronger = 1e-4 },
  { dim = 2, L = 1, cracks = "mid", bodies = 3, rigid = true, stronger = 9e-4 },
  { dim = 2, L = 1, cracks = "mid", bodies = 3, stronger = 2e-3 } } do
  local m, r, cracked = pulled(t)
  near(r.peak_force, ft*A, 2e-3, "peak")
  check_branch(r, t)
  near(m.energy.contact_fracture, (Gf - ft^2/(2*kn))*A, 0.01, "fracture energy of one plane")
  assert(math.abs(m.residual) < 1e-9)
  assert(#cracked == 1, #cracked)
  assert(cracked[1].mode == "tension" and (not t.stronger or cracked[1].body.name == "bar1"))
end
