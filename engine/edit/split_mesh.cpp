#include "edit/split_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/rotation_3d.hpp"
#include "edit/mesh_section.hpp"
#include "law/contact/list.hpp"

namespace trilith {
namespace {

/// Rotation of the nodes of a body in the plane on a cut from the initial position; others need none.
std::vector<std::optional<Turn>> turns_of_nodes(const Model<2>& model, const State<2>& state, int body,
                                                const MeshCut& cut) {
  const auto nodes = static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].nodes);
  std::vector<std::optional<Turn>> turns(nodes);
  const std::vector<Turn> on_cut = turns_of_cut(model, state, body, cut);
  for (std::size_t i = 0; i < cut.nodes.size(); ++i) turns[static_cast<std::size_t>(cut.nodes[i])] = on_cut[i];
  return turns;
}
/// In space no node moves.
std::vector<std::optional<Turn3>> turns_of_nodes(const Model<3>& model, const State<3>& /*state*/, int body,
                                                 const MeshCut& /*cut*/) {
  return std::vector<std::optional<Turn3>>(
      static_cast<std::size_t>(model.bodies[static_cast<std::size_t>(body)].nodes));
}

int integration_points(const Element& e) {
  return e.nodes == 4 ? 4 : 1;
}
int integration_points(const SpaceElement& e) {
  return info_of(e.shape).points;
}

/// A body that has split keeps no strain, so that the ledger has the energy of its parts alone.
template <int D>
void relax(const Model<D>& model, State<D>& state, const MeshParts<D>& parts, int body) {
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  const auto first = static_cast<std::size_t>(b.first_node);
  const Vec<D> moved = state.position[first] - model.start_position[first];
  for (std::size_t n = first; n < first + static_cast<std::size_t>(b.nodes); ++n) {
    state.position[n] = model.start_position[n] + moved;
    state.velocity[n].setZero();
  }
  for (const auto& [whole, own] : parts.elements()) {
    const auto &from = elements_of(model)[static_cast<std::size_t>(whole)],
               &to = elements_of(model)[static_cast<std::size_t>(own)];
    for (int p = 0; p < integration_points(to) && from.first_point >= 0; ++p) {
      auto& memory = state.plastic[static_cast<std::size_t>(from.first_point + p)];
      state.plastic[static_cast<std::size_t>(to.first_point + p)] = memory;
      memory = {};
    }
  }
}

}  // namespace

template <int D>
void place_mesh_parts(const Model<D>& model, State<D>& state, const SplitBody& split, const MeshCut& cut) {
  const MeshParts<D> parts(model, split, cut);
  const Body& b = model.bodies[static_cast<std::size_t>(split.body)];
  const auto turns = turns_of_nodes(model, state, split.body, cut);
  for (int i = 0; i < b.nodes; ++i)
    for (const int side : {0, 1}) {
      const auto n = static_cast<std::size_t>(b.first_node + i);
      if (parts.copy(side, b.first_node + i) < 0) continue;
      const auto p = static_cast<std::size_t>(parts.copy(side, b.first_node + i));
      const auto& turn = turns[static_cast<std::size_t>(i)];
      const Vec<D> apart = model.start_position[p] - model.start_position[n];
      state.position[p] = state.position[n] + (turn ? turn->apply(apart) : Vec<D>(Vec<D>::Zero()));
      state.rotation[p] = state.rotation[n];
      state.velocity[p] = state.velocity[n], state.spin[p] = state.spin[n];
    }
  for (const int side : {0, 1}) {
    const auto part = static_cast<std::size_t>(parts.body(side)), whole = static_cast<std::size_t>(split.body);
    state.resting[part] = state.resting[whole], state.moved_at[part] = state.moved_at[whole];
  }
  relax(model, state, parts, split.body);
  state.removed_at.resize(state.left.size(), never_removed);
  state.left[static_cast<std::size_t>(split.body)] = 1;
  state.removed_at[static_cast<std::size_t>(split.body)] = state.time;
}
template void place_mesh_parts(const Model<2>&, State<2>&, const SplitBody&, const MeshCut&);
template void place_mesh_parts(const Model<3>&, State<3>&, const SplitBody&, const MeshCut&);

namespace {

/// Contacts after a split. `give(record, first)` moves a contact of the body, as its first or second piece, to a part;
/// false if no part has its face. Contacts of other bodies stay.
template <int D, class Record, class Give>
std::vector<Record> given_contacts(const Model<D>& model, const std::vector<Record>& records, int body, Give&& give) {
  const auto is_on = [&](int piece) { return model.piece_body[static_cast<std::size_t>(piece)] == body; };
  std::vector<Record> out;
  for (const Record& record : records) {
    const bool first = is_on(record.piece_a);
    Record given = record;
    if ((!first && !is_on(record.piece_b)) || give(given, first)) out.push_back(std::move(given));
  }
  return out;
}

}  // namespace

