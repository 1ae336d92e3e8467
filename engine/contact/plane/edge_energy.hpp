// The elastic energy of two solids with few faces, from the triangles that carry their pressure.
//
// The energy is kn / 2 times the integrals over the shared solid V of the depths phi_a and phi_b below the nearest face
// of each. If a point o lies on all faces of a that are nearest somewhere in V, phi_a is homogeneous about o:
//
//     div(phi_a (x - o)) = 4 phi_a,    integral of phi_a over V = 1/4 integral of phi_a (x - o) . n over b's faces in
//     a,
//
// because phi_a is 0 on a's own faces. So no cell of V has to be cut out. Up to three faces have such a point: all
// contacts of a face, an edge or a corner.
#pragma once

#include <vector>

#include "geometry/space/convex_solid.hpp"
#include "geometry/space/triangle_lanes.hpp"

namespace trilith {

/// Integral of phi_a + phi_b over the shared solid [m4], exact to rounding. Both solids have few faces
/// (have_few_faces). False, without a result, where they share nothing, the shared solid is not found from the edges,
/// or its depth has no such point. `room`: scratch.
bool edge_depths(const PlacedSolid& a, const PlacedSolid& b, std::vector<FourTriangles>& room, double& depths);

}  // namespace trilith
