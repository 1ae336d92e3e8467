-- Wrong input in space: each case is one line of script and the expected one-line message with its line number.
local trilith = require "trilith"
local given = dofile "wrong_input.lua"

local function new()
  local m = trilith.model { name = "wrong", dim = 3 }
  m:material { name = "stone", density = 2000, E = 1e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4 } }
  m:block { name = "ground", size = { 8, 8, 1 }, at = { -4, -4, -1 }, material = "stone", support = "fixed" }
  return m
end
--- Corners of a box of 1 m, starting at x.
local function box(x)
  local corners = {}
  for i = 0, 7 do corners[i + 1] = { x + (i & 1), i >> 1 & 1, i >> 2 & 1 } end
  return corners
end
local function with_block()
  local m = new()
  m:block { name = "b", size = { 1, 1, 1 }, material = "stone" }
  return m
end
local function soft()
  local w = new()
  w:block { name = "b", size = { 1, 1, 1 }, material = "stone", body = { mesh = { 2, 2, 2 } } }
  return w
end
local function part(...) return { { name = "p", outline = { ... } } } end

local m, pulse = new(), trilith.motion { acceleration = { 0, 1, 0, -1, 0 }, dt = 0.1 }
local cases = {
  -- parts of the plane with a depth
  { function() m:add(part({ 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 }), { depth = 1, material = "stone" }) end,
    "add: part 'p': outline crosses or touches itself at (0.5, 0.5): the edge from point 1 (0, 0) to point 2 (1, 1) "
      .. "meets the edge from point 3 (1, 0) to point 4 (0, 1); give the points in order around the outline" },
  { function() m:add(part({ 0, 0 }, { 1, 0 }, { 2, 0 }), { depth = 1, material = "stone" }) end,
    "add: part 'p': outline has no area, all 3 points lie on one line from point 1 (0, 0)" },
  -- lists with keys of their own
  { function() new():block { name = "b", size = { 1, 1, 1 }, material = "stone", body = "brick",
      hold = { from = { 0, 0, 0 }, to = { 0, 1, 1 } } } end,
    "block 'b': 'hold' has the key 'from' in it, must be a list of tables: { { ... }, { ... } }" },
  { function() new():block { name = "b", size = { 1, 1, 1 }, material = "stone",
      body = { mesh = { 4, 1, 2, element = "tet4" } } } end,
    "block 'b': body: 'mesh' has the key 'element' in it, must be three whole numbers {nx, ny, nz}, divisions along "
      .. "the three sides" },
  { function() new():block { name = "b", size = { 1, 1, 1, depth = 3 }, material = "stone" } end,
    "block 'b': 'size' is {1, 1, 1, depth = ...}, must be {x, y, z}, three finite numbers" },
  { function() new():block { name = "b", size = { 1, 1, 1 }, material = "stone",
      body = { mesh = { 2.5, 2, 1 } } } end,
    "block 'b': body: 'mesh' is {2.5, 2, 1}, must be three whole numbers {nx, ny, nz}, divisions along the three "
      .. "sides" },
  -- pieces
  { function() m:body { name = "b", pieces = { { hull = box(0) }, { hull = box(0.5) } }, material = "stone" } end,
    "body 'b': its pieces 1 and 2 overlap by 0.5 m (0.29 of the smaller one's size, at most 1e-06 is allowed), so "
      .. "their common part would count twice. Move one of them, or make them separate bodies" },
  { function() m:body { name = "b", pieces = { { hull = box(0) }, { hull = { { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 },
      { 2, 1, 0 } } } }, material = "stone" } end,
    "hull 'b, piece 2': all its points lie in one plane; give points on both sides of it" },
  { function() m:body { name = "b", pieces = 3, material = "stone" } end,
    "body 'b': 'pieces' is 3, must be a list { { hull = { {x, y, z}, ... } }, ... }" },
  -- numbers
  { function() m:block { name = "b", size = { 1, 0 / 0, 1 }, material = "stone" } end,
    "block 'b': 'size' is {1, nan, 1}, must be {x, y, z}, three finite numbers" },
  { function() m:block { name = "b", size = { 1, -1, 1 }, material = "stone" } end,
    "block 'b': size along y is -1 m, must be finite and above 0" },
  { function() m:block { name = "b", size = { 1e-99, 1e-99, 1e-99 }, material = "stone" } end,
    "body 'b': is 1.73e-99 m large, must be at least 1e-09 m; check its unit" },
  { function() m:hull { name = "b", points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1e13 } } } end,
    "hull 'b': point 4 is (0, 0, 1e+13) m, must be finite and within 1e12 m" },
  { function() m:sphere { name = "b", radius = 1e300, material = "stone" } end,
    "sphere 'b': radius is 1e+300 m, must be from 1e-09 to 1e12 m; try 0.05" },
  { function() m:vault { name = "v", stone_length = 0.5, radius = 1, thickness = 3, material = "stone" } end,
    "vault 'v': arch: thickness is 3 m, must be below twice the mid radius of 1 m" },
  -- exceeds the memory: nothing is built
  { function() m:wall { name = "w", length = 1e9, courses = 3, material = "stone" } end,
    "wall 'w': would have about 1.5e+10 parts, at most 200000 are allowed; check its sizes and their units, or build "
      .. "it in sections" },
  { function() m:building { name = "h", walls = { { from = { 0, 0 }, to = { 1e6, 0 } } }, courses = 3 } end,
    "building 'h': would have about 1.5e+07 parts, at most 200000 are allowed; check its sizes and their units, or "
      .. "build it in sections" },
  { function() m:cross_vault { name = "v", stone_length = 1e-6, material = "stone" } end,
    "cross vault 'v': would have about 6.45e+07 parts, at most 200000 are allowed; check its sizes and their units, "
      .. "or build it in sections" },
  { function() m:vault { name = "v", stone_length = 1, stones = 10000, voussoirs = 10000, material = "stone" } end,
    "vault 'v': would have about 1e+08 parts, at most 200000 are allowed; check its sizes and their units, or build "
      .. "it in sections" },
  { function() m:dome { name = "d", rings = 1000, sectors = 1000, material = "stone" } end,
    "dome 'd': would have about 1e+06 parts, at most 200000 are allowed; check its sizes and their units, or build "
      .. "it in sections" },
  { function() m:block { name = "b", size = { 1, 1, 1 }, material = "stone", body = { mesh = { 100, 100, 100 } } } end,
    "body 'b': its mesh of 100 x 100 x 100 would have 1e+06 elements, at most 200000 are made; divide its sides less" },
  { function() m:block { name = "b", size = { 1, 1, 1 }, weight = -3 } end,
    "block 'b': 'weight' is -3 N, must be above 0" },
  { function() m:building { name = "h", walls = { { from = { 0, 0 }, to = { 2, 0 } } }, courses = 3,
      storey_height = 1, material = "stone" } end,
    "building 'h': storey 1: 3 courses are given, but its height of 1 m holds 5; keep one of the two" },
  { function() m:calibrate { frequency = 10, vary = "frictional 1.kx" } end,
    "calibrate: there is no stiffness 'frictional 1.kx'; it may vary frictional 1.kn, frictional 1.ks" },
  -- input without effect
  { function() m:block { name = "b", size = { 1, 1, 1 }, material = "stone", body = "brick",
      hold = { { from = { 7, 7, 7 }, to = { 8, 8, 8 } } } } end,
    "body 'b': hold 1 holds no node: its box reaches from (7, 7, 7) to (8, 8, 8) m, the body's nodes from (0, 0, 0) to "
      .. "(1, 1, 1) m" },
  { function() with_block():point_load { name = "p", body = "b", force = { 1, 0, 0 }, at = { 100, 0.5, 0.5 } } end,
    "load 'p' on 'b': its point (100, 0.5, 0.5) is 98.6 m away from body 'b', which is 1.73 m large; give a point in "
      .. "it or near it, in m" },
  { function() with_block():point_load { body = "b", force = { 1, 0, 0 }, at = "top" } end,
    "point_load: 'at' is 'top', must be {x, y, z}, \"centroid\" or the name of a joint of 'b'" },
  { function() soft():point_load { name = "p", body = "b", moment = { 1, 0, 0 } } end,
    "load 'p' on 'b': the body deforms; give 'at', the point where the moment acts" },
  { function() soft():fix("b", "r") end,
    "fix: body 'b' is made of elements, whose nodes have no rotation to hold; fix x, y and z, or hold some of its nodes"
  },
  { function() m:shake { motions = { { body = "ground", x = pulse }, { body = "ground", x = pulse } } } end,
    "shake: body 'ground' is given two motions along x; keep one" },
}

