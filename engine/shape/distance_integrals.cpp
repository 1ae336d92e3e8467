#include "shape/distance_integrals.hpp"

#include <cmath>

#include "base/portable.hpp"

namespace trilith {
namespace {

/// asinh(s / d), d above 0.
double arc_sinh(double s, double d, double root) {
  const double size = portable::log((std::abs(s) + root) / d);
  return s < 0 ? -size : size;
}

}  // namespace

// Integrals over a polygon of the distance from c and of the direction from it, edge by edge: with d the distance of
// the edge's line from c, s along it from the foot of the perpendicular, and r = sqrt(d^2 + s^2), the triangle between
// c and the edge gives
//
//        from . . . . to           int |x| dA     = d/6 [s r + d^2 asinh(s/d)]
//           .   | d .              int x/|x| dA   = d/2 ([r] along + d [asinh(s/d)] across)
//             . | .
//               c                  [.]: at `to` less at `from`
//
// by R^3/3 and R^2/2 d(angle), with d(angle) = d ds / r^2. Signs of d make triangles outside of the polygon count less.
DistanceIntegrals distance_integrals(std::span<const Vec2> outline, const Vec2& c) {
  DistanceIntegrals sum;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 from = outline[i] - c, to = outline[i + 1 == outline.size() ? 0 : i + 1] - c;
    const Vec2 edge = to - from;
    const double length = edge.norm();
    if (!(length > 0)) continue;
    const Vec2 along = edge / length, across = -left_of(along);
    const double d = across.dot(from), s0 = along.dot(from), s1 = along.dot(to);
    // what an edge through c adds is less than its rounding
    if (std::abs(d) < 1e-150) continue;
    const double r0 = from.norm(), r1 = to.norm();
    const double turn = d * d * (arc_sinh(s1, std::abs(d), r1) - arc_sinh(s0, std::abs(d), r0));
    sum.distance += d / 6 * (s1 * r1 - s0 * r0 + turn);
    sum.direction += turn / 2 * across + d / 2 * (r1 - r0) * along;
  }
  return sum;
}

}  // namespace trilith
