// How far a sphere is from another solid.
#pragma once

#include "geometry/space/convex_solid.hpp"

namespace trilith {

/// The point of the surface of a polyhedron that is nearest to x.
Vec3 nearest_point(const PlacedSolid& solid, const Vec3& x);

/// Of two solids of which at least one is a sphere [m]; below 0 where they overlap: how far one has to move to be free.
double sphere_distance(const PlacedSolid& a, const PlacedSolid& b);

}  // namespace trilith
