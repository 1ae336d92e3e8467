#include "assembly/contact/shared_edge_normal.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "assembly/contact/contact_rows.hpp"
#include "assembly/contact/moving_solid.hpp"
#include "assembly/contact/pair_sleeping.hpp"
#include "base/team.hpp"
#include "contact/space/solid_contact.hpp"

namespace trilith {
namespace {

/// Rows per chunk of a thread.
constexpr int met_stretch = 64;

/// True if a shared edge of one piece lies in another piece.
bool lies_in(const Work<2>& work, int owner, const SharedEdgePart& part, int other) {
  const PlacedPiece &of = work.placed.piece[static_cast<std::size_t>(owner)],
                    &in = work.placed.piece[static_cast<std::size_t>(other)];
  const Vec2& x = of.corner[static_cast<std::size_t>(part.from)];
  for (std::size_t e = 0; e < in.corner.size(); ++e) {
    const EdgeRow& edge = in.sides.row[e];
    if (!(edge.nx * (edge.x - x.x()) + edge.ny * (edge.y - x.y()) > 0)) return false;
  }
  return true;
}

/// In space a part of the length of the edge is sufficient.
bool lies_in(const Work<3>& work, int owner, const SharedEdgePart& part, int other) {
  const PlacedSolid &of = work.solids.placed[owner], &in = work.solids.placed[other];
  const Vec3 &p = of.corners[static_cast<std::size_t>(part.from)], &q = of.corners[static_cast<std::size_t>(part.to)];
  double from = 0, to = 1;
  for (int f = 0; f < in.solid->shape.faces.count(); ++f) {
    const double at_p = depth_below(in, f, p), at_q = depth_below(in, f, q);
    if (!(at_p > 0) && !(at_q > 0)) return false;
    if (at_p > 0 && at_q > 0) continue;
    const double crossing = at_p / (at_p - at_q);
    at_p > 0 ? to = std::min(to, crossing) : from = std::max(from, crossing);
  }
  return from < to || part.from == part.to;
}

/// Calls f(shared edge, owner, other) for each shared edge of either piece of a pair that lies in the other piece.
template <int D, class F>
void for_met(const Work<D>& work, const NearPair& pair, F&& f) {
  for (const bool of_a : {true, false}) {
    const int owner = of_a ? pair.piece_a : pair.piece_b, other = of_a ? pair.piece_b : pair.piece_a;
    for (const SharedEdgePart& part : work.ridges.parts_of(owner))
      if (lies_in(work, owner, part, other)) f(part.ridge, owner, other);
  }
}

template <int D>
bool meets_any(const Work<D>& work, const NearPair& pair) {
  bool any = false;
  for_met(work, pair, [&](int, int, int) { any = true; });
  return any;
}

template <int D>
bool has_ridges(const Work<D>& work, const NearPair& pair) {
  return !work.ridges.parts_of(pair.piece_a).empty() || !work.ridges.parts_of(pair.piece_b).empty();
}

/// Lists in work.met the rows for which meets(row) holds, out of `rows` rows with row_of(i), and stores push(row,
/// thread) for each.
template <int D, class RowOf, class Meets, class Push>
void list_met(Work<D>& work, std::size_t rows, RowOf&& row_of, Meets&& meets, Push&& push) {
  work.met.clear();
  if (work.ridges.empty()) return;
  const auto count = static_cast<int>(rows);
  work.meets.assign(rows, 0);
  share(work.threads, count, met_stretch, [&](int first, int last, int /*thread*/) {
    for (int i = first; i < last; ++i) work.meets[static_cast<std::size_t>(i)] = meets(row_of(i)) ? 1 : 0;
  });
  for (int i = 0; i < count; ++i)
    if (work.meets[static_cast<std::size_t>(i)] != 0) work.met.push_back({row_of(i), Vec<D>::Zero()});
  share(work.threads, static_cast<int>(work.met.size()), met_stretch, [&](int first, int last, int thread) {
    for (int i = first; i < last; ++i) {
      MetRow<D>& met = work.met[static_cast<std::size_t>(i)];
      met.push = push(met.row, thread);
    }
  });
}

/// Spring force of a row on b. It uses the trial memory of the row, which its evaluation overwrites later.
Vec2 push_of(const Model<2>& model, const State<2>& state, Work<2>& work, int row, double dt) {
  const NearPair& pair = work.pairs[row];
  const ContactHistory& before = contacts_before(state, work);
  const PlacedPiece &a = work.placed.piece[static_cast<std::size_t>(pair.piece_a)],
                    &b = work.placed.piece[static_cast<std::size_t>(pair.piece_b)];
  const auto r = static_cast<std::size_t>(row);
  return spring_force(a, b, {before.memory[r], before.law_numbers(r)}, law_in_use(model, pair.law, dt),
                      work.contacts.law_numbers(r));
}

/// The entry of a row in work.met; nullptr if there is none.
template <int D>
const MetRow<D>* find_met(const Work<D>& work, int row) {
  const auto met =
      std::lower_bound(work.met.begin(), work.met.end(), row, [](const MetRow<D>& m, int r) { return m.row < r; });
  return met != work.met.end() && met->row == row ? &*met : nullptr;
}

/// The entry of two pieces.
template <int D>
const MetRow<D>* find_met(const Work<D>& work, int piece, int other) {
  return find_met(work, work.contacts.find(contact_key(std::min(piece, other), std::max(piece, other))));
}

}  // namespace

void join_shared_edges(const Model<2>& model, const State<2>& state, Work<2>& work, double dt) {
  const auto meets = [&](int row) {
    const NearPair& pair = work.pairs[static_cast<std::size_t>(row)];
    if (pair.replaced || !has_ridges(work, pair)) return false;
    place_once(model, state, work, pair.piece_a), place_once(model, state, work, pair.piece_b);
    return meets_any(work, pair);
  };
  const auto row_of = [&](int i) { return work.awake_rows[static_cast<std::size_t>(i)]; };
  list_met(work, work.awake_rows.size(), row_of, meets,
           [&](int row, int /*thread*/) { return push_of(model, state, work, row, dt); });
}

void join_shared_edges(const Model<3>& model, const State<3>& state, Work<3>& work, double dt) {
  const Contacts<3>& before = contacts_before(state, work);
  const auto meets = [&](int row) {
    const auto r = static_cast<std::size_t>(row);
    const NearPair& pair = work.pairs[r];
    if (pair.replaced || !has_ridges(work, pair) || has_sphere(work, pair)) return false;
    if (const JointMemory* joint = before.joint_at(r); joint != nullptr && !joint->empty()) return false;
    if ((before.memory[r].state & contact_touching) == 0 && sleeps(work, r)) return false;
    return meets_any(work, pair);
  };
  const auto row_of = [](int i) { return i; };
  list_met(work, work.pairs.size(), row_of, meets, [&](int row, int thread) {
    return spring_force(model, state, work, row, dt, work.solids.room[static_cast<std::size_t>(thread)]);
  });
}

Vec2 spring_force(const PlacedPiece& a, const PlacedPiece& b, const Remembered& before, const LawInUse& law,
                  double* law_after) {
  std::array<Vec2, max_piece_corners> on_a, on_b;  // required by the function and not used
  on_a.fill(Vec2::Zero()), on_b.fill(Vec2::Zero());
  const OverlapResponse response = respond_overlap(a, b, before, law, std::span(on_a).first(a.corner.size()),
                                                   std::span(on_b).first(b.corner.size()), law_after);
  if (!response.touching) return Vec2::Zero();
  return response.force - Vec2(response.memory.damping_force[0], response.memory.damping_force[1]);
}

Vec3 spring_force(const Model<3>& model, const State<3>& state, Work<3>& work, int row, double dt, SolidRoom& room) {
  const auto r = static_cast<std::size_t>(row);
  const NearPair& pair = work.pairs[r];
  const MovingSolid a = moving_solid(model, state, work, pair.piece_a),
                    b = moving_solid(model, state, work, pair.piece_b);
  const SolidPressure pressed =
      pressure_between(a, b, {model.laws[pair.law], model.thickness, dt}, work.solids.separation[r], room.shared, true,
                       contacts_before(state, work).memory[r].crushed);
  return pressed.force - pressed.damping;
}

template <int D>
SharedEdgeRows<D> rows_at_shared_edges(const Work<D>& work, int row) {
  SharedEdgeRows<D> rows;
  const MetRow<D>* met = find_met(work, row);
  if (met == nullptr) return rows;
  rows.row[rows.count++] = met;
  rows.push = met->push;
  for_met(work, work.pairs[static_cast<std::size_t>(row)], [&](int ridge, int owner, int other) {
    for (const int piece : work.ridges.pieces_of(ridge)) {
      const MetRow<D>* at = piece == owner || rows.count == rows.row.size() ? nullptr : find_met(work, piece, other);
      const auto end = rows.row.begin() + static_cast<std::ptrdiff_t>(rows.count);
      if (at == nullptr || std::find(rows.row.begin(), end, at) != end) continue;
      rows.row[rows.count++] = at;
      rows.push += at->push;
    }
  });
  return rows;
}

template <int D>
bool direction_at_shared_edges(const Work<D>& work, int row, Vec<D>& along) {
  if (work.met.empty()) return false;
  const SharedEdgeRows<D> rows = rows_at_shared_edges(work, row);
  if (!rows.has_others()) return false;
  along = rows.push / rows.push.norm();
  return true;
}

template SharedEdgeRows<2> rows_at_shared_edges(const Work<2>& work, int row);
template SharedEdgeRows<3> rows_at_shared_edges(const Work<3>& work, int row);
template bool direction_at_shared_edges(const Work<2>& work, int row, Vec2& along);
template bool direction_at_shared_edges(const Work<3>& work, int row, Vec3& along);

}  // namespace trilith