std::vector<ContactRecord> mesh_handed_over(const Model<2>& model, const State<2>& /*state*/,
                                            const std::vector<ContactRecord>& records, const SplitBody& split,
                                            const MeshCut& cut) {
  const MeshParts<2> parts(model, split, cut);
  return given_contacts(model, records, split.body, [&](ContactRecord& given, bool first) {
    int &piece = first ? given.piece_a : given.piece_b, &from = first ? given.a0 : given.b0,
        &to = first ? given.a1 : given.b1;
    const PartPiece own = given.general ? parts.piece(piece) : parts.face(from, to);
    if (own.piece < 0) return false;
    piece = own.piece;
    if (!given.general) from = parts.skin_copy(own.side, from), to = parts.skin_copy(own.side, to);
    given = ordered(std::move(given));
    return true;
  });
}

/// The shear of an edge is linear. Its two halves act at a quarter and three quarters of the edge, so that they have
/// the nodal forces of the stress.
std::vector<ContactRecord> mesh_crack_contacts(const Model<2>& model, const State<2>& /*state*/, const SplitBody& split,
                                               const CrackingBody<2>& row, const Crack<2>& crack) {
  const MeshCut& cut = *row.sections[static_cast<std::size_t>(crack.section)].cut;
  const MeshParts<2> parts(model, split, cut);
  const Body& whole = model.bodies[static_cast<std::size_t>(split.body)];
  const ContactLaw& law = model.laws[static_cast<std::size_t>(row.law)];
  const auto place = static_cast<std::uint32_t>(law.index());
  std::vector<ContactRecord> out;
  std::size_t i = 0;  // of the first node of the face among the nodes of the cut
  for (const auto& face : cut.faces) {
    while (cut.nodes[i] != face[0]) ++i;
    const int a0 = parts.skin_copy(0, whole.first_skin + face[0]), a1 = parts.skin_copy(0, whole.first_skin + face[1]);
    const int b0 = parts.skin_copy(1, whole.first_skin + face[1]), b1 = parts.skin_copy(1, whole.first_skin + face[0]);
    const Vec2 along = model.start_position[static_cast<std::size_t>(whole.first_node + face[1])] -
                       model.start_position[static_cast<std::size_t>(whole.first_node + face[0])];
    const double length = along.norm(), size = length * model.thickness;
    const double from = along.dot(crack.traction[i]) / length, to = along.dot(crack.traction[i + 1]) / length;
    const double first = size * (from / 3 + to / 6), last = size * (from / 6 + to / 3);
    ContactRecord r{parts.piece_at(0, a0, a1), parts.piece_at(1, b0, b1), a0, a1, b0, b1};
    r.law = place;
    r.numbers.assign(law_number_counts[place], 0.0);
    r.memory.bonds = 3, r.memory.state = contact_touching;
    const std::array shear{1.5 * first - 0.5 * last, 1.5 * last - 0.5 * first};
    for (const std::size_t h : {0, 1}) {
      r.memory.shear_elastic[h] = r.memory.shear_total[h] = shear[h];
      r.memory.active[h] = 0.5 * length;
    }
    out.push_back(ordered(std::move(r)));
  }
  return out;
}

std::vector<SolidRecord> mesh_handed_over(const Model<3>& model, const State<3>& state,
                                          const std::vector<SolidRecord>& records, const SplitBody& split,
                                          const MeshCut& cut) {
  const MeshParts<3> parts(model, split, cut);
  return given_contacts(model, records, split.body, [&](SolidRecord& given, bool first) {
    int& piece = first ? given.piece_a : given.piece_b;
    const PartPiece own = parts.piece(piece);
    if (own.piece < 0) return false;
    piece = own.piece;
    given = ordered(model, state, std::move(given));
    return true;
  });
}

/// The faces of both elements move with the nodes that were one, so the joint follows them from the present position.
std::vector<SolidRecord> mesh_crack_contacts(const Model<3>& model, const State<3>& state, const SplitBody& split,
                                             const CrackingBody<3>& row, const Crack<3>& crack) {
  const MeshCut& cut = *row.sections[static_cast<std::size_t>(crack.section)].cut;
  const MeshParts<3> parts(model, split, cut);
  const ContactLaw& law = model.laws[static_cast<std::size_t>(row.law)];
  const double kn = with_kernel({law}, [](const auto& kernel) { return kernel.kn; });
  std::vector<SolidRecord> out;
  const int whole = model.bodies[static_cast<std::size_t>(split.body)].first_node;
  std::vector<Vec3> nodes;
  for (const int n : cut.nodes) nodes.push_back(state.position[static_cast<std::size_t>(parts.copy(0, whole + n))]);
  const SpaceCut& faces = space_cut(cut);
  for (std::size_t f = 0; f < faces.plates.size(); ++f) {
    const CutFace& face = faces.plates[f];
    const PlacedPlate now = placed_plate(nodes, face);
    const CrackFaces sides{parts.piece_of_element(face.element[0]), face.face[0],
                           parts.piece_of_element(face.element[1]), face.face[1]};
    Eigen::Matrix3d axes;
    axes.col(0) = face.section.x, axes.col(1) = face.section.y, axes.col(2) = face.section.normal;
    out.push_back(
        section_joint(model, state, sides, face.section, now.centre, now.turn * axes, unpacked_forces(crack, f), kn));
  }
  return out;
}

}  // namespace trilith
