// Rotations in space as unit quaternions: conversion from and to rotation vectors and matrices, and composition.
//
// A rotation vector points along the axis; its length is the angle [rad], counter-clockwise seen from its tip.
#pragma once

#include <Eigen/Core>

#include "base/space.hpp"

namespace trilith {

/// Composition: rotates by b first, then by a.
constexpr UnitQuaternion operator*(const UnitQuaternion& a, const UnitQuaternion& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

/// Inverse rotation.
constexpr UnitQuaternion inverse(const UnitQuaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// Restores unit length after rounding by one Newton step.
constexpr UnitQuaternion renormalised(const UnitQuaternion& q) {
  const double scale = 1.5 - 0.5 * (q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {scale * q.w, scale * q.x, scale * q.y, scale * q.z};
}

/// Rotation by a rotation vector [rad] of any length.
UnitQuaternion rotation_by(const Vec3& angle);

/// The shortest rotation vector of q, at most pi long [rad].
Vec3 angle_of(const UnitQuaternion& q);

/// The rotation of the world's axes to the columns of `axes`, which are orthonormal and right-handed.
UnitQuaternion rotation_of(const Eigen::Matrix3d& axes);

/// Rotates vectors by one rotation, whose matrix is computed once. The plane counterpart is Turn.
class Turn3 {
 public:
  explicit Turn3(const UnitQuaternion& q);
  [[nodiscard]] Vec3 apply(const Vec3& v) const { return x_ * v.x() + y_ * v.y() + z_ * v.z(); }
  [[nodiscard]] Vec3 undo(const Vec3& v) const { return {x_.dot(v), y_.dot(v), z_.dot(v)}; }
  /// The rotated axes in world coordinates.
  [[nodiscard]] const Vec3& x() const { return x_; }
  [[nodiscard]] const Vec3& y() const { return y_; }
  [[nodiscard]] const Vec3& z() const { return z_; }

 private:
  Vec3 x_, y_, z_;
};

// Overloads for the plane and for space: from a rotation, and from an angle [rad] or a rotation vector.

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
