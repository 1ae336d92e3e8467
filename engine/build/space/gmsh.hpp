// Reader of meshes in the format of Gmsh, version 4.1, written as text.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "element/solid/space_mesh.hpp"
#include "geometry/plane/mesh.hpp"

namespace trilith {

/// The triangles (type 2) and quadrilaterals (type 3) of a mesh in the plane, whatever surfaces they belong to; points
/// and lines are passed over. Nodes that belong to none of them are left out. Throws InputError with the line and what
/// is wrong there: another version or a binary file, elements of higher order or of three dimensions, nodes out of one
/// plane z = constant, counts, tags or numbers that do not fit. `owner` begins every message.
Mesh parse_gmsh(std::string_view text, std::string_view owner);

/// Reads a file. Throws InputError where it cannot be read, and as parse_gmsh.
Mesh read_gmsh(const std::filesystem::path& path);

/// The hexahedra (type 5) and tetrahedra of four (4) or ten nodes (11) of a mesh in space, whatever volumes they belong
/// to; points, lines and surfaces are passed over. Throws as the other, and where there is no volume in it.
SpaceMesh parse_gmsh_in_space(std::string_view text, std::string_view owner);
SpaceMesh read_gmsh_in_space(const std::filesystem::path& path);

}  // namespace trilith
