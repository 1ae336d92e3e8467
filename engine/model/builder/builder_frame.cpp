// Frames: their nodes, beams, sections as skin, and the pieces between these.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "element/beam/beam_element.hpp"
#include "model/builder/builder.hpp"
#include "model/builder/frame.hpp"
#include "model/builder/frame_ends.hpp"
#include "model/flatness.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// A frame during its conversion to rows of the model.
struct FrameRows {
  const BodySpec& spec;
  const FrameSpec& frame;
  const FramePlan& plan;
  Model<2>& model;
  int body, first_node, first_skin;
  std::vector<std::vector<std::array<int, 2>>> skin = {};  ///< [member][station] of its bottom and top
  std::vector<std::vector<int>> block_skin = {};           ///< [joint][corner] of its block
};

/// Supports of the nodes inside a box of spec.supports.
std::array<Support, 3> support_of(const BodySpec& spec, const Vec2& place, std::array<Support, 3> own) {
  for (int k = 0; k < 3; ++k)
    if (spec.support[k] != Support::free) own[k] = spec.support[k];
  for (const NodeSupport& hold : spec.supports)
    for (const int k : {0, 1})
      if (is_supported_at(hold, place) && hold.support[k] != Support::free) own[k] = hold.support[k];
  return own;
}

/// Mass [kg] of a joint's block, and inertia about the joint, its centroid [kg m2].
std::array<double, 2> mass_of_block(const FrameJoint& joint, double density, double thickness) {
  if (joint.block.empty()) return {};
  const PolygonMoments moments = polygon_moments(joint.block);
  const double plate = joint.density.value_or(density) * joint.thickness.value_or(thickness);
  return {plate * moments.area, plate * moments.second_moment};
}

/// `density`: of blocks [kg/m3].
void append_nodes(const FrameRows& rows, const Vec2& centre, double density) {
  Model<2>& model = rows.model;
  for (std::size_t n = 0; n < rows.plan.node.size(); ++n) {
    const Vec2& place = rows.plan.node[n];
    const FrameJoint* const joint = n < rows.frame.joints.size() ? &rows.frame.joints[n] : nullptr;
    const auto [mass, inertia] =
        joint != nullptr ? mass_of_block(*joint, density, model.thickness) : std::array<double, 2>{};
    model.mass.push_back(joint != nullptr ? joint->mass + mass : 0);
    model.inertia.push_back(joint != nullptr ? joint->inertia + inertia : 0);
    model.support.push_back(support_of(rows.spec, place, joint != nullptr ? joint->support : std::array<Support, 3>{}));
    model.start_position.push_back(place);
    model.start_rotation.push_back(0);
    model.start_velocity.emplace_back(rows.spec.velocity + cross(rows.spec.spin, Vec2(place - centre)));
    model.start_spin.push_back(rows.spec.spin);
    model.load.push_back(Vec2::Zero());
  }
}

/// Half of a beam's mass is lumped at each node, with the rotary inertia of its section. With more inertia a member of
/// few beams would rotate too slowly, with less the stable step would be shorter.
struct EndMass {
  double mass;                    ///< [kg]
  std::array<double, 2> inertia;  ///< [kg m2]
};
EndMass end_mass(const Beam& beam, double mass, const Section& section) {
  const double half = 0.5 * mass, own = section.second_moment / section.area;
  return {half, {half * (own + beam.arm[0].squaredNorm()), half * (own + beam.arm[1].squaredNorm())}};
}

void add_masses(const FrameRows& rows, const Beam& beam, const EndMass& end) {
  const Turn axes(beam.angle);
  for (const std::size_t side : {0, 1}) {
    rows.model.mass[beam.node[side]] += end.mass;
    rows.model.inertia[beam.node[side]] += end.inertia[side];
  }
  const double most = beam_frequency2(beam.stiffness, beam.length, {axes.undo(beam.arm[0]), axes.undo(beam.arm[1])},
                                      {end.mass, end.mass}, end.inertia);
  RateBound& bound = rows.model.element_bound[rows.body];
  const double stiffening = beam.band < 0 ? 1 : rows.model.bands[beam.band].stiffening();
  bound.stiffness = std::max(bound.stiffness, stiffening * most);
  bound.unbanded = std::max(bound.unbanded, most);
  bound.damping = std::max(bound.damping, beam.damping * most);
}

