// The elastic energy from which the forces of contact/space/solid_pressure.hpp derive.
#pragma once

#include "geometry/space/overlap_3d.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Energy of the normal pressures of two solids; without shear [J]. `shared`, `scratch`: buffers; `crushed`: crushed
/// depth of their mortar [m].
double solid_energy(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law, SolidOverlapBuffer& shared,
                    SolidOverlapBuffer& scratch, double crushed = 0);

/// Decrease of that energy per crushed depth [N], for a linear law. `shared`: the shared solid, as shared_volume leaves
/// it.
double solid_crushing_force(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law,
                            const SolidOverlapBuffer& shared, SolidOverlapBuffer& scratch, double crushed);

}  // namespace trilith
