// Whether a surface passes through itself.
#pragma once

#include <optional>

#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// Where two faces of a surface pass through each other, or where the loop of one face crosses itself.
struct FaceCrossing {
  int a, b;  ///< faces; the same where a loop crosses itself
  Vec3 at;   ///< m
};

/// The first crossing that is found. Faces that share a corner are not looked at together, nor are faces in one plane
/// that overlap. A side that reaches less than `within` [m] through a plane does not count, one that goes through the
/// rim of the other face does. Time goes with the pairs of faces whose boxes meet and the corners of both; where that
/// is more work than a second or two, the search ends and nothing is found.
std::optional<FaceCrossing> crossing_faces(const Polyhedron& surface, double within);

}  // namespace trilith
