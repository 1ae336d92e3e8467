// Plane vectors: the one alias and the two products that plane geometry needs.
#pragma once

// base/space.hpp is about to land with the same names; from then on this header is that one alone.
#if __has_include("base/space.hpp")
#include "base/space.hpp"
#else
#include <Eigen/Core>

namespace trilith {

/// A point or vector of the plane (x to the right, y upward), m unless said otherwise.
using Vec2 = Eigen::Vector2d;

/// z component of a x b: positive where b lies to the left of a.
inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// `a` turned by +90 degrees (to the left), same length.
inline Vec2 left_of(const Vec2& a) {
  return {-a.y(), a.x()};
}

}  // namespace trilith
#endif
