// Bodies of finite elements in space: their nodes, elements, and the pieces of their skin.
#include <algorithm>

#include "base/error.hpp"
#include "model/element/space_element_rows.hpp"
#include "model/space_builder/mesh_skin.hpp"
#include "model/space_builder/space_builder.hpp"

namespace trilith {
namespace {

/// Without rotation; masses are added with the elements.
void append_nodes(const SpaceMeshBody& body, Model<3>& model) {
  for (const Vec3& place : body.mesh.mesh.node) {
    std::array<Support, 6> support{body.support[0], body.support[1], body.support[2],
                                   Support::fixed,  Support::fixed,  Support::fixed};
    for (const SpaceNodeSupport& hold : body.supports)
      for (std::size_t k = 0; k < 3; ++k)
        if (is_supported_at(hold, place) && hold.support[k] != Support::free) support[k] = hold.support[k];
    model.mass.push_back(0), model.inertia.push_back(Vec3::Zero());
    model.support.push_back(support);
    model.drive_of.emplace_back().fill(-1);
    model.start_position.push_back(place), model.start_rotation.emplace_back();
    model.start_velocity.push_back(body.velocity), model.start_spin.push_back(Vec3::Zero());
    model.load.push_back(Vec3::Zero());
  }
}

int solid_index(Model<3>& model, const Solid& solid) {
  const auto at = std::find(model.solids.begin(), model.solids.end(), solid);
  const auto index = static_cast<int>(at - model.solids.begin());
  if (at == model.solids.end()) model.solids.push_back(solid);
  return index;
}

/// Spin about the centre of mass; returns the largest distance of a node from it [m].
double set_spin(const SpaceMeshBody& body, int first, Model<3>& model) {
  double mass = 0, radius = 0;
  Vec3 centre = Vec3::Zero();
  const auto from = static_cast<std::size_t>(first);
  for (std::size_t n = from; n < model.mass.size(); ++n)
    mass += model.mass[n], centre += model.mass[n] * model.start_position[n];
  centre /= mass;
  for (std::size_t n = from; n < model.mass.size(); ++n) {
    const Vec3 arm = model.start_position[n] - centre;
    model.start_velocity[n] += cross(body.spin, arm);
    radius = std::max(radius, arm.norm());
  }
  return radius;
}

}  // namespace

int SpaceBuilder::add(const SpaceMeshBody& body) {
  require_new_body(body.name);
  const SpaceMesh& mesh = body.mesh.mesh;
  const auto index = static_cast<int>(model_.bodies.size());
  Body row;
  row.name = body.name, row.surface = body.surface;
  row.kind = mesh_kind(mesh);
  row.first_node = model_.nodes(), row.nodes = static_cast<int>(mesh.node.size());
  row.first_skin = static_cast<int>(model_.skin_place.size()), row.first_piece = model_.pieces();
  row.first_fit = static_cast<int>(model_.fits.size());
  append_nodes(body, model_);
  model_.element_bound.resize(static_cast<std::size_t>(index));
  model_.element_bound.emplace_back();
  if (model_.piece_first.empty()) model_.piece_first.push_back(0);
  SpaceElement element;
  element.body = index, element.solid = solid_index(model_, body.solid);
  for (std::size_t e = 0; e < mesh.cell.size(); ++e) {
    const SpaceCell& cell = mesh.cell[e];
    const auto nodes = static_cast<std::size_t>(info_of(cell.shape).nodes);
    element.shape = cell.shape;
    for (std::size_t i = 0; i < nodes; ++i) element.node[i] = row.first_node + cell.node[i];
    append_element(model_, element, body.density);
    const auto surface = std::span(body.mesh.surface[e]).first(static_cast<std::size_t>(info_of(cell.shape).faces));
    if (std::any_of(surface.begin(), surface.end(), [](std::uint8_t s) { return s != 0; }))
      append_element_piece(model_, element, surface);
  }
  find_faces_in_line(model_, row.first_piece);
  find_bounds(model_, row.first_piece);
  model_.body_radius.push_back(set_spin(body, row.first_node, model_));
  row.pieces = model_.pieces() - row.first_piece;
  row.skins = static_cast<int>(model_.skin_place.size()) - row.first_skin;
  row.fits = static_cast<int>(model_.fits.size()) - row.first_fit;
  model_.surfaces = std::max(model_.surfaces, body.surface + 1);
  model_.bodies.push_back(row);
  return index;
}

}  // namespace trilith
