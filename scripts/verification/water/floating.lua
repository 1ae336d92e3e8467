-- A floating box: draught, heave and roll.
local trilith = require "trilith"
local g = 9.80665
local sin, cos = trilith.math.sin, trilith.math.cos

-- A box of width b and height h, its centroid at (0, y), turned by `angle` [rad]; the surface is at 0.
local function box(p, y, angle)
  local m = trilith.model { name = "box" }
  m:material { name = "light", density = 600 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 1e9, mu = 0.6 } }
  local c, s, outline = cos(angle), sin(angle), {}
  for i, q in ipairs { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } do
    local u, v = q[1]*p.b/2, q[2]*p.h/2
    outline[i] = { c*u - s*v, y + s*u + c*v }
  end
  local body = m:polygon { name = "box", outline = outline, material = "light", floating = true }
  m:water { body = body, level = 0, side = "all" }
  return m, body
end

-- Period from the first and the fifth passage of the mean [s].
local function period(m, read)
  local times, before = {}, nil
  m:run { duration = 6, dt = 5e-4, until_true = function(now)
    local v = read()
    if before and before < 0 and v >= 0 then times[#times + 1] = now.time - 5e-4*v/(v - before) end
    before = v
    return false
  end }
  return (times[#times] - times[1])/(#times - 1)
end

local upright = { { "b", 1, "m" }, { "h", 0.5, "m" } }
local middle = -0.3 + 0.25 -- of the box at its draught
local metacentre = 1/(12*0.3) - 0.1
return {
  title = "Floating box",
  source = "Hydrostatics; metacentric height of a box, roll without added mass",
  formula = [[d = h\,\frac{\rho_s}{\rho}, \qquad T_\text{heave} = 2\pi\sqrt{\frac{d}{g}}, \qquad
\overline{GM} = \frac{b^2}{12 d} - \frac{h - d}{2}, \qquad T_\text{roll} = 2\pi\sqrt{\frac{J}{m g\,\overline{GM}}}]],
  text = "A box of width $b$, height $h$ and density 600 kg/m3 floats with draught $d$. It floats upright where the " ..
    "metacentric height $\\overline{GM}$ is above 0. A box of 0.5 m by 1 m does not.",
  cases = {
    { name = "water_draught", title = "draught", parameters = upright,
      checks = { { "draught", unit = "m", exact = 0.3, tolerance = 0.005 } },
      run = function(p)
        local m, body = box(p, 0.1, 0)
        m:consolidate { integrator = "static" }
        return p.h/2 - body.y
      end },
    { name = "water_heave", title = "heave", parameters = upright,
      checks = { { "period", unit = "s", exact = 2*math.pi*(0.3/g)^0.5, tolerance = 0.005 } },
      run = function(p)
        local m, body = box(p, middle - 0.01, 0)
        return period(m, function() return body.y - middle end)
      end },
    { name = "water_roll", title = "roll", parameters = upright,
      checks = { { "period", unit = "s", exact = 2*math.pi*((1 + 0.25)/12/(g*metacentre))^0.5, tolerance = 0.005 } },
      run = function(p)
        local angle = 0.5*math.pi/180
        local m, body = box(p, middle, angle)
        return period(m, function() return body.rotation + angle end)
      end },
    { name = "water_upright", title = "a box that floats upright", parameters = upright,
      checks = { { "box", exact = "upright" } },
      run = function(p)
        local m, body = box(p, middle, 0.01)
        m:run { duration = 10 }
        return math.abs(body.rotation) < 0.05 and "upright" or "turns over"
      end },
    { name = "water_turns_over", title = "a box that does not", parameters = { { "b", 0.5, "m" }, { "h", 1, "m" } },
      checks = { { "box", exact = "turns over" } },
      run = function(p)
        local m, body = box(p, -0.6 + 0.5, 0.01)
        m:run { duration = 10 }
        return math.abs(body.rotation) < 0.05 and "upright" or "turns over"
      end },
  },
}
