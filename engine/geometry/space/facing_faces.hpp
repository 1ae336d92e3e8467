// Which faces of two convex solids look at each other, and one face of a solid as the overlap of faces takes it.
#pragma once

#include "geometry/space/convex_solid.hpp"
#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {

/// A face of each of two solids.
struct FacingFaces {
  int a, b;
  double opposed;  ///< -na . nb: 1 where they are parallel and look at each other
};

/// The face of `a` whose normal is nearest to the axis (of length 1, from `a` towards `b`, as of Separation3), and that
/// of `b` nearest to its reverse; of equal ones the first.
FacingFaces facing_faces(const PlacedSolid& a, const PlacedSolid& b, const Vec3& axis);

/// Room for the corners of one face.
using FaceRoom = std::array<Vec3, max_face_corners>;

/// Face `face` of a solid, its corners in `room`, which must outlive it. At most max_face_corners of them.
PlacedFace face_of(const PlacedSolid& solid, int face, FaceRoom& room);

}  // namespace trilith