given.check(cases)

-- A clockwise outline is reversed, in m:add too.
do
  local made = new():add(part({ 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 0 }), { depth = 0.5, material = "stone" })
  assert(made.mass == 1000)
end

-- A note that applies to many bodies is given for the first one.
do
  local w = trilith.model { name = "noted", dim = 3 }
  for i = 1, 3 do w:block { name = "b" .. i, size = { 400, 200, 190 + 10*i }, at = { 500*i, 0, 0 }, density = 2.4 } end
  local notes = w.notes
  assert(#notes == 2 and notes[1] == "body 'b1': density = 2.4 kg/m3 is below the usual 25 kg/m3: is it in t/m3 or "
    .. "g/cm3? 2.4 t/m3 are 2400 kg/m3", notes[1])
  assert(notes[2] == "body 'b1': least side = 200 m is above the usual 40 m: is it in mm? multiply it by "
    .. 'trilith.units "mm", or give a file scale = 0.001', notes[2])
end

-- Accepted input without effect gets a note: motion along a fixed direction, a load on it, a piece far from the others.
do
  local w = trilith.model { name = "idle", dim = 3 }
  w:material { name = "stone", density = 2000 }
  w:block { name = "b", size = { 1, 1, 1 }, material = "stone", support = "fixed", velocity = { 0, 1, 0 } }
  w:body { name = "two", pieces = { { hull = box(5) }, { hull = box(9) } }, material = "stone", floating = true }
  w:body { name = "near", pieces = { { hull = box(15) }, { hull = box(16) } }, material = "stone", floating = true }
  w:point_load { name = "p", body = "b", force = { 1, 0, 0 } }
  local notes = w.notes
  assert(#notes == 3, #notes)
  assert(notes[1] == "body 'b': it is given a velocity along y, but is held in that direction and does not move; "
    .. "free that direction or leave it out", notes[1])
  assert(notes[2] == "body 'two': its piece 1 of 1.73 m is 3 m away from all others, but moves rigidly with them; "
    .. "move it, or make it a separate body", notes[2])
  assert(notes[3] == "load 'p': body 'b' is held or driven in all directions, so the load has no effect before one "
    .. "of them is free", notes[3])
end
