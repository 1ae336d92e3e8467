// Frames in space: their nodes with mass and principal axes, beams, and the skin that moves with the nodes.
#include <algorithm>

#include "base/error.hpp"
#include "base/rotation_3d.hpp"
#include "model/space_builder/space_builder.hpp"

namespace trilith {
namespace {

/// Mass and inertia tensor of a node about itself, in world axes.
struct NodeMass {
  Vec3 place = Vec3::Zero();
  double mass = 0;                                    ///< [kg]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< [kg m2]
  std::array<Support, 6> support{};
};

/// Half of a beam's mass is lumped at each node, with the rotary inertia of its section, as in the plane.
struct HalfBeam {
  double mass;   ///< [kg]
  Vec3 inertia;  ///< about x, y and z of the beam [kg m2]
};

HalfBeam half_beam(const SpaceMember& m, double per_length, double length) {
  const double half = 0.5 * per_length * length;
  const Section3& s = m.section;
  return {half, half / s.area * Vec3(s.second_moment[0] + s.second_moment[1], s.second_moment[0], s.second_moment[1])};
}

/// Supports of the body or a box apply to its nodes, otherwise the joint's supports.
std::array<Support, 6> support_of(const SpaceFrameBody& body, const Vec3& place, std::array<Support, 6> own) {
  for (std::size_t k = 0; k < own.size(); ++k)
    if (body.support[k] != Support::free) own[k] = body.support[k];
  for (const SpaceNodeSupport& hold : body.supports)
    for (std::size_t k = 0; k < hold.support.size(); ++k)
      if (is_supported_at(hold, place) && hold.support[k] != Support::free) own[k] = hold.support[k];
  return own;
}

/// From node `i` of a member to the start or end of its beams there, in world axes [m].
Vec3 arm_at(const SpaceFrameSpec& spec, const SpaceMember& member, int i) {
  if (i > 0 && i < member.divisions) return Vec3::Zero();
  const std::size_t side = i == 0 ? 0 : 1;
  if (!member.ends[side]) return Vec3::Zero();
  return *member.ends[side] - spec.joints[static_cast<std::size_t>(side == 0 ? member.from : member.to)].place;
}

std::vector<NodeMass> node_masses(const SpaceFrameBody& body) {
  const SpaceFrameSpec& spec = body.frame;
  std::vector<NodeMass> nodes;
  for (const Vec3& place : node_places(spec)) {
    const SpaceJoint joint = nodes.size() < spec.joints.size() ? spec.joints[nodes.size()] : SpaceJoint{};
    nodes.push_back(
        {place, joint.mass, joint.inertia * Eigen::Matrix3d::Identity(), support_of(body, place, joint.support)});
    if (!joint.has_block()) continue;
    const SolidMoments block = solid_moments(joint.block);
    const double density = joint.density.value_or(body.density);
    nodes.back().mass += density * block.volume, nodes.back().inertia += density * block.inertia;
  }
  for (std::size_t m = 0; m < spec.members.size(); ++m) {
    const SpaceMember& member = spec.members[m];
    const Turn3 turn = turn_of(member_axes(spec, member));
    const HalfBeam half = half_beam(member, body.material[m].mass, length_of(spec, member) / member.divisions);
    Eigen::Matrix3d axes;
    axes << turn.x(), turn.y(), turn.z();
    const Eigen::Matrix3d inertia = axes * half.inertia.asDiagonal() * axes.transpose();
    for (int i = 0; i < member.divisions; ++i)
      for (const int side : {0, 1}) {
        NodeMass& node = nodes[static_cast<std::size_t>(node_within(spec, m, i + side))];
        node.mass += half.mass, node.inertia += inertia + inertia_at(half.mass, arm_at(spec, member, i + side));
      }
  }
  return nodes;
}

void append_nodes(const SpaceFrameBody& body, const std::vector<NodeMass>& nodes, Model<3>& model) {
  double mass = 0;
  Vec3 centre = Vec3::Zero();
  for (const NodeMass& n : nodes) mass += n.mass, centre += n.mass * n.place;
  centre /= mass;
  for (const NodeMass& n : nodes) {
    const PrincipalInertia principal = principal_inertia(n.inertia);
    model.mass.push_back(n.mass), model.inertia.push_back(principal.moments);
    model.support.push_back(n.support);
    model.drive_of.emplace_back().fill(-1);
    model.start_position.push_back(n.place), model.start_rotation.push_back(principal.axes);
    model.start_velocity.emplace_back(body.velocity + cross(body.spin, Vec3(n.place - centre)));
    model.start_spin.push_back(body.spin);
    model.load.push_back(Vec3::Zero());
  }
}

/// Appends the yield rows of a member's beams: of fibres, or of hinges at its start and end.
class SpaceYieldRows {
 public:
  SpaceYieldRows(const SpaceMember& member, const BeamMaterial3& elastic, Model<3>& model)
      : member_(member), elastic_(elastic), model_(model) {
    for (const std::size_t end : {0, 1})
      if (member.hinge[end]) hinge_[end] = add_law(*member.hinge[end]);
    if (!member.fibres) return;
    section_ = static_cast<int>(model.yields_3d.sections.size());
    model.yields_3d.sections.push_back(make_fibres_in_space(member.fibres->spec));
  }
  /// `first`, `last`: the beam is the member's first or last one.
  void add(Beam3& beam, bool first, bool last, const std::array<bool, 2>& pinned) {
    if (section_ >= 0) {
      add_fibres(beam, pinned);
    } else if ((first && hinge_[0] >= 0) || (last && hinge_[1] >= 0)) {
      const std::array<int, 2> law{first && hinge_[0] >= 0 ? hinge_[0] : add_law(HingeLaw::never()),
                                   last && hinge_[1] >= 0 ? hinge_[1] : add_law(HingeLaw::never())};
      beam.yield = BeamYield::at_hinges, beam.yield_row = static_cast<int>(model_.yields_3d.hinged_beams.size());
      model_.yields_3d.hinged_beams.push_back(law);
    }
    if (beam.yield == BeamYield::never) return;
    beam.first_memory = model_.beam_memory;
    model_.beam_memory += memory_size(model_.yields_3d, beam);
  }

