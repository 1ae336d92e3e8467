-- Blocks whose section forces follow from statics: beams under loads and on joints, pure shear, pure compression.
local trilith = require "trilith"

local tension, cohesion, compression = 0.3e6, 0.5e6, 4e6
local length, height, depth = 0.8, 0.2, 0.2

-- A block of the section 0.2 m by 0.2 m with one plane, in a model without weight.
local function block(options)
  local m = trilith.model { name = "block", thickness = depth, gravity = 0 }
  m:material { name = "stone", density = 2400 }
  m:contact { between = { "*", "*" }, law = "none" }
  local law = { kn = 1e11, ks = 5e10, mu = 0.6, tension = tension, cohesion = cohesion, beta = 1e-6 }
  if options.softens then
    law.energy_tension, law.energy_shear, law.compression = 100, 400, compression
  end
  m:contact { between = { "block", "block" }, name = "plane",
    law = options.softens and trilith.cohesive(law) or trilith.bonded(law) }
  m:contact { between = { "ground", "block" }, name = "joint", law = options.joint or "none" }
  options.build(m)
  m:block { name = "block", width = length, height = height, at = { 0, 0 }, material = "stone", floating = true,
    cracks = options.cracks or "mid", crack_law = "plane" }
  return m
end

-- The load at which the block cracks, as a share of `limit` [N]; it grows slowly from 0.98 to 1.02 of it.
local function load_at_crack(m, limit, loads)
  for _, load in ipairs(loads) do
    local f = load.force or { 0, 0 }
    m:point_load { body = "block", at = load.at, force = { f[1]*limit, f[2]*limit }, moment = (load.moment or 0)*limit,
      load_curve = { { 0, 0 }, { 0.05, 0.98 }, { 0.25, 1.02 } } }
  end
  local found, mode, plane
  m:on("unit.cracked", function(e)
    local t = m.time
    found, mode, plane = found or 0.98 + 0.04*(t - 0.05)/0.2, mode or e.mode, plane or e.plane
  end)
  m:run { duration = 0.25, until_true = function() return found ~= nil end }
  return { ["load at the crack"] = found or 0/0, mode = mode or "none", plane = plane or 0 }
end

local modulus = depth*height^2/6
local stiff = trilith.linear { stiffness = 1e9, damping = 2e5 }

local function hinge(m, name, x)
  m:bearing { name = name, between = { "ground", "block" }, at = { x, 0 }, along = stiff, axial = stiff }
end
local function ground(m)
  m:block { name = "ground", width = 2, height = 0.2, at = { -0.6, -0.2 }, material = "stone", support = "fixed" }
end

-- Two supports 0.6 m apart and a force between them: M = P L / 4.
local function simple_beam()
  local span = 0.6
  local m = block { build = ground }
  hinge(m, "left", 0.1)
  hinge(m, "right", 0.7)
  return load_at_crack(m, 4*tension*modulus/span, { { at = { 0.4, height }, force = { 0, -1 } } })
end

-- On an elastic joint over its whole length, the pressure is uniform: M = P L / 8. Joints lumped at the corners would
-- give twice this moment.
local function on_a_joint()
  local m = block { build = ground, joint = trilith.frictional { kn = 2e10, ks = 1e10, mu = 0.6, beta = 2e-5 } }
  local limit = 8*tension*modulus/length
  return load_at_crack(m, limit, { { at = { 0.4, height }, force = { 0, -1 } } })
end

-- Bonded by its left face: M = P a at the plane, and the plane nearest to the root cracks.
local function cantilever()
  local m = block { cracks = "quarter", joint = trilith.bonded { kn = 1e11, ks = 5e10, mu = 0.6, tension = 1e9,
    cohesion = 1e9, beta = 1e-5 }, build = function(model)
    model:block { name = "ground", width = 0.4, height = 1, at = { -0.4, -0.4 }, material = "stone", support = "fixed" }
  end }
  return load_at_crack(m, tension*modulus/(0.75*length), { { at = { length, height/2 }, force = { 0, -1 } } })
end

-- A couple of forces on both sides of the plane, balanced by moments, so that the plane carries shear alone.
local function shear(p)
  local m, e = block { build = ground, softens = p.softens }, 0.1
  return load_at_crack(m, cohesion*height*depth, {
    { at = { 0.4 - e, height/2 }, force = { 0, 1 }, moment = e }, { at = { 0.4 + e, height/2 }, force = { 0, -1 },
      moment = e } })
end

local function compressed()
  local m = block { build = ground, softens = true }
  return load_at_crack(m, compression*height*depth,
    { { at = { 0, height/2 }, force = { 1, 0 } }, { at = { length, height/2 }, force = { -1, 0 } } })
end

local function case(name, title, run, mode, plane, parameters)
  return { name = name, title = title, parameters = parameters, run = run, checks = {
    { "load at the crack", unit = "of the limit", exact = 1, within = 0.005 }, { "mode", exact = mode },
    { "plane", exact = plane, within = 0 } } }
end

return {
  title = "Section forces of a block, and where it cracks",
  source = "Statics of one part of the block; linear stress over the section",
  formula = [[\sigma = \frac{N}{A} + \frac{6 M}{A h}, \qquad M = \frac{P L}{4}, \quad \frac{P L}{8}, \quad P a]],
  text = "A block of 0.8 m by 0.2 m by 0.2 m has planes of tensile strength 0.3 MPa, cohesion 0.5 MPa and, where it " ..
    "crushes, compressive strength 4 MPa. The load grows through the limit. On the elastic joint the stress of the " ..
    "contact is integrated up to the plane.",
  cases = {
    case("cracking_beam", "beam on two supports, force in the middle", simple_beam, "tension", 1),
    case("cracking_on_a_joint", "block on an elastic joint, force in the middle", on_a_joint, "tension", 1),
    case("cracking_cantilever", "block bonded by its left face, force at its end", cantilever, "tension", 1),
    case("cracking_in_shear", "plane in pure shear, brittle", shear, "shear", 1),
    case("cracking_in_shear_softening", "plane in pure shear, with fracture energy", shear, "shear", 1,
      { { "softens", 1 } }),
    case("cracking_in_compression", "plane in pure compression", compressed, "compression", 1),
  },
}
