-- Fibre sections of steel: moment, axial force and curvature.
local trilith = require "trilith"
local E, fy, b, h = 2.1e11, 240e6, 0.1, 0.2
local My, curvature_y = 160e3, 2*240e6/(2.1e11*0.2)

-- A short cantilever under a dead moment at its end has one curvature along its length.
local function cantilever()
  local m = trilith.model { name = "section", gravity = 0 }
  m:material { name = "steel", density = 7850, E = E }
  local section = trilith.fibre_section { shape = trilith.rectangle_section { width = b, depth = h }, layers = 40,
    law = trilith.bilinear_steel { E = E, yield = fy } }
  return m, m:beam { name = "beam", from = { 0, 0 }, to = { 0.1, 0 }, section = section, material = "steel",
    divisions = 1, from_support = "fixed", floating = true }
end

local cases = {}
for _, row in ipairs { { 1.27778, 1.5 }, { 1.375, 2 }, { 1.44444, 3 }, { 1.48, 5 } } do
  cases[#cases + 1] = {
    name = ("fibre_moment_%.0f"):format(10*row[2]), title = "moment of a rectangle beyond yield",
    parameters = { { "M_over_My", row[1] }, { "layers", 40 } },
    checks = { { "curvature over that at yield", exact = row[2], tolerance = 0.02 } },
    run = function(p)
      local m, body = cantilever()
      m:point_load { body = body, at = { 0.1, 0 }, moment = p.M_over_My*My }
      m:consolidate { integrator = "static", shares = 20, within = 10 }
      return math.abs(body:fibres()[1].curvature)/curvature_y
    end,
  }
end

return {
  title = "Yielding of a section",
  source = "Neal (1977), The Plastic Methods of Structural Analysis, section 1.3",
  formula = [[\frac{M}{M_y} = \frac{3}{2} - \frac{1}{2}\left(\frac{\varphi_y}{\varphi}\right)^2]],
  text = "An elastic and perfectly plastic rectangle under a moment. The curvature grows without bound as the " ..
    "moment tends to " ..
    "1.5 times that at yield.",
  cases = cases,
}
