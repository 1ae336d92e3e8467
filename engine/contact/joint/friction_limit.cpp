#include "contact/joint/friction_limit.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

#include "contact/joint/friction_projection.hpp"
#include "contact/space/solid_pressure.hpp"

namespace trilith {
namespace {

using Place = Triple<double>;

/// Projection to an ellipsoid z' D z = 1 that has the limit's normal at one point: z + lambda G D z = the point beyond
/// it, G = L L'.
struct WayBack {
  Eigen::Matrix3d ellipsoid, way;  // D, G D

  WayBack(const LimitPlaces<double>& l, const Place& z) {
    const LimitNormal<double> normal(z, l.shape);
    const LimitTensor<double> in_plane = normal.ellipse(l.shape);
    ellipsoid << in_plane.xx, in_plane.xy, 0, in_plane.xy, in_plane.yy, 0, 0, 0, normal.turn;
    ellipsoid /= normal.vector().dot(z);
    for (int i = 0; i < 3; ++i) way.col(i) = vector_of(l.applied({ellipsoid(0, i), ellipsoid(1, i), ellipsoid(2, i)}));
  }
  /// (1 + lambda G D)^-1.
  [[nodiscard]] Eigen::Matrix3d back(double lambda) const {
    return (Eigen::Matrix3d::Identity() + lambda * way).inverse();
  }
};

Place on_curve(const LimitPlaces<double>& l, const Place& z) {
  const double curve = beyond_curve(z, l.shape);
  return {z.x / curve, z.y / curve, z.z / curve};
}

/// Fixed-point iteration. Each round projects to the ellipsoid that has the limit's normal at the last point. The
/// projection has one unknown lambda, for which 1 / |z| is concave, so Newton's method from the left increases and
/// never overshoots. The next point is the projection brought to the limit along its ray. It converges because the two
/// surfaces touch. It is slow and robust, except for areas close to a line, where the ellipsoid may be degenerate: then
/// the last point is kept.
Place nearest_by_rounds(const LimitPlaces<double>& places, const Place& beyond) {
  Place z = on_curve(places, beyond);
  for (int i = 0; i < 40; ++i) {
    const WayBack way(places, z);
    double lambda = 0;
    Eigen::Matrix3d back = way.back(lambda);
    Vec3 at = vector_of(beyond);
    for (int k = 0; k < 60; ++k) {
      const double square = at.dot(way.ellipsoid * at), length = std::sqrt(square);
      if (length <= 1 + 1e-14) break;
      lambda += (length - 1) * square / at.dot(way.ellipsoid * Vec3(back * Vec3(way.way * at)));
      back = way.back(lambda);
      at = back * vector_of(beyond);
    }
    const Place next = on_curve(places, triple_of(at));
    if (!std::isfinite(next.x + next.y + next.z)) return z;
    const double moved = largest_size(next - z);
    z = next;
    if (moved < 1e-13) break;
  }
  return z;
}

}  // namespace

double limit_measure(double x, double y) {
  return LimitSpread<double>().beyond_square({x, 0, 0}, y);
}

Vec3 nearest_on_limit(const Vec3& spring, double lean, double reach) {
  return nearest_on_limit(spring, lean, reach, square_limit);
}

// A copy for newer processors saves the moves between registers; the operations, and so the bits, are the same.
[[gnu::target_clones("avx2", "default")]] Vec3 nearest_on_limit(const Vec3& spring, double lean, double reach,
                                                                const LimitShape<double>& shape) {
  const LimitPlaces<double> places{lean, reach, shape};
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

AreaLimit::AreaLimit(double held, const Vec3& across, const Vec3& from_middle, double gyration, double mean_distance,
                     const std::array<Vec3, 2>& arms)
    : FrictionLimit(held, across, from_middle, gyration, mean_distance) {
  if (gyration > 0) spread = LimitSpread<double>(triple_of(arms[0]), triple_of(arms[1]));
}

bool FrictionLimit::is_below(const Vec3& spring) const {
  return AreaLimit(*this).is_below(spring);
}
Vec3 FrictionLimit::nearest_to(const Vec3& spring) const {
  return AreaLimit(*this).nearest_to(spring);
}

bool AreaLimit::is_below(const Vec3& spring) const {
  if (!(force > 0)) return true;
  const double turning = normal.dot(spring);
  const Vec3 across = spring - turning * normal, v = across / force;
  const double turn = (radius * turning - normal.dot(cross(offset, across))) / (force * arm);
  return !(spread.beyond_square(triple_of(v), turn) <= 1);  // NaN: far beyond
}

/// Axes: d, the in-plane direction normal to d, the normal.
Vec3 AreaLimit::nearest_to(const Vec3& spring) const {
  if (!(force > 0)) return Vec3::Zero();
  const Place of = triple_of(spring);
  LimitFrame<double> frame(triple_of(normal), triple_of(offset), of);
  if (!frame.known) frame.turn(triple_of(line_across(normal).normalized()));
  const Vec3 held =
      nearest_on_limit(vector_of(frame.shares(force, of)), frame.off / arm, radius / arm, spread.in(frame.x, frame.y));
  return vector_of(frame.force_of(force, triple_of(held)));
}

SlidingResponse slide(const SlidingMotion& motion, const AreaLimit& limit, double area, const SlidingForce& before,
                      const SlidingLaw& law) {
  const ShearForce<double> last{triple_of(before.elastic), triple_of(before.total), before.area};
  SlidingStep<double> step(triple_of(motion.path), triple_of(motion.rate), area, last, law.ks, law.beta);
  Triple<double> held = step.total;
  const bool slides = limit.is_below(vector_of(step.total));
  if (slides) held = triple_of(limit.nearest_to(vector_of(step.total)));
  const Triple<double> stretch = step.hold(held, slides, law.beta, law.dt);
  const SlidingLoss<double> lost(step, stretch, last);
  return {{vector_of(step.elastic), vector_of(step.total), area}, lost.slip, lost.friction, lost.damping};
}

}  // namespace trilith
