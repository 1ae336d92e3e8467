-- Keys of square bars along x, in the plane and in space.
local bars = {}

-- The point at height y; in space also at depth y.
function bars.at(dim, x, y) return dim == 3 and { x, y, y } or { x, y } end

-- Adds the size to the keys of a block: length along x and side of the square section [m].
function bars.sized(dim, length, side, keys)
  if dim == 3 then keys.size = { length, side, side } else keys.width, keys.height = length, side end
  return keys
end

-- Support of a block that moves along x only.
function bars.guided(dim)
  if dim == 2 then return { y = "fixed", rotation = "fixed" } end
  return { y = "fixed", z = "fixed", rotation_x = "fixed", rotation_y = "fixed", rotation_z = "fixed" }
end

return bars
