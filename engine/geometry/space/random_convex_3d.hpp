// Seeded random rotations and random convex solids that are the same on every platform: for tests and demonstrations.
#pragma once

#include "geometry/plane/random_convex.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// A point evenly spread over the ball of radius 1, but for its innermost thousandth.
Vec3 random_in_ball(std::mt19937_64& bits);

/// A rotation evenly spread over all of them.
UnitQuaternion random_rotation(std::mt19937_64& bits);

/// What random convex solids look like.
struct RandomSolid {
  int fewest_corners = 4, most_corners = 12;
  double smallest = 0.5, largest = 2;  ///< long axis of the ellipsoid the corners lie on, m
  double slenderest = 1;  ///< largest ratio of the ellipsoid's axes, at least 1; two ratios are drawn from 1 to this
};

/// A strictly convex solid in random pose about its centroid, which lies at the origin (to rounding). Its faces are
/// triangles but by chance; its corners lie on an ellipsoid, none very near to another.
Polyhedron random_convex_solid(std::mt19937_64& bits, const RandomSolid& wanted = {});

/// A prism over a random convex polygon, `low` to `high` [m] high, in random pose about its centroid, which lies at the
/// origin: faces of many corners.
Polyhedron random_prism(std::mt19937_64& bits, double low, double high, const RandomConvex& wanted = {});

}  // namespace trilith
