// The elastic energy that contact/plane/overlap_pair.hpp has its forces from.
#pragma once

#include "contact/plane/overlap_pair.hpp"

namespace trilith {

/// Of the normal pressures of two pieces whose mortar is crushed by `crushed` [m]; without shear [J].
double overlap_energy(const PlacedPiece& a, const PlacedPiece& b, const LawInUse& law, double crushed = 0);

/// What that energy falls by where the mortar is crushed deeper [N]: of a law with linear springs.
double crushing_force(const PlacedPiece& a, const PlacedPiece& b, double kn, double crushed);

/// What two pieces press by that remember nothing.
OverlapResponse whole_overlap(const PlacedPiece& a, const PlacedPiece& b, const LawInUse& law);

}  // namespace trilith
