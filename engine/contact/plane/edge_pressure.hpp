// The pressure of contact/space/solid_pressure.hpp between two solids of few faces, as boxes are, for a fraction of the
// work.
//
// Comes in: two solids that may touch, and how they move. Goes out: the same integrals, exact to rounding, of a law
// whose pressure goes with the depth and that crushes nothing. The shared solid is found from edges
// (geometry/plane/edge_overlap.hpp). Each of its faces is divided along the lines that are equally near to two faces of
// the other solid. Over each of the resulting triangles the pressure is linear
// (contact/space/pressed_triangles.hpp).
#pragma once

#include <vector>

#include "contact/space/solid_pressure.hpp"

namespace trilith {

/// Whether edge_pressure may be asked: both have few faces, all of them surface, see geometry/plane/edge_overlap.hpp.
bool have_few_faces(const PlacedSolid& a, const PlacedSolid& b);

/// True where the two surely share a part and `out` has its pressure: `kn` [Pa/m] times the depth, damped over `beta`
/// [s]. False of solids that are apart, or nearly so, or that a longer way must part. The pose alone decides.
bool edge_pressure(const MovingSolid& a, const MovingSolid& b, double kn, double beta, std::vector<FourTriangles>& room,
                   SolidPressure& out);

}  // namespace trilith
