// How far a sphere is from another solid.
#pragma once

#include "shape/convex_solid.hpp"

namespace trilith {

/// Of two solids of which at least one is a sphere [m]; below 0 where they overlap: how far one has to move to be free.
double sphere_distance(const PlacedSolid& a, const PlacedSolid& b);

}  // namespace trilith
