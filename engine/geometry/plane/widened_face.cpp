#include "geometry/plane/widened_face.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace trilith {

/// A corner between two edges that move by h and k along their outward normals m and n moves by u m + v n with u + v (m
/// . n) = h and u (m . n) + v = k.
PlacedFace widened_face(const PlacedSolid& solid, int face, FaceRoom& room) {
  const PlacedFace own = face_of(solid, face, room);
  const std::span<const double> goes_on = solid.solid->goes_on_from(face);
  if (goes_on.empty()) return own;
  const std::size_t count = own.corners.size();
  FaceRoom moved;
  const auto edge = [&](const auto& corner, std::size_t i) {
    return Vec3(corner[i + 1 == count ? 0 : i + 1] - corner[i]);
  };
  const auto outward = [&](std::size_t i) { return Vec3(cross(edge(room, i), own.normal).normalized()); };
  Vec3 before = outward(count - 1);
  double beyond = goes_on[count - 1];
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 after = outward(i);
    const double both = before.dot(after), left = 1 - both * both;
    if (!(left > 0)) return own;
    moved[i] = room[i] + ((beyond - both * goes_on[i]) * before + (goes_on[i] - both * beyond) * after) / left;
    before = after, beyond = goes_on[i];
  }
  for (std::size_t i = 0; i < count; ++i)
    if (!(edge(moved, i).dot(edge(room, i)) > 0)) return own;
  for (std::size_t i = 0; i < count; ++i) room[i] = moved[i];
  return own;
}

bool lies_beyond(const PlacedSolid& other, int other_face, const PlacedSolid& solid, int face) {
  const std::span<const double> goes_on = solid.solid->goes_on_from(face);
  const std::span<const int> loop = solid.solid->shape.faces[face], others = other.solid->shape.faces[other_face];
  const auto corner = [](const PlacedSolid& of, int c) -> const Vec3& {
    return of.corners[static_cast<std::size_t>(c)];
  };
  for (std::size_t k = 0; k < goes_on.size(); ++k) {
    if (!(goes_on[k] > 0)) continue;
    const Vec3& from = corner(solid, loop[k]);
    const Vec3 out = cross(Vec3(corner(solid, loop[k + 1 == loop.size() ? 0 : k + 1]) - from),
                           solid.normals[static_cast<std::size_t>(face)]);
    if (std::all_of(others.begin(), others.end(), [&](int c) { return out.dot(Vec3(corner(other, c) - from)) >= 0; }))
      return true;
  }
  return false;
}

}  // namespace trilith
