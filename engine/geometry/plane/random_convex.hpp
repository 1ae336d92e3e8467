// Seeded random numbers and random convex polygons that are the same on every platform: for tests and demonstrations.
#pragma once

#include <random>

#include "geometry/plane/polygon.hpp"

namespace trilith {

/// A random number in [low, high): the upper 53 raw bits of the generator, which the standard fixes (its distributions
/// are not fixed, so they are not used).
double random_between(std::mt19937_64& bits, double low, double high);

/// A random whole number from `low` to `high`, both included.
int random_count(std::mt19937_64& bits, int low, int high);

/// A unit vector of random direction, from sums, products and one division per component only (no sine), so the same
/// bits on every IEEE platform. Nearly, not exactly, evenly spread over the circle.
Vec2 random_direction(std::mt19937_64& bits);

/// What random convex polygons look like.
struct RandomConvex {
  int fewest_corners = 3, most_corners = 10;
  double smallest = 0.5, largest = 2;  ///< long axis of the ellipse the corners lie on, m
  double slenderest = 1;  ///< largest ratio of the ellipse's axes, at least 1; the ratio is drawn from 1 to this
};

/// A strictly convex counter-clockwise polygon in random pose about its centroid, which lies at the origin (to
/// rounding). Corners lie on an ellipse, one in each of n equal stretches of it, so no two are very near.
Polygon random_convex(std::mt19937_64& bits, const RandomConvex& wanted = {});

/// `outline` turned about the origin by the angle of unit vector `direction`, then moved by `shift`.
Polygon placed(const Polygon& outline, const Vec2& direction, const Vec2& shift);

}  // namespace trilith
