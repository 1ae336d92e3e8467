// Whether a face of one solid and a face of another may lie on each other.
#pragma once

#include <cmath>
#include <cstddef>

#include "contact/space/solid_faces.hpp"

namespace trilith {

/// Whether a face is surface, with no more corners than the overlap of faces supports.
inline bool fits_faces(const PlacedSolid& solid, int face) {
  return solid.solid->is_surface(face) && solid.solid->shape.faces[face].size() <= max_face_corners;
}

/// Distance of a corner of the smaller solid from the plane of the larger one's face [m], and from a corner of that
/// face [m].
struct PlaneDistance {
  double depth, corner;

  PlaneDistance(const PlacedSolid& a, int face_a, const PlacedSolid& b, int face_b) {
    const bool b_is_larger = a.solid->size < b.solid->size;
    const PlacedSolid &large = b_is_larger ? b : a, &small = b_is_larger ? a : b;
    const int face = b_is_larger ? face_b : face_a, other = b_is_larger ? face_a : face_b;
    const Vec3& x = small.corners[static_cast<std::size_t>(small.solid->shape.faces[other][0])];
    const Vec3& on_face = large.corners[static_cast<std::size_t>(large.solid->shape.faces[face][0])];
    depth = std::abs(depth_below(large, face, x)), corner = (on_face - x).norm();
  }
};

/// The product of their normals: -1 where they are parallel and opposed.
inline double opposed(const PlacedSolid& a, int f, const PlacedSolid& b, int g) {
  return a.normals[static_cast<std::size_t>(f)].dot(b.normals[static_cast<std::size_t>(g)]);
}

}  // namespace trilith
