// Frames of the model builder in space: their check, and their rows in the model.
#include <algorithm>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "model/space_builder/frame_skin.hpp"
#include "model/space_builder/solid_model_builder.hpp"
#include "model/space_builder/space_builder.hpp"

namespace trilith {
namespace {

/// Centre of mass of the nodes [m].
Vec3 centre_of_mass(const std::vector<NodeMass<3>>& nodes, const std::vector<Vec3>& place) {
  double mass = 0;
  Vec3 centre = Vec3::Zero();
  for (std::size_t n = 0; n < nodes.size(); ++n) mass += nodes[n].mass, centre += nodes[n].mass * place[n];
  return centre / mass;
}

}  // namespace

/// The initial skin becomes the pieces of the body, for bearings that must be near it.
void SolidModelBuilder::check_frame(SolidSpec& spec, const std::string& owner) const {
  begin_at_blocks(*spec.frame);
  const FramePlanOf<3> plan = plan_frame(*spec.frame, owner);
  refuse_idle_holds(spec.supports, plan.node, owner);
  if (spec.density) require_positive(*spec.density, owner + ": density", "kg/m3");
  if (spec.mass) require_positive(*spec.mass, owner + ": mass", "kg");
  if (spec.density && spec.mass) throw InputError(owner + ": both density and mass are given; keep one");
  check_member_materials(*spec.frame, spec.material, materials_, owner);
  spec.pieces = skin_solids(*spec.frame, plan);
}

SpaceFrameBody SolidModelBuilder::frame_body(const SolidSpec& spec) const {
  const std::string owner = "body '" + spec.name + "'";
  const FrameMass mass{spec.material, spec.density, spec.mass};
  return {spec.name,
          *spec.frame,
          plan_frame(*spec.frame, owner),
          member_materials(*spec.frame, mass, materials_, owner),
          block_density(mass, materials_),
          spec.velocity,
          spec.spin,
          spec.support,
          spec.supports};
}

int SpaceBuilder::add(const SpaceFrameBody& body) {
  require_new_body(body.name);
  const auto index = static_cast<int>(model_.bodies.size());
  Body row;
  row.name = body.name, row.kind = BodyKind::frame;
  row.first_node = model_.nodes(), row.nodes = static_cast<int>(body.plan.node.size());
  row.first_skin = static_cast<int>(model_.skin_place.size()), row.first_piece = model_.pieces();
  const std::vector<NodeMass<3>> nodes = node_masses(body, 0);
  append_nodes(body, nodes, centre_of_mass(nodes, body.plan.node), model_);
  std::array<int, Space<3>::dofs> no_drive;
  no_drive.fill(-1);
  model_.drive_of.resize(static_cast<std::size_t>(model_.nodes()), no_drive);
  model_.element_bound.resize(static_cast<std::size_t>(index) + 1);
  append_beams(body, index, row.first_node, model_);
  if (model_.piece_first.empty()) model_.piece_first.push_back(0);
  const std::vector<UnitQuaternion> rotation(model_.start_rotation.begin() + row.first_node,
                                             model_.start_rotation.end());
  Vec3 low = Vec3::Constant(unbounded), high = -low;
  for (const auto& [node, piece] : skin_pieces(body, rotation)) {
    add_piece(piece, row.first_node + node, index);
    const Turn3 turn = turn_of(rotation[static_cast<std::size_t>(node)]);
    for (const Vec3& x : piece.shape.corners) {
      const Vec3 corner = body.plan.node[static_cast<std::size_t>(node)] + turn.apply(x);
      low = low.cwiseMin(corner), high = high.cwiseMax(corner);
    }
  }
  model_.body_radius.push_back(0.5 * (high - low).norm());
  row.pieces = model_.pieces() - row.first_piece;
  row.skins = static_cast<int>(model_.skin_place.size()) - row.first_skin;
  model_.surfaces = std::max(model_.surfaces, row.surface + 1);
  model_.bodies.push_back(row);
  return index;
}

}  // namespace trilith
