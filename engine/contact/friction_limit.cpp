#include "contact/friction_limit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/solid_pressure.hpp"

namespace trilith {
namespace {

constexpr double rounder = friction_roundness;
/// Beyond this many times what friction holds only the direction counts, to the same share; squares stay in range where
/// a pressure of nothing but rounding holds next to nothing.
constexpr double far_beyond = 1e9;

/// By how much (V, T) is beyond the curve: over this it lies on it.
double beyond_curve(const Vec3& z) {
  const double x2 = z.x() * z.x() + z.y() * z.y(), y2 = z.z() * z.z(), sum = x2 + y2;
  return std::sqrt(0.5 * (sum + std::sqrt(sum * sum + 4 * rounder * x2 * y2)));
}

/// Half the gradient of the measure: (a x, b y), x for both ways across.
struct LimitNormal {
  double a, b;

  explicit LimitNormal(const Vec3& z)
      : a(1 + rounder * z.z() * z.z()), b(1 + rounder * (z.x() * z.x() + z.y() * z.y())) {}
  [[nodiscard]] Vec3 at(const Vec3& z) const { return {a * z.x(), a * z.y(), b * z.z()}; }
  [[nodiscard]] double along(const Vec3& z) const { return at(z).dot(z); }
};

/// z = L s takes the spring's force to V and T.
struct LimitPlaces {
  double lean, reach;

  [[nodiscard]] Vec3 from_spring(const Vec3& s) const { return {s.x(), s.y(), reach * s.z() - lean * s.y()}; }
  [[nodiscard]] Vec3 to_spring(const Vec3& z) const { return {z.x(), z.y(), (z.z() + lean * z.y()) / reach}; }
  /// G = L L' applied.
  [[nodiscard]] Vec3 applied(const Vec3& v) const {
    return {v.x(), v.y() - lean * v.z(), (lean * lean + reach * reach) * v.z() - lean * v.y()};
  }
};

/// The way back to an ellipsoid z' D z = 1, D = diag(a, a, b): z + lambda G D z = the point beyond it, G = L L'. The
/// first row stands alone.
struct WayBack {
  double p, q, r, s;  // rows two and three of G D
  double a, b;

