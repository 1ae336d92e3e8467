// Elastic energy of two convex pieces that overlap, see contact/overlap_pair.hpp.
#pragma once

#include "contact/overlap_pair.hpp"

namespace trilith {

/// [J]. `kn` times thickness [N/m2]; `crushed`: depth of crushed mortar [m].
double overlap_energy(const PlacedPiece& a, const PlacedPiece& b, double kn, double crushed = 0);

/// What that energy falls by as the mortar is crushed deeper, per depth [N].
double crushing_force(const PlacedPiece& a, const PlacedPiece& b, double kn, double crushed);

}  // namespace trilith
