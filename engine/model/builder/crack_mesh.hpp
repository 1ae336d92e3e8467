// Meshes in the plane that may crack: the edges of elements along which a plane parts them, and their parts.
#pragma once

#include <string>
#include <vector>

#include "geometry/plane/mesh.hpp"
#include "model/crack_planes.hpp"

namespace trilith {

/// The section of a plane through a checked mesh. Elements whose centroid is ahead of the plane are ahead, all others
/// are behind, so the crack runs along the edges next to the plane. Only for planes without mesh_plane_fault.
/// `number`: of the plane.
CrackSection<2> mesh_section(const Mesh& mesh, const CrackPlane<2>& plane, int number);

/// The reason why a plane does not divide a mesh into two parts along edges of its elements; "" if it does.
std::string mesh_plane_fault(const Mesh& mesh, const CrackPlane<2>& plane, int number);

/// The elements on one side of a cut, in their order, and their nodes.
struct MeshPart {
  Mesh mesh;
  std::vector<int> node;  ///< [node of mesh] in the whole mesh
};
MeshPart part_of_mesh(const Mesh& whole, const MeshCut& cut, bool behind);

/// [node of mesh] share of the mass of each node that the elements behind a cut have [1].
std::vector<double> shares_behind(const Mesh& mesh, const MeshCut& cut);

}  // namespace trilith
