// Reader of meshes in the Gmsh format, versions 4.1 and 2.2, ASCII.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "element/solid/space_mesh.hpp"
#include "geometry/plane/mesh.hpp"

namespace trilith {

/// Reads the triangles (types 2 and 9) and quadrilaterals (types 3, 10 and 16) of a mesh in the plane, of all surfaces;
/// points and lines are skipped. Elements of second order give their corners. Unused nodes are removed. Throws
/// InputError with the line and the error: another version or a binary file, inconsistent counts, tags or numbers. It
/// also throws for elements of second order with curved sides, of higher order or of three dimensions, and for nodes
/// outside one plane z = constant. `owner` begins every message.
Mesh parse_gmsh(std::string_view text, std::string_view owner);

/// Reads a file. Throws InputError if it cannot be read, and as parse_gmsh.
Mesh read_gmsh(const std::filesystem::path& path);

/// Reads the hexahedra (type 5) and tetrahedra with four (4) or ten nodes (11) of a mesh in space, of all volumes;
/// points, lines and surfaces are skipped. Throws as parse_gmsh, and if the mesh contains no volume.
SpaceMesh parse_gmsh_in_space(std::string_view text, std::string_view owner);
SpaceMesh read_gmsh_in_space(const std::filesystem::path& path);

}  // namespace trilith
