// Seeded random rotations and random convex solids, the same on every platform: for tests and demonstrations.
#pragma once

#include "geometry/plane/random_convex.hpp"
#include "geometry/space/polyhedron.hpp"

namespace trilith {

/// A point uniformly distributed in the unit ball, without its innermost thousandth.
Vec3 random_in_ball(std::mt19937_64& bits);

/// A uniformly distributed rotation.
UnitQuaternion random_rotation(std::mt19937_64& bits);

/// Parameters of random convex solids.
struct RandomSolid {
  int fewest_corners = 4, most_corners = 12;
  double smallest = 0.5, largest = 2;  ///< long axis of the ellipsoid through the corners [m]
  double slenderest = 1;  ///< largest ratio of the ellipsoid's axes, at least 1; two ratios are drawn from 1 to this
};

/// A strictly convex solid in random orientation with its centroid at the origin (to rounding). Its faces are triangles
/// almost surely; its corners lie on an ellipsoid, no two very near to each other.
Polyhedron random_convex_solid(std::mt19937_64& bits, const RandomSolid& wanted = {});

/// A prism over a random convex polygon, `low` to `high` [m] high, in random orientation with its centroid at the
/// origin: faces with many corners.
Polyhedron random_prism(std::mt19937_64& bits, double low, double high, const RandomConvex& wanted = {});

}  // namespace trilith
