// Seeded random numbers and random convex polygons, the same on every platform: for tests and demonstrations.
#pragma once

#include <random>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// A random number in [low, high), from the upper 53 raw bits of the generator. The standard fixes these bits but not
/// its distributions, which are therefore not used.
double random_between(std::mt19937_64& bits, double low, double high);

/// A random integer from `low` to `high`, both included.
int random_count(std::mt19937_64& bits, int low, int high);

/// A unit vector of random direction. It uses sums, products and one division per component but no sine, so the bits
/// are the same on every IEEE platform. The distribution over the circle is nearly, not exactly, uniform.
Vec2 random_direction(std::mt19937_64& bits);

/// Parameters of random convex polygons.
struct RandomConvex {
  int fewest_corners = 3, most_corners = 10;
  double smallest = 0.5, largest = 2;  ///< long axis of the ellipse through the corners [m]
  double slenderest = 1;  ///< largest axis ratio of the ellipse, at least 1; the ratio is drawn from 1 to this
};

/// A strictly convex counter-clockwise polygon in random orientation, with its centroid at the origin (to rounding).
/// The corners lie on an ellipse, one in each of n equal sections, so no two are very near.
Polygon random_convex(std::mt19937_64& bits, const RandomConvex& wanted = {});

/// `outline` rotated about the origin by the angle of unit vector `direction`, then moved by `shift`.
Polygon placed(const Polygon& outline, const Vec2& direction, const Vec2& shift);

}  // namespace trilith
