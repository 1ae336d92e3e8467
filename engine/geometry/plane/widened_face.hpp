// A face of a mesh, widened over the coplanar surface next to it.
//
//        _______ _____________
//       |       |             .
//       |  face |  next face  .
//       |_______|_____________.
//
// Each edge across which the surface continues in the face's plane (ConvexSolid::goes_on) is moved outward by that
// length. Where two such edges meet, the corner region between them counts as part of the surface.
#pragma once

#include "geometry/space/facing_faces.hpp"

namespace trilith {

/// Face `face` of a solid, widened by its neighbours. Its corners are in `room`, which must outlive it. Returns the
/// face itself where nothing continues it, or where the moved edges would not bound a convex face. At most
/// max_face_corners.
PlacedFace widened_face(const PlacedSolid& solid, int face, FaceRoom& room);

/// True if face `other_face` of `other` lies entirely beyond one edge of `face` across which the surface continues,
/// seen along the normal of `face`. It can then touch only the next face.
bool lies_beyond(const PlacedSolid& other, int other_face, const PlacedSolid& solid, int face);

}  // namespace trilith
