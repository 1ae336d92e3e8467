// Detects whether a surface intersects itself.
#pragma once

#include <optional>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// Two faces of a surface that intersect, or a face whose loop crosses itself.
struct FaceCrossing {
  int a, b;  ///< faces; equal where a loop crosses itself
  Vec3 at;   ///< [m]
};

/// The first crossing found. Pairs of faces that share a corner are skipped, and so are coplanar faces that overlap. An
/// edge that passes less than `within` [m] through a plane does not count; an edge that passes through the rim of the
/// other face does. Time is proportional to the pairs of faces with overlapping boxes and the corners of both. Where
/// that exceeds a second or two, the search ends without a result.
std::optional<FaceCrossing> crossing_faces(const Polyhedron& surface, double within);

}  // namespace trilith