 private:
  int add_law(const HingeLaw& law) {
    model_.yields_3d.hinge_laws.push_back(law);
    return static_cast<int>(model_.yields_3d.hinge_laws.size()) - 1;
  }
  /// The elastic stiffness is then the largest one, for the stability limit.
  void add_fibres(Beam3& beam, const std::array<bool, 2>& pinned) const {
    BeamYields3& yields = model_.yields_3d;
    const FibreSection3& section = yields.sections[static_cast<std::size_t>(section_)];
    std::array<double, 2> shear{};
    if (elastic_.shears)
      for (const std::size_t axis : {0, 1}) shear[axis] = elastic_.shear * member_.section.shear_area[axis];
    const FibreBeam3 made =
        make_fibre_beam_in_space(section, beam.length, pinned, shear, elastic_.shear * member_.section.torsion,
                                 member_.fibres->rule, member_.fibres->stations);
    beam.stiffness = stiffest_beam(made, section);
    beam.yield = BeamYield::in_fibres, beam.yield_row = static_cast<int>(yields.fibre_beams.size());
    yields.fibre_beams.push_back({made, section_});
  }

  const SpaceMember& member_;
  const BeamMaterial3& elastic_;
  Model<3>& model_;
  int section_ = -1;
  std::array<int, 2> hinge_{-1, -1};
};

/// Reserves the memory of a beam's damping branches, after the memory of its yielding; adds its part of the bounds and
/// its consistent mass.
void complete(Beam3& beam, const SpaceMemberMaterial& made, const HalfBeam& half, const std::array<bool, 2>& pinned,
              bool consistent, Model<3>& model) {
  beam.damping = made.damping, beam.band = band_row(made.band, model.bands);
  double stiffening = 1;
  if (beam.band >= 0) {
    const DampingBranches& branches = model.bands[static_cast<std::size_t>(beam.band)];
    beam.first_branch = model.beam_memory, stiffening = branches.stiffening();
    model.beam_memory += branches.memory_size(static_cast<int>(BeamStress3{}.size()));
  }
  const double most = beam_frequency2(
      beam.stiffness, beam.length, half.mass, half.inertia,
      {turn_of(inverse(beam.axes[0])).apply(beam.arm[0]), turn_of(inverse(beam.axes[1])).apply(beam.arm[1])});
  RateBound& bound = model.element_bound.back();
  bound.stiffness = std::max(bound.stiffness, stiffening * most);
  bound.unbanded = std::max(bound.unbanded, most);
  bound.damping = std::max(bound.damping, beam.damping * most);
  if (!consistent) return;
  beam.inertia = static_cast<int>(model.beam_inertias_3d.size());
  model.beam_inertias_3d.push_back(beam_inertia_in_space(2 * half.mass, beam.length, pinned));
}

/// Bounds of the beams' rates: no frequency of all beams exceeds the highest one of a single beam on its share of the
/// nodal masses.
void append_beams(const SpaceFrameBody& body, std::size_t m, int index, int first_node, Model<3>& model) {
  const SpaceFrameSpec& spec = body.frame;
  const SpaceMember& member = spec.members[m];
  const SpaceMemberMaterial& made = body.material[m];
  model.members.push_back(
      {name_of(spec, member),
       index,
       static_cast<int>(model.beams_3d.size()),
       member.divisions,
       {spec.joints[static_cast<std::size_t>(member.from)].name, spec.joints[static_cast<std::size_t>(member.to)].name},
       made.strain_limit});
  const UnitQuaternion axes = member_axes(spec, member);
  const double length = length_of(spec, member) / member.divisions;
  const HalfBeam half = half_beam(member, made.mass, length);
  SpaceYieldRows yields(member, made.elastic, model);
  for (int i = 0; i < member.divisions; ++i) {
    Beam3 beam;
    beam.body = index, beam.length = length;
    for (const int side : {0, 1}) {
      const int node = first_node + node_within(spec, m, i + side);
      beam.node[static_cast<std::size_t>(side)] = node;
      const UnitQuaternion to_node = inverse(model.start_rotation[static_cast<std::size_t>(node)]);
      beam.axes[static_cast<std::size_t>(side)] = to_node * axes;
      const Vec3 arm = arm_at(spec, member, i + side);
      if (arm != Vec3(0, 0, 0)) beam.arm[static_cast<std::size_t>(side)] = turn_of(to_node).apply(arm);
    }
    const std::array pinned{i == 0 && member.pinned[0], i + 1 == member.divisions && member.pinned[1]};
    beam.stiffness = beam_stiffness_in_space(made.elastic, member.section, length, pinned);
    yields.add(beam, i == 0, i + 1 == member.divisions, pinned);
    complete(beam, made, half, pinned, spec.consistent, model);
    model.beams_3d.push_back(beam);
  }
}

/// The solids of all other members at a joint, and the joint's block.
std::vector<ConvexSolid> solids_beside(const SpaceFrameSpec& spec, std::size_t member, int joint) {
  std::vector<ConvexSolid> out;
  const SpaceJoint& at = spec.joints[static_cast<std::size_t>(joint)];
  if (at.has_block()) out.push_back(convex_solid(at.block, "a joint", 1e-8));
  for (std::size_t m = 0; m < spec.members.size(); ++m) {
    const SpaceMember& other = spec.members[m];
    if (m == member || (other.from != joint && other.to != joint)) continue;
    const std::vector<SkinStretch> stretches = skin_stretches(spec, m);
    for (const Polyhedron& solid : skin_solids(spec, m, other.from == joint ? stretches.front() : stretches.back()))
      out.push_back(convex_solid(solid, "a member", 1e-8));
  }
  return out;
}

/// Whether one of these solids contains all corners of a face.
bool is_covered(const Polyhedron& solid, int face, const std::vector<ConvexSolid>& by) {
  const auto holds = [&](const ConvexSolid& c, const Vec3& x) {
    for (int f = 0; f < c.shape.faces.count(); ++f) {
      const Vec3& on = c.shape.corners[static_cast<std::size_t>(c.shape.faces[f][0])];
      if (c.normals[static_cast<std::size_t>(f)].dot(x - on) > 1e-6 * c.size) return false;
    }
    return true;
  };
  return std::any_of(by.begin(), by.end(), [&](const ConvexSolid& c) {
    return std::ranges::all_of(solid.faces[face],
                               [&](int k) { return holds(c, solid.corners[static_cast<std::size_t>(k)]); });
  });
}

/// Surface at the ends of a member's section of skin: none where the next section continues; at a joint a face that no
/// solid of another member covers completely.
class StretchEnds {
 public:
  StretchEnds(const SpaceFrameSpec& spec, std::size_t m, const SkinStretch& stretch)
      : along_(turn_of(member_axes(spec, spec.members[m])).x()) {
    const SpaceMember& member = spec.members[m];
    at_joint_ = {!(stretch.from > 0), stretch.to > (1 - 1e-9) * length_of(spec, member)};
    if (at_joint_[0] && !stretch.begins) beside_[0] = solids_beside(spec, m, member.from);
    if (at_joint_[1] && !stretch.ends) beside_[1] = solids_beside(spec, m, member.to);
  }
  [[nodiscard]] bool is_surface(const Polyhedron& solid, int face, const Vec3& normal) const {
    const double way = normal.dot(along_);
    if (std::abs(way) <= 0.5) return true;
    const std::size_t end = way > 0 ? 1 : 0;
    return at_joint_[end] && !is_covered(solid, face, beside_[end]);
  }

