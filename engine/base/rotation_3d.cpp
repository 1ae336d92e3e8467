#include "base/rotation_3d.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/portable.hpp"

namespace trilith {

/// (cos(t/2), sin(t/2) a / t) for a rotation vector a of length t.
UnitQuaternion rotation_by(const Vec3& angle) {
  const double size = std::sqrt(angle.dot(angle));
  if (!(size > 0)) return {};
  const auto [s, c] = portable::sine_cosine(0.5 * size);
  const double share = s / size;
  return {c, share * angle.x(), share * angle.y(), share * angle.z()};
}

// tan(t/2) = |(x, y, z)| / w. The sign is chosen so that w is not negative, which gives the shorter rotation.
Vec3 angle_of(const UnitQuaternion& q) {
  const double side = q.w < 0 ? -1 : 1, s = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(s > 0)) return Vec3::Zero();
  const double scale = side * 2 * portable::atan2(s, side * q.w) / s;
  return {scale * q.x, scale * q.y, scale * q.z};
}

// From the largest of the four components (Shepperd 1978): its square follows from the diagonal, the others by
// division.
UnitQuaternion rotation_of(const Eigen::Matrix3d& m) {
  const std::array<double, 4> four{1 + m(0, 0) + m(1, 1) + m(2, 2), 1 + m(0, 0) - m(1, 1) - m(2, 2),
                                   1 - m(0, 0) + m(1, 1) - m(2, 2), 1 - m(0, 0) - m(1, 1) + m(2, 2)};
  const auto largest = std::max_element(four.begin(), four.end()) - four.begin();
  const double root = std::sqrt(four[static_cast<std::size_t>(largest)]), by = 0.5 / root;
  const double zy = m(2, 1) - m(1, 2), xz = m(0, 2) - m(2, 0), yx = m(1, 0) - m(0, 1);
  const double xy = m(0, 1) + m(1, 0), yz = m(1, 2) + m(2, 1), zx = m(2, 0) + m(0, 2);
  UnitQuaternion q;
  if (largest == 0) q = {0.5 * root, by * zy, by * xz, by * yx};
  if (largest == 1) q = {by * zy, 0.5 * root, by * xy, by * zx};
  if (largest == 2) q = {by * xz, by * xy, 0.5 * root, by * yz};
  if (largest == 3) q = {by * yx, by * zx, by * yz, 0.5 * root};
  return renormalised(q);
}

/// The columns of the rotation matrix: the rotated axes.
Turn3::Turn3(const UnitQuaternion& q)
    : x_(1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y + q.w * q.z), 2 * (q.x * q.z - q.w * q.y)),
      y_(2 * (q.x * q.y - q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z + q.w * q.x)),
      z_(2 * (q.x * q.z + q.w * q.y), 2 * (q.y * q.z - q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y)) {}

}  // namespace trilith
