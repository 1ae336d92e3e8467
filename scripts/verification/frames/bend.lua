-- Frames in space that bend far.
local trilith = require "trilith"

-- A circular cantilever of 45 degrees in the plane, loaded across it; straight elements between points of the circle.
local function bend(p)
  local m = trilith.model { name = "bend", dim = 3, gravity = 0 }
  m:material { name = "m", density = 1, E = 1e7, nu = 0 }
  local section = trilith.section { area = 1, inertia = 1/12, depth = 1, inertia_across = 1/12, torsion = p.torsion,
    width = 1 }
  local joints, members = {}, {}
  for i = 0, p.elements do
    local a = math.pi/4*i/p.elements
    local at = { 100*trilith.math.sin(a), 100*(1 - trilith.math.cos(a)), 0 }
    joints["j" .. i] = i == 0 and { at = at, support = "fixed" } or at
    if i > 0 then
      members[i] = { from = "j" .. i - 1, to = "j" .. i, section = section, divisions = 1, orientation = { 0, 0, 1 },
        shear = true }
    end
  end
  local body = m:frame { name = "bend", material = "m", joints = joints, members = members, floating = true }
  m:point_load { body = body, at = "j" .. p.elements, force = { 0, 0, p.force } }
  m:consolidate { integrator = "static", shares = 20, within = 10 }
  local x, y, z = body:point("j" .. p.elements)
  return { x = x, y = y, z = z }
end

local cases = {}
for _, row in ipairs { { 300, 58.779, 22.245, 40.192 }, { 450, 52.239, 18.508, 48.503 }, { 600, 47.150, 15.685,
  53.475 } } do
  cases[#cases + 1] = {
    name = ("bend_%.0f"):format(row[1]), title = "bend of 45 degrees, torsion constant 1/6",
    parameters = { { "force", row[1], "N" }, { "elements", 16 }, { "torsion", 1/6, "m4" } },
    checks = { { "x", unit = "m", exact = row[2], tolerance = 0.003 }, { "y", unit = "m", exact = row[3],
      tolerance = 0.003 },
      { "z", unit = "m", exact = row[4], tolerance = 0.003 } },
    run = bend,
  }
end
return {
  title = "Cantilever bend of 45 degrees",
  source = "Bathe and Bolourchi (1979), International Journal for Numerical Methods in Engineering 14; Simo and " ..
    "Vu-Quoc " ..
    "(1986), Computer Methods in Applied Mechanics and Engineering 58, section 5.4; recomputed by shooting",
  text = "A cantilever along an eighth of a circle of 100 m in the plane, section 1 m x 1 m, E = 10 MPa, G = 5 " ..
    "MPa, bears a " ..
    "dead force across the plane at its tip. The position of the tip is compared.",
  cases = cases,
}