 private:
  Vec3 along_;
  std::array<bool, 2> at_joint_;
  std::array<std::vector<ConvexSolid>, 2> beside_;
};

/// The convex solids of one section of skin in the axes of its node.
std::vector<ConvexSolid> stretch_pieces(const SpaceFrameBody& body, std::size_t m, const SkinStretch& stretch,
                                        const Vec3& place, const UnitQuaternion& rotation) {
  const UnitQuaternion back = inverse(rotation);
  const Turn3 turn = turn_of(rotation);
  const StretchEnds ends(body.frame, m, stretch);
  const std::vector<Polyhedron> solids = skin_solids(body.frame, m, stretch);
  std::vector<ConvexSolid> pieces;
  for (const Polyhedron& solid : solids)
    pieces.push_back(convex_solid(placed(placed(solid, {}, -place), back, Vec3::Zero()), body.name, 1e-8));
  mark_inner_faces(pieces);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    ConvexSolid& piece = pieces[p];
    const int faces = piece.shape.faces.count();
    if (piece.surface.empty()) piece.surface.assign(static_cast<std::size_t>(faces), 1);
    for (int f = 0; f < faces; ++f) {
      const auto row = static_cast<std::size_t>(f);
      if (!ends.is_surface(solids[p], f, turn.apply(piece.normals[row]))) piece.surface[row] = 0;
    }
  }
  return pieces;
}

/// The block of a joint in the axes of its node.
ConvexSolid block_piece(const SpaceFrameBody& body, std::size_t joint, const UnitQuaternion& rotation) {
  const SpaceJoint& at = body.frame.joints[joint];
  return convex_solid(placed(placed(at.block, {}, -at.place), inverse(rotation), Vec3::Zero()), body.name, 1e-8);
}

}  // namespace

