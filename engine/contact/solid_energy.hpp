// The elastic energy that contact/solid_pressure.hpp has its forces from.
#pragma once

#include "contact/list.hpp"
#include "shape/overlap_3d.hpp"

namespace trilith {

/// Of the normal pressures of two solids; without shear [J]. `shared`, `scratch`: room.
double solid_energy(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law, SolidOverlapBuffer& shared,
                    SolidOverlapBuffer& scratch);

}  // namespace trilith
