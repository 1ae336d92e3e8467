// Frames in the plane: their check, and their rows in the model. Sections and blocks of joints are the skin.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "model/builder/builder.hpp"
#include "model/builder/frame_ends.hpp"
#include "model/builder/frame_outline.hpp"
#include "model/builder/frame_rows.hpp"
#include "model/flatness.hpp"
#include "model/pose.hpp"

namespace trilith {
namespace {

/// The skin of a frame during its conversion to rows of the model.
struct FrameSkinRows {
  const FrameSpec& frame;
  const FramePlan& plan;
  Model<2>& model;
  int body, first_node;
  std::vector<std::vector<std::array<int, 2>>> skin = {};  ///< [member][station] of its bottom and top
  std::vector<std::vector<int>> block_skin = {};           ///< [joint][corner] of its block
};

/// Skin points in the order of the outline. An arm is given in the axes of the node with which it rotates.
void append_skin(FrameSkinRows& rows) {
  for (const auto& stations : rows.plan.stations) rows.skin.emplace_back(stations.size());
  for (const FrameJoint& joint : rows.frame.joints) rows.block_skin.emplace_back(joint.block.size());
  for (const auto& [m, i, side, joint] : frame_outline(rows.frame, rows.plan)) {
    if (joint >= 0) {
      rows.block_skin[joint][side] = static_cast<int>(rows.model.skin_place.size());
      rows.model.skin_place.emplace_back(rows.frame.joints[joint].block[side] - rows.frame.joints[joint].place);
      rows.model.skin_node.push_back(rows.first_node + joint);
      rows.model.skin_turn.push_back(rows.first_node + joint);
      continue;
    }
    const StationOf<2>& station = rows.plan.stations[m][i];
    rows.skin[m][i][side] = static_cast<int>(rows.model.skin_place.size());
    rows.model.skin_place.emplace_back(station.arm + section_edge(rows.frame, rows.plan, m, side));
    rows.model.skin_node.push_back(rows.first_node + station.node);
    rows.model.skin_turn.push_back(rows.first_node + station.turn);
  }
}

/// Position of a frame's skin point at the start.
Vec2 start_of(const FrameSkinRows& rows, int skin) {
  return rows.model.start_position[rows.model.skin_node[skin]] + rows.model.skin_place[skin];
}

void append_piece(const FrameSkinRows& rows, const std::vector<int>& skin, const ConvexPiece& piece) {
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
void append_frame_pieces(const FrameSkinRows& rows) {
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

/// Default mass of the members: `mass` or `weight` of the body.
FrameMass mass_of_frame(const BodySpec& spec) {
  FrameMass mass{spec.material, spec.density, spec.mass};
  if (!mass.mass && spec.weight) mass.mass = *spec.weight / standard_gravity;
  return mass;
}

/// Side area of the members and blocks [m2].
double side_area(const FrameSpec& frame) {
  double area = 0;
  for (const FrameMember& m : frame.members) area += m.section.depth() * length_of(frame, m);
  for (const FrameJoint& joint : frame.joints)
    if (joint.has_block()) area += polygon_moments(joint.block).area;
  return area;
}

}  // namespace

void ModelBuilder::check_frame(BodySpec& spec, const std::string& owner) const {
  FrameSpec& frame = *spec.frame;
  for (FrameJoint& joint : frame.joints)
    if (joint.has_block())
      joint.block = check_polygon(std::move(joint.block), fmt::format("{}: joint '{}'", owner, joint.name)).outline;
  begin_at_blocks(frame);
  const FramePlan plan = plan_frame(frame, owner);
  if (spec.inertia)
    throw InputError(owner + ": a frame takes no inertia, which follows from its members; leave it out");
  if (spec.thickness)
    throw InputError(owner + ": a frame takes no body_thickness, because its sections have a width; leave it out");
  check_member_materials(frame, spec.material, materials_, owner);
  spec.outline.clear();
  for (const OutlinePoint& point : frame_outline(frame, plan)) spec.outline.push_back(place_of(frame, plan, point));
}

void ModelBuilder::append_frame(const BodySpec& spec, Model<2>& model) const {
  const std::string owner = fmt::format("body '{}'", spec.name);
  const FrameMass mass = mass_of_frame(spec);
  FrameBody<2> made{spec.name,
                    *spec.frame,
                    plan_frame(*spec.frame, owner),
                    member_materials(*spec.frame, mass, materials_, owner),
                    block_density(mass, materials_),
                    spec.velocity,
                    spec.spin,
                    spec.support,
                    spec.supports};
  const Box2 box = bounding_box(spec.outline);
  const Vec2 centre = 0.5 * (box.low + box.high);
  Body body;
  body.name = spec.name, body.kind = spec.kind, body.material = spec.material, body.groups = spec.groups;
  body.first_node = model.nodes(), body.nodes = static_cast<int>(made.plan.node.size());
  body.first_skin = static_cast<int>(model.skin_place.size());
  body.skins = body.outline = static_cast<int>(spec.outline.size());
  body.first_piece = model.pieces();
  body.area = side_area(made.frame);
  const auto row = static_cast<int>(model.bodies.size());
  append_nodes(made, node_masses(made, model.thickness), centre, model);
  model.element_bound.emplace_back();
  append_beams(made, row, body.first_node, model);
  FrameSkinRows rows{made.frame, made.plan, model, row, body.first_node};
  append_skin(rows);
  double radius = 0;
  for (int s = body.first_skin; s < body.first_skin + body.skins; ++s)
    radius = std::max(radius, (start_of(rows, s) - centre).norm());
  model.body_radius.push_back(radius);
  append_frame_pieces(rows);
  body.pieces = model.pieces() - body.first_piece;
  model.bodies.push_back(std::move(body));
  const double sum = body_mass(model, row);
  for (int n = model.bodies[row].first_node; n < model.nodes(); ++n) model.load[n] = spec.load * (model.mass[n] / sum);
}

}  // namespace trilith
