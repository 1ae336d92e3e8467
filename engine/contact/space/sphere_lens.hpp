// Two intersecting spheres: the disc between them, and the pressure over it.
//
// Input: radii R, r and the distance d of the centres. The overlap at the distance rho from the axis is s = sqrt(R^2 -
// rho^2) + sqrt(r^2 - rho^2) - d. The area of the disc times its mean is the volume of the lens, pi (R + r - d)^2 (d^2
// + 2 d (R + r) - 3 (R - r)^2) / 12 d. Output: the force over kn.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "law/contact/list.hpp"

namespace trilith {

/// Gauss quadrature with 5 points from 0 to 1.
inline constexpr std::array<double, 5> sphere_point{0.046910077030668, 0.2307653449471584, 0.5, 0.7692346550528415,
                                                    0.953089922969332};
inline constexpr std::array<double, 5> sphere_weight{0.1184634425280945, 0.2393143352496832, 0.2844444444444444,
                                                     0.2393143352496832, 0.1184634425280945};

/// Integral of f over 0 to 1 for f that varies with a power of 1 - x^2: f(1 - w^2) 2 w.
template <class F>
double integral_to_rim(F&& f) {
  double sum = 0;
  for (std::size_t i = 0; i < sphere_point.size(); ++i)
    sum += 2 * sphere_weight[i] * sphere_point[i] * f(1 - sphere_point[i] * sphere_point[i]);
  return sum;
}

struct SphereLens {
  double large, small;  ///< radii [m]
  double distance;      ///< of the centres, less than the sum of the radii [m]
  double inverse;       ///< 1 / distance [1/m]

  SphereLens(double r, double s, double d) : SphereLens(r, s, d, 1 / d) {}
  SphereLens(double r, double s, double d, double one_over) : large(r), small(s), distance(d), inverse(one_over) {}

  [[nodiscard]] double overlap() const { return large + small - distance; }
  /// One lies inside the other: the overlap has no rim.
  [[nodiscard]] bool is_swallowed() const { return distance <= large - small; }
  /// From the centre of a sphere to the plane of the disc [m].
  [[nodiscard]] double plane_from(double radius, double other) const {
    return 0.5 * (distance + (radius - other) * (radius + other) * inverse);
  }
  [[nodiscard]] double disc_radius_squared() const {
    if (is_swallowed()) return small * small;
    const double plane = plane_from(small, large);
    return std::max(0.0, small * small - plane * plane);
  }
  [[nodiscard]] double area() const { return std::numbers::pi * disc_radius_squared(); }
  [[nodiscard]] double volume() const {
    if (is_swallowed()) return 4.0 / 3 * std::numbers::pi * small * small * small;
    const double sum = large + small, difference = large - small, e = overlap();
    return std::numbers::pi / 12 * e * e * inverse * (distance * (distance + 2 * sum) - 3 * difference * difference);
  }
};

/// Integral of max(e(s) - relief, 0) over the disc [m3]; relief [m].
template <class K>
double lens_force(const SphereLens& lens, const K& law, double relief) {
  if constexpr (K::linear) {
    if (relief == 0) return lens.overlap() > 0 ? lens.volume() : 0;
    const SphereLens left(lens.large, lens.small, lens.distance + relief);
    return left.overlap() > 0 ? left.volume() : 0;
  } else {
    if (lens.is_swallowed()) return std::max(0.0, law.effective(2 * lens.small) - relief) * lens.area();
    const double square = lens.disc_radius_squared();
    const double plane_large = lens.plane_from(lens.large, lens.small),
                 plane_small = lens.plane_from(lens.small, lens.large);
    return std::numbers::pi * square * integral_to_rim([&](double share) {
             const double left = square * (1 - share);
             const double s = left / (std::sqrt(lens.large * lens.large - square * share) + plane_large) +
                              left / (std::sqrt(lens.small * lens.small - square * share) + plane_small);
             return std::max(0.0, law.effective(s) - relief);
           });
  }
}

/// Work over kn to move the two from touching to their position [m4].
template <class K>
double lens_energy(const SphereLens& lens, const K& law) {
  const double from = lens.large + lens.small, way = lens.overlap();
  return way * integral_to_rim([&](double share) {
           return lens_force(SphereLens(lens.large, lens.small, from - way * (1 - share)), law, 0);
         });
}

}  // namespace trilith
