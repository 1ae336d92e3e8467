-- Running bond that is pulled along its beds: under light pressure the beds slide, under heavy pressure units crack.
local trilith = require "trilith"

local length, height, courses, units, overlap, mu, tension = 0.4, 0.2, 6, 4, 0.2, 0.6, 0.3e6
local thickness = 0.2

-- Courses of whole units, and between them courses that begin and end with a half. Head joints are open: the units of
-- a course do not touch. Pressure acts on the top course, and the bed below the bottom course has no friction. Units of
-- the outer courses have no planes and do not rotate: friction on one face alone bends them.
local function bond(pressure, dim)
  local m = dim == 3 and trilith.model { name = "running bond", dim = 3, gravity = 0 } or
    trilith.model { name = "running bond", thickness = thickness, gravity = 0 }
  -- A block of the wall; in space it has the thickness of the wall.
  local function block(t)
    if dim == 3 then
      t.size, t.at = { t.width, thickness, t.height }, { t.at[1], 0, t.at[2] }
      t.width, t.height = nil, nil
      if t.support and t.support.rotation then
        local word = t.support.rotation
        t.support = { rotation_x = word, rotation_y = word, rotation_z = word }
      end
    end
    return m:block(t)
  end
  m:material { name = "brick", density = 1800 }
  local kn, beta = 5e10, 2e-5
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = mu, beta = beta } }
  for c = 1, courses do m:contact { between = { "course " .. c, "course " .. c }, law = "none" } end
  m:contact { between = { "base", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 0, beta = beta } }
  m:contact { between = { "platens", "platens" }, law = "none" }
  m:contact { between = { "platens", "*" }, name = "glue",
    law = trilith.bonded { kn = kn, ks = 0, mu = 0, tension = 1e9, cohesion = 1e9, beta = beta } }
  m:contact { between = { "platens", "base" }, law = "none" }
  m:contact { between = { "unit", "platens" }, name = "plane",
    law = trilith.bonded { kn = kn, ks = kn/2, mu = mu, tension = tension, cohesion = 10*tension, beta = beta } }
  m:contact { between = { "unit", "platens" }, law = "glue" }
  block { name = "base", width = 4, height = 0.2, at = { -1, -0.2 }, material = "brick", support = "fixed" }
  for c = 1, courses do
    local y, x, n = (c - 1)*height, 0, 0
    while x < units*length - 1e-9 do
      local whole = c % 2 == 1 or (n > 0 and x + length < units*length + 1e-9)
      local l, planes = whole and length or length/2, whole and c > 1 and c < courses
      n = n + 1
      block { name = ("c%d.u%d"):format(c, n), width = l, height = height, at = { x, y }, material = "brick",
        groups = { "course " .. c, "unit" }, cracks = planes and "mid" or nil, crack_law = planes and "plane" or nil,
        support = { rotation = (c == 1 or c == courses) and "fixed" or "free" } }
      x = x + l
    end
  end
  local tall = courses*height
  block { name = "left", width = 0.2, height = tall, at = { -0.2, 0 }, material = "brick", groups = { "platens" },
    support = "fixed" }
  block { name = "right", width = 0.2, height = tall, at = { units*length, 0 }, material = "brick",
    groups = { "platens" }, support = "fixed" }
  for _, unit in ipairs(m:bodies { group = "course " .. courses }) do
    m:pressure { body = unit, face = "top", value = pressure }
  end
  return m
end

local function pulled(p)
  local m = bond(p.pressure, p.dim)
  local cracks, first = 0, nil
  m:on("unit.cracked", function(e)
    cracks, first = cracks + 1, first or e.body.name
  end)
  m:run { name = "pressed", duration = 0.05 }
  m:drive { body = "right", x = trilith.ramp { by = 2e-4, duration = 0.4 } }
  local left, most, inner = m:body "left", 0, true
  m:run { name = "pulled", duration = 0.4, until_true = function()
    most = math.max(most, math.abs(left.reaction_x))
    return cracks > 0
  end }
  if first then inner = first:match "^c[2-5]%." ~= nil end
  return { outcome = cracks > 0 and "cracks" or "slides", ["largest pull"] = most,
    ["first crack"] = first and (inner and "inner course" or "outer course") or "none" }
end

local slides = 5*mu*overlap*thickness
local function case(pressure, outcome, dim)
  local checks = { { "outcome", exact = outcome },
    { "first crack", exact = outcome == "cracks" and "inner course" or "none" } }
  if outcome == "slides" then
    checks[#checks + 1] = { "largest pull", unit = "N", exact = slides*pressure, tolerance = 0.02 }
  end
  return { name = ("running_bond_%.0f_kPa%s"):format(pressure/1e3, dim == 3 and "_in_space" or ""),
    title = "running bond pulled along its beds", parameters = { { "pressure", pressure, "Pa" }, { "dim", dim } },
    checks = checks, run = pulled }
end

return {
  title = "Units or beds: a running bond that is pulled",
  source = "Equilibrium of an inner unit under the friction of both its beds",
  formula = [[\sigma_\text{limit} = \frac{f_t \, h}{2 \mu \, l_o}, \qquad P = 5 \, \mu \, \sigma \, l_o \, t]],
  text = "Six courses, four units of 0.4 m by 0.2 m by 0.2 m long, overlap half a unit. Beds have friction alone, " ..
    "head joints are open, and each unit of the inner courses has a brittle plane of 0.3 MPa in its middle. It " ..
    "cracks above 250 kPa. Units of the outer courses do not rotate: friction on one face alone would bend them.",
  cases = { case(125e3, "slides", 2), case(225e3, "slides", 2), case(275e3, "cracks", 2), case(375e3, "cracks", 2),
    case(225e3, "slides", 3), case(275e3, "cracks", 3) },
}
