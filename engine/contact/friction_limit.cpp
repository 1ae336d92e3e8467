#include "contact/friction_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/nearest_held.hpp"
#include "contact/solid_pressure.hpp"

namespace trilith {
namespace {

using Place = Triple<double>;

/// The way back to an ellipsoid z' D z = 1, D = diag(a, a, b): z + lambda G D z = the point beyond it, G = L L'. The
/// first row stands alone.
struct WayBack {
  double p, q, r, s;  // rows two and three of G D
  double a, b;

  WayBack(const LimitPlaces<double>& l, double along, double turning)
      : p(along),
        q(-l.lean * turning),
        r(-l.lean * along),
        s((l.lean * l.lean + l.reach * l.reach) * turning),
        a(along),
        b(turning) {}
  /// (1 + lambda G D)^-1 z.
  [[nodiscard]] Place back(const Place& z, double lambda) const {
    const double pp = 1 + lambda * p, qq = lambda * q, rr = lambda * r, ss = 1 + lambda * s;
    const double share = 1 / (pp * ss - qq * rr);
    return {z.x / (1 + lambda * a), share * (ss * z.y - qq * z.z), share * (pp * z.z - rr * z.y)};
  }
  [[nodiscard]] Place applied(const Place& z) const { return {a * z.x, p * z.y + q * z.z, r * z.y + s * z.z}; }
  [[nodiscard]] double product(const Place& y, const Place& z) const {
    return a * (y.x * z.x + y.y * z.y) + b * y.z * z.z;
  }
};

Place on_curve(const Place& z) {
  const double curve = beyond_curve(z);
  return {z.x / curve, z.y / curve, z.z / curve};
}

/// By rounds: around the point found last lies the ellipsoid that has the limit's normal there. Its nearest point has
/// one unknown, for which 1 / |z| is concave: by Newton's rule from the left it grows and never goes too far. The next
/// point is that one brought to the limit along its ray; it settles because the two surfaces touch. Slow and sure.
Place nearest_by_rounds(const LimitPlaces<double>& places, const Place& beyond) {
  Place z = on_curve(beyond);
  for (int i = 0; i < 40; ++i) {
    const LimitNormal<double> at(z);
    const WayBack way(places, at.a / at.along(z), at.b / at.along(z));
    double lambda = 0;
    Place next = beyond;
    for (int k = 0; k < 60; ++k) {
      const double square = way.product(next, next), length = std::sqrt(square);
      if (length <= 1 + 1e-14) break;
      lambda += (length - 1) * square / way.product(next, way.back(way.applied(next), lambda));
      next = way.back(beyond, lambda);
    }
    next = on_curve(next);
    const double moved = largest_size(next - z);
    z = next;
    if (moved < 1e-13) break;
  }
  return z;
}

}  // namespace

double limit_measure(double x, double y) {
  return x * x + y * y + friction_roundness * x * x * y * y;
}

Vec3 nearest_on_limit(const Vec3& spring, double lean, double reach) {
  const LimitPlaces<double> places{lean, reach};
  const Place beyond = places.from_spring(triple_of(spring));
  Place z;
  if (nearest_by_newton<double>(places, beyond, true, z)) z = nearest_by_rounds(places, beyond);
  return vector_of(spring_on_limit(places, z));
}

FrictionLimit::FrictionLimit(double held, const Vec3& across, const Vec3& from_middle, double gyration,
                             double mean_distance)
    : force(held > least_held_force ? held : 0), normal(across), offset(Vec3::Zero()), radius(1), arm(1) {
  if (!(gyration > 0)) return;
  offset = from_middle - across.dot(from_middle) * across;
  radius = gyration, arm = std::max(mean_distance, 0.01 * gyration);
}

bool FrictionLimit::is_below(const Vec3& spring) const {
  if (!(force > 0)) return true;
  const double turning = normal.dot(spring);
  const Vec3 across = spring - turning * normal;
  const double couple = radius * turning - normal.dot(cross(offset, across));
  return limit_measure(across.norm() / force, std::abs(couple) / (force * arm)) > 1;
}

/// Axes: d, across it in the plane, the normal.
Vec3 FrictionLimit::nearest_to(const Vec3& spring) const {
  if (!(force > 0)) return Vec3::Zero();
  const Place of = triple_of(spring);
  LimitFrame<double> frame(triple_of(normal), triple_of(offset), of);
  if (!frame.known) frame.turn(triple_of(line_across(normal).normalized()));
  const Vec3 held = nearest_on_limit(vector_of(frame.shares(force, of)), frame.off / arm, radius / arm);
  return vector_of(frame.force_of(force, triple_of(held)));
}

}  // namespace trilith
