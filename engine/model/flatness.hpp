// Preparation of a convex piece for the contact kernels: removes straight corners, and computes the flatness of its
// faces' ends.
#pragma once

#include <vector>

#include "geometry/plane/convex_parts.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith {

struct PieceEdges {
  std::vector<int> corner;            ///< indices into the outline, counter-clockwise
  std::vector<std::uint8_t> is_face;  ///< edge from this corner to the next is surface
  std::vector<double> flatness;  ///< of that edge, at least 1: largest cotangent of the turning angle at its ends to a
                                 ///< next surface face (see FaceOverlap::is_flat)
};

/// Corners between two collinear surface edges are dropped, because they separate no faces for contact.
PieceEdges piece_edges(const Polygon& outline, const ConvexPiece& piece);

}  // namespace trilith
