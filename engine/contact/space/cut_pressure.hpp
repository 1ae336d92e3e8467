// Normal pressure of two solids by cutting one with the faces of the other, for pairs that the fast methods of
// contact/space/solid_contact.hpp do not know.
#pragma once

#include "contact/space/solid_contact.hpp"

namespace trilith {

/// pressure_between() for two solids that do not lie flat on each other, without contact/plane/edge_pressure.hpp.
SolidPressure cut_pressure(const MovingSolid& a, const MovingSolid& b, const LawInUse& law, Separation3& apart,
                           SolidOverlapBuffer& shared, double crushed, const Vec3* along);

}  // namespace trilith
