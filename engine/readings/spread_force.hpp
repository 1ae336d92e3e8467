// A force that is spread over a plane area, with stresses that are linear over it.
#pragma once

#include <span>
#include <vector>

#include "base/space.hpp"

namespace trilith {

/// Resultants of a part of a spread force: force [N], and moment about the centroid of the whole area [N m].
struct SpreadPart {
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
};

/// Normal stress s + slope . p and shear stress t + twist z x p over a polygon, at p from its centroid along the axes.
struct SpreadForce {
  Vec3 centre, x, y, normal;                               ///< centroid of the area [m]; right-handed unit vectors
  std::vector<Vec2> corners;                               ///< from the centroid, counter-clockwise [m]
  double normal_stress = 0, twist = 0;                     ///< [Pa], [Pa/m]
  Vec2 slope = Vec2::Zero(), shear_stress = Vec2::Zero();  ///< [Pa/m], [Pa]
  SpreadPart whole;

  /// The stresses with these resultants. `polygon`: convex, along x and y from `origin`; `moment`: about `origin`.
  SpreadForce(const Vec3& origin, const Vec3& x_axis, const Vec3& y_axis, std::span<const Vec2> polygon,
              const Vec3& force, const Vec3& moment);
  /// The part behind a plane: normal . (r - on_plane) <= 0.
  [[nodiscard]] SpreadPart behind(const Vec3& on_plane, const Vec3& plane_normal) const;
  /// The opposite force.
  [[nodiscard]] SpreadForce reversed() const;
};

/// The part of a convex polygon where at + slope . p <= 0.
std::vector<Vec2> part_below(std::span<const Vec2> corners, double at, const Vec2& slope);

/// The linear function with the integral `sum` and the first moments `moment` over an area with these second moments,
/// all about its centroid.
struct LinearOver {
  double at = 0;
  Vec2 slope = Vec2::Zero();
};
LinearOver linear_over(double area, double xx, double xy, double yy, double sum, const Vec2& moment);

}  // namespace trilith
