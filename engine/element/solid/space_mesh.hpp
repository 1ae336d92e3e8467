// Meshes of bricks, wedges and tetrahedra: the check and repair of a user's mesh, and grids.
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

/// A checked mesh, and the faces of its elements that form the skin.
struct CheckedSpaceMesh {
  SpaceMesh mesh;
  std::vector<std::array<std::uint8_t, 6>> surface;  ///< [cell][face] 1: on the skin
  std::vector<std::string> notes;
};

/// Positions of an element's nodes.
std::vector<Vec3> nodes_of(const SpaceMesh& mesh, std::size_t cell);

/// Checks and repairs a mesh. Repaired, with a note: inverted elements are reversed, unused nodes are removed.
///
/// Throws InputError, which names the element or node (counted from 1), for: no element, an index out of range, a node
/// twice in an element, coordinates that are not finite. Further for an element that is flat or partly inverted, and
/// for two nodes at one position. Also for a face of more than two elements or of two on one side, neighbours with
/// different nodes on their common face, and parts that share no face. `owner` begins every message.
CheckedSpaceMesh check_space_mesh(SpaceMesh mesh, std::string_view owner);

/// The corners of a solid with the topology of a brick (six faces of four corners), in the order of a brick's nodes.
/// Throws InputError, which begins with `owner`, for any other solid. A solid with corners in that order keeps it.
std::array<Vec3, 8> brick_corners(const Polyhedron& solid, std::string_view owner);

/// Bricks between eight corners; `divisions` along the sides from corner 0 to 1, 3 and 4.
SpaceMesh brick_grid(const std::array<Vec3, 8>& corners, const std::array<int, 3>& divisions);

/// Splits each brick into six tetrahedra about its diagonal from node 0 to 6, so that neighbouring bricks of a grid
/// match.
SpaceMesh tetrahedra_of(const SpaceMesh& bricks);

/// Splits each brick into two wedges by the plane through its nodes 0, 2, 4 and 6.
SpaceMesh wedges_of(const SpaceMesh& bricks);

/// Bricks unchanged, or split into elements of that shape.
SpaceMesh divided_into(ElementShape shape, const SpaceMesh& bricks);

/// Extrudes a plane mesh from `low` to `high` [m]: bricks from quadrilaterals, wedges from triangles, one through the
/// depth. `right` and `up` are the plane's axes; elements are counter-clockwise about high - low.
SpaceMesh extruded(const Mesh& flat, const Vec3& right, const Vec3& up, const Vec3& low, const Vec3& high);

/// Adds mid-edge nodes to tetrahedra with four nodes.
SpaceMesh quadratic_of(const SpaceMesh& tetrahedra);

}  // namespace trilith
