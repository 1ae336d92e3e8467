#include "edit/split_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "edit/mesh_section.hpp"
#include "law/contact/list.hpp"

namespace trilith {
namespace {

const Body& body_at(const Model<2>& model, int body) {
  return model.bodies[static_cast<std::size_t>(body)];
}

/// Index of the first element of a body; elements are stored body by body.
int first_element_of(const Model<2>& model, int body) {
  const auto at = std::lower_bound(model.elements.begin(), model.elements.end(), body,
                                   [](const Element& e, int b) { return e.body < b; });
  return static_cast<int>(at - model.elements.begin());
}

}  // namespace

MeshParts::MeshParts(const Model<2>& model, const SplitBody& split, const MeshCut& cut)
    : model_(model), split_(split), first_node_(body_at(model, split.body).first_node) {
  std::array next{first_element_of(model, split.behind), first_element_of(model, split.ahead)};
  for (std::vector<int>& of : copy_) of.assign(static_cast<std::size_t>(body_at(model, split.body).nodes), -1);
  const int first = first_element_of(model, split.body);
  for (std::size_t e = 0; e < cut.behind.size(); ++e) {
    const std::size_t side = cut.behind[e] != 0 ? 0 : 1;
    const int whole = first + static_cast<int>(e), own = next[side]++;
    const Element &from = model.elements[static_cast<std::size_t>(whole)],
                  &to = model.elements[static_cast<std::size_t>(own)];
    for (std::size_t i = 0; i < static_cast<std::size_t>(from.nodes); ++i)
      copy_[side][static_cast<std::size_t>(from.node[i] - first_node_)] = to.node[i];
    elements_.push_back({whole, own});
  }
  for (const int side : {0, 1}) add_pieces(side);
}

void MeshParts::add_pieces(int side) {
  const auto at = static_cast<std::size_t>(side);
  const Body& part = body_at(model_, body(side));
  for (int p = part.first_piece; p < part.first_piece + part.pieces; ++p) {
    const int first = model_.piece_first[static_cast<std::size_t>(p)], corners = model_.corners_of(p);
    std::vector<int> nodes;
    for (int k = 0; k < corners; ++k) {
      const auto corner = static_cast<std::size_t>(first + k);
      const int skin = model_.corner_skin[corner],
                after = model_.corner_skin[static_cast<std::size_t>(first + (k + 1) % corners)];
      nodes.push_back(model_.skin_node[static_cast<std::size_t>(skin)]);
      if (model_.edge_is_face[corner] != 0) faces_[at][{skin, after}] = p;
    }
    std::sort(nodes.begin(), nodes.end());
    pieces_[at][nodes] = p;
  }
}

/// The nodes of a mesh are its skin points.
int MeshParts::skin_copy(int side, int skin) const {
  const int node = model_.skin_node[static_cast<std::size_t>(skin)];
  if (!has_node(node) || copy(side, node) < 0) return -1;
  const Body& part = body_at(model_, body(side));
  return part.first_skin + copy(side, node) - part.first_node;
}

int MeshParts::piece_at(int side, int from, int to) const {
  const auto& faces = faces_[static_cast<std::size_t>(side)];
  const auto at = faces.find({from, to});
  return at == faces.end() ? -1 : at->second;
}

MeshParts::Face MeshParts::face(int from, int to) const {
  for (const int side : {0, 1}) {
    const int a = skin_copy(side, from), b = skin_copy(side, to);
    if (a < 0 || b < 0) continue;
    if (const int piece = piece_at(side, a, b); piece >= 0) return {side, piece};
  }
  return {};
}

MeshParts::Face MeshParts::piece(int piece) const {
  for (const int side : {0, 1}) {
    std::vector<int> nodes;
    const int first = model_.piece_first[static_cast<std::size_t>(piece)];
    for (int k = first; k < first + model_.corners_of(piece); ++k)
      nodes.push_back(
          copy(side, model_.skin_node[static_cast<std::size_t>(model_.corner_skin[static_cast<std::size_t>(k)])]));
    std::sort(nodes.begin(), nodes.end());
    const auto& pieces = pieces_[static_cast<std::size_t>(side)];
    if (const auto at = pieces.find(nodes); at != pieces.end()) return {side, at->second};
  }
  return {};
}

namespace {

/// Rotation of the nodes of a body on a cut from the initial position; others need none.
std::vector<std::optional<Turn>> turns_of_nodes(const Model<2>& model, const State<2>& state, int body,
                                                const MeshCut& cut) {
  std::vector<std::optional<Turn>> turns(static_cast<std::size_t>(body_at(model, body).nodes));
  const std::vector<Turn> on_cut = turns_of_cut(model, state, body, cut);
  for (std::size_t i = 0; i < cut.nodes.size(); ++i) turns[static_cast<std::size_t>(cut.nodes[i])] = on_cut[i];
  return turns;
}

/// A body that has split keeps no strain, so that the ledger has the energy of its parts alone.
void relax(const Model<2>& model, State<2>& state, const MeshParts& parts, int body) {
  const Body& b = body_at(model, body);
  const auto first = static_cast<std::size_t>(b.first_node);
  const Vec2 moved = state.position[first] - model.start_position[first];
  for (std::size_t n = first; n < first + static_cast<std::size_t>(b.nodes); ++n) {
    state.position[n] = model.start_position[n] + moved;
    state.velocity[n].setZero();
  }
  for (const auto& [whole, own] : parts.elements()) {
    const int from = model.elements[static_cast<std::size_t>(whole)].first_point;
    const int to = model.elements[static_cast<std::size_t>(own)].first_point;
    const int count = model.elements[static_cast<std::size_t>(own)].nodes == 4 ? 4 : 1;
    for (int p = 0; p < count && from >= 0; ++p) {
      auto& memory = state.plastic[static_cast<std::size_t>(from + p)];
      state.plastic[static_cast<std::size_t>(to + p)] = memory;
      memory = {};
    }
  }
}

}  // namespace

void place_mesh_parts(const Model<2>& model, State<2>& state, const SplitBody& split, const MeshCut& cut) {
  const MeshParts parts(model, split, cut);
  const Body& b = body_at(model, split.body);
  const auto turns = turns_of_nodes(model, state, split.body, cut);
  for (int i = 0; i < b.nodes; ++i)
    for (const int side : {0, 1}) {
      const auto n = static_cast<std::size_t>(b.first_node + i);
      if (parts.copy(side, b.first_node + i) < 0) continue;
      const auto p = static_cast<std::size_t>(parts.copy(side, b.first_node + i));
      const auto& turn = turns[static_cast<std::size_t>(i)];
      const Vec2 apart = model.start_position[p] - model.start_position[n];
      state.position[p] = state.position[n] + (turn ? turn->apply(apart) : Vec2(Vec2::Zero()));
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

namespace {

/// Attached points, loads and displacement controls of a mesh for its parts; see load/load_kind.hpp.
class MeshLinks {
 public:
  MeshLinks(const Model<2>& model, const SplitBody& split, const MeshParts& parts)
      : model_(model), split_(split), parts_(parts) {}

  [[nodiscard]] bool is_on(int body) const { return body == split_.body; }
  [[nodiscard]] bool is_on(const Attachment<2>& at) const { return at.nodes > 0 && parts_.has_node(at.node[0]); }
  [[nodiscard]] bool is_behind(int body) const { return body == split_.behind; }
  /// Both copies carry a point between nodes of the cut.
  [[nodiscard]] bool is_on_cut(const Attachment<2>& at) const {
    for (int i = 0; i < at.nodes; ++i)
      if (has_weight(at, i) && !parts_.on_both(at.node[static_cast<std::size_t>(i)])) return false;
    return true;
  }
  /// Share of the mass that a side has at a point on the cut.
  [[nodiscard]] double share(int side, const Attachment<2>& at) const {
    double own = 0, all = 0;
    for (int i = 0; i < at.nodes; ++i) {
      if (!has_weight(at, i)) continue;
      const int node = at.node[static_cast<std::size_t>(i)];
      own += mass(parts_.copy(side, node)), all += mass(parts_.copy(0, node)) + mass(parts_.copy(1, node));
    }
    return own / all;
  }
  /// To the side whose part has all nodes of the point, and behind if both have.
  void give(Attachment<2>& at, int& body) const { give(at, body, side_of(at)); }
  void give(Attachment<2>& at, int& body, int side) const {
    if (!is_on(at)) return;
    body = parts_.body(side);
    int known = 0;  // nodes without weight may be missing on this side
    for (int i = 0; i < at.nodes; ++i)
      if (has_weight(at, i)) known = parts_.copy(side, at.node[static_cast<std::size_t>(i)]);
    for (std::size_t i = 0; i < static_cast<std::size_t>(at.nodes); ++i)
      for (int* node : {&at.node[i], &at.turn[i]}) {
        const int copy = parts_.copy(side, *node);
        *node = copy >= 0 ? copy : known;
      }
  }
  void give(std::vector<PushRow<2>>& rows) const {
    std::vector<PushRow<2>> given;
    for (const PushRow<2>& row : rows) {
      if (!parts_.has_node(row.node)) {
        given.push_back(row);
        continue;
      }
      const double all = mass(parts_.copy(0, row.node)) + mass(parts_.copy(1, row.node));
      for (const int side : {0, 1}) {
        if (parts_.copy(side, row.node) < 0) continue;
        PushRow<2> part = row;
        part.node = part.turn = parts_.copy(side, row.node);
        if (parts_.on_both(row.node)) part.weight *= mass(part.node) / all;
        given.push_back(part);
      }
    }
    rows = std::move(given);
  }

  template <class See>
  void for_face(const SplitFace& face, See&& see) const {
    const MeshParts::Face at = parts_.face(face.skin_a, face.skin_b);
    if (at.side >= 0)
      see(SplitFace{parts_.body(at.side), parts_.skin_copy(at.side, face.skin_a),
                    parts_.skin_copy(at.side, face.skin_b)});
  }
  template <class See>
  void for_new_faces(const MeshCut& cut, See&& see) const {
    const int first = body_at(model_, split_.body).first_skin;
    for (const auto& face : cut.faces)
      for (const int side : {0, 1}) {
        const int from = parts_.skin_copy(side, first + face[0]), to = parts_.skin_copy(side, first + face[1]);
        see(side == 0 ? SplitFace{split_.behind, from, to} : SplitFace{split_.ahead, to, from});
      }
  }

 private:
  [[nodiscard]] static bool has_weight(const Attachment<2>& at, int i) {
    return std::abs(at.weight[static_cast<std::size_t>(i)]) > 1e-9;
  }
  [[nodiscard]] double mass(int node) const { return node < 0 ? 0 : model_.mass[static_cast<std::size_t>(node)]; }
  [[nodiscard]] bool holds(int side, const Attachment<2>& at, bool weighted) const {
    for (int i = 0; i < at.nodes; ++i)
      if ((!weighted || has_weight(at, i)) && parts_.copy(side, at.node[static_cast<std::size_t>(i)]) < 0) return false;
    return true;
  }
  [[nodiscard]] int side_of(const Attachment<2>& at) const {
    for (const bool weighted : {false, true})
      for (const int side : {0, 1})
        if (holds(side, at, weighted)) return side;
    return 0;
  }

  const Model<2>& model_;
  SplitBody split_;
  const MeshParts& parts_;
};

/// The parts that a kind of load sees, with the faces of the crack.
class MeshLoadParts : public MeshLinks {
 public:
  MeshLoadParts(const MeshLinks& links, const MeshCut& cut) : MeshLinks(links), cut_(cut) {}
  template <class See>
  void for_new_faces(See&& see) const {
    MeshLinks::for_new_faces(cut_, see);
  }

 private:
  const MeshCut& cut_;
};

/// A load at a point of the cut becomes two, which share it like the mass.
template <class L>
void give_load(const L& load, const MeshLoadParts& parts, std::vector<L>& given) {
  if constexpr (requires(L l) {
                  l.at;
                  l.body;
                })
    if (parts.is_on(load.body) && parts.is_on_cut(load.at)) {
      for (const int side : {0, 1}) {
        L part = load;
        part.scale(parts.share(side, load.at));
        parts.give(part.at, part.body, side);
        given.push_back(std::move(part));
      }
      return;
    }
  hand_over(load, parts, given);
}

/// Supports, motions and steady forces of the nodes.
void copy_conditions(Model<2>& model, const MeshParts& parts, int body) {
  const Body b = body_at(model, body);
  for (int n = b.first_node; n < b.first_node + b.nodes; ++n)
    for (const int side : {0, 1}) {
      const int copy = parts.copy(side, n);
      if (copy < 0) continue;
      const auto p = static_cast<std::size_t>(copy), from = static_cast<std::size_t>(n);
      model.support[p] = model.support[from];
      model.load[p] = model.mass[p] / model.mass[from] * model.load[from];
      for (std::size_t k = 0; k < model.drive_of[from].size(); ++k) {
        if (model.drive_of[from][k] < 0) continue;
        Drive drive = model.drives[static_cast<std::size_t>(model.drive_of[from][k])];
        drive.node = copy;
        model.drive_of[p][k] = static_cast<int>(model.drives.size());
        model.drives.push_back(std::move(drive));
      }
    }
}

}  // namespace

void hand_over_mesh_links(Model<2>& model, const SplitBody& split, const MeshCut& cut) {
  const MeshParts rows(model, split, cut);
  const MeshLoadParts parts(MeshLinks(model, split, rows), cut);
  const auto give_end = [&](Attachment<2>& at, int& body, int& piece) {
    if (!parts.is_on(at)) return;
    parts.give(at, body);
    const MeshParts::Face own = piece >= 0 ? rows.piece(piece) : MeshParts::Face{};
    piece = own.piece >= 0 ? own.piece : body_at(model, body).first_piece;
  };
  for (Bearing<2>& b : model.bearings) {
    give_end(b.end_a, b.body_a, b.piece_a);
    give_end(b.end_b, b.body_b, b.piece_b);
  }
  for (Seat<2>& s : model.seats) {
    if (parts.is_on(s.end)) parts.give(s.end, s.body);
    if (parts.is_on(s.edge)) parts.give(s.edge, s.support);
  }
  for (Push<2>& push : model.pushes) parts.give(push.rows);
  model.loads.for_each_kind([&]<class L>(std::vector<L>& loads) {
    if constexpr (acts_in<L, 2> && !is_inertia<L>) {
      std::vector<L> given;
      for (const L& load : loads) give_load(load, parts, given);
      loads = std::move(given);
    }
  });
  copy_conditions(model, rows, split.body);
}

std::vector<ContactRecord> mesh_handed_over(const Model<2>& model, const std::vector<ContactRecord>& records,
                                            const SplitBody& split, const MeshCut& cut) {
  const MeshParts parts(model, split, cut);
  const auto body_of = [&](int piece) { return model.piece_body[static_cast<std::size_t>(piece)]; };
  std::vector<ContactRecord> out;
  for (const ContactRecord& record : records) {
    const bool first = body_of(record.piece_a) == split.body;
    if (!first && body_of(record.piece_b) != split.body) {
      out.push_back(record);
      continue;
    }
    ContactRecord given = record;
    int &piece = first ? given.piece_a : given.piece_b, &from = first ? given.a0 : given.b0,
        &to = first ? given.a1 : given.b1;
    const MeshParts::Face own = record.general ? parts.piece(piece) : parts.face(from, to);
    if (own.piece < 0) continue;
    piece = own.piece;
    if (!record.general) from = parts.skin_copy(own.side, from), to = parts.skin_copy(own.side, to);
    out.push_back(ordered(std::move(given)));
  }
  return out;
}

/// The shear of an edge is linear. Its two halves act at a quarter and three quarters of the edge, so that they have
/// the nodal forces of the stress.
std::vector<ContactRecord> mesh_crack_contacts(const Model<2>& model, const SplitBody& split,
                                               const CrackingBody<2>& row, const Crack<2>& crack) {
  const MeshCut& cut = *row.sections[static_cast<std::size_t>(crack.section)].cut;
  const MeshParts parts(model, split, cut);
  const Body& whole = body_at(model, split.body);
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

}  // namespace trilith
