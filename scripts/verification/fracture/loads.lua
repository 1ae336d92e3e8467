-- A block under water that a wall holds: bending by its submerged weight, and the pressure of the water on its end.
local trilith = require "trilith"

local length, height, depth, tension = 1.2, 0.2, 0.3, 0.15e6
local density, weight = 2400, 1000*9.80665

-- Submerged weight of the part ahead of the plane bends the section, and the water presses it together.
local function bending(arm)
  local moment = (density*9.80665 - weight)*height*depth*arm^2/2
  return 6*moment/(depth*height^2)
end

-- Depth of the upper edge of the section under the water at which its stress is the strength.
local function limit(p) return (bending(p.arm) - tension)/weight end

local function laws(m)
  m:material { name = "concrete", density = density }
  m:contact { between = { "*", "*" }, name = "glue",
    law = trilith.bonded { kn = 1e11, ks = 5e10, mu = 0.5, tension = 1e9, cohesion = 1e9, beta = 1e-4 } }
  m:contact { between = { "block", "block" }, name = "plane",
    law = trilith.bonded { kn = 1e11, ks = 5e10, mu = 0.6, tension = tension, cohesion = 20*tension, beta = 1e-4 } }
  m:contact { between = { "*", "*" }, law = "glue" }
end

local function held_block(p)
  local m
  if p.dim == 3 then
    m = trilith.model { name = "wet block", dim = 3 }
    laws(m)
    m:block { name = "wall", size = { 0.5, depth, 1 }, at = { -0.5, 0, -0.5 }, material = "concrete",
      support = "fixed" }
    m:block { name = "block", size = { length, depth, height }, at = { 0, 0, 0 }, material = "concrete",
      floating = true, crack_law = "plane", cracks = { { point = { length - p.arm, 0, 0.05 }, normal = { 1, 0, 0 } } } }
  else
    m = trilith.model { name = "wet block", thickness = depth }
    laws(m)
    m:block { name = "wall", width = 0.5, height = 1, at = { -0.5, -0.5 }, material = "concrete", support = "fixed" }
    m:block { name = "block", width = length, height = height, at = { 0, 0 }, material = "concrete", floating = true,
      crack_law = "plane", cracks = { { point = { length - p.arm, 0.05 }, normal = { 1, 0 } } } }
  end
  return m
end

-- The level falls until the block cracks; the pressure of the water has held it together.
local function drawdown(p, joints)
  local m = held_block(p)
  local top = height
  m:water { name = "lake", body = "block", level = top + limit(p) + 0.3, side = "all", joints = joints }
  m:consolidate { rest = { ratio = 1e-5 }, duration = 2 }
  local found
  m:on("unit.cracked", function(e) found = found or { level = m:water_state "lake".level, e = e } end)
  m:set_level { name = "lake", level = top + limit(p) - 0.3, duration = 0.4 }
  m:run { duration = 0.5, until_true = function() return found ~= nil end }
  local pressed = m:water_state "lake".force
  return { ["depth of the upper edge at the crack"] = found and found.level - top or 0/0,
    mode = found and found.e.mode or "none",
    ["upward force of the water"] = pressed[#pressed]/(weight*length*height*depth) }
end

local function case(dim, joints)
  local checks = { { "depth of the upper edge at the crack", unit = "m", exact = limit { arm = 1 }, within = 0.03 },
    { "mode", exact = "tension" } }
  if joints == "sealed" then
    checks[#checks + 1] = { "upward force of the water", unit = "of the displaced weight", exact = 1, within = 1e-3 }
  end
  return { name = ("submerged_block_%dd_%s"):format(dim, joints),
    title = ("a block under a falling level, %s joints"):format(joints),
    parameters = { { "dim", dim }, { "arm", 1, "m" } }, checks = checks,
    run = function(p) return drawdown(p, joints) end }
end

return {
  title = "Loads on bodies with planes: a block under water",
  source = "Statics of the part ahead of the section; pressure of water at rest",
  formula = [[\sigma_\text{top} = \frac{3 (\rho g - w) a^2}{h} - w \, (z_w - z_\text{top})]],
  text = "A block of 1.2 m by 0.3 m by 0.2 m is bonded to a wall by its end, under water. At a plane 1 m from its " ..
    "free end the submerged weight pulls the upper edge, and the water presses it together. The level falls slowly, " ..
    "and the block cracks at the depth where both differ by its strength. The joint at the wall is sealed. The case " ..
    "with a wet joint has the same section, because water behind the bond acts on the other part.",
  cases = { case(2, "sealed"), case(2, "wet"), case(3, "sealed"), case(3, "wet") },
}
