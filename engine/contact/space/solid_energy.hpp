// The elastic energy that contact/space/solid_pressure.hpp has its forces from.
#pragma once

#include "geometry/space/overlap_3d.hpp"
#include "law/contact/list.hpp"

namespace trilith {

/// Of the normal pressures of two solids; without shear [J]. `shared`, `scratch`: room; `crushed`: depth by which their
/// mortar is crushed [m].
double solid_energy(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law, SolidOverlapBuffer& shared,
                    SolidOverlapBuffer& scratch, double crushed = 0);

/// The force with which that energy gives way as the depth crushed grows [N], of a law that is linear. `shared`: what
/// the two share, as shared_volume leaves it.
double solid_crushing_force(const PlacedSolid& a, const PlacedSolid& b, const LawInUse& law,
                            const SolidOverlapBuffer& shared, SolidOverlapBuffer& scratch, double crushed);

}  // namespace trilith
