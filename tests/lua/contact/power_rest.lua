-- A block under a power of the overlap rests at the depth where its pressure carries the weight, in the plane and in
-- space, and rebounds from a flat blow with its speed.
--
--     kn d (depth/d)^n = density g h
local trilith = require "trilith"
local near = dofile "near_expected.lua"

local g <const>, density <const>, height <const> = 9.81, 2000, 0.3
local kn <const>, reach <const> = 1e9, 1e-5

local function model_of(dim, exponent, lift, speed, weight, beta)
  local m = trilith.model { name = "power", dim = dim, gravity = weight }
  m:material { name = "stone", density = density }
  m:contact { between = { "*", "*" },
    law = trilith.power { kn = kn, ks = kn/2, mu = 0.5, depth = reach, exponent = exponent,
      beta = beta } }
  if dim == 3 then
    m:block { name = "floor", size = { 2, 2, 1 }, at = { -1, -1, -1 }, material = "stone", support = "fixed" }
    m:block { name = "a", size = { 0.5, 0.4, height }, at = { -0.2, -0.1, lift }, material = "stone",
              velocity = { 0, 0, -speed }, floating = lift > 0 or nil }
  else
    m:block { name = "floor", width = 2, height = 1, at = { -1, -1 }, material = "stone", support = "fixed" }
    m:block { name = "a", width = 0.5, height = height, at = { -0.2, lift }, material = "stone",
              velocity = { 0, -speed }, floating = lift > 0 or nil }
  end
  return m
end

for _, dim in ipairs { 2, 3 } do
  for _, exponent in ipairs { 1, 1.5, 1.8 } do
    local depth = reach*(density*g*height/(kn*reach))^(1/exponent)
    for _, integrator in ipairs { "explicit", "implicit", "static" } do
      local m = model_of(dim, exponent, 0, 0, g, 1e-3)
      if integrator == "explicit" then
        m:run { duration = 0.1 }
      elseif integrator == "implicit" then
        m:run { duration = 0.1, dt = 1e-3, integrator = "implicit" }
      else
        m:consolidate { integrator = "static" }
      end
      local a = m:body "a"
      near(("depth at rest, dim %d, exponent %g, %s"):format(dim, exponent, integrator),
        dim == 3 and -a.uz or -a.uy, depth, 1e-3)
      m:close()
    end
    local m = model_of(dim, exponent, 1e-5, 0.05, 0, 0)
    m:run { duration = 0.01, dt = 2e-6 }
    local a = m:body "a"
    near(("rebound, dim %d, exponent %g"):format(dim, exponent), dim == 3 and a.vz or a.vy, 0.05, 1e-3)
    m:close()
  end
end
