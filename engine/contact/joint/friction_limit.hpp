// Combined limit of sliding and turning friction of an area.
//
//      y
//
//     1 |----._
//       |       `.
//       |         \               x = V / mu N,   y = T / mu N a
//       |__________|_ x
//                  1              m(x, y) = 1
//
// The limit for the force V in the plane and the couple T about the centre of pressure is a convex curve. An area at
// the limit moves along the curve's normal (Goyal, Ruina and Papadopoulos, "Planar sliding with dry friction", Wear
// 143, 1991). Here a is the mean distance of the pressure from its centre, and m depends on the shape of the area:
// contact/joint/area_limit.hpp. FrictionLimit is the limit of a square; AreaLimit includes the orientation of the area.
//
// The limited spring is attached elsewhere, at the centroid of the area. With the centre of pressure at d from it, the
// spring's force f and couple m give V = f and T = m - d x f: seen from the spring the limit is sheared. An area that
// slides under eccentric pressure has a couple in its spring but does not turn.
#pragma once

#include "base/space.hpp"

namespace trilith {

inline constexpr double least_held_force = 1e-140;  ///< no friction below it, as squares underflow [N]

/// Squared ratio of (x, y) to the limit of a square along their ray: 1 on it.
double limit_measure(double x, double y);

/// The admissible friction force nearest to one beyond the limit. Input and output: the spring's force along d and
/// across it, and its couple over the spring's radius, relative to mu N; `lean` = |d| / a, `reach` = radius / a.
Vec3 nearest_on_limit(const Vec3& spring, double lean, double reach);

/// The admissible friction for a spring's force: in the plane normal to `normal`, and along it the couple over
/// `radius`.
struct FrictionLimit {
  double force;   ///< mu N [N]
  Vec3 normal;    ///< unit vector
  Vec3 offset;    ///< from the spring to the centre of pressure, in the plane [m]
  double radius;  ///< radius of gyration of the area [m]
  double arm;     ///< mean distance of the pressure from its centre [m]

  /// `from_middle`: from the spring to the centre of pressure, in any direction. Pressure on a line or a point can
  /// resist a couple of at least a hundredth of the area's; without area it resists none.
  FrictionLimit(double held, const Vec3& across, const Vec3& from_middle, double gyration, double mean_distance);

  /// True where the force is beyond the limit.
  [[nodiscard]] bool is_below(const Vec3& spring) const;
  /// The admissible force nearest to one beyond the limit.
  [[nodiscard]] Vec3 nearest_to(const Vec3& spring) const;
};

}  // namespace trilith
