// Meshes that may crack: the faces of elements along which a plane parts them (edges in the plane), and their parts.
#pragma once

#include <string>
#include <vector>

#include "element/solid/space_mesh.hpp"
#include "geometry/plane/mesh.hpp"
#include "model/crack_planes.hpp"

namespace trilith {

/// The section of a plane through a checked mesh. Elements whose centroid is ahead of the plane are ahead, all others
/// are behind, so the crack runs along the faces next to the plane. In space the centroid is the mean of the corners,
/// and the cut is a SpaceCut. Only for planes without mesh_plane_fault. `number`: of the plane.
CrackSection<2> mesh_section(const Mesh& mesh, const CrackPlane<2>& plane, int number);
CrackSection<3> mesh_section(const SpaceMesh& mesh, const CrackPlane<3>& plane, int number);

/// The reason why a plane does not divide a mesh into two parts along faces of its elements; "" if it does.
std::string mesh_plane_fault(const Mesh& mesh, const CrackPlane<2>& plane, int number);
std::string mesh_plane_fault(const SpaceMesh& mesh, const CrackPlane<3>& plane, int number);

/// The elements on one side of a cut, in their order, and their nodes. `M`: Mesh or SpaceMesh.
template <class M>
struct MeshPart {
  M mesh;
  std::vector<int> node;  ///< [node of mesh] in the whole mesh
};
template <class M>
MeshPart<M> part_of_mesh(const M& whole, const MeshCut& cut, bool behind);

/// [node of mesh] share of the mass of each node that the elements behind a cut have [1].
template <class M>
std::vector<double> shares_behind(const M& mesh, const MeshCut& cut);

}  // namespace trilith
