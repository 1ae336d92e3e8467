-- Arcs, circles and inserted blocks of DXF drawings.
local trilith = require "trilith"

local function drawing(blocks, entities)
  local text = "0\nSECTION\n2\nBLOCKS\n" .. blocks .. "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" .. entities
    .. "0\nENDSEC\n0\nEOF\n"
  local path = os.tmpname() .. ".dxf"
  local file = assert(io.open(path, "w"))
  file:write(text)
  file:close()
  return path
end
local function read(blocks, entities, options)
  local path = drawing(blocks, entities)
  options = options or {}
  options.file, options.unit = path, "m"
  local ok, parts = pcall(trilith.dxf, options)
  os.remove(path)
  return ok, parts
end
local function area(outline)
  local sum = 0
  for i, p in ipairs(outline) do
    local q = outline[i % #outline + 1]
    sum = sum + p[1]*q[2] - p[2]*q[1]
  end
  return math.abs(sum)/2
end
local function middle(outline)
  local x, y = 0, 0
  for _, p in ipairs(outline) do x, y = x + p[1]/#outline, y + p[2]/#outline end
  return x, y
end
local function near(a, b)
  assert(math.abs(a - b) < 1e-9*math.max(1, math.abs(b)), ("%.12g, expected %.12g"):format(a, b))
end

-- A circle of 4 n chords has the area 2 n r^2 sin(pi / 2n).
local ok, parts = read("", "0\nCIRCLE\n8\nround\n10\n2\n20\n3\n40\n0.5\n", { arc_segments = 8 })
assert(ok and #parts == 1 and parts[1].name == "round.1" and #parts[1].outline == 32, tostring(parts))
near(area(parts[1].outline), 16*0.25*trilith.math.sin(math.pi/16))
local x, y = middle(parts[1].outline)
near(x, 2) near(y, 3)

-- A half disc: an arc from 0 to 180 degrees, closed by a line. An arc that ends before it begins passes through 0.
ok, parts = read("", "0\nARC\n8\nd\n10\n1\n20\n0\n40\n1\n50\n0\n51\n180\n"
  .. "0\nLINE\n8\nd\n10\n0\n20\n0\n11\n2\n21\n0\n", { arc_segments = 6 })
assert(ok and #parts == 1 and #parts[1].outline == 13, tostring(parts))
near(area(parts[1].outline), 6*trilith.math.sin(math.pi/12))
ok, parts = read("", "0\nARC\n8\nd\n10\n0\n20\n0\n40\n1\n50\n270\n51\n90\n"
  .. "0\nLINE\n8\nd\n10\n0\n20\n1\n11\n0\n21\n-1\n")
assert(ok and middle(parts[1].outline) > 0.3, "the arc passes on the wrong side")

-- A block of a unit square with its base in the centre, inserted twice: scaled and turned, and as rows and columns.
local square = "0\nBLOCK\n8\n0\n2\nbrick\n10\n0.5\n20\n0.5\n"
  .. "0\nLWPOLYLINE\n8\n0\n70\n1\n10\n0\n20\n0\n10\n1\n20\n0\n10\n1\n20\n1\n10\n0\n20\n1\n0\nENDBLK\n"
ok, parts = read(square, "0\nINSERT\n8\nwall\n2\nbrick\n10\n4\n20\n5\n41\n2\n42\n3\n50\n90\n")
assert(ok and #parts == 1 and parts[1].groups[1] == "wall", tostring(parts))
near(area(parts[1].outline), 6)
x, y = middle(parts[1].outline)
near(x, 4) near(y, 5)
for _, p in ipairs(parts[1].outline) do near(math.abs(p[1] - 4), 1.5) near(math.abs(p[2] - 5), 1) end
ok, parts = read(square, "0\nINSERT\n8\nwall\n2\nbrick\n10\n0\n20\n0\n70\n3\n71\n2\n44\n1.5\n45\n2\n")
assert(ok and #parts == 6, tostring(parts))
x, y = middle(parts[6].outline)
near(x, 3) near(y, 2)

-- Blocks within blocks, a mirrored entity, and a layer of its own.
local nested = square .. "0\nBLOCK\n8\n0\n2\npair\n10\n0\n20\n0\n0\nINSERT\n8\n0\n2\nbrick\n10\n1\n20\n0\n"
  .. "0\nINSERT\n8\nother\n2\nbrick\n10\n3\n20\n0\n0\nENDBLK\n"
ok, parts = read(nested, "0\nINSERT\n8\nwall\n2\npair\n10\n10\n20\n1\n")
assert(ok and #parts == 2 and parts[1].groups[1] == "wall" and parts[2].groups[1] == "other", tostring(parts))
x, y = middle(parts[2].outline)
near(x, 13) near(y, 1)
ok, parts = read("", "0\nCIRCLE\n8\nm\n10\n2\n20\n3\n40\n1\n230\n-1\n")
assert(ok)
x = middle(parts[1].outline)
near(x, -2)

-- A block that contains itself is refused; an unknown block is counted as not read.
local loop = "0\nBLOCK\n2\na\n10\n0\n20\n0\n0\nINSERT\n2\na\n0\nENDBLK\n"
ok, parts = read(loop, "0\nINSERT\n8\n0\n2\na\n")
assert(not ok and tostring(parts):find("the block 'a' contains itself", 1, true), tostring(parts))
ok, parts = read(square, "0\nINSERT\n8\n0\n2\nnone\n10\n0\n20\n0\n0\nCIRCLE\n8\nm\n10\n2\n20\n3\n40\n1\n")
assert(ok and parts.skipped == "1 INSERT", tostring(ok and parts.skipped))
