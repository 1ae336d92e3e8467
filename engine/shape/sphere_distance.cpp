#include "shape/sphere_distance.hpp"

#include <algorithm>
#include <cmath>

#include "base/schema.hpp"

namespace trilith {
namespace {

/// Square of the distance of x from a face, within it or at its sides.
double square_from_face(const PlacedSolid& solid, int face, const Vec3& x) {
  const std::span<const int> loop = solid.solid->shape.faces[face];
  const Vec3& n = solid.normals[static_cast<std::size_t>(face)];
  const double height = depth_below(solid, face, x);
  double beside = unbounded;
  bool inside = true;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& from = solid.corners[static_cast<std::size_t>(loop[i])];
    const Vec3 side = solid.corners[static_cast<std::size_t>(loop[i + 1 < loop.size() ? i + 1 : 0])] - from;
    const Vec3 arm = x - from;
    inside = inside && arm.dot(cross(side, n)) <= 0;
    const double along = std::clamp(arm.dot(side) / side.squaredNorm(), 0.0, 1.0);
    beside = std::min(beside, (arm - along * side).squaredNorm());
  }
  return inside ? height * height : beside;
}

double point_distance(const PlacedSolid& solid, const Vec3& x) {
  double highest = -unbounded, nearest = unbounded;
  for (int f = 0; f < solid.solid->shape.faces.count(); ++f) highest = std::max(highest, -depth_below(solid, f, x));
  if (highest <= 0) return highest;
  for (int f = 0; f < solid.solid->shape.faces.count(); ++f) nearest = std::min(nearest, square_from_face(solid, f, x));
  return std::sqrt(nearest);
}

}  // namespace

double sphere_distance(const PlacedSolid& a, const PlacedSolid& b) {
  if (!a.solid->is_sphere()) return point_distance(a, b.corners[0]) - b.solid->radius;
  if (!b.solid->is_sphere()) return point_distance(b, a.corners[0]) - a.solid->radius;
  return (b.corners[0] - a.corners[0]).norm() - a.solid->radius - b.solid->radius;
}

}  // namespace trilith
