-- Pressure of water on plane faces: force and point of action.
local trilith = require "trilith"
local sin, cos = trilith.math.sin, trilith.math.cos
local deg = trilith.units "deg"
local weight = 1000*9.80665

local function model()
  local m = trilith.model { name = "water" }
  m:material { name = "concrete", density = 2400 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e10, ks = 1e10, mu = 0.6 } }
  return m
end

local function turned(angle)
  local m = model()
  local c, s, outline = cos(angle*deg), sin(angle*deg), {}
  for i, p in ipairs { { -0.5, -0.5 }, { 0.5, -0.5 }, { 0.5, 0.5 }, { -0.5, 0.5 } } do
    outline[i] = { 3 + c*p[1] - s*p[2], 1 + s*p[1] + c*p[2] }
  end
  m:polygon { name = "cube", outline = outline, material = "concrete", floating = true }
  m:water { name = "lake", body = "cube", level = 4, side = "all" }
  return m:water_state "lake"
end

local cases = {
  {
    name = "water_upright_face", title = "upright face, 3 m deep", parameters = { { "depth", 3, "m" } },
    checks = { { "force", unit = "N", exact = weight*4.5, tolerance = 1e-9 },
      { "depth of the force", unit = "m", exact = 2, tolerance = 1e-9 } },
    run = function(p)
      local m = model()
      m:block { name = "wall", width = 1, height = 5, at = { 0, 0 }, material = "concrete", floating = true }
      m:water { name = "lake", body = "wall", level = p.depth, side = "left" }
      local s = m:water_state "lake"
      return { force = s.force[1], ["depth of the force"] = p.depth + s.moment/s.force[1] }
    end,
  },
  {
    name = "water_inclined_face", title = "inclined face, its upper edge under water",
    parameters = { { "length", 2.5, "m" }, { "angle", 60, "deg" }, { "depth", 1.2, "m" } },
    checks = { { "force", unit = "N", exact = weight*2.5*(1.2 + 1.25*sin(60*deg)), tolerance = 1e-9 },
      { "distance from the upper edge", unit = "m",
        exact = 1.25 + 2.5^2*sin(60*deg)/12/(1.2 + 1.25*sin(60*deg)), tolerance = 1e-9 } },
    run = function(p)
      local m = model()
      local x, y = -p.length*cos(p.angle*deg), -p.length*sin(p.angle*deg)
      m:polygon { name = "wall", outline = { { 0, 0 }, { x, y }, { 2, y }, { 2, 0 } }, material = "concrete",
        floating = true }
      m:water { name = "lake", body = "wall", level = p.depth, from = { 0, 0 }, to = { x, y } }
      local s = m:water_state "lake"
      local force = (s.force[1]^2 + s.force[2]^2)^0.5
      return { force = force, ["distance from the upper edge"] = math.abs(s.moment)/force }
    end,
  },
}
for _, angle in ipairs { 0, 17, 45 } do
  cases[#cases + 1] = {
    name = ("water_cube_%d"):format(angle), title = ("cube under water, turned by %d degrees"):format(angle),
    parameters = { { "angle", angle, "deg" } },
    checks = { { "force upwards", unit = "N", exact = weight, tolerance = 1e-9 },
      { "force across", unit = "N", exact = 0, within = 1e-6 },
      { "moment about the centroid", unit = "N m", exact = 0, within = 1e-6 } },
    run = function(p)
      local s = turned(p.angle)
      return { ["force upwards"] = s.force[2], ["force across"] = s.force[1],
        ["moment about the centroid"] = s.moment - 3*s.force[2] + 1*s.force[1] }
    end,
  }
end

return {
  title = "Pressure of water on plane faces",
  source = "Hydrostatics: the pressure of water at rest is its weight per volume times the depth",
  formula = [[p = \rho g\,(h - z), \qquad F = \rho g\, A\, d_c, \qquad
    y = \frac{L}{2} + \frac{L^2 \sin\alpha}{12\, d_c}]],
  text = "$d_c$ is the depth of the centroid of a face of length $L$, inclined by $\\alpha$, and $y$ the distance " ..
    "of the " ..
    "resultant from its upper edge. On a closed body the resultant is the weight of the displaced water, through " ..
    "the centroid.",
  cases = cases,
}
