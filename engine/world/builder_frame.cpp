// Frames: their nodes, beams, sections as skin, and the pieces between these.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "body/beam_element.hpp"
#include "world/builder.hpp"
#include "world/flatness.hpp"
#include "world/frame.hpp"
#include "world/pose.hpp"

namespace trilith {
namespace {

/// A frame while it becomes rows of the model.
struct FrameRows {
  const BodySpec& spec;
  const FrameSpec& frame;
  const FramePlan& plan;
  Model<2>& model;
  int body, first_node, first_skin;
  std::vector<std::vector<std::array<int, 2>>> skin = {};  ///< [member][station] of its bottom and top
};

/// The nodes that stand in a box of spec.holds are held as it says.
std::array<Support, 3> support_of(const BodySpec& spec, const Vec2& place, std::array<Support, 3> own) {
  for (int k = 0; k < 3; ++k)
    if (spec.support[k] != Support::free) own[k] = spec.support[k];
  for (const NodeHold& hold : spec.holds)
    for (const int k : {0, 1})
      if (holds_at(hold, place) && hold.support[k] != Support::free) own[k] = hold.support[k];
  return own;
}

void append_nodes(const FrameRows& rows, const Vec2& centre) {
  Model<2>& model = rows.model;
  for (std::size_t n = 0; n < rows.plan.node.size(); ++n) {
    const Vec2& place = rows.plan.node[n];
    const FrameJoint* const joint = n < rows.frame.joints.size() ? &rows.frame.joints[n] : nullptr;
    model.mass.push_back(joint != nullptr ? joint->mass : 0);
    model.inertia.push_back(joint != nullptr ? joint->inertia : 0);
    model.support.push_back(support_of(rows.spec, place, joint != nullptr ? joint->support : std::array<Support, 3>{}));
    model.start_position.push_back(place);
    model.start_rotation.push_back(0);
    model.start_velocity.emplace_back(rows.spec.velocity + cross(rows.spec.spin, Vec2(place - centre)));
    model.start_spin.push_back(rows.spec.spin);
    model.load.push_back(Vec2::Zero());
  }
}

/// Half of a beam's mass goes to either node, where it turns as its section does: more would let a member of few beams
/// turn too slowly, and less would shorten the step.
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
  bound.stiffness = std::max(bound.stiffness, most);
  bound.damping = std::max(bound.damping, beam.damping * most);
}

/// What a member is made of: mass per length, elasticity and damping.
struct MemberMaterial {
  double mass;  ///< [kg/m]
  BeamMaterial elastic;
  double damping;  ///< [s]
};

void append_beams(const FrameRows& rows, std::size_t m, const MemberMaterial& made) {
  const FrameMember& member = rows.frame.members[m];
  const std::vector<Station>& stations = rows.plan.stations[m];
  rows.model.members.push_back({name_of(rows.frame, member), rows.body, static_cast<int>(rows.model.beams.size()),
                                static_cast<int>(stations.size()) - 1});
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
    add_masses(rows, beam, end_mass(beam, made.mass * beam.length, member.section));
    rows.model.beams.push_back(beam);
  }
}

/// Skin in the order of the way round. An arm stands in the axes of the node that it turns with.
void append_skin(FrameRows& rows) {
  for (const auto& stations : rows.plan.stations) rows.skin.emplace_back(stations.size());
  for (const auto& [m, i, side] : rows.plan.outline) {
    const Station& station = rows.plan.stations[m][i];
    rows.skin[m][i][side] = static_cast<int>(rows.model.skin_place.size());
    rows.model.skin_place.emplace_back(station.arm + section_edge(rows.frame, rows.plan, m, side));
    rows.model.skin_node.push_back(rows.first_node + station.node);
    rows.model.skin_turn.push_back(rows.first_node + station.turn);
  }
}

