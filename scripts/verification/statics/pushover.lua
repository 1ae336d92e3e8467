-- A rigid block on a joint without tension that is pushed over, and a beam on a bed without tension.
local trilith = require "trilith"
local g = 9.80665

-- Horizontal force at the height a that holds a block at a rotation, once the joint opens.
local B, H, kn, a = 0.5, 2, 1e8, 1
local W = 2000*B*H*g*0.5
local function held_at(angle)
  local s, c = trilith.math.sin(angle), trilith.math.cos(angle)
  local length = math.sqrt(2*W/(kn*0.5*s))
  local r = B/2 - length/3
  return W*(r*c - H/2*s)/(a*c + r*s)
end

local cases = { {
  name = "block_pushed_over", title = "block of 0.5 m x 0.5 m x 2 m, pushed at 1 m by arc length",
  parameters = { { "B", B, "m" }, { "H", H, "m" }, { "kn", kn, "Pa/m" } },
  checks = { { "peak force", unit = "N", exact = 1791.3, tolerance = 0.005 },
    { "rotation at the peak", unit = "rad", exact = 0.02157, tolerance = 0.02 },
    { "force at 0.05 rad", unit = "N", exact = held_at(0.05), tolerance = 0.01 },
    { "force at 0.1 rad", unit = "N", exact = held_at(0.1), tolerance = 0.01 } },
  run = function()
    local m = trilith.model { name = "pushed", thickness = 0.5 }
    m:material { name = "stone", density = 2000 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = kn, ks = kn/2, mu = 2, beta = 1e-4 } }
    m:block { name = "ground", width = 4, height = 1, at = { -2, -1 }, material = "stone", support = "fixed" }
    local block = m:block { name = "block", width = B, height = H, at = { -B/2, 0 }, material = "stone" }
    m:consolidate { integrator = "static" }
    local angle, force, top = {}, {}, 1
    m:on_step(function()
      angle[#angle + 1], force[#force + 1] = math.abs(block.rotation), m.push_force
      if m.push_force > force[top] then top = #force end
    end)
    m:pushover { body = block, at = { 0, 1 }, control = "arc", displacement = 0.13, samples = 600, arc = 2e-4 }
    local function at_angle(wanted)
      for i = 2, #angle do
        if angle[i] >= wanted then
          return force[i - 1] + (force[i] - force[i - 1])*(wanted - angle[i - 1])/(angle[i] - angle[i - 1])
        end
      end
      return 0/0
    end
    -- Vertex of the parabola through the highest point and its neighbours, as the peak is flat.
    local function slope(i) return (force[i + 1] - force[i])/(angle[i + 1] - angle[i]) end
    local left, right = 0.5*(angle[top - 1] + angle[top]), 0.5*(angle[top] + angle[top + 1])
    local share = slope(top - 1)/(slope(top - 1) - slope(top))
    return { ["peak force"] = force[top], ["rotation at the peak"] = left + share*(right - left),
      ["force at 0.05 rad"] = at_angle(0.05), ["force at 0.1 rad"] = at_angle(0.1) }
  end,
} }

-- A weightless beam on a bed of blocks of its own width that only press.
cases[#cases + 1] = {
  name = "beam_on_bed", title = "weightless beam on a bed without tension, force in the middle",
  parameters = { { "EI", 2.025e7, "N m2" }, { "bed", 5e7, "N/m2" }, { "P", 1e5, "N" } },
  checks = { { "deflection", unit = "m", exact = 0.96645e-3, tolerance = 0.01 },
    { "moment", unit = "N m", exact = 30752, tolerance = 0.01 } },
  run = function(p)
    local m = trilith.model { name = "bed", thickness = 0.3, gravity = 0 }
    m:material { name = "m", density = 2400, E = 30e9 }
    m:contact { between = { "*", "*" }, law = trilith.frictional { kn = p.bed/0.3, ks = p.bed/0.6, mu = 0.5,
      beta = 1e-4 } }
    m:block { name = "bed", width = 24, height = 1, at = { -12, -1.15 }, material = "m", support = "fixed" }
    local n = 160
    local body = m:beam { name = "beam", from = { -10, 0 }, to = { 10, 0 }, material = "m", divisions = n,
      floating = true,
      section = trilith.rectangle_section { width = 0.3, depth = 0.3 } }
    m:point_load { body = body, at = { 0, 0 }, force = { 0, -p.P } }
    m:consolidate { integrator = "static", shares = 10 }
    local _, y = body:point { 0, 0 }
    local most = 0
    for _, row in ipairs(body:forces()) do most = math.max(most, math.abs(row.moment)) end
    return { deflection = -y, moment = most }
  end,
}

return {
  title = "Pushover of a block, beam on a bed",
  source = "Derived: equilibrium of a block that turns on a joint with a triangle of stress. Hetenyi (1946), " ..
    "Beams on Elastic " ..
    "Foundation, and Weitsman (1970), Journal of Applied Mechanics 37, for the bed that only presses",
  formula = [[F = W\,\frac{r\cos\theta - \tfrac{H}{2}\sin\theta}{a\cos\theta + r\sin\theta}, \qquad
r = \frac{B}{2} - \frac{c}{3}, \qquad c = \sqrt{\frac{2W}{k_n D\sin\theta}}]],
  cases = cases,
}
