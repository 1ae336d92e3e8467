// Distance of a sphere from another solid.
#pragma once

#include "geometry/space/convex_solid.hpp"

namespace trilith {

/// The point of a polyhedron's surface nearest to x.
Vec3 nearest_point(const PlacedSolid& solid, const Vec3& x);

/// Distance of two solids, at least one a sphere [m]; negative where they overlap: minus the least separating
/// translation.
double sphere_distance(const PlacedSolid& a, const PlacedSolid& b);

}  // namespace trilith
