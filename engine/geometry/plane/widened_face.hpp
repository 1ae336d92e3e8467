// A face of a mesh as far as the surface of its body goes on in its plane.
//
//        _______ _____________
//       |       |             .      Each edge beyond which the surface goes on (ConvexSolid::goes_on) is moved outward
//       |  face |  next face  .      by that much; where two such edges meet, what lies between them is taken as there.
//       |_______|_____________.
#pragma once

#include "geometry/space/facing_faces.hpp"

namespace trilith {

/// Face `face` of a solid, wider by what its neighbours add; its corners in `room`, which must outlive it. The face
/// itself where nothing goes on, or where edges moved so would no longer bound a convex face. At most max_face_corners.
PlacedFace widened_face(const PlacedSolid& solid, int face, FaceRoom& room);

/// True where all of face `other_face` lies beyond one edge of face `face` across which the surface goes on, as seen
/// along the latter's normal: what it may touch there is the next face.
bool lies_beyond(const PlacedSolid& other, int other_face, const PlacedSolid& solid, int face);

}  // namespace trilith
