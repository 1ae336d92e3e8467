-- Solids and meshes in files of other programs, and joints with the names of places: read, or rejected with the remedy.
local trilith = require "trilith"
local name = os.tmpname()
os.remove(name)

local function write(ending, text)
  local file <close> = assert(io.open(name .. ending, "wb"))
  file:write(text)
  return name .. ending
end
local function model()
  local m = trilith.model { name = "files", dim = 3 }
  m:material { name = "stone", density = 1000 }
  return m
end
-- Bodies, their mass and the notes of a file of solids.
local function solids(ending, text, more)
  local file, m = write(ending, text), model()
  local call = { name = "n", file = file, material = "stone", floating = true }
  for key, value in pairs(more or {}) do call[key] = value end
  local good, made = pcall(m.solids, m, call)
  os.remove(file)
  if not good then return nil, made end
  local mass = 0
  for _, body in ipairs(made) do mass = mass + body.mass end
  return mass, table.concat(m.notes, "\n"), #made
end

-- A box of 1 m x 0.6 m x 0.4 m, 240 kg; `noise` moves its corners, differently at each call.
local box = { { -0.5, -0.3, 0 }, { 0.5, -0.3, 0 }, { 0.5, 0.3, 0 }, { -0.5, 0.3, 0 }, { -0.5, -0.3, 0.4 },
  { 0.5, -0.3, 0.4 },
  { 0.5, 0.3, 0.4 }, { -0.5, 0.3, 0.4 } }
