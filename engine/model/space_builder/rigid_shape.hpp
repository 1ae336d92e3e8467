// A rigid body from a mesh: its pieces, and the mass properties of elements with curved edges.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "element/solid/space_mesh.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// Pieces are convex solids between nodes. An element with straight edges is one piece between its corners; a ten-node
/// tetrahedron with curved edges is eight pieces between its ten nodes.
struct RigidShape {
  std::vector<Polyhedron> pieces;
  std::optional<SolidMoments> moments;  ///< of the curved elements; empty if no edge is curved
  int curved = 0;                       ///< number of elements with a curved edge
  double pieces_volume = 0;             ///< [m3]
  double deviation = 0;  ///< approximate largest distance of a curved edge from its two straight segments [m]
};

RigidShape rigid_shape(const SpaceMesh& mesh);

/// Volume, centroid and inertia of a ten-node element, by quadrature that is exact for its curved edges.
SolidMoments curved_moments(const std::vector<Vec3>& nodes);

/// A line on the difference between the contact shape and the curved one; empty if no edge is curved.
std::string curved_note(const RigidShape& shape, const std::string& owner);

}  // namespace trilith
