#include "geometry/space/facing_faces.hpp"

#include <cassert>

namespace trilith {
namespace {

/// The face whose normal has the largest product with the axis; of equal ones the first.
int nearest_normal(const std::vector<Vec3>& normals, const Vec3& axis) {
  std::size_t best = 0;
  double most = axis.dot(normals[0]);
  for (std::size_t f = 1; f < normals.size(); ++f)
    if (const double along = axis.dot(normals[f]); along > most) most = along, best = f;
  return static_cast<int>(best);
}

}  // namespace

// For each solid the face most nearly normal to the axis from a to b. Faces are exactly opposed where the product of
// their normals is -1; `opposed` is its negative.
FacingFaces facing_faces(const PlacedSolid& a, const PlacedSolid& b, const Vec3& axis) {
  const int of_a = nearest_normal(a.normals, axis), of_b = nearest_normal(b.normals, -axis);
  return {of_a, of_b, -a.normals[static_cast<std::size_t>(of_a)].dot(b.normals[static_cast<std::size_t>(of_b)])};
}

PlacedFace face_of(const PlacedSolid& solid, int face, FaceRoom& room) {
  const auto loop = solid.solid->shape.faces[face];
  assert(loop.size() <= room.size());
  for (std::size_t k = 0; k < loop.size(); ++k) room[k] = solid.corners[static_cast<std::size_t>(loop[k])];
  return {std::span<const Vec3>(room.data(), loop.size()), solid.normals[static_cast<std::size_t>(face)]};
}

}  // namespace trilith
