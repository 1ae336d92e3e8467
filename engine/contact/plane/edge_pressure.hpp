// The pressure of contact/space/solid_pressure.hpp for two solids with few faces, such as boxes, at a fraction of the
// cost.
//
// Input: two solids that may touch, and their motion. Output: the same integrals, exact to rounding, for laws with
// pressure proportional to the depth and without crushing. The shared solid is found from edges
// (geometry/plane/edge_overlap.hpp). Each of its faces is divided along the lines that are equally near to two faces of
// the other solid. Over each of the resulting triangles the pressure is linear (contact/space/pressed_triangles.hpp).
#pragma once

#include <vector>

#include "contact/space/solid_pressure.hpp"
#include "contact/space/triangle_sums.hpp"
#include "geometry/plane/edge_overlap.hpp"

namespace trilith {

/// Whether edge_pressure is applicable: both have few faces, all of them surface, see geometry/plane/edge_overlap.hpp.
bool have_few_faces(const PlacedSolid& a, const PlacedSolid& b);

/// True where the two surely overlap; `out` are then the sums over their pressed triangles, with the pressure damped
/// over `beta` [s]. False where the solids are apart, nearly so, or need the general method. Depends on the positions
/// alone. `known`: see edge_overlap.
bool edge_sums(const MovingSolid& a, const MovingSolid& b, double beta, std::vector<FourTriangles>& room, PairSums& out,
               OverlapTopology* known = nullptr);

/// The same; `out` is the pressure from these sums, `kn` [Pa/m] times the depth.
bool edge_pressure(const MovingSolid& a, const MovingSolid& b, double kn, double beta, std::vector<FourTriangles>& room,
                   SolidPressure& out);

}  // namespace trilith
