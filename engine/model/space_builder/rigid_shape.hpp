// A rigid body from a mesh: its pieces, and the mass properties of elements whose edges are curved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "element/solid/space_mesh.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// Pieces are convex solids between nodes. An element of straight edges is one piece between its corners; a tetrahedron
/// of ten nodes with curved edges is eight pieces between its ten nodes.
struct RigidShape {
  std::vector<Polyhedron> pieces;
  std::optional<SolidMoments> moments;  ///< of the curved elements; empty where no edge is curved
  int curved = 0;                       ///< elements with a curved edge
  double pieces_volume = 0;             ///< [m3]
  double deviation = 0;                 ///< farthest a curved edge lies from the two straight ones beside it, about [m]
};

RigidShape rigid_shape(const SpaceMesh& mesh);

/// Volume, centroid and inertia of an element of ten nodes, by a rule that is exact for its curved edges.
SolidMoments curved_moments(const std::vector<Vec3>& nodes);

/// A line that says how the contact shape differs from the curved one; empty where no edge is curved.
std::string curved_note(const RigidShape& shape, const std::string& owner);

}  // namespace trilith
