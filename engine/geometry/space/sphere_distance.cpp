#include "geometry/space/sphere_distance.hpp"

#include <algorithm>
#include <cmath>

#include "base/schema.hpp"

namespace trilith {
namespace {

/// The point of a face, inside or on its edges, nearest to x.
Vec3 nearest_of_face(const PlacedSolid& solid, int face, const Vec3& x) {
  const std::span<const int> loop = solid.solid->shape.faces[face];
  const Vec3& n = solid.normals[static_cast<std::size_t>(face)];
  Vec3 nearest = x;
  double least = unbounded;
  bool inside = true;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3& from = solid.corners[static_cast<std::size_t>(loop[i])];
    const Vec3 side = solid.corners[static_cast<std::size_t>(loop[i + 1 < loop.size() ? i + 1 : 0])] - from;
    const Vec3 arm = x - from;
    inside = inside && arm.dot(cross(side, n)) <= 0;
    const Vec3 at = from + std::clamp(arm.dot(side) / side.squaredNorm(), 0.0, 1.0) * side;
    if (const double square = (x - at).squaredNorm(); square < least) least = square, nearest = at;
  }
  return inside ? Vec3(x + depth_below(solid, face, x) * n) : nearest;
}

/// Distance of a point from a convex solid: inside, minus the least depth below a face; outside, the distance from the
/// nearest surface point. The highest of the heights over all faces decides: it is negative inside only.
double point_distance(const PlacedSolid& solid, const Vec3& x) {
  double highest = -unbounded;
  for (int f = 0; f < solid.solid->shape.faces.count(); ++f) highest = std::max(highest, -depth_below(solid, f, x));
  return highest <= 0 ? highest : (x - nearest_point(solid, x)).norm();
}

}  // namespace

Vec3 nearest_point(const PlacedSolid& solid, const Vec3& x) {
  Vec3 nearest = x;
  double least = unbounded;
  for (int f = 0; f < solid.solid->shape.faces.count(); ++f) {
    const Vec3 at = nearest_of_face(solid, f, x);
    if (const double square = (x - at).squaredNorm(); square < least) least = square, nearest = at;
  }
  return nearest;
}

/// Positive where the two are apart, negative where they overlap; at least one is a sphere.
double sphere_distance(const PlacedSolid& a, const PlacedSolid& b) {
  if (!a.solid->is_sphere()) return point_distance(a, b.corners[0]) - b.solid->radius;
  if (!b.solid->is_sphere()) return point_distance(b, a.corners[0]) - a.solid->radius;
  return (b.corners[0] - a.corners[0]).norm() - a.solid->radius - b.solid->radius;
}

}  // namespace trilith
