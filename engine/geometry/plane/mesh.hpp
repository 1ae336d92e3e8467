// Plane meshes of triangles and quadrilaterals: the check and repair of a user's mesh, and grids.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// Nodes [m] and elements: three or four node indices each; the last one of a triangle is -1.
struct Mesh {
  std::vector<Vec2> node;
  std::vector<std::array<int, 4>> element;
};

/// 3 or 4.
constexpr int corners_of(const std::array<int, 4>& element) {
  return element[3] < 0 ? 3 : 4;
}
/// Positions of the corners of element `e` [m].
std::vector<Vec2> corners_of(const Mesh& mesh, std::size_t e);

/// A checked mesh: elements counter-clockwise, nodes of the outer boundary first and in order around it.
struct CheckedMesh {
  Mesh mesh;
  int outline = 0;  ///< number of nodes of the outer boundary
  /// [element] bit i: the edge from corner i to the next is boundary.
  std::vector<unsigned> boundary_edges;
  std::vector<std::string> notes;
};

/// Checks and repairs a mesh. Repaired, with a note: clockwise elements are reversed, unused nodes are removed.
///
/// Throws InputError, which names the element or node (counted from 1), for: no element, an index out of range, a node
/// twice in an element, coordinates that are not finite. Further for an element without area or with a corner of 178
/// degrees or more, an edge of more than two elements, elements that overlap at an edge, and parts that share no edge.
/// `owner` begins every message.
CheckedMesh check_mesh(Mesh mesh, std::string_view owner);

/// nx by ny quadrilaterals inside the quadrilateral of four corners: nx along the side from corner 0 to 1. Nodes are
/// row-major.
Mesh grid_mesh(const std::array<Vec2, 4>& corners, int nx, int ny);

}  // namespace trilith
