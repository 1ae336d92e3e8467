#include "run/record/recording_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "model/contact/skin_places.hpp"
#include "model/pose.hpp"
#include "results/file/provenance.hpp"
#include "run/record/recorded_texts.hpp"

namespace trilith {
namespace {

/// Names separated by blanks; a blank within a name becomes '_'.
std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (std::string name : names) {
    std::replace(name.begin(), name.end(), ' ', '_');
    if (!out.empty()) out += ' ';
    out += name;
  }
  return out;
}

/// Outline of a body in the axes of its node.
std::vector<double> outline_of(const Model<2>& model, const Body& body) {
  std::vector<double> out;
  for (int i = body.first_skin; i < body.first_skin + body.outline; ++i) {
    out.push_back(model.skin_place[i].x());
    out.push_back(model.skin_place[i].y());
  }
  return out;
}

/// "free", "fixed" or "moved" if all nodes are alike, otherwise "free (2 of 9 nodes held)".
template <int D>
std::string nodes_support_text(const Model<D>& model, const Body& body) {
  int free = 0, driven = 0;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
    const auto& s = model.support[n];
    const auto end = s.begin() + D;
    free += std::all_of(s.begin(), end, [](Support k) { return k == Support::free; }) ? 1 : 0;
    driven += std::any_of(s.begin(), end, [](Support k) { return k == Support::driven; }) ? 1 : 0;
  }
  if (free == body.nodes) return "free";
  if (driven == body.nodes) return "moved";
  if (!model.body_moves(static_cast<int>(&body - model.bodies.data()))) return "fixed";
  return fmt::format("free ({} of {} nodes held)", body.nodes - free, body.nodes);
}

/// Point in the axes of the body's first node; for a point attached to several nodes, its initial position.
Vec2 point_from_node(const Model<2>& model, int body, const Attachment<2>& attachment) {
  if (attachment.is_rigid()) return attachment.arm[0];
  return pose_at(model, initial_state(model), attachment).place - model.start_position[model.bodies[body].first_node];
}

/// The version for space. For a frame the point is relative to the initial position of its first node, in world axes.
Vec3 point_from_node(const Model<3>& model, int body, const Attachment<3>& attachment) {
  const Body& b = model.bodies[body];
  if (b.is_rigid()) return attachment.arm[0];
  const BodyMotion start = start_of(model, attachment.node[0]);
  return start.place + turn_of(start.rotation).apply(attachment.arm[0]) - model.start_position[b.first_node];
}

void add_deformable(const Model<2>& model, const State<2>& state, const Body& body, results::Header& header) {
  results::BodyRow row;
  row.name = body.name;
  row.kind = name_of(body.kind);
  row.material = body.material;
  row.groups = joined(body.groups);
  row.support = nodes_support_text(model, body);
  row.first_node = static_cast<std::int32_t>(header.node_count());
  row.node_count = body.nodes;
  row.first_vertex = static_cast<std::int32_t>(header.vertex_node.size());
  row.vertex_count = body.outline;
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
    header.node_position.insert(header.node_position.end(), {state.position[n].x(), state.position[n].y()});
    header.node_rotation.push_back(state.rotation[n]);
    header.node_mass.push_back(model.mass[n]);
    header.node_inertia.push_back(model.inertia[n]);
  }
  for (int i = 0; i < body.outline; ++i) {
    // Relative to the node that the point turns with, which at a pin differs from the node that carries it.
    const int skin = body.first_skin + i, turn = model.skin_turn[skin];
    const Vec2 at = skin_start(model, skin) - model.start_position[turn];
    header.vertices.insert(header.vertices.end(), {at.x(), at.y()});
    header.vertex_node.push_back(row.first_node + turn - body.first_node);
  }
  const int index = static_cast<int>(&body - model.bodies.data());
  for (const Element& e : model.elements) {
    if (e.body != index) continue;
    header.element_node.insert(header.element_node.end(), e.node.begin(), e.node.end());
    header.element_body.push_back(index);
  }
  header.bodies.push_back(std::move(row));
}

