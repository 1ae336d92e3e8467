// Meshes of bricks, wedges and tetrahedra: the check that makes a user's one fit for use, and grids.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "element/solid/space_element.hpp"
#include "geometry/plane/mesh.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith {

struct SpaceCell {
  ElementShape shape = ElementShape::brick;
  std::array<int, max_space_nodes>
      node{};  ///< as many as the shape has, in the order of element/solid/space_element.hpp
};

/// Nodes [m] and elements.
struct SpaceMesh {
  std::vector<Vec3> node;
  std::vector<SpaceCell> cell;
};

/// A mesh fit for use, and which faces of its elements are its skin.
struct CheckedSpaceMesh {
  SpaceMesh mesh;
  std::vector<std::array<std::uint8_t, 6>> surface;  ///< [cell][face] 1: on the skin
  std::vector<std::string> notes;
};

/// Where the nodes of an element are.
std::vector<Vec3> nodes_of(const SpaceMesh& mesh, std::size_t cell);

/// Repaired, with a note: elements that are turned round throughout, unused nodes left out. Refused with InputError
/// that names element or node (counted from 1): no element, an index that is not there, a node twice in an element,
/// numbers that are not finite, an element that is flat or turned inside out somewhere, two nodes in one place, a face
/// of more than two elements or of two on one side of it, neighbours that have other nodes on their common face, parts
/// that hang together by no face. `owner` begins every message.
CheckedSpaceMesh check_space_mesh(SpaceMesh mesh, std::string_view owner);

/// The corners of a solid that is a brick in topology (six faces of four corners), in the order of a brick's nodes;
/// throws InputError, begun with `owner`, for any other. A solid with corners in that order keeps it.
std::array<Vec3, 8> brick_corners(const Polyhedron& solid, std::string_view owner);

/// Bricks between eight corners, `divisions` along the sides from corner 0 to 1, 3 and 4.
SpaceMesh brick_grid(const std::array<Vec3, 8>& corners, const std::array<int, 3>& divisions);

/// Each brick parted into six tetrahedra about its diagonal from node 0 to 6, so that those of a grid fit together.
SpaceMesh tetrahedra_of(const SpaceMesh& bricks);

/// Each brick parted into two wedges by the plane through its nodes 0, 2, 4 and 6.
SpaceMesh wedges_of(const SpaceMesh& bricks);

/// Bricks as they are, or parted into elements of that shape.
SpaceMesh divided_into(ElementShape shape, const SpaceMesh& bricks);

/// What a mesh of the plane sweeps over from `low` to `high` [m]: bricks of quadrilaterals, wedges of triangles, one
/// through the depth. `right` and `up` are the plane's axes; high - low points to where its elements turn
/// counter-clockwise about.
SpaceMesh extruded(const Mesh& flat, const Vec3& right, const Vec3& up, const Vec3& low, const Vec3& high);

/// Nodes in the middle of the edges of tetrahedra of four nodes.
SpaceMesh quadratic_of(const SpaceMesh& tetrahedra);

}  // namespace trilith
