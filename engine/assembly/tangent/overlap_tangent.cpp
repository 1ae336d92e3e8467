// The tangent of general contacts, piece by piece, including the rows whose springs change the contact direction.
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "assembly/contact/contact_rows.hpp"
#include "assembly/contact/shared_edge_normal.hpp"
#include "assembly/tangent/fd_tangent.hpp"
#include "broad_phase/bearing_rules.hpp"
#include "contact/plane/overlap_pair.hpp"

namespace trilith {
namespace {

/// A row, and the rows whose springs change its direction at a shared edge.
std::vector<int> rows_with(const Work<2>& work, int row) {
  const SharedEdgeRows<2> ridge = rows_at_shared_edges(work, row);
  if (!ridge.has_others()) return {row};
  std::vector<int> rows;
  for (std::size_t i = 0; i < ridge.count; ++i) rows.push_back(ridge.row[i]->row);
  return rows;
}

/// The skin points of the pieces of rows. Points that move with a perturbed node are placed again, and all are
/// restored.
class RowSkins {
 public:
  RowSkins(const Model<2>& model, Work<2>& work, std::span<const int> rows) : model_(model), work_(work) {
    std::vector<int> pieces;
    for (const int row : rows)
      for (const int piece : {work.pairs[row].piece_a, work.pairs[row].piece_b})
        if (std::find(pieces.begin(), pieces.end(), piece) == pieces.end()) pieces.push_back(piece);
    for (const int piece : pieces)
      for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c)
        if (std::find(skin_.begin(), skin_.end(), model.corner_skin[c]) == skin_.end())
          skin_.push_back(model.corner_skin[c]);
    for (const int s : skin_) {
      was_.push_back(work.skin[s]);
      if (!work.skin_mean.empty()) mean_was_.push_back(work.skin_mean[s]);
    }
  }
  RowSkins(const RowSkins&) = delete;
  RowSkins& operator=(const RowSkins&) = delete;
  ~RowSkins() { reactivate(); }

  void reactivate() {
    for (std::size_t i = 0; i < skin_.size(); ++i) {
      work_.skin[skin_[i]] = was_[i];
      if (!mean_was_.empty()) work_.skin_mean[skin_[i]] = mean_was_[i];
    }
  }
  void place(const State<2>& state, const Freedom& moved) {
    reactivate();
    const double per_step = state.last_dt > 0 ? 1 / state.last_dt : 0;
    for (std::size_t i = 0; i < skin_.size(); ++i) {
      const int s = skin_[i];
      if (moved.node != (moved.k == 2 ? model_.skin_turn[s] : model_.skin_node[s])) continue;
      work_.skin[s] = placed_skin(model_, state, s).motion;
      if (mean_was_.empty()) continue;
      const Vec2 by(work_.skin[s].x - was_[i].x, work_.skin[s].y - was_[i].y);
      work_.skin_mean[s] = mean_was_[i] + per_step * by;
    }
  }
  void list_nodes(TermNodes& nodes) const {
    nodes.clear();
    for (const int s : skin_) nodes.add_skin(model_, s);
  }

 private:
  const Model<2>& model_;
  Work<2>& work_;
  std::vector<int> skin_;
  std::vector<SkinMotion<2>> was_;
  std::vector<Vec2> mean_was_;
};

/// Forces at the corners of a piece, transferred to its nodes.
void take_corners(const TermSum<2>& sum, const Work<2>& work, int piece, const Vec2* force, const TermNodes& nodes,
                  TermForces& out) {
  const Model<2>& model = sum.model;
  for (int c = model.piece_first[piece]; c < model.piece_first[piece + 1]; ++c, ++force) {
    if (force->isZero(0)) continue;
    const int s = model.corner_skin[c], n = model.skin_node[s];
    const Vec2 arm = Vec2(work.skin[s].x, work.skin[s].y) - sum.state.position[n];
    double* const on = &out[3 * nodes.place_of(n)];
    on[0] += force->x(), on[1] += force->y();
    out[3 * nodes.place_of(model.skin_turn[s]) + 2] += cross(arm, *force);
  }
}

/// The contact of two pieces by the overlap of their areas, as placed in `work`. `rows`: the row itself, then the rows
/// whose springs change its direction.
class GeneralTerm {
 public:
  GeneralTerm(const TermSum<2>& sum, const Work<2>& work, const ContactHistory& before, std::span<const int> rows)
      : sum_(sum), work_(work), before_(before), rows_(rows) {}

  void respond(const TermNodes& nodes, TermForces& out) {
    const NearPair& pair = work_.pairs[rows_[0]];
    on_a_.fill(Vec2::Zero()), on_b_.fill(Vec2::Zero());
    const Vec2 along = rows_.size() > 1 ? direction() : Vec2(Vec2::Zero());
    ask(rows_[0], [&](const PlacedPiece& a, const PlacedPiece& b, const Remembered& before, const LawInUse& law) {
      const auto on = [](auto& force, const PlacedPiece& p) { return std::span(force).first(p.corner.size()); };
      respond_overlap(a, b, before, law, on(on_a_, a), on(on_b_, b), law_after_.data(), nullptr,
                      rows_.size() > 1 ? &along : nullptr);
    });
    take_corners(sum_, work_, pair.piece_a, on_a_.data(), nodes, out);
    take_corners(sum_, work_, pair.piece_b, on_b_.data(), nodes, out);
  }

 private:
  /// Calls f with the two pieces of a row in their present position, its memory, and its law.
  template <class F>
  void ask(int row, F&& f) {
    const NearPair& pair = work_.pairs[row];
    PieceCorners corners_a, corners_b;
    law_after_.resize(law_number_counts[before_.law_row[row].place] + 1);
    f(placed_piece(sum_.model, sum_.state, work_, pair.piece_a, corners_a),
      placed_piece(sum_.model, sum_.state, work_, pair.piece_b, corners_b),
      Remembered{before_.memory[row], before_.law_numbers(row)},
      law_beside_bearings(sum_.model, sum_.state, work_, pair, sum_.options.dt));
  }
  [[nodiscard]] Vec2 direction() {
    Vec2 push = Vec2::Zero();
    for (const int row : rows_)
      ask(row, [&](const PlacedPiece& a, const PlacedPiece& b, const Remembered& before, const LawInUse& law) {
        push += spring_force(a, b, before, law, law_after_.data());
      });
    return push.normalized();
  }

  const TermSum<2>& sum_;
  const Work<2>& work_;
  const ContactHistory& before_;
  std::span<const int> rows_;
  std::vector<double> law_after_;  // not used afterwards
  std::array<Vec2, max_piece_corners> on_a_, on_b_;
};

}  // namespace

void add_overlap_terms(TermSum<2>& sum, Work<2>& work) {
  const ContactHistory& before = contacts_before(sum.state, work);
  const double near = work.travel + reach_of_moves(sum.options);
  TermNodes nodes;
  for (int row = 0; row < static_cast<int>(work.pairs.size()); ++row) {
    if (!is_general(work, row)) continue;
    const bool touches = (work.contacts.memory[row].state & contact_touching) != 0;
    if (!touches && (work.pairs[row].replaced || work.asleep_until[row] > near)) continue;
    const std::vector<int> rows = rows_with(work, row);
    RowSkins skins(sum.model, work, rows);
    skins.list_nodes(nodes);
    GeneralTerm term(sum, work, before, rows);
    sum.add(nodes, [&](const Freedom& moved, TermForces& out) {
      skins.place(sum.state, moved);
      term.respond(nodes, out);
    });
  }
}

}  // namespace trilith