/// Appends the yield rows of a member's beams, in fibres or at its ends. The inner beams of a member with hinges are
/// elastic. For fibres the elastic stiffness is the largest one, for the stability limit.
class YieldRows {
 public:
  YieldRows(const FrameMember& member, double shear_modulus, Model<2>& model)
      : member_(member), shear_(member.shear ? shear_modulus * member.section.shear_area : 0), model_(model) {
    if (const auto* const fibres = std::get_if<MemberFibres>(&member.yields)) {
      section_ = static_cast<int>(model.yields.sections.size());
      model.yields.sections.push_back(make_fibres(fibres->spec));
    }
    if (const auto* const hinges = std::get_if<MemberHinges>(&member.yields))
      for (const int end : {0, 1}) hinge_[end] = add_law(hinges->end[end]);
  }

  /// `first`, `last`: the beam is the member's first or last one.
  void add(Beam& beam, bool first, bool last, const std::array<bool, 2>& pinned) {
    BeamYields& yields = model_.yields;
    if (const auto* const fibres = std::get_if<MemberFibres>(&member_.yields)) {
      const FibreBeam made =
          make_fibre_beam(yields.sections[section_], beam.length, pinned, shear_, fibres->rule, fibres->stations);
      beam.yield = BeamYield::in_fibres, beam.yield_row = static_cast<int>(yields.fibre_beams.size());
      beam.stiffness = stiffest_beam(made, yields.sections[section_]);
      yields.fibre_beams.push_back({made, section_});
    } else if ((first && hinge_[0] >= 0) || (last && hinge_[1] >= 0)) {
      const std::array<int, 2> law{first && hinge_[0] >= 0 ? hinge_[0] : add_law(HingeLaw::never()),
                                   last && hinge_[1] >= 0 ? hinge_[1] : add_law(HingeLaw::never())};
      beam.yield = BeamYield::at_hinges, beam.yield_row = static_cast<int>(yields.hinged_beams.size());
      yields.hinged_beams.push_back(law);
    }
    beam.first_memory = model_.beam_memory;
    model_.beam_memory += memory_size(yields, beam);
  }

 private:
  int add_law(const std::optional<HingeLaw>& law) {
    if (!law) return -1;
    model_.yields.hinge_laws.push_back(*law);
    return static_cast<int>(model_.yields.hinge_laws.size()) - 1;
  }

  const FrameMember& member_;
  double shear_;  ///< G A_s [N]
  Model<2>& model_;
  int section_ = -1;
  std::array<int, 2> hinge_{-1, -1};
};

/// Material data of a member: mass per length, elasticity and damping.
struct MemberMaterial {
  double mass;  ///< [kg/m]
  BeamMaterial elastic;
  double damping;  ///< [s]
  int band;        ///< index into Model::bands, or -1
  double strain_limit;
};

/// Reserves the memory of a beam's damping branches, after the memory of its yielding.
void add_branches(Beam& beam, int band, Model<2>& model) {
  if (band < 0) return;
  beam.band = band, beam.first_branch = model.beam_memory;
  model.beam_memory += model.bands[band].memory_size();
}

