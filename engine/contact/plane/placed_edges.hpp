// The edges of a placed convex piece.
#pragma once

#include <algorithm>
#include <array>

#include "contact/plane/overlap_pair.hpp"

namespace trilith {

/// Unit outward normals of a piece's edges, and whether they count as surface.
struct PlacedEdges {
  int count = 0;
  std::array<Vec2, max_piece_corners> normal;
  std::array<double, max_piece_corners> length;
  std::array<bool, max_piece_corners> surface;

  explicit PlacedEdges(const PlacedPiece& piece) : count(static_cast<int>(piece.corner.size())) {
    bool any = false;
    for (int i = 0; i < count; ++i) {
      const Vec2 along = piece.corner[(i + 1) % count] - piece.corner[i];
      length[i] = along.norm();
      normal[i] = Vec2(along.y(), -along.x()) / length[i];
      surface[i] = piece.is_face[i] != 0;
      any = any || surface[i];
    }
    // A piece cut out of the interior of a body has no surface edge: then every edge counts.
    if (!any) std::fill_n(surface.begin(), count, true);
  }
};

}  // namespace trilith
