// Rotation in space by unit quaternions: from and to rotation vectors and matrices, one after the other.
//
// A rotation vector points along the axis; its length is the angle [rad], counter-clockwise seen from its tip.
#pragma once

#include <Eigen/Core>

#include "base/space.hpp"

namespace trilith {

/// b first, then a.
constexpr UnitQuaternion operator*(const UnitQuaternion& a, const UnitQuaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// The way back.
constexpr UnitQuaternion inverse(const UnitQuaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// Of length 1 again, where rounding has left it next to 1: one step of Newton's method.
constexpr UnitQuaternion renormalised(const UnitQuaternion& q) {
  const double scale = 1.5 - 0.5 * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

/// By a rotation vector [rad], of any length.
UnitQuaternion rotation_by(const Vec3& angle);

/// The shortest rotation vector, at most pi long [rad].
Vec3 angle_of(const UnitQuaternion& q);

/// That turns the world's axes to the columns of a matrix, which are of length 1, at right angles and right-handed.
UnitQuaternion rotation_of(const Eigen::Matrix3d& axes);

/// Turns vectors by one rotation; its matrix is found once. As Turn is in the plane.
class Turn3 {
 public:
  explicit Turn3(const UnitQuaternion& q);
  [[nodiscard]] Vec3 apply(const Vec3& v) const { return x_ * v.x() + y_ * v.y() + z_ * v.z(); }
  [[nodiscard]] Vec3 undo(const Vec3& v) const { return {x_.dot(v), y_.dot(v), z_.dot(v)}; }
  /// The axes that turn, in the world.
  [[nodiscard]] const Vec3& x() const { return x_; }
  [[nodiscard]] const Vec3& y() const { return y_; }
  [[nodiscard]] const Vec3& z() const { return z_; }

 private:
  Vec3 x_, y_, z_;
};

// The same words in the plane and in space: of a rotation, and by an angle [rad] or a rotation vector.

inline Turn turn_of(double rotation) {
  return Turn(rotation);
}
inline Turn3 turn_of(const UnitQuaternion& rotation) {
  return Turn3(rotation);
}
inline Turn turn_by(double angle) {
  return Turn(angle);
}
inline Turn3 turn_by(const Vec3& angle) {
  return Turn3(rotation_by(angle));
}

}  // namespace trilith
