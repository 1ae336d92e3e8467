// Meshes of triangles and quadrilaterals in the plane: the check that makes a user's one fit for use, and grids.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// Nodes [m] and elements: three or four indices of nodes each; a triangle's last one is -1.
struct Mesh {
  std::vector<Vec2> node;
  std::vector<std::array<int, 4>> element;
};

/// 3 or 4.
constexpr int corners_of(const std::array<int, 4>& element) {
  return element[3] < 0 ? 3 : 4;
}
/// Where the corners of element `e` are.
std::vector<Vec2> corners_of(const Mesh& mesh, std::size_t e);

/// A mesh fit for use: elements counter-clockwise, nodes of the outer boundary first and in order around it.
struct CheckedMesh {
  Mesh mesh;
  int outline = 0;  ///< nodes of the outer boundary
  /// [element] bit i: the edge from its corner i to the next is boundary.
  std::vector<unsigned> boundary_edges;
  std::vector<std::string> notes;
};

/// Repaired, with a note: clockwise elements are turned round, unused nodes left out. Refused with InputError that
/// names element or node (counted from 1): no element, an index that is not there, a node twice in an element, numbers
/// that are not finite, an element without area or with a corner of 178 degrees and more, an edge of more than two
/// elements, elements that lap over each other at an edge, parts that hang together by no edge. `owner` begins every
/// message.
CheckedMesh check_mesh(Mesh mesh, std::string_view owner);

/// nx by ny quadrilaterals in the one with these four corners: nx along the side from corner 0 to 1. Nodes row by row.
Mesh grid_mesh(const std::array<Vec2, 4>& corners, int nx, int ny);

}  // namespace trilith
