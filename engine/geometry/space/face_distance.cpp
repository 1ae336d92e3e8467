#include "geometry/space/face_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trilith {

/// For a point over the face the distance from its plane, else the distance from the nearest edge. A point is over the
/// face if it is on the inner side of every edge: ((q - p) x (x - p)) . n >= 0 with the area vector n of the loop.
double face_distance(const std::vector<Vec3>& corners, std::span<const int> loop, const Vec3& point) {
  const std::size_t count = loop.size();
  const auto corner = [&](std::size_t i) -> const Vec3& { return corners[static_cast<std::size_t>(loop[i % count])]; };
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < count; ++i)
    normal += cross(Vec3(corner(i) - corner(0)), Vec3(corner(i + 1) - corner(0)));
  bool over = true;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 edge = corner(i + 1) - corner(i), from = point - corner(i);
    over = over && cross(edge, from).dot(normal) >= 0;
    const double share = std::clamp(from.dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (from - share * edge).norm());
  }
  return over ? std::abs(normal.dot(point - corner(0))) / normal.norm() : nearest;
}

}  // namespace trilith