  WayBack(const LimitPlaces& l, double along, double turning)
      : p(along),
        q(-l.lean * turning),
        r(-l.lean * along),
        s((l.lean * l.lean + l.reach * l.reach) * turning),
        a(along),
        b(turning) {}
  /// (1 + lambda G D)^-1 z.
  [[nodiscard]] Vec3 back(const Vec3& z, double lambda) const {
    const double pp = 1 + lambda * p, qq = lambda * q, rr = lambda * r, ss = 1 + lambda * s;
    const double share = 1 / (pp * ss - qq * rr);
    return {z.x() / (1 + lambda * a), share * (ss * z.y() - qq * z.z()), share * (pp * z.z() - rr * z.y())};
  }
  [[nodiscard]] Vec3 applied(const Vec3& z) const { return {a * z.x(), p * z.y() + q * z.z(), r * z.y() + s * z.z()}; }
  [[nodiscard]] double product(const Vec3& y, const Vec3& z) const {
    return a * (y.x() * z.x() + y.y() * z.y()) + b * y.z() * z.z();
  }
};

/// By rounds: around the point found last lies the ellipsoid that has the limit's normal there. Its nearest point has
/// one unknown, for which 1 / |z| is concave: by Newton's rule from the left it grows and never goes too far. The next
/// point is that one brought to the limit along its ray; it settles because the two surfaces touch. Slow and sure.
Vec3 nearest_by_rounds(const LimitPlaces& places, const Vec3& beyond) {
  Vec3 z = beyond / beyond_curve(beyond);
  for (int i = 0; i < 40; ++i) {
    const LimitNormal at(z);
    const WayBack way(places, at.a / at.along(z), at.b / at.along(z));
    double lambda = 0;
    Vec3 next = beyond;
    for (int k = 0; k < 60; ++k) {
      const double square = way.product(next, next), length = std::sqrt(square);
      if (length <= 1 + 1e-14) break;
      lambda += (length - 1) * square / way.product(next, way.back(way.applied(next), lambda));
      next = way.back(beyond, lambda);
    }
    next /= beyond_curve(next);
    const double moved = (next - z).cwiseAbs().maxCoeff();
    z = next;
    if (moved < 1e-13) break;
  }
  return z;
}

/// By Newton's rule on both equations, z + lambda G v = beyond and measure(z) = 1, v being the limit's normal; false
/// where that does not settle in a few rounds on the near side.
bool nearest_by_newton(const LimitPlaces& places, const Vec3& beyond, Vec3& z) {
  z = beyond / beyond_curve(beyond);
  Vec3 v = LimitNormal(z).at(z), g = places.applied(v);
  double lambda = v.dot(beyond - z) / v.dot(g);
  for (int i = 0; i < 10; ++i) {
    const LimitNormal normal(z);
    const double bend = 2 * rounder * z.z();
    const Vec3 rest = z + lambda * g - beyond;
    const std::array<Vec3, 3> columns = {
        Vec3(Vec3::UnitX() + lambda * places.applied(Vec3(normal.a, 0, bend * z.x()))),
        Vec3(Vec3::UnitY() + lambda * places.applied(Vec3(0, normal.a, bend * z.y()))),
        Vec3(Vec3::UnitZ() + lambda * places.applied(Vec3(bend * z.x(), bend * z.y(), normal.b)))};
    const Vec3 yz = cross(columns[1], columns[2]), zx = cross(columns[2], columns[0]),
               xy = cross(columns[0], columns[1]);
    const double share = 1 / columns[0].dot(yz);
    const auto solved = [&](const Vec3& of) { return Vec3(share * Vec3(yz.dot(of), zx.dot(of), xy.dot(of))); };
    const Vec3 by_rest = solved(rest), by_lambda = solved(g);
    const double off = 0.5 * (limit_measure(std::sqrt(z.x() * z.x() + z.y() * z.y()), z.z()) - 1);
    const double more = (off - v.dot(by_rest)) / v.dot(by_lambda);
    const Vec3 step = by_rest + more * by_lambda;
    z -= step, lambda += more;
    if (!(z.squaredNorm() < 4 && lambda > 0)) return false;
    v = LimitNormal(z).at(z), g = places.applied(v);
    if (step.cwiseAbs().maxCoeff() < 1e-9) return true;
  }
  return false;
}

}  // namespace

double limit_measure(double x, double y) {
  return x * x + y * y + rounder * x * x * y * y;
}

Vec3 nearest_on_limit(const Vec3& spring, double lean, double reach) {
  const LimitPlaces places{lean, reach};
  const Vec3 beyond = places.from_spring(spring);
  Vec3 z;
  if (!nearest_by_newton(places, beyond, z)) z = nearest_by_rounds(places, beyond);
  return places.to_spring(z / beyond_curve(z));
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
  const double off = offset.norm();
  const Vec3 across = spring - normal.dot(spring) * normal;
  Vec3 x = off > 0 ? Vec3(offset / off) : across;
  x -= normal.dot(x) * normal;
  if (!(x.squaredNorm() > 0)) x = line_across(normal);
  x.normalize();
  const Vec3 y = cross(normal, x);
  const double most = far_beyond * force, largest = spring.cwiseAbs().maxCoeff();
  const Vec3 shares = (largest > most ? Vec3(far_beyond * (spring / largest)) : Vec3(spring / force));
  const Vec3 held = nearest_on_limit(Vec3(x.dot(shares), y.dot(shares), normal.dot(shares)), off / arm, radius / arm);
  return force * (held.x() * x + held.y() * y + held.z() * normal);
}

}  // namespace trilith
