// The two stages of the separating axis test, for callers that may stop after the first.
#pragma once

#include "geometry/space/separation_3d.hpp"

namespace trilith {

/// Largest distance over the face normals of both solids; a lower bound of the distance of separation().
Separation3 face_separation(const PlacedSolid& a, const PlacedSolid& b);

/// separation() of two solids whose face_separation() is `faces`, with the same bits.
Separation3 separation_beyond(const PlacedSolid& a, const PlacedSolid& b, const Separation3& faces);

}  // namespace trilith
