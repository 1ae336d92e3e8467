// A convex piece as the contact kernels want it: straight corners taken out, and how flat its faces' ends are.
#pragma once

#include <vector>

#include "geometry/plane/convex_parts.hpp"
#include "geometry/plane/polygon.hpp"

namespace trilith {

struct PieceEdges {
  std::vector<int> corner;            ///< indices into the outline, counter-clockwise
  std::vector<std::uint8_t> is_face;  ///< edge from this corner to the next is surface
  std::vector<double> flatness;       ///< of that edge, at least 1: the largest cot of the turning angle at its ends to
                                      ///< a next surface face (see FaceOverlap::is_flat)
};

/// Corners between two surface edges in one line are dropped: they part no face for contact.
PieceEdges piece_edges(const Polygon& outline, const ConvexPiece& piece);

}  // namespace trilith