void append_beams(const FrameRows& rows, std::size_t m, const MemberMaterial& made) {
  const FrameMember& member = rows.frame.members[m];
  const std::vector<Station>& stations = rows.plan.stations[m];
  rows.model.members.push_back({name_of(rows.frame, member),
                                rows.body,
                                static_cast<int>(rows.model.beams.size()),
                                static_cast<int>(stations.size()) - 1,
                                {rows.frame.joints[member.from].name, rows.frame.joints[member.to].name},
                                made.strain_limit});
  YieldRows yields(member, made.elastic.shear, rows.model);
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    Beam beam;
    beam.body = rows.body;
    for (const std::size_t side : {0, 1}) {
      beam.node[side] = rows.first_node + stations[i + side].node;
      beam.arm[side] = stations[i + side].arm;
    }
    const Vec2 along = rows.plan.place_of(stations[i + 1]) - rows.plan.place_of(stations[i]);
    beam.length = along.norm();
    beam.angle = portable::atan2(along.y(), along.x());
    beam.damping = made.damping;
    const std::array pinned{i == 0 && member.pinned[0], i + 2 == stations.size() && member.pinned[1]};
    beam.stiffness = beam_stiffness(made.elastic, member.section, beam.length, pinned);
    yields.add(beam, i == 0, i + 2 == stations.size(), pinned);
    add_branches(beam, made.band, rows.model);
    const EndMass end = end_mass(beam, made.mass * beam.length, member.section);
    add_masses(rows, beam, end);
    if (rows.frame.consistent) {
      BeamInertia inertia = beam_inertia(made.mass * beam.length, beam.length, member.section, pinned);
      inertia.lumped = end.mass, inertia.turning = end.inertia;
      beam.inertia = static_cast<int>(rows.model.beam_inertias.size());
      rows.model.beam_inertias.push_back(inertia);
    }
    rows.model.beams.push_back(beam);
  }
}

/// Skin points in the order of the outline. An arm is given in the axes of the node with which it rotates.
void append_skin(FrameRows& rows) {
  for (const auto& stations : rows.plan.stations) rows.skin.emplace_back(stations.size());
  for (const FrameJoint& joint : rows.frame.joints) rows.block_skin.emplace_back(joint.block.size());
  for (const auto& [m, i, side, joint] : rows.plan.outline) {
    if (joint >= 0) {
      rows.block_skin[joint][side] = static_cast<int>(rows.model.skin_place.size());
      rows.model.skin_place.emplace_back(rows.frame.joints[joint].block[side] - rows.frame.joints[joint].place);
      rows.model.skin_node.push_back(rows.first_node + joint);
      rows.model.skin_turn.push_back(rows.first_node + joint);
      continue;
    }
    const Station& station = rows.plan.stations[m][i];
    rows.skin[m][i][side] = static_cast<int>(rows.model.skin_place.size());
    rows.model.skin_place.emplace_back(station.arm + section_edge(rows.frame, rows.plan, m, side));
    rows.model.skin_node.push_back(rows.first_node + station.node);
    rows.model.skin_turn.push_back(rows.first_node + station.turn);
  }
}

/// Position of a frame's skin point at the start.
Vec2 start_of(const FrameRows& rows, int skin) {
  return rows.model.start_position[rows.model.skin_node[skin]] + rows.model.skin_place[skin];
}

void append_piece(const FrameRows& rows, const std::vector<int>& skin, const ConvexPiece& piece) {
  Model<2>& model = rows.model;
  Polygon outline;
  for (const int s : skin) outline.push_back(start_of(rows, s));
  const PieceEdges edges = piece_edges(outline, piece);
  model.piece_body.push_back(rows.body);
  model.piece_first.push_back(static_cast<int>(model.corner_skin.size()));
  for (std::size_t c = 0; c < edges.corner.size(); ++c) {
    model.corner_skin.push_back(skin[edges.corner[c]]);
    model.edge_is_face.push_back(edges.is_face[c]);
    model.edge_corner.push_back(edges.flatness[c]);
  }
}

