// A body of finite elements in space to be. World coordinates at the start.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "element/solid/space_mesh.hpp"
#include "model/builder/node_support.hpp"
#include "model/model.hpp"

namespace trilith {

/// Which elements a body is divided into.
struct SpaceForm {
  BodyKind kind = BodyKind::rigid;        ///< rigid, brick or mesh
  std::array<int, 3> divisions{1, 1, 1};  ///< of a solid that is a brick, along its three sides
  ElementShape element = ElementShape::brick;
};

/// The elements of a solid that has the shape of a brick, as `form` says; throws InputError where it has not.
SpaceMesh mesh_of(const Polyhedron& solid, const SpaceForm& form, const std::string& owner);

/// A body of elements with all that its rows of a model are made from.
struct SpaceMeshBody {
  std::string name;
  CheckedSpaceMesh mesh;
  Solid solid;
  double density = 0;                      ///< [kg/m3]
  std::array<Support, 3> support{};        ///< of all nodes
  std::vector<SpaceNodeSupport> supports;  ///< of some
  Vec3 velocity = Vec3::Zero();            ///< of its centre of mass [m/s]
  Vec3 spin = Vec3::Zero();                ///< [rad/s]
  int surface = 0;
};

/// One brick, or a mesh.
inline BodyKind mesh_kind(const SpaceMesh& mesh) {
  return mesh.cell.size() == 1 && mesh.cell[0].shape == ElementShape::brick ? BodyKind::brick : BodyKind::mesh;
}

/// Volume of all elements [m3].
double volume_of(const SpaceMesh& mesh);
/// Where the centre of mass of one density is, with its mass lumped at the nodes as the elements do [m].
Vec3 centre_of(const SpaceMesh& mesh);

/// All elements as solids between their corners: the pieces of a rigid body of that shape.
std::vector<Polyhedron> solids_of(const SpaceMesh& mesh);

/// The elements on the skin as solids, for what wants to know how near a point is. Their faces may be warped.
std::vector<Polyhedron> skin_of(const CheckedSpaceMesh& mesh);

}  // namespace trilith
