// What a place, a turn and a spin are in two dimensions; the room for three is one more specialisation.
#pragma once

#include <Eigen/Core>

#include "base/portable.hpp"

namespace trilith {

/// Types of motion in D dimensions. Rotation is the pose's turn, Spin its rate, Inertia the resistance to it.
template <int D>
struct Space;

template <>
struct Space<2> {
  using Vec = Eigen::Vector2d;
  using Rotation = double;  ///< angle, counter-clockwise [rad], unwrapped
  using Spin = double;      ///< [rad/s]
  using Inertia = double;   ///< about the node [kg m2]
  static constexpr int translations = 2;
  static constexpr int dofs = 3;
};

template <int D>
using Vec = typename Space<D>::Vec;
using Vec2 = Vec<2>;

/// z component of a x b.
inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}
/// spin x arm: velocity of the tip of `arm` that turns with `spin`.
inline Vec2 cross(double spin, const Vec2& arm) {
  return {-spin * arm.y(), spin * arm.x()};
}
/// `v` turned by +90 degrees.
inline Vec2 left_of(const Vec2& v) {
  return {-v.y(), v.x()};
}

/// Turns vectors by one angle; the cosine and sine are found once.
struct Turn {
  double c, s;
  explicit Turn(double angle) : Turn(portable::sine_cosine(angle)) {}
  explicit Turn(const portable::SineCosine& of) : c(of.cosine), s(of.sine) {}
  [[nodiscard]] Vec2 apply(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
  [[nodiscard]] Vec2 undo(const Vec2& v) const { return {c * v.x() + s * v.y(), -s * v.x() + c * v.y()}; }
};

}  // namespace trilith