/// A piece for each block and for each beam: its two long sides are faces, and its ends where nothing covers them.
void append_frame_pieces(const FrameRows& rows) {
  for (std::size_t m = 0; m < rows.skin.size(); ++m) {
    const auto is_face = [&](int side) { return end_is_face(rows.frame, rows.plan, static_cast<int>(m), side); };
    const std::array<bool, 2> face{is_face(0), is_face(1)};
    for (std::size_t i = 0; i + 1 < rows.skin[m].size(); ++i) {
      const auto& near = rows.skin[m][i];
      const auto& far = rows.skin[m][i + 1];
      const bool begins = i == 0 && face[0], ends = i + 2 == rows.skin[m].size() && face[1];
      append_piece(rows, {near[0], far[0], far[1], near[1]}, {{0, 1, 2, 3}, {0, ends ? 1 : -1, 2, begins ? 3 : -1}});
    }
  }
  for (const std::vector<int>& block : rows.block_skin) {
    if (block.empty()) continue;
    std::vector<int> all(block.size());
    std::iota(all.begin(), all.end(), 0);
    append_piece(rows, block, {all, all});
  }
}

const Material* find_material(const std::vector<Material>& materials, const std::string& name) {
  const auto found =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return found == materials.end() ? nullptr : &*found;
}

double density_of(const std::vector<Material>& materials, const std::string& name) {
  const Material* const material = find_material(materials, name);
  return material == nullptr ? 0 : material->density;
}

double length_of(const FramePlan& plan, std::size_t member) {
  const std::vector<Station>& stations = plan.stations[member];
  return (plan.place_of(stations.back()) - plan.place_of(stations.front())).norm();
}

/// For each member; if the body's mass or weight is given, all masses are scaled to it.
std::vector<MemberMaterial> member_materials(const FrameRows& rows, const std::vector<Material>& materials) {
  const BodySpec& spec = rows.spec;
  std::vector<MemberMaterial> made;
  double given = 0;
  for (std::size_t m = 0; m < rows.frame.members.size(); ++m) {
    const FrameMember& member = rows.frame.members[m];
    const Material& material = *find_material(materials, member.material.empty() ? spec.material : member.material);
    const auto [young, poisson] =
        std::visit([](const auto& l) { return std::pair(l.young, l.poisson); }, material.solid->law);
    made.push_back({spec.density.value_or(material.density) * member.section.area,
                    {young, member.shear ? young / (2 * (1 + poisson)) : 0.0},
                    material.solid->damping(),
                    band_row(material.band, rows.model.bands),
                    material.solid->strain_limit});
    given += made.back().mass * length_of(rows.plan, m);
  }
  const double wanted = spec.mass ? *spec.mass : spec.weight ? *spec.weight / standard_gravity : given;
  for (MemberMaterial& m : made) m.mass *= wanted / given;
  return made;
}

/// Throws InputError, with `what` in front, if a member of `length` [m] cannot yield as specified.
void check_yields(const FrameMember& member, const Material& material, const std::string& what, double length,
                  bool consistent) {
  const auto* const hinges = std::get_if<MemberHinges>(&member.yields);
  const double young = std::visit([](const auto& l) { return l.young; }, material.solid->law);
  try {
    if (const auto* const fibres = std::get_if<MemberFibres>(&member.yields))
      make_fibre_beam(make_fibres(fibres->spec), length, member.pinned, 0, fibres->rule, fibres->stations);
    for (const int end : {0, 1}) {
      if (hinges == nullptr || !hinges->end[end]) continue;
      const HingeLaw& law = *hinges->end[end];
      check_parameters(law), law.check();
      if (law.removes && consistent)
        throw InputError(
            "end_hinge: a removed member keeps its mass at its nodes; leave out mass_matrix = \"consistent\"");
      check_softening(law, 2 * young * member.section.second_moment * member.divisions / length);
      if (member.pinned[end])
        throw InputError(fmt::format("end_hinge: its {} is pinned already", end == 0 ? "start" : "end"));
    }
  } catch (const InputError& e) {
    throw InputError(fmt::format("{}: {}", what, e.what()));
  }
}

}  // namespace

