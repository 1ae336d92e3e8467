#include "assembly/tangent/dof_graph.hpp"

#include <algorithm>

namespace trilith {
namespace {

/// Numbers the unknowns by node, then by direction; fixed and driven directions have none.
template <int D>
void list_freedoms(const Model<D>& model, DofGraph<D>& out) {
  std::array<int, Space<D>::dofs> none;
  none.fill(-1);
  out.unknown.assign(model.mass.size(), none);
  for (int n = 0; n < model.nodes(); ++n)
    for (int k = 0; k < Space<D>::dofs; ++k) {
      if (model.support[n][k] != Support::free) continue;
      out.unknown[n][k] = out.size();
      out.freedom.push_back({n, k});
    }
}

/// Groups of nodes; all nodes of a group are coupled.
template <int D>
class Groups {
 public:
  Groups(const Model<D>& model, DofGraph<D>& out) : model_(model), out_(out) { out.near.resize(model.mass.size()); }

  void add(int node) {
    if (model_.moves(node)) group_.push_back(node);
  }
  void add_carrier(int contact_frame) {
    for_nodes_of(model_, contact_frame, [&](int n) { add(n); });
  }
  void add(const Attachment<D>& attachment) {
    for (int i = 0; i < attachment.nodes; ++i) add_carrier(attachment.node[i]), add_carrier(attachment.turn[i]);
  }
  void add_skin(int skin) { add(model_.skin_node[skin]), add(model_.skin_turn[skin]); }
  void add_piece(int piece) {
    const Body& body = model_.bodies[model_.piece_body[piece]];
    if (body.is_rigid()) return add(body.first_node);
    if (model_.is_fitted(piece)) return for_nodes_of_piece(model_, piece, [&](int n) { add(n); });
    for (int c = model_.piece_first[piece]; c < model_.piece_first[piece + 1]; ++c) add_skin(model_.corner_skin[c]);
  }
  void end() {
    std::sort(group_.begin(), group_.end());
    group_.erase(std::unique(group_.begin(), group_.end()), group_.end());
    for (const int n : group_) out_.near[n].insert(out_.near[n].end(), group_.begin(), group_.end());
    group_.clear();
  }

 private:
  const Model<D>& model_;
  DofGraph<D>& out_;
  std::vector<int> group_;
};

/// Each node with itself, and the nodes of each element.
template <int D>
void add_bodies(const Model<D>& model, Groups<D>& groups) {
  for (int n = 0; n < model.nodes(); ++n) groups.add(n), groups.end();
  for (const Element& e : model.elements) {
    for (int i = 0; i < e.nodes; ++i) groups.add(e.node[i]);
    groups.end();
  }
  for (const SpaceElement& e : model.space_elements) {
    for (int i = 0; i < info_of(e.shape).nodes; ++i) groups.add(e.node[static_cast<std::size_t>(i)]);
    groups.end();
  }
}

template <int D>
void add_beams(const Model<D>& model, Groups<D>& groups) {
  for (const Beam& beam : model.beams) groups.add(beam.node[0]), groups.add(beam.node[1]), groups.end();
  for (const Beam3& beam : model.beams_3d) groups.add(beam.node[0]), groups.add(beam.node[1]), groups.end();
}

/// Couples two neighbouring pieces with the pieces that share an edge with either and are near the other: at a common
/// edge they have one contact direction (assembly/contact/shared_edge_normal.hpp). `a`, `b`: the pieces of a pair, in
/// either order.
template <int D>
void add_ridge_pieces(const Work<D>& work, int a, int b, Groups<D>& groups) {
  for (const SharedEdgePart& part : work.ridges.parts_of(a))
    for (const int piece : work.ridges.pieces_of(part.ridge))
      if (work.contacts.find(contact_key(std::min(piece, b), std::max(piece, b))) >= 0) groups.add_piece(piece);
}

/// The places of a load, in the form of `visit` (load/load_kind.hpp).
template <int D>
struct GroupPlaces {
  Groups<D>& groups;
  void operator()(const Attachment<D>& at) const { groups.add(at); }
  void operator()(int skin) const { groups.add_skin(skin); }
};

/// Bearings couple the nodes of their ends, loads the nodes of their places, and each candidate pair all
/// nodes of both pieces, because the contact may change within a step.
template <int D>
void add_links(const Model<D>& model, const Work<D>& work, Groups<D>& groups) {
  for (const Bearing<D>& b : model.bearings) groups.add(b.end_a), groups.add(b.end_b), groups.end();
  model.loads.for_each([&](const auto& load) {
    for (int part = 0; part < load.parts(); ++part) {
      load.visit(part, GroupPlaces<D>{groups});
      groups.end();
    }
  });
  for (const NearPair& p : work.pairs) {
    groups.add_piece(p.piece_a), groups.add_piece(p.piece_b);
    add_ridge_pieces(work, p.piece_a, p.piece_b, groups), add_ridge_pieces(work, p.piece_b, p.piece_a, groups);
    groups.end();
  }
}

void make_unique(std::vector<std::vector<int>>& near) {
  for (std::vector<int>& row : near) {
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
  }
}

/// Each node takes the first colour that no node has which acts on a common node (Curtis, Powell and Reid, "On the
/// estimation of sparse Jacobian matrices", J. Inst. Maths Applics 13, 1974). The pattern is symmetric.
template <int D>
void choose_colours(DofGraph<D>& out) {
  std::vector<int> colour_of(out.near.size(), -1), taken_by;
  for (std::size_t n = 0; n < out.near.size(); ++n) {
    if (out.near[n].empty()) continue;
    const int self = static_cast<int>(n);
    for (const int through : out.near[n])
      for (const int other : out.near[through])
        if (colour_of[other] >= 0) taken_by[colour_of[other]] = self;
    const auto free = std::find_if(taken_by.begin(), taken_by.end(), [&](int by) { return by != self; });
    colour_of[n] = static_cast<int>(free - taken_by.begin());
    if (free == taken_by.end()) taken_by.push_back(-1), out.colour.emplace_back();
    out.colour[colour_of[n]].push_back(self);
  }
}

}  // namespace

template <int D>
DofGraph<D> dof_graph_of(const Model<D>& model, const Work<D>& work) {
  DofGraph<D> out;
  list_freedoms(model, out);
  Groups groups(model, out);
  add_bodies(model, groups);
  add_links(model, work, groups);
  add_beams(model, groups);
  make_unique(out.near);
  choose_colours(out);
  return out;
}

template DofGraph<2> dof_graph_of(const Model<2>&, const Work<2>&);
template DofGraph<3> dof_graph_of(const Model<3>&, const Work<3>&);

}  // namespace trilith
