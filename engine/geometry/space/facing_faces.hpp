// Finds the opposed faces of two convex solids, and converts one face of a solid for the overlap of faces.
#pragma once

#include "geometry/space/convex_solid.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {

/// A face of each of two solids.
struct FacingFaces {
  int a, b;
  double opposed;  ///< -na . nb: 1 where the faces are parallel and oppose each other
};

/// The face of `a` whose normal is nearest to the axis, and the face of `b` whose normal is nearest to the reversed
/// axis; of equal ones the first. The axis is a unit vector from `a` towards `b`, as in Separation3.
FacingFaces facing_faces(const PlacedSolid& a, const PlacedSolid& b, const Vec3& axis);

/// Buffer for the corners of one face.
using FaceRoom = std::array<Vec3, max_face_corners>;

/// Face `face` of a solid, at most max_face_corners corners. They are stored in `room`, which must outlive the result.
PlacedFace face_of(const PlacedSolid& solid, int face, FaceRoom& room);

}  // namespace trilith