void ModelBuilder::check_frame(BodySpec& spec, const std::string& owner) const {
  for (FrameJoint& joint : spec.frame->joints)
    if (!joint.block.empty())
      joint.block = check_polygon(std::move(joint.block), fmt::format("{}: joint '{}'", owner, joint.name)).outline;
  begin_at_blocks(*spec.frame);
  const FramePlan plan = plan_frame(*spec.frame, owner);
  if (spec.inertia)
    throw InputError(owner + ": a frame takes no inertia, which follows from its members; leave it out");
  if (spec.thickness)
    throw InputError(owner + ": a frame takes no body_thickness, because its sections have a width; leave it out");
  for (const FrameMember& m : spec.frame->members) {
    const std::string& name = m.material.empty() ? spec.material : m.material;
    const Material* const material = find_material(materials_, name);
    if (material == nullptr || !material->solid)
      throw InputError(fmt::format("{}: its members need a material with a stiffness (E, nu); {} has none", owner,
                                   name.empty() ? "it" : "'" + name + "'"));
    if (!material->solid->is_elastic())
      throw InputError(
          fmt::format("{}: members need an elastic material, and '{}' is not elastic ({}); give one with E and nu, and "
                      "let members yield by a fibre_section or an end_hinge",
                      owner, name, describe(*material->solid)));
    check_yields(m, *material, fmt::format("{}: member '{}'", owner, name_of(*spec.frame, m)),
                 length_of(plan, static_cast<std::size_t>(&m - spec.frame->members.data())), spec.frame->consistent);
  }
  spec.outline.clear();
  for (const auto& [m, i, side, joint] : plan.outline)
    spec.outline.emplace_back(joint >= 0
                                  ? spec.frame->joints[joint].block[side]
                                  : plan.place_of(plan.stations[m][i]) + section_edge(*spec.frame, plan, m, side));
}

void ModelBuilder::append_frame(const BodySpec& spec, Model<2>& model) const {
  const FrameSpec& frame = *spec.frame;
  const FramePlan plan = plan_frame(frame, fmt::format("body '{}'", spec.name));
  FrameRows rows{spec,
                 frame,
                 plan,
                 model,
                 static_cast<int>(model.bodies.size()),
                 model.nodes(),
                 static_cast<int>(model.skin_place.size())};
  const Box2 box = bounding_box(spec.outline);
  const Vec2 centre = 0.5 * (box.low + box.high);
  Body body;
  body.name = spec.name, body.kind = spec.kind, body.material = spec.material, body.groups = spec.groups;
  body.first_node = rows.first_node, body.nodes = static_cast<int>(plan.node.size());
  body.first_skin = rows.first_skin, body.skins = body.outline = static_cast<int>(plan.outline.size());
  body.first_piece = model.pieces();
  append_nodes(rows, centre, spec.density.value_or(density_of(materials_, spec.material)));
  model.element_bound.emplace_back();
  const std::vector<MemberMaterial> made = member_materials(rows, materials_);
  for (std::size_t m = 0; m < made.size(); ++m) {
    append_beams(rows, m, made[m]);
    body.area += frame.members[m].section.depth() * length_of(plan, m);
  }
  for (const FrameJoint& joint : frame.joints)
    if (!joint.block.empty()) body.area += polygon_moments(joint.block).area;
  append_skin(rows);
  double radius = 0;
  for (int s = rows.first_skin; s < rows.first_skin + body.skins; ++s)
    radius = std::max(radius, (start_of(rows, s) - centre).norm());
  model.body_radius.push_back(radius);
  append_frame_pieces(rows);
  body.pieces = model.pieces() - body.first_piece;
  model.bodies.push_back(std::move(body));
  const double mass = body_mass(model, rows.body);
  for (int n = rows.first_node; n < model.nodes(); ++n) model.load[n] = spec.load * (model.mass[n] / mass);
}

}  // namespace trilith