/// Where a skin point of the frame is at the start.
Vec2 start_of(const FrameRows& rows, int skin) {
  return rows.model.start_position[rows.model.skin_node[skin]] + rows.model.skin_place[skin];
}

/// A piece for each beam: its two long sides are faces, its ends where nothing joins on there.
void append_frame_pieces(const FrameRows& rows) {
  Model<2>& model = rows.model;
  for (std::size_t m = 0; m < rows.skin.size(); ++m)
    for (std::size_t i = 0; i + 1 < rows.skin[m].size(); ++i) {
      const auto& near = rows.skin[m][i];
      const auto& far = rows.skin[m][i + 1];
      const std::array<int, 4> skin{near[0], far[0], far[1], near[1]};
      const bool begins = i == 0 && rows.plan.is_tip[m][0],
                 ends = i + 2 == rows.skin[m].size() && rows.plan.is_tip[m][1];
      Polygon outline;
      for (const int s : skin) outline.push_back(start_of(rows, s));
      const PieceEdges edges = piece_edges(outline, {{0, 1, 2, 3}, {0, ends ? 1 : -1, 2, begins ? 3 : -1}});
      model.piece_body.push_back(rows.body);
      model.piece_first.push_back(static_cast<int>(model.corner_skin.size()));
      for (std::size_t c = 0; c < edges.corner.size(); ++c) {
        model.corner_skin.push_back(skin[edges.corner[c]]);
        model.edge_is_face.push_back(edges.is_face[c]);
        model.edge_corner.push_back(edges.flatness[c]);
      }
    }
}

const Material* find_material(const std::vector<Material>& materials, const std::string& name) {
  const auto found =
      std::find_if(materials.begin(), materials.end(), [&](const Material& m) { return m.name == name; });
  return found == materials.end() ? nullptr : &*found;
}

double length_of(const FramePlan& plan, std::size_t member) {
  const std::vector<Station>& stations = plan.stations[member];
  return (plan.place_of(stations.back()) - plan.place_of(stations.front())).norm();
}

/// Of each member; where the body's mass or weight is given, all masses are scaled to it.
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
                    material.solid->damping()});
    given += made.back().mass * length_of(rows.plan, m);
  }
  const double wanted = spec.mass ? *spec.mass : spec.weight ? *spec.weight / standard_gravity : given;
  for (MemberMaterial& m : made) m.mass *= wanted / given;
  return made;
}

}  // namespace

void ModelBuilder::check_frame(BodySpec& spec, const std::string& owner) const {
  const FramePlan plan = plan_frame(*spec.frame, owner);
  if (spec.inertia)
    throw InputError(owner + ": a frame takes no inertia, as that follows from its members; leave it out");
  if (spec.thickness)
    throw InputError(owner + ": a frame takes no body_thickness, as its sections have a width; leave it out");
  for (const FrameMember& m : spec.frame->members) {
    const std::string& name = m.material.empty() ? spec.material : m.material;
    const Material* const material = find_material(materials_, name);
    if (material == nullptr || !material->solid)
      throw InputError(fmt::format("{}: its members need a material with a stiffness (E, nu); {} has none", owner,
                                   name.empty() ? "it" : "'" + name + "'"));
    if (!material->solid->is_elastic())
      throw InputError(
          fmt::format("{}: its members are elastic, and material '{}' is not ({}); give it one with E and nu", owner,
                      name, describe(*material->solid)));
  }
  spec.outline.clear();
  for (const auto& [m, i, side] : plan.outline)
    spec.outline.emplace_back(plan.place_of(plan.stations[m][i]) + section_edge(*spec.frame, plan, m, side));
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
  append_nodes(rows, centre);
  model.element_bound.emplace_back();
  const std::vector<MemberMaterial> made = member_materials(rows, materials_);
  for (std::size_t m = 0; m < made.size(); ++m) {
    append_beams(rows, m, made[m]);
    body.area += frame.members[m].section.depth() * length_of(plan, m);
  }
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
