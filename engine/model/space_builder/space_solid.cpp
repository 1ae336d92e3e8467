#include "model/space_builder/space_solid.hpp"

#include <algorithm>

namespace trilith {

SpaceMesh mesh_of(const Polyhedron& solid, const SpaceForm& form, const std::string& owner) {
  return divided_into(form.element, brick_grid(brick_corners(solid, owner), form.divisions));
}

double volume_of(const SpaceMesh& mesh) {
  double sum = 0;
  for (std::size_t e = 0; e < mesh.cell.size(); ++e) sum += node_shares(mesh.cell[e].shape, nodes_of(mesh, e)).volume;
  return sum;
}

Vec3 centre_of(const SpaceMesh& mesh) {
  double volume = 0;
  Vec3 sum = Vec3::Zero();
  for (std::size_t e = 0; e < mesh.cell.size(); ++e) {
    const std::vector<Vec3> nodes = nodes_of(mesh, e);
    const ElementVolume shares = node_shares(mesh.cell[e].shape, nodes);
    volume += shares.volume;
    for (std::size_t i = 0; i < nodes.size(); ++i) sum += shares.share[i] * shares.volume * nodes[i];
  }
  return sum / volume;
}

std::vector<Polyhedron> solids_of(const SpaceMesh& mesh) {
  std::vector<Polyhedron> out;
  for (std::size_t e = 0; e < mesh.cell.size(); ++e) {
    const ElementShapeInfo& info = info_of(mesh.cell[e].shape);
    Polyhedron& solid = out.emplace_back();
    solid.corners = nodes_of(mesh, e);
    solid.corners.resize(static_cast<std::size_t>(info.corners));
    for (int f = 0; f < info.faces; ++f) solid.faces.add(info.corners_of_face(f));
  }
  return out;
}

std::vector<Polyhedron> skin_of(const CheckedSpaceMesh& checked) {
  std::vector<Polyhedron> out;
  for (std::size_t e = 0; e < checked.mesh.cell.size(); ++e) {
    const auto& surface = checked.surface[e];
    if (std::none_of(surface.begin(), surface.end(), [](std::uint8_t s) { return s != 0; })) continue;
    const ElementShapeInfo& info = info_of(checked.mesh.cell[e].shape);
    Polyhedron& solid = out.emplace_back();
    solid.corners = nodes_of(checked.mesh, e);
    solid.corners.resize(static_cast<std::size_t>(info.corners));
    for (int f = 0; f < info.faces; ++f)
      if (surface[static_cast<std::size_t>(f)] != 0) solid.faces.add(info.corners_of_face(f));
  }
  return out;
}

}  // namespace trilith
