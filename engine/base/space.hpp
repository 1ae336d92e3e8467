// Types of position, rotation and spin in two and three dimensions.
#pragma once

#include <Eigen/Core>

#include <type_traits>

#include "base/portable.hpp"

namespace trilith {

/// A rotation in space: by the angle t about the unit vector e it is (cos t/2, sin t/2 e). See base/rotation_3d.hpp.
struct UnitQuaternion {
  double w = 1, x = 0, y = 0, z = 0;
};

/// Types of motion in D dimensions. Rotation is the orientation, Spin its rate, Inertia the moment of inertia, Moment
/// the conjugate load.
template <int D>
struct Space;

template <>
struct Space<2> {
  using Vec = Eigen::Vector2d;
  using Rotation = double;  ///< angle, counter-clockwise [rad], unwrapped
  using Spin = double;      ///< [rad/s]
  using Moment = double;    ///< [N m]
  using Inertia = double;   ///< about the node [kg m2]
  static constexpr int translations = 2;
  static constexpr int dofs = 3;
};

template <>
struct Space<3> {
  using Vec = Eigen::Vector3d;
  using Rotation = UnitQuaternion;  ///< from the node's axes to the world's axes
  using Spin = Eigen::Vector3d;     ///< in world axes [rad/s]
  using Moment = Eigen::Vector3d;   ///< in world axes [N m]
  using Inertia = Eigen::Vector3d;  ///< principal moments of inertia about the node, whose axes are principal [kg m2]
  static constexpr int translations = 3;
  static constexpr int dofs = 6;
};

template <int D>
using Vec = typename Space<D>::Vec;
using Vec2 = Vec<2>;
using Vec3 = Vec<3>;
template <int D>
using Rotation = typename Space<D>::Rotation;
template <int D>
using Spin = typename Space<D>::Spin;
template <int D>
using Moment = typename Space<D>::Moment;

/// Zero rotation, spin or moment.
template <class T>
T nothing() {
  if constexpr (std::is_same_v<T, Eigen::Vector3d>)
    return Eigen::Vector3d::Zero();
  else
    return T{};
}

// Calls f(number) for each component of a position, velocity, rotation or spin, in order.

template <class F>
void for_each_number(double& v, F&& f) {
  f(v);
}
template <class F>
void for_each_number(const double& v, F&& f) {
  f(v);
}
template <class F, class Derived>
void for_each_number(Eigen::MatrixBase<Derived>& v, F&& f) {
  for (Eigen::Index k = 0; k < v.size(); ++k) f(v[k]);
}
template <class F, class Derived>
void for_each_number(const Eigen::MatrixBase<Derived>& v, F&& f) {
  for (Eigen::Index k = 0; k < v.size(); ++k) f(v[k]);
}
template <class F>
void for_each_number(UnitQuaternion& q, F&& f) {
  f(q.w), f(q.x), f(q.y), f(q.z);
}
template <class F>
void for_each_number(const UnitQuaternion& q, F&& f) {
  f(q.w), f(q.x), f(q.y), f(q.z);
}

/// z component of a x b.
inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}
/// spin x arm: velocity of the tip of `arm`, which rotates with `spin`.
inline Vec2 cross(double spin, const Vec2& arm) {
  return {-spin * arm.y(), spin * arm.x()};
}
/// a x b in space.
template <class A, class B>
requires(A::SizeAtCompileTime == 3 && B::SizeAtCompileTime == 3) Vec3
    cross(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(), a.x() * b.y() - a.y() * b.x()};
}
/// `v` rotated by +90 degrees.
inline Vec2 left_of(const Vec2& v) {
  return {-v.y(), v.x()};
}

/// Rotates vectors by one angle, whose cosine and sine are computed once.
struct Turn {
  double c, s;
  explicit Turn(double angle) : Turn(portable::sine_cosine(angle)) {}
  explicit Turn(const portable::SineCosine& of) : c(of.cosine), s(of.sine) {}
  [[nodiscard]] Vec2 apply(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
  [[nodiscard]] Vec2 undo(const Vec2& v) const { return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()}; }
};

}  // namespace trilith
