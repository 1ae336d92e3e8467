// How much sliding and turning friction an area carries at once.
//
//      y                          An area that slides with the force V and turns with the couple T about its centre of
//                                 pressure reaches its limit on a convex curve, and moves along the curve's normal
//     1 |----._                   (Goyal, Ruina and Papadopoulos, "Planar sliding with dry friction", Wear 143, 1991).
//       |       `.                With
//       |         \               x = V / mu N, y = T / mu N a, a the mean distance of the pressure from its centre,
//       |__________|_ x
//                  1                  m(x, y) = 1, by the shape of the area: contact/joint/area_limit.hpp
//
// FrictionLimit is that of a square; AreaLimit knows how the area lies.
//
// The spring whose force is limited sits elsewhere, in the middle of the area. With the centre of pressure at d from
// it, the spring's force f and couple m are V = f and T = m - d x f: seen from the spring the limit leans, and what
// slides while its pressure is off the middle has a couple in its spring but does not turn.
#pragma once

#include "base/space.hpp"

namespace trilith {

inline constexpr double least_held_force = 1e-140;  ///< below it, where squares run out, nothing is held [N]

/// The square of how often (x, y) is what the limit of a square has along their ray: 1 on it.
double limit_measure(double x, double y);

/// The point that friction holds which is nearest to one beyond the limit. In and out: the spring's force along d and
/// across it and its couple over the radius at which the spring sits, in shares of mu N; `lean` = |d| / a, `reach` =
/// that radius / a.
Vec3 nearest_on_limit(const Vec3& spring, double lean, double reach);

/// What friction holds of a spring's force: one in the plane across `normal`, and along it the couple over `radius`.
struct FrictionLimit {
  double force;   ///< mu N [N]
  Vec3 normal;    ///< of length 1
  Vec3 offset;    ///< of the centre of pressure from the spring, in the plane [m]
  double radius;  ///< of gyration of the area [m]
  double arm;     ///< mean distance of the pressure from its centre [m]

  /// `from_middle`: the centre of pressure from the spring, anywhere. A pressure on a line or a point holds a couple
  /// about its centre of at least a hundredth of what the area would; one on no area none.
  FrictionLimit(double held, const Vec3& across, const Vec3& from_middle, double gyration, double mean_distance);

  /// True where friction cannot hold it.
  [[nodiscard]] bool is_below(const Vec3& spring) const;
  /// The nearest that it holds, of one that it cannot.
  [[nodiscard]] Vec3 nearest_to(const Vec3& spring) const;
};

}  // namespace trilith
