#include "geometry/plane/outline_moments.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/space/face_overlap_3d.hpp"

namespace trilith {
namespace {

/// There is no principal axis if the second moments differ by less than this relative amount.
constexpr double same_moment = 1e-6;

}  // namespace

OutlineMoments::OutlineMoments(std::span<const Vec2> corners) {
  const FaceIntegrals sum = integrals_over_all(corners, 0, Vec2::Zero());
  area = sum.area;
  if (!(area > 0)) return;
  middle = sum.area_moment / area;
  xx = sum.xx - area * middle.x() * middle.x(), yy = sum.yy - area * middle.y() * middle.y();
  xy = sum.xy - area * middle.x() * middle.y();
}

/// By Steiner's theorem about the common centroid.
void OutlineMoments::add(const OutlineMoments& other, double sign) {
  const double whole = area + sign * other.area;
  if (!(whole > 0)) {
    area = whole;
    return;
  }
  const Vec2 between = other.middle - middle;
  const double share = sign * other.area / whole, lever = area * share;
  area = whole, middle += share * between;
  xx += sign * other.xx + lever * between.x() * between.x(), yy += sign * other.yy + lever * between.y() * between.y();
  xy += sign * other.xy + lever * between.x() * between.y();
}

/// Half the difference of the principal moments.
double OutlineMoments::spread() const {
  return std::sqrt(0.25 * (xx - yy) * (xx - yy) + xy * xy);
}

bool OutlineMoments::has_axis() const {
  return spread() > same_moment * (xx + yy);
}

Vec2 OutlineMoments::axis() const {
  if (!has_axis()) return Vec2::UnitX();
  const double half = 0.5 * (xx - yy), t = spread();
  const Vec2 along = half >= 0 ? Vec2(half + t, xy) : Vec2(xy, t - half);
  return along.normalized();
}

std::array<Vec2, 4> OutlineMoments::arms() const {
  const double mean = 0.5 * (xx + yy) / area, t = has_axis() ? spread() / area : 0;
  const Vec2 to = axis(), far = std::sqrt(std::max(0.0, mean + t)) * to,
             near = std::sqrt(std::max(0.0, mean - t)) * Vec2(-to.y(), to.x());
  return {Vec2(-far - near), Vec2(far - near), Vec2(far + near), Vec2(near - far)};
}

}  // namespace trilith
