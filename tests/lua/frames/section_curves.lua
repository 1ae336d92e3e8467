-- Curves of sections of fibres: closed forms of perfectly plastic steel, pictures, and messages.
local trilith = require "trilith"

local b, h, E, fy = 0.1, 0.2, 2e11, 250e6
local section = trilith.fibre_section { shape = trilith.rectangle_section { width = b, depth = h }, layers = 200,
  law = trilith.bilinear_steel { E = E, yield = fy } }
local first, full = 2*fy/(E*h), b*h^2/4*fy

local function near(value, expected, share)
  assert(math.abs(value - expected) <= share*math.abs(expected), ("%g, expected %g"):format(value, expected))
end
local function refused(words, f, ...)
  local ok, why = pcall(f, ...)
  assert(not ok and tostring(why):find(words, 1, true), ("%s is not in: %s"):format(words, tostring(why)))
end

local wide = { curvature = 10*first, points = 50, compression = 0.1, tension = 0.1 }
local curve = section:moment_curvature(wide)
assert(#curve.curvature == 51 and #curve.moment == 51 and #curve.axial == 51 and curve.limit == "curvature")
near(curve.moment[51], full*(1 - 0.1^2/3), 1e-4)
near(curve.yield_curvature, first, 5e-3)
near(curve.yield_moment, 2/3*full, 5e-3)
near(curve.peak_moment, curve.moment[51], 1e-12)
-- With half of the squash load the plastic moment is 3/4.
near(section:moment_curvature { normal = -0.5*b*h*fy, compression = 0.1, tension = 0.1 }.peak_moment, 0.75*full, 2e-3)

local both = section:interaction { points = 9, compression = 0.1, tension = 0.1 }
assert(#both.normal == 9)
near(both.normal[1], -b*h*fy, 1e-9)
near(both.sagging[5], full, 2e-3)
near(both.hogging[5], -full, 2e-3)
near(both.sagging[3], 0.75*full, 5e-3)

for _, of in ipairs { "moment_curvature", "interaction" } do
  local file = os.tmpname() .. ".svg"
  section:plot { file = file, of = of }
  local text = assert(io.open(file)):read "a"
  assert(text:find "<svg" and #text > 2000, of)
  os.remove(file)
end

refused("has no fibres and so no strength", function()
  return trilith.rectangle_section { width = b, depth = h }:moment_curvature {}
end)
refused("does not carry a normal force of", section.moment_curvature, section, { normal = 1.1*b*h*fy })
refused("must be a strain above 0", section.interaction, section, { compression = -0.01 })
refused("'normal' is for of", section.plot, section, { file = "a.svg", of = "interaction", normal = 1 })
refused("list of them", section.plot, section, { file = "a.svg", normal = {} })
refused(".svg, .pdf", section.plot, section, { file = "a.gif" })