local quads = { { 1, 4, 3, 2 }, { 5, 6, 7, 8 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 4, 8, 7 }, { 4, 1, 5, 8 } }
local triangles = {}
for _, q in ipairs(quads) do
  triangles[#triangles + 1] = { q[1], q[2], q[3] }
  triangles[#triangles + 1] = { q[1], q[3], q[4] }
end
local function stl(noise)
  local lines, k = { "solid part" }, 0
  for _, t in ipairs(triangles) do
    lines[#lines + 1] = "facet normal 0 0 0\nouter loop"
    for _, i in ipairs(t) do
      local p = {}
      for c = 1, 3 do
        k = k + 1
        p[c] = ("%.8f"):format(box[i][c] + (k*7 % 5 - 2)*(noise or 0)/2)
      end
      lines[#lines + 1] = "vertex " .. table.concat(p, " ")
    end
    lines[#lines + 1] = "endloop\nendfacet"
  end
  return table.concat(lines, "\n") .. "\nendsolid part\n"
end
local function binary(behind, count)
  local bytes = { (" "):rep(80), ("<I4"):pack(count or #triangles) }
  for _, t in ipairs(triangles) do
    bytes[#bytes + 1] = ("<fff"):pack(0, 0, 0)
    for _, i in ipairs(t) do bytes[#bytes + 1] = ("<fff"):pack(table.unpack(box[i])) end
    bytes[#bytes + 1] = "\0\0"
  end
  return table.concat(bytes) .. (behind or "")
end
local points, faces, continued = {}, {}, {}
for i, p in ipairs(box) do points[i] = "v " .. table.concat(p, " ") end
for i, q in ipairs(quads) do
  faces[i] = "f " .. table.concat(q, " ")
  continued[i] = ("f %d %d \\\r\n %d\\\r\n %d"):format(table.unpack(q))
end
points = table.concat(points, "\n") .. "\n"
local obj = points .. table.concat(faces, "\n") .. "\n"

local read = {
  { "text", ".stl", stl() },
  { "upper case", ".stl", stl():upper() },
  { "an empty first line", ".stl", "\r\n\n" .. stl() },
  { "a mark of the end", ".stl", stl() .. "\x1a" },
  { "zero bytes behind a text", ".stl", stl() .. ("\0"):rep(40) },
  { "binary", ".stl", binary() },
  { "binary, padded", ".stl", binary(("\0"):rep(12)), note = "12 bytes after its 12 triangles are ignored" },
  { "binary, padded by more than a triangle", ".stl", binary(("x"):rep(77)), note = "77 bytes after" },
  { "noise of single precision", ".stl", stl(2e-7), { weld = 1e-6 } },
  { "object", ".obj", "o block\n" .. obj },
  { "lines that go on", ".obj", points .. table.concat(continued, "\r\n") .. "\r\n" },
  { "a last line that goes on into nothing", ".obj", obj .. "\\" },
  { "a mark of the end of an object file", ".obj", obj .. "\x1a" },
}
for _, case in ipairs(read) do
  local mass, notes = solids(case[2], case[3], case[4])
  assert(mass, case[1] .. ": " .. tostring(notes))
  assert(math.abs(mass - 240) < 1e-3, ("%s: %.9g kg"):format(case[1], mass))
  if case.note then assert(notes:find(case.note, 1, true), case[1] .. ": " .. notes) end
end

local refused = {
  { ".stl", binary("", 13), "is cut short or not an STL file" },
  { ".stl", binary(("\0"):rep(12), 0), "not an STL file" },
  { ".stl", stl(2e-7), "weld = 5e-07 closes it" },
  { ".stl", stl(2e-5), "weld = 5e-05 closes it" },
  { ".stl", (stl():gsub("facet normal.-endfacet\n", "", 1)), "close it in the program that made it" },
  { ".obj", points .. "f 1 4 x\\\n 2", "a corner of a face is 'x'" },
}
for _, case in ipairs(refused) do
  local mass, message = solids(case[1], case[2])
  assert(not mass and message:find(case[3], 1, true), tostring(message))
end

-- Two boxes with one name, or without one: a note, and separate bodies if requested.
local second = obj:gsub("v (%S+)", function(x) return ("v %g"):format(x + 2) end)
  :gsub("f (%d+) (%d+) (%d+) (%d+)", function(...)
    local moved = { ... }
    for i = 1, 4 do moved[i] = math.tointeger(moved[i] + 8) end
    return "f " .. table.concat(moved, " ")
  end)
local _, notes, count = solids(".obj", "o Cube\n" .. obj .. "o Cube\n" .. second)
assert(count == 1 and notes:find("object 'Cube' appears again", 1, true), notes)
assert(notes:find("shells_are_bodies", 1, true), notes)
_, notes, count = solids(".obj", obj .. second)
assert(count == 1 and notes:find("shells_are_bodies", 1, true), notes)
for _, text in ipairs { "o Cube\n" .. obj .. "o Cube\n" .. second, obj .. second } do
  _, notes, count = solids(".obj", text, { shells_are_bodies = true })
  assert(count == 2, notes)
end

-- Meshes whose parts have separate nodes at the same position.
local function mesh_refusal(dim, nodes, elements)
  local m = trilith.model { name = "mesh", dim = dim }
  m:material { name = "stone", density = 1000, E = 1e8, nu = 0.2 }
  local good, message = pcall(m.body, m,
    { name = "n", material = "stone", floating = true, mesh = { nodes = nodes, elements = elements } })
  assert(not good, "taken")
  return message
end
local flat = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 } }
local parts = { { 1, 2, 3, 4 }, { 5, 6, 7, 8 } }
assert(mesh_refusal(2, flat, parts):find("nodes 2 and 5 are at the same place: merge such nodes", 1, true))
for i = 5, 8 do flat[i][1] = flat[i][1] + 1 end
assert(mesh_refusal(2, flat, parts):find("shares no edge with the others; make each part a body", 1, true))
local deep = {}
for x = 0, 1 do
  for _, p in ipairs { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 },
    { 0, 1, 1 } } do
    deep[#deep + 1] = { p[1] + x, p[2], p[3] }
  end
end
local message = mesh_refusal(3, deep, { { 1, 2, 3, 4, 5, 6, 7, 8 }, { 9, 10, 11, 12, 13, 14, 15, 16 } })
assert(message:find("at the same place, so the mesh is open there; merge them", 1, true), message)

-- A joint takes precedence over the place of the same name: a load on it acts as one at its coordinates.
local function sag(dim, at)
  local m = trilith.model { name = "top", gravity = 0, dim = dim }
  m:material { name = "steel", density = 7850, E = 2e11, nu = 0.3 }
  local s = trilith.rectangle_section { width = 0.1, depth = 0.1 }
  local function place(x, h) return dim == 3 and { x, 0, h } or { x, h } end
  m:frame { name = "f", material = "steel", floating = true,
    joints = { l = { at = place(0, 0), support = "fixed" }, [dim == 3 and "centroid" or "top"] = place(1, 1),
      bottom = place(1.5, 0.5), r = { at = place(2, 0), support = "fixed" } },
    members = { { from = "l", to = dim == 3 and "centroid" or "top", section = s },
      { from = dim == 3 and "centroid" or "top", to = "bottom", section = s },
        { from = "bottom", to = "r", section = s } } }
  m:point_load { name = "p", body = "f", at = at, force = place(0, -1e4) }
  m:consolidate { integrator = "static" }
  return (select(dim, m:body("f"):point(dim == 3 and "centroid" or "top")))
end
assert(sag(2, "top") == sag(2, { 1, 1 }) and sag(2, "top") < 1)
assert(sag(2, "bottom") == sag(2, { 1.5, 0.5 }) and sag(2, "bottom") ~= sag(2, "top"))
assert(sag(3, "centroid") == sag(3, { 1, 0, 1 }) and sag(3, "centroid") < 1)