void add_bodies(const Model<2>& model, const State<2>& state, results::Header& header) {
  for (const Body& body : model.bodies) {
    const int n = body.first_node;
    if (!body.is_rigid()) {
      add_deformable(model, state, body, header);
      continue;
    }
    results::BodyRow row;
    row.name = body.name;
    row.kind = name_of(body.kind);
    row.material = body.material;
    row.groups = joined(body.groups);
    row.support = support_text(model.support[n]);
    const std::array position{state.position[n].x(), state.position[n].y()};
    header.add_rigid_body(std::move(row), position, std::span(&state.rotation[n], 1), model.mass[n],
                          std::span(&model.inertia[n], 1), outline_of(model, body));
  }
}

/// Outer faces of a body's pieces, and their corners in the axes of the carrying nodes. For elements the corners are
/// the nodes.
struct BodySkin {
  std::vector<double> corners;  ///< [corner][3] m
  FaceLoops faces;
};
BodySkin skin_of(const Model<3>& model, const Body& body) {
  BodySkin skin;
  for (int p = body.first_piece; p < body.first_piece + body.pieces; ++p) {
    const ConvexSolid& piece = model.piece_solid[p];
    const int first = static_cast<int>(skin.corners.size() / 3);
    const bool at_nodes = model.is_fitted(p);  // then corners are nodes
    for (const Vec3& corner : piece.shape.corners) {
      const Vec3 x = at_nodes ? Vec3(Vec3::Zero()) : corner;
      skin.corners.insert(skin.corners.end(), {x.x(), x.y(), x.z()});
    }
    for (int f = 0; f < piece.shape.faces.count(); ++f) {
      if (!piece.is_surface(f)) continue;
      std::vector<int> loop;
      for (const int corner : piece.shape.faces[f]) loop.push_back(first + corner);
      skin.faces.add(loop);
    }
  }
  return skin;
}

/// A body of several nodes in space: the first node as for a rigid body, then the others, with each corner on its own
/// node.
void add_several_nodes(const Model<3>& model, const State<3>& state, const Body& body, results::BodyRow row,
                       results::Header& header) {
  const BodySkin skin = skin_of(model, body);
  const std::size_t first_vertex = header.vertex_node.size();
  row.support = nodes_support_text(model, body);
  for (int n = body.first_node; n < body.first_node + body.nodes; ++n) {
    const UnitQuaternion& q = state.rotation[n];
    const std::array rotation{q.w, q.x, q.y, q.z};
    if (n == body.first_node) {
      header.add_solid_body(row, std::span(state.position[n].data(), 3), rotation, model.mass[n],
                            std::span(model.inertia[n].data(), 3), skin.corners, skin.faces);
      continue;
    }
    header.node_position.insert(header.node_position.end(), state.position[n].data(), state.position[n].data() + 3);
    header.node_rotation.insert(header.node_rotation.end(), rotation.begin(), rotation.end());
    header.node_mass.push_back(model.mass[n]);
    header.node_inertia.insert(header.node_inertia.end(), model.inertia[n].data(), model.inertia[n].data() + 3);
  }
  header.bodies.back().node_count = body.nodes;
  const std::int32_t base = header.bodies.back().first_node;
  std::size_t vertex = first_vertex;
  for (int p = body.first_piece; p < body.first_piece + body.pieces; ++p)
    for (std::size_t c = 0; c < model.piece_solid[p].shape.corners.size(); ++c)
      header.vertex_node[vertex++] =
          base + model.skin_node[model.corner_skin[model.piece_first[p] + static_cast<int>(c)]] - body.first_node;
}

