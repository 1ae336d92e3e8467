-- Spheres and clumps of spheres: weight, fall, and messages for impossible ones.
local trilith = require "trilith"

local function model()
  local m = trilith.model { dim = 3 }
  m:material { name = "stone", density = 2500 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e8, ks = 5e7, mu = 0.5, beta = 2e-4 } }
  m:block { name = "ground", size = { 8, 8, 1 }, at = { -4, -4, -1 }, support = "fixed", material = "stone" }
  return m
end

local function near(value, expected, share)
  assert(math.abs(value - expected) <= share * math.abs(expected), ("%g is not %g"):format(value, expected))
end

local function ball(r) return 4/3*math.pi*r^3 end

-- A sphere, and two overlapping ones, whose common volume counts once.
do
  local m = model()
  near(m:sphere { name = "one", radius = 0.1, at = { 0, 0, 1 }, material = "stone", floating = true }.mass,
    2500*ball(0.1), 1e-12)
  local pair = m:clump { name = "pair",
    spheres = { { at = { 0, 0, 0 }, radius = 0.1 }, { at = { 0.1, 0, 0 }, radius = 0.1 } },
    at = { 1, 0, 1 }, turn = { axis = { 0, 1, 1 }, angle = 0.7 }, material = "stone", floating = true }
  near(pair.mass, 2500*(2*ball(0.1) - math.pi*(4*0.1 + 0.1)*(2*0.1 - 0.1)^2/12), 1e-8)
  near(m:sphere { name = "given", radius = 0.1, at = { 2, 0, 1 }, mass = 7, floating = true }.mass, 7, 1e-12)
end

-- A ball falls, bounces and comes to rest on the ground; the clump next to it too.
do
  local m = model()
  local ball_of = m:sphere { name = "ball", radius = 0.1, at = { 0, 0, 0.3 }, material = "stone", floating = true }
  local clump = m:clump { name = "clump",
    spheres = { { at = { 0, 0, 0 }, radius = 0.1 }, { at = { 0.12, 0, 0 }, radius = 0.08 } },
    at = { 1, 0, 0.2 }, material = "stone", floating = true }
  m:run { duration = 0.19 }
  near(ball_of.z, 0.3 - 0.5*9.80665*0.19^2, 1e-3)
  m:consolidate { rest = { ratio = 1e-4 } }
  near(0.1 - ball_of.z, math.sqrt(ball_of.mass*9.80665/(1e8*math.pi*0.1)), 0.02) -- carried by kn pi R e^2
  assert(clump.z < 0.101 and clump.speed < 0.05)
end

-- Grains in a box settle and stay in it; the same seed gives the same grains.
do
  local function heap()
    local m = model()
    local sides = { { -0.3, -0.3, 0.1, 0.6 }, { 0.2, -0.3, 0.1, 0.6 }, { -0.2, -0.4, 0.4, 0.1 },
      { -0.2, 0.3, 0.4, 0.1 } }
    for k, side in ipairs(sides) do
      m:block { name = "side " .. k, size = { side[3], side[4], 0.4 }, at = { side[1], side[2], 0 }, support = "fixed",
        material = "stone" }
    end
    local grains = m:pour { name = "grains", low = { -0.2, -0.3, 0.02 }, high = { 0.2, 0.3, 0.6 }, count = 60,
      radius = { 0.03, 0.045 }, grading = "mass", share = 0.5, seed = 4, material = "stone",
      clump = { { at = { 0, 0, 0 }, radius = 1 }, { at = { 1, 0, 0 }, radius = 0.8 } } }
    return m, grains
  end
  local m, grains = heap()
  assert(#grains == 60 and #m:bodies { group = "clumps" } > 15 and #m:bodies { group = "clumps" } < 45)
  local _, again = heap()
  assert(grains.mass == again.mass)
  m:run { duration = 0.5 }
  -- The centre of a ball is at the height of its radius. A clump of two balls, R and 0.8 R, that lies on both has its
  -- centre of mass at 0.94 R; its volume is 5.583 R^3. An impact at 3 m/s compresses a ball by a quarter of its radius.
  local clumps = {}
  for _, g in ipairs(m:bodies { group = "clumps" }) do clumps[g.name] = true end
  for _, g in ipairs(grains) do
    local volume = g.mass/2500
    local least = clumps[g.name] and 0.94*(volume/5.583)^(1/3) or (volume*3/(4*math.pi))^(1/3)
    assert(math.abs(g.x) < 0.2 and math.abs(g.y) < 0.3 and g.z < 0.5, g.name)
    assert(g.z > 0.75*least, ("%s is %g m high, at least %g"):format(g.name, g.z, least))
  end
end

-- Impossible input gives the reason and a remedy.
local function refused(make, text)
  local ok, message = pcall(make, model())
  assert(not ok and tostring(message):find(text, 1, true), tostring(message))
end
refused(function(m) m:sphere { name = "a", radius = 0 } end, "'a': radius is 0 m, must be above 0; try 0.05")
refused(function(m) m:sphere { name = "a" } end, "sphere 'a': 'radius' is missing")
refused(function(m) m:sphere { name = "a", raduis = 1 } end, "radius")
refused(function(m) m:clump { name = "c" } end, "clump 'c': 'spheres' is missing")
refused(function(m)
  m:clump { name = "c", spheres = { { at = { 0, 0, 0 }, radius = 1 }, { at = { 3, 0, 0 }, radius = 1 } } }
end, "sphere 1 is 1 m away from all others")
refused(function(m)
  m:clump { name = "c", spheres = { { at = { 0, 0, 0 }, radius = 1 }, { at = { 0.1, 0, 0 }, radius = 0.5 } } }
end, "sphere 2 lies within sphere 1; leave it out or move it")
refused(function(m)
  m:pour { low = { 0, 0, 0 }, high = { 1, 1, 1 }, count = 2000, radius = 0.1, material = "stone" }
end, "its box has room for 64 grains of up to 0.2 m, but count asks for 2000")
refused(function(m) m:pour { low = { 0, 0, 0 }, high = { 1, 1, 1 }, radius = { 0.2, 0.1 }, material = "stone" } end,
  "radius is from 0.2 to 0.1 m")
refused(function(m) m:pour { low = { 0, 0, 0 }, high = { 1, 0.1, 1 }, radius = 0.1, material = "stone" } end,
  "its box is 0.1 m wide in y")
refused(function(m)
  m:sphere { name = "a", radius = 0.1, at = { 0, 0, 0.05 }, material = "stone" }
  m:run { duration = 0.1 }
end, "bodies 'ground' and 'a' overlap by 0.05 m at the start")
refused(function(m)
  m:sphere { name = "a", radius = 0.1, at = { 0, 0, 1 }, material = "stone" }
  m:run { duration = 0.1 }
end, "body 'a' has no support")
