// The elastic energy from which the forces of contact/plane/overlap_pair.hpp derive.
#pragma once

#include "contact/plane/overlap_pair.hpp"

namespace trilith {

/// Energy of the normal pressures of two pieces with mortar crushed by `crushed` [m]; without shear [J].
double overlap_energy(const PlacedPiece& a, const PlacedPiece& b, const LawInUse& law, double crushed = 0);

/// Decrease of that energy per crushed depth [N], for a law with linear springs.
double crushing_force(const PlacedPiece& a, const PlacedPiece& b, double kn, double crushed);

/// Contact forces of two pieces without a memory.
OverlapResponse whole_overlap(const PlacedPiece& a, const PlacedPiece& b, const LawInUse& law);

}  // namespace trilith