/// Pieces of each body in space with their outer faces, in the principal axes of the body.
void add_bodies(const Model<3>& model, const State<3>& state, results::Header& header) {
  for (const Body& body : model.bodies) {
    const int n = body.first_node;
    results::BodyRow row;
    row.name = body.name, row.kind = name_of(body.kind), row.material = body.material;
    row.groups = joined(body.groups), row.support = support_text(model.support[n]);
    if (!body.is_rigid()) {
      add_several_nodes(model, state, body, std::move(row), header);
      continue;
    }
    const auto [corners, faces] = skin_of(model, body);
    const UnitQuaternion& q = state.rotation[n];
    header.add_solid_body(std::move(row), std::span(state.position[n].data(), 3), std::array{q.w, q.x, q.y, q.z},
                          model.mass[n], std::span(model.inertia[n].data(), 3), corners, faces);
    int corner = 0;
    for (int p = body.first_piece; p < body.first_piece + body.pieces; ++p) {
      const ConvexSolid& piece = model.piece_solid[p];
      if (piece.is_sphere()) header.add_sphere(corner, piece.radius);
      corner += static_cast<int>(piece.shape.corners.size());
    }
  }
}

/// Common label of the bodies of a surface: material and groups.
std::string surface_label(const Body& body) {
  if (body.groups.empty()) return body.material.empty() ? body.name : body.material;
  const std::string groups = joined(body.groups);
  return body.material.empty() ? fmt::format("({})", groups) : fmt::format("{} ({})", body.material, groups);
}

template <int D>
void add_laws(const Model<D>& model, const std::vector<Material>& materials, results::Header& header) {
  for (const Material& m : materials)
    header.laws.push_back({m.name, "material", "", "",
                           fmt::format("density={:g} kg/m3{}", m.density, m.solid ? ", " + describe(*m.solid) : "")});
  std::vector<std::string> label(static_cast<std::size_t>(model.surfaces));
  for (const Body& body : model.bodies)
    if (label[body.surface].empty()) label[body.surface] = surface_label(body);
  std::set<std::tuple<int, std::string, std::string>> pairs;  // by law, each pair of labels once
  for (int i = 0; i < model.surfaces; ++i)
    for (int j = i; j < model.surfaces; ++j)
      if (const int law = model.law_of[i * model.surfaces + j]; law >= 0) pairs.emplace(law, label[i], label[j]);
  for (const auto& [law, first, second] : pairs)
    header.laws.push_back({model.law_names[law], "contact", first, second,
                           std::visit([](const auto& l) { return describe(l); }, model.laws[law])});
}

template <int D>
void add_bearings(const Model<D>& model, results::Header& header) {
  for (const Bearing<D>& b : model.bearings) {
    results::BearingRow row;
    row.name = b.name;
    row.body_a = b.body_a;
    row.body_b = b.body_b;
    const Vec<D> a = point_from_node(model, b.body_a, b.end_a), at_b = point_from_node(model, b.body_b, b.end_b);
    for (int k = 0; k < D; ++k) row.point_a[k] = a[k], row.point_b[k] = at_b[k];
    row.law = bearing_text(model, b);
    header.bearings.push_back(std::move(row));
  }
}

template <int D>
void complete(const Model<D>& model, results::Provenance& p) {
  const results::Provenance here = results::provenance_here();
  for (const auto part : {&results::Provenance::compiler, &results::Provenance::platform,
                          &results::Provenance::git_commit, &results::Provenance::start_time})
    if ((p.*part).empty()) p.*part = here.*part;
  if (!p.motions.empty()) return;
  for (const Drive& drive : model.drives)
    if (leads(model, drive)) p.motions.push_back(drive_text(model, drive));
}

}  // namespace

template <int D>
results::Header recording_header(const Model<D>& model, const State<D>& state, const RecordingOptions<D>& options) {
  results::Header header;
  header.dim = D;
  header.provenance = options.provenance;
  complete(model, header.provenance);
  add_bodies(model, state, header);
  add_laws(model, options.materials, header);
  add_bearings(model, header);
  for (const RecordedHistory<D>& h : options.histories) header.histories.push_back({h.name, h.unit, h.description});
  for (const EnergyTermInfo& term : energy_term_info)
    header.energy_terms.push_back({std::string(term.name), "J", std::string(term.sentence)});
  header.with_velocity = options.with_velocity;
  return header;
}

template results::Header recording_header(const Model<2>&, const State<2>&, const RecordingOptions<2>&);
template results::Header recording_header(const Model<3>&, const State<3>&, const RecordingOptions<3>&);

}  // namespace trilith