int SpaceBuilder::add(const SpaceFrameBody& body) {
  require_new_body(body.name);
  const auto index = static_cast<int>(model_.bodies.size());
  Body row;
  row.name = body.name, row.kind = BodyKind::frame, row.surface = body.surface;
  row.first_node = model_.nodes(), row.first_skin = static_cast<int>(model_.skin_place.size());
  row.first_piece = model_.pieces();
  const std::vector<NodeMass> nodes = node_masses(body);
  row.nodes = static_cast<int>(nodes.size());
  append_nodes(body, nodes, model_);
  model_.element_bound.resize(static_cast<std::size_t>(index));
  model_.element_bound.emplace_back();
  if (model_.piece_first.empty()) model_.piece_first.push_back(0);
  Vec3 low = Vec3::Constant(unbounded), high = -low;
  const auto take = [&](const ConvexSolid& piece, std::size_t n) {
    add_piece(piece, static_cast<int>(n), index);
    const Turn3 turn = turn_of(model_.start_rotation[n]);
    for (const Vec3& x : piece.shape.corners) {
      const Vec3 corner = model_.start_position[n] + turn.apply(x);
      low = low.cwiseMin(corner), high = high.cwiseMax(corner);
    }
  };
  const auto first = static_cast<std::size_t>(row.first_node);
  for (std::size_t j = 0; j < body.frame.joints.size(); ++j)
    if (body.frame.joints[j].has_block()) take(block_piece(body, j, model_.start_rotation[first + j]), first + j);
  for (std::size_t m = 0; m < body.frame.members.size(); ++m) {
    append_beams(body, m, index, row.first_node, model_);
    for (const SkinStretch& stretch : skin_stretches(body.frame, m)) {
      const auto n = first + static_cast<std::size_t>(stretch.node);
      for (const ConvexSolid& piece :
           stretch_pieces(body, m, stretch, model_.start_position[n], model_.start_rotation[n]))
        take(piece, n);
    }
  }
  model_.body_radius.push_back(0.5 * (high - low).norm());
  row.pieces = model_.pieces() - row.first_piece;
  row.skins = static_cast<int>(model_.skin_place.size()) - row.first_skin;
  model_.surfaces = std::max(model_.surfaces, body.surface + 1);
  model_.bodies.push_back(row);
  return index;
}

}  // namespace trilith
