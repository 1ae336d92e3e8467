-- Wrong input in space: each case is one line of script and the one line of message it must give, at its own line.
local trilith = require "trilith"

local function new()
  local m = trilith.model { name = "wrong", dim = 3 }
  m:material { name = "stone", density = 2000, E = 1e9, nu = 0.2 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 4e8, mu = 0.6, beta = 1e-4 } }
  m:block { name = "ground", size = { 8, 8, 1 }, at = { -4, -4, -1 }, material = "stone", support = "fixed" }
  return m
end
--- Corners of a box of 1 m, from x on.
local function box(x)
  local corners = {}
  for i = 0, 7 do corners[i + 1] = { x + (i & 1), i >> 1 & 1, i >> 2 & 1 } end
  return corners
end
local function part(...) return { { name = "p", outline = { ... } } } end

local m = new()
local cases = {
  -- parts of the plane with a depth
  { function() m:add(part({ 0, 0 }, { 1, 1 }, { 1, 0 }, { 0, 1 }), { depth = 1, material = "stone" }) end,
    "add: part 'p': outline crosses or touches itself at (0.5, 0.5): the edge from point 1 (0, 0) to point 2 (1, 1) "
      .. "meets the edge from point 3 (1, 0) to point 4 (0, 1); give the points in order around the outline" },
  { function() m:add(part({ 0, 0 }, { 1, 0 }, { 2, 0 }), { depth = 1, material = "stone" }) end,
    "add: part 'p': outline has no area, all 3 points lie on one line from point 1 (0, 0)" },
  -- pieces
  { function() m:body { name = "b", pieces = { { hull = box(0) }, { hull = box(0.5) } }, material = "stone" } end,
    "body 'b': its pieces 1 and 2 overlap by 0.5 m (0.29 of the smaller one's size, at most 1e-06 is allowed), and "
      .. "what they share would count twice; move one of them, or make them bodies of their own" },
  { function() m:body { name = "b", pieces = { { hull = box(0) }, { hull = { { 1, 0, 0 }, { 2, 0, 0 }, { 1, 1, 0 },
      { 2, 1, 0 } } } }, material = "stone" } end,
    "hull 'b, piece 2': all its points lie in one plane; give points on both sides of it" },
  { function() m:body { name = "b", pieces = 3, material = "stone" } end,
    "body 'b': 'pieces' is 3, must be a list { { hull = { {x, y, z}, ... } }, ... }" },
}

local wrong = 0
for _, case in ipairs(cases) do
  local info = debug.getinfo(case[1], "S")
  local good, message = pcall(case[1])
  local expected = ("space_messages.lua:%d: %s"):format(info.linedefined, case[2])
  if good or message ~= expected then
    wrong = wrong + 1
    print(("line %d\n  expected: %s\n  was:      %s"):format(info.linedefined, expected, good and "no error" or message))
  end
end
assert(wrong == 0, wrong .. " messages are not as they should be")

-- An outline that runs clockwise is turned round, in m:add too.
do
  local made = new():add(part({ 0, 0 }, { 0, 1 }, { 1, 1 }, { 1, 0 }), { depth = 0.5, material = "stone" })
  assert(made.mass == 1000)
end
