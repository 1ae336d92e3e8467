// Specification of a body of finite elements in space. World coordinates at the start.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "element/solid/space_mesh.hpp"
#include "model/builder/node_support.hpp"
#include "model/model.hpp"

namespace trilith {

/// The elements into which a body is divided.
struct SpaceForm {
  BodyKind kind = BodyKind::rigid;        ///< rigid, brick or mesh
  std::array<int, 3> divisions{1, 1, 1};  ///< for a brick-shaped solid, along its three sides
  ElementShape element = ElementShape::brick;
};

/// The elements of a brick-shaped solid, as specified in `form`; throws InputError for other shapes.
SpaceMesh mesh_of(const Polyhedron& solid, const SpaceForm& form, const std::string& owner);

/// A body of elements with all data for its rows of a model.
struct SpaceMeshBody {
  std::string name;
  CheckedSpaceMesh mesh;
  Solid solid;
  double density = 0;                      ///< [kg/m3]
  std::array<Support, 3> support{};        ///< for all nodes
  std::vector<SpaceNodeSupport> supports;  ///< for some nodes
  Vec3 velocity = Vec3::Zero();            ///< of its centre of mass [m/s]
  Vec3 spin = Vec3::Zero();                ///< [rad/s]
  int surface = 0;
};

/// brick for a single brick element, otherwise mesh.
inline BodyKind mesh_kind(const SpaceMesh& mesh) {
  return mesh.cell.size() == 1 && mesh.cell[0].shape == ElementShape::brick ? BodyKind::brick : BodyKind::mesh;
}

/// Volume of all elements [m3].
double volume_of(const SpaceMesh& mesh);
/// Centre of mass for constant density, with the mass lumped at the nodes as for the elements [m].
Vec3 centre_of(const SpaceMesh& mesh);

/// All elements as solids between their corners: the pieces of a rigid body with this shape.
std::vector<Polyhedron> solids_of(const SpaceMesh& mesh);

/// The elements on the skin as solids, for the distance of points. Their faces may be warped.
std::vector<Polyhedron> skin_of(const CheckedSpaceMesh& mesh);

}  // namespace trilith
