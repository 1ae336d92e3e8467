-- DXF drawings: outlines by layer, in units of the file, as bodies of a model that stands.
local trilith = require "trilith"

local function near(a, b, share)
  assert(math.abs(a - b) <= (share or 1e-12)*math.max(1, math.abs(b)), ("%.15g is not %.15g"):format(a, b))
end
local function area(outline)
  local sum = 0
  for i, p in ipairs(outline) do
    local q = outline[i % #outline + 1]
    sum = sum + p[1]*q[2] - q[1]*p[2]
  end
  return math.abs(sum)/2
end
local function refused(text, options)
  local ok, message = pcall(trilith.dxf, options)
  assert(not ok, "this was not refused: " .. text)
  assert(tostring(message):find(text, 1, true), ("said '%s' instead of '%s'"):format(message, text))
end

-- Closed polylines keep their order; lines that meet follow. The file is in mm and has lines that end in CR LF.
local parts = trilith.dxf { file = "dxf/facade.dxf" }
local names = {}
for i, part in ipairs(parts) do names[i] = part.name end
local all = table.concat(names, " ")
assert(all == "GROUND.1 stone_wall.1 ARCH.1 AXES.1 stone_wall.2 LINTEL.1", all)
for i, expected in ipairs { 0.9, 0.4, math.pi/8, 0.1^2*math.pi, 0.4, 0.4 } do
  -- A semicircle of 8 chords: r^2/2 * 8 sin(pi/8).
  if parts[i].name == "ARCH.1" then expected = 0.5^2/2*8*math.sin(math.pi/8) end
  if parts[i].name == "AXES.1" then expected = 0.1^2/2*16*math.sin(math.pi/8) end -- a circle of 16 chords
  near(area(parts[i].outline), expected, 1e-4)
end
local arch = parts[3]
assert(#arch.outline == 9 and arch.groups[1] == "ARCH")
for _, p in ipairs(arch.outline) do near(math.sqrt((p[1] - 1)^2 + (p[2] - 0.6)^2), 0.5) end
local top = 0
for _, p in ipairs(arch.outline) do top = math.max(top, p[2]) end
near(top, 1.1) -- the bulge is on the left of its direction: upwards
assert(parts.open == 1 and parts.skipped == "1 INSERT" and parts.unit == 1e-3, parts.skipped)

local fine = trilith.dxf { file = "dxf/facade.dxf", layers = "ARCH", arc_segments = 64, origin = { 1, 0.6 } }
assert(#fine == 1)
near(area(fine[1].outline), math.pi/8, 1e-3)
near(trilith.dxf { file = "dxf/facade.dxf", layers = { "GROUND" }, unit = "cm" }[1].outline[2][1], 25)
-- Below the gap of 0.03 mm between two ends, the lines of the lintel remain open.
assert(trilith.dxf { file = "dxf/facade.dxf", tolerance = 1e-5 }.open == 2)
assert(#trilith.dxf { file = "dxf/no_unit.dxf", unit = "m" } == 1)

-- The drawing as a model in the plane, and the same in space.
local function build(dim)
  local m = trilith.model { name = "facade", dim = dim, thickness = dim == 2 and 0.5 or nil }
  m:material { name = "stone", density = 2000 }
  m:contact { between = { "*", "*" }, law = trilith.frictional { kn = 1e9, ks = 5e8, mu = 0.6, beta = 1e-4 } }
  return m
end
parts = trilith.dxf { file = "dxf/facade.dxf", layers = { "GROUND", "stone wall", "ARCH", "LINTEL" } }
local m = build(2)
m:add(parts, { material = "stone", fixed = "GROUND" })
assert(#m:bodies { group = "stone_wall" } == 2)
near(m:body "LINTEL.1".mass, 2000*0.4*0.5, 1e-4)
m:consolidate { duration = 5 }
assert(m:body "GROUND.1".uy == 0 and math.abs(m:body "ARCH.1".uy) < 1e-3)
m:close()

local space = build(3)
for _, part in ipairs(trilith.dxf { file = "dxf/facade.dxf", layers = { "GROUND", "stone wall" } }) do
  space:extrusion { name = part.name, outline = part.outline, groups = part.groups, depth = 0.5, material = "stone",
    support = part.groups[1] == "GROUND" and "fixed" or nil }
end
near(space:body "stone_wall.2".mass, 2000*0.4*0.5, 1e-9)
space:close()

refused("'file' is missing", {})
refused("cannot read 'dxf/nowhere.dxf'", { file = "dxf/nowhere.dxf" })
refused("names no unit of length; give unit", { file = "dxf/no_unit.dxf" })
refused("has no closed outline; draw each stone as a closed polyline", { file = "dxf/open.dxf" })
refused("line 5: 'no code' is not a group code", { file = "dxf/damaged.dxf" })
refused("ends within a group", { file = "dxf/cut.dxf" })
refused("is a binary DXF file; save it as ASCII DXF", { file = "dxf/binary.dxf" })
refused("group 10 has the value '1,5', must be a number", { file = "dxf/number.dxf" })
refused("there is no layer 'GRUND' with lines; did you mean 'GROUND'?", { file = "dxf/facade.dxf", layers = "GRUND" })
refused("there is no 'inch' for the key 'unit'", { file = "dxf/facade.dxf", unit = "inch" })
refused("unknown key 'layer'; did you mean 'layers'?", { file = "dxf/facade.dxf", layer = "A" })
