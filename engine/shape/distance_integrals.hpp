// Friction of a plane face that turns: integrals of the distance from a point, and of the direction from it.
//
// A face under a uniform pressure p that turns about the point c, and slips all over, resists with the couple
// mu p `distance` about c and the force mu p `direction`, turned by 90 degrees against the motion.
#pragma once

#include <span>

#include "base/space.hpp"

namespace trilith {

/// Of r = x - c over a polygon.
struct DistanceIntegrals {
  double distance = 0;            ///< of |r| [m3]
  Vec2 direction = Vec2::Zero();  ///< of r / |r| [m2]
};

/// Exact, for a simple outline (counter-clockwise, at least 3 points, m) and any point, inside or not. From each edge
/// at the distance d of c, between s = s0 and s1 along it, with R^2 = d^2 + s^2:
///     of |r|:             d/6 (s R + d^2 asinh(s/d))
///     of r/|r|:  across   d^2/2 asinh(s/d),   along   d/2 R
DistanceIntegrals distance_integrals(std::span<const Vec2> outline, const Vec2& c);

}  // namespace trilith
