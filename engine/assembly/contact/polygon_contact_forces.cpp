// Contacts of general shape: corners, deep overlap, tumbling pieces.
#include <algorithm>
#include <array>
#include <atomic>
#include <cassert>
#include <span>

#include "assembly/contact/contact_rows.hpp"
#include "assembly/contact/corner_rows.hpp"
#include "assembly/contact/general_contact_partition.hpp"
#include "assembly/contact/shared_edge_normal.hpp"
#include "assembly/evaluate.hpp"
#include "assembly/stored_energy.hpp"
#include "base/ask_for.hpp"
#include "base/team.hpp"
#include "broad_phase/bearing_rules.hpp"
#include "broad_phase/pairs.hpp"
#include "contact/plane/overlap_energy.hpp"

namespace trilith {

namespace {

/// Energy that two faces stored and their general contact does not: the effects of dilation and of halves crushed
/// unequally have no counterpart in the overlap of areas.
ShapeLoss change_of_shape(const Work<2>& work, const NearPair& pair, const Remembered& before, const LawInUse& use) {
  return with_kernel(use, [&]<class K>(const K& law) {
    return law.leave_faces(face_overlap(work, pair), before.contact, law_memory<K>(before.law));
  });
}

/// Sets the memory of a row whose pieces do not touch.
void part_row(const ContactHistory& before, ContactHistory& after, int row) {
  after.memory[row] = before.memory[row].parted();
  with_kernel_type(before.law_row[row].place, [&]<class K>() {
    keep_law_memory<K>(K::parted(law_memory<K>(before.law_numbers(row))), after.law_numbers(row));
  });
}

/// True if no law has a memory for pieces that are apart.
bool forgets_all(const Model<2>& model) {
  return std::all_of(model.laws.begin(), model.laws.end(), [](const ContactLaw& law) {
    return std::visit([]<class L>(const L&) { return !L::Kernel::bonds && !L::Kernel::crushes; }, law);
  });
}

/// The rows of one evaluation. Each depends on State and its own row, and writes only its own row.
struct GeneralPass {
  const Model<2>& model;
  const State<2>& state;
  const ContactHistory& before;
  Work<2>& work;
  double dt;
  bool forgets;  ///< see forgets_all: if false, only rows without memory sleep

  /// False if the pieces were apart and still are. A row that did not touch and has no memory is already empty before
  /// and after.
  [[nodiscard]] bool wakes(int row) const {
    // A pair found apart sleeps until the travel of the fastest point may have brought it together.
    const bool awake = work.travel >= work.asleep_until[row];
    if (forgets) return awake;
    const ContactMemory& memory = before.memory[row];
    if ((memory.state & contact_touching) != 0) return true;
    assert(!memory.empty() || work.contacts.memory[row].empty());
    if (!memory.empty()) part_row(before, work.contacts, row);
    return awake;
  }
  /// Distance at the edge that separated two pieces last; 0 if it does not separate them now [m].
  [[nodiscard]] double still_apart(const PlacedPiece& a, const PlacedPiece& b, int row) const {
    const int by = work.pairs[row].apart_by, e = by % max_piece_corners;
    const PlacedPiece &owner = by < max_piece_corners ? a : b, &other = by < max_piece_corners ? b : a;
    if (by < 0 || e >= static_cast<int>(owner.corner.size())) return 0;
    return distance_outside(owner.sides.row[e], other.corner);
  }
  void sleep(int row, double distance) const {
    // Each of the two may approach by the travel of the fastest point.
    work.asleep_until[row] = work.travel + 0.5 * (1 - 1e-9) * distance;
  }
  /// True if the special case of one corner below one face is implemented for a pair with the memory `memory`.
  [[nodiscard]] bool knows_corners(const NearPair& pair, const ContactMemory& memory, LawOfCorners& last) const {
    return last.knows(model, pair.law) && !pair.replaced && (memory.empty() || (memory.state & contact_general) != 0);
  }
  [[nodiscard]] PlainFriction friction_of(int law) const { return plain_friction(law_in_use(model, law, dt)); }
  void fetch_pairs(std::span<const int> rows) const;
  void fetch(std::span<const int> rows) const;
  /// As place_once(), without a call for a piece that is placed already, as for nearly all rows.
  void place(int piece) const {
    constexpr std::uint8_t is_made = 2;  // see make_once
    if (std::atomic_ref(work.placed.is_placed[piece]).load(std::memory_order_acquire) != is_made)
      place_once(model, state, work, piece);
  }
  void respond_run(GeneralRun<2>& run, OverlapAnswer* answers, Vec2* force) const;
  void respond_rows(std::span<const int> rows, OverlapAnswer* answers, Vec2* force) const;
  void respond(int row, CornerOnFace tried, OverlapAnswer& answer) const;
  [[nodiscard]] CornerCase corner_case(int row, CornerOnFace at, OverlapAnswer& answer) const;
  void finish_corner(int row, CornerOnFace at, OverlapAnswer& answer) const;
  [[nodiscard]] bool holds_off(int row, OverlapAnswer& answer) const;
  CornerOnFace respond_any(int row, OverlapAnswer& answer, bool may_be_corner, const Vec2* along = nullptr) const;
  void finish(int row, OverlapAnswer& answer) const;
};

std::span<Vec2> forces_on(Vec2* on, const PlacedPiece& piece) {
  return {on, piece.corner.size()};
}

/// Prepares an answer for writing, with its forces on both pieces from `force` on; returns the end of these.
Vec2* make_ready(OverlapAnswer& answer, const PlacedPiece& a, const PlacedPiece& b, Vec2* force) {
  answer.counts = true;
  answer.changed = answer.touching = false;
  answer.let_go = {};
  answer.corner_at = {};
  answer.on_a = force, answer.on_b = force + a.corner.size();
  return answer.on_b + b.corner.size();
}

/// Prefetches the pairs of the next rows while others are processed. They are too far apart in memory for hardware
/// prefetching.
void GeneralPass::fetch_pairs(std::span<const int> rows) const {
  for (const int row : rows) ask_for<Asked::read, sizeof(NearPair)>(&work.pairs[row]);
}

/// Prefetches the memories of the next rows, and the data that placing their pieces reads and writes.
void GeneralPass::fetch(std::span<const int> rows) const {
  PlacedPieces& placed = work.placed;
  constexpr std::size_t room = 64;
  std::array<int, room> asked;  // pieces asked for already, which have several of the rows
  asked.fill(-1);
  for (const int row : rows) {
    const NearPair& pair = work.pairs[row];
    ask_for<Asked::read, sizeof(ContactMemory)>(&before.memory[row]);
    ask_for<Asked::write, sizeof(ContactMemory)>(&work.contacts.memory[row]);
    for (const int piece : {pair.piece_a, pair.piece_b}) {
      // If another thread is placing it, the prefetch is merely useless.
      int& last = asked[static_cast<std::size_t>(piece) % room];
      if (last == piece || std::atomic_ref(placed.is_placed[piece]).load(std::memory_order_relaxed) != 0) continue;
      last = piece;
      const PieceSource& source = placed.source[piece];
      ask_for<Asked::read, lane_count * sizeof(SkinMotion<2>)>(&work.skin[source.skin]);
      ask_for<Asked::read, sizeof(Vec2)>(&state.position[source.node]);
      ask_for<Asked::read, sizeof(Vec2)>(&state.velocity[source.node]);
      ask_for<Asked::read, sizeof(double)>(&state.spin[source.node]);
      ask_for<Asked::write, sizeof(PlacedPiece)>(&placed.piece[piece]);
      ask_for<Asked::write, lane_count * sizeof(Vec2)>(&placed.place[source.corner]);
      ask_for<Asked::write, lane_count * sizeof(EdgeRow)>(&placed.row[PlacedPieces::first_row(piece, source.corner)]);
      ask_for<Asked::write, lane_count * sizeof(Vec2)>(&work.skin_force[source.skin]);
    }
  }
}

/// Evaluates the case of one corner below one face, or of one corner of each piece in the other, for several rows at a
/// time. These are rows with this case in the last step, and rows that have it now. All other rows are evaluated one by
/// one. `answers`: one for each row; `force`: buffer for the forces of all rows.
void GeneralPass::respond_rows(std::span<const int> rows, OverlapAnswer* answers, Vec2* force) const {
  // All pieces first: a short loop allows more parallel memory accesses.
  for (const int row : rows) {
    const NearPair& pair = work.pairs[row];
    place(pair.piece_a), place(pair.piece_b);
  }
  LawOfCorners last;
  CornerRows one, both;  // one corner under a face; one corner of each piece in the other
  const auto answer_waiting = [&](CornerRows& waiting) {
    if (waiting.count == 0) return;
    const std::uint32_t done = respond_corners(std::span(waiting.pair).first(waiting.count), *waiting.friction);
    for (std::size_t k = 0; k < waiting.count; ++k)
      (done >> k & 1U) != 0 ? finish_corner(waiting.row[k], waiting.pair[k].at, *waiting.answer[k])
                            : respond(waiting.row[k], waiting.pair[k].at, *waiting.answer[k]);
    waiting.count = 0;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const int row = rows[i];
    NearPair& pair = work.pairs[row];
    const ContactMemory& memory = before.memory[row];
    OverlapAnswer& answer = answers[i];
    answer.counts = false;
    if (pair.replaced && holds_off(row, answer)) continue;
    const PlacedPiece &a = work.placed.piece[static_cast<std::size_t>(pair.piece_a)],
                      &b = work.placed.piece[static_cast<std::size_t>(pair.piece_b)];
    if (memory.empty())
      if (const double distance = still_apart(a, b, row); distance > 0) {
        sleep(row, distance);
        continue;
      }
    force = make_ready(answer, a, b, force);
    if (Vec2 along; !work.met.empty() && direction_at_shared_edges(work, row, along)) {
      respond_any(row, answer, false, &along);
      continue;
    }
    const bool knows = knows_corners(pair, memory, last) && has_plain_corners(a) && has_plain_corners(b);
    CornerOnFace at = pair.corner_at;
    if (!knows || !at.is_there() || !there_is(at, a, b)) {
      at = respond_any(row, answer, knows);
      if (!at.is_there()) continue;
    }
    CornerRows& waiting = at.both ? both : one;
    if (waiting.law != pair.law) answer_waiting(waiting), waiting.begin(pair.law, friction_of(pair.law));
    waiting.add(row, {&a, &b, at, &memory, &work.contacts.memory[row], &answer.response, &answer.push}, answer);
    if (waiting.count == waiting.pair.size()) answer_waiting(waiting);
  }
  answer_waiting(one), answer_waiting(both);
}

/// True if a bearing carries the load of its two faces. Flat contact is suppressed and its depth is stored; a tilted
/// piece presses only with the additional depth. The remaining energy of the contact is dissipated when it lies flat
/// again.
bool GeneralPass::holds_off(int row, OverlapAnswer& answer) const {
  const NearPair& pair = work.pairs[row];
  const PlacedPiece &a = work.placed.piece[static_cast<std::size_t>(pair.piece_a)],
                    &b = work.placed.piece[static_cast<std::size_t>(pair.piece_b)];
  const OverlapResponse whole = whole_overlap(a, b, law_in_use(model, pair.law, dt));
  if (!whole.touching || !presses_flat<2>(model, state, work, state.bearing, pair, whole.force)) return false;
  stand_for<2>(model, work.search, pair, whole.depth, work.stood_for);
  const bool was = (before.memory[row].state & contact_touching) != 0;
  if (was) part_row(before, work.contacts, row);
  answer.counts = answer.changed = was;
  answer.touching = false;
  answer.let_go = {}, answer.response = {};
  if (was)
    answer.let_go.friction = general_energy(a, b, {before.memory[row], before.law_numbers(row)},
                                            law_beside_bearings(model, state, work, pair));
  return true;
}

/// Evaluates a row that the corner `tried` does not describe. The result for one corner is computed in one way,
/// remembered or not, so that the bits do not depend on it.
void GeneralPass::respond(int row, CornerOnFace tried, OverlapAnswer& answer) const {
  const CornerOnFace at = respond_any(row, answer, true);
  if (!at.is_there()) return;
  const NearPair& pair = work.pairs[row];
  if (!(at == tried)) {
    const CornerCase one = corner_case(row, at, answer);
    if (respond_corners({&one, 1}, friction_of(pair.law)) != 0) return finish_corner(row, at, answer);
  }
  respond_any(row, answer, false);
}

/// Evaluates a row of any shape with placed pieces. If `may_be_corner` and exactly one corner of either piece, or one
/// of each, lies in the other, this case is stored and returned without evaluation. `along`: see
/// direction_at_shared_edges.
CornerOnFace GeneralPass::respond_any(int row, OverlapAnswer& answer, bool may_be_corner, const Vec2* along) const {
  NearPair& pair = work.pairs[row];
  const PlacedPiece &a = work.placed.piece[static_cast<std::size_t>(pair.piece_a)],
                    &b = work.placed.piece[static_cast<std::size_t>(pair.piece_b)];
  const ContactMemory& memory = before.memory[row];
  const LawInUse law = law_beside_bearings(model, state, work, pair, dt);
  const Remembered remembered{memory, before.law_numbers(row)};
  CornerOnFace alone;
  std::fill(answer.on_a, answer.on_b + b.corner.size(), Vec2::Zero());
  answer.response = respond_overlap(a, b, remembered, law, forces_on(answer.on_a, a), forces_on(answer.on_b, b),
                                    work.contacts.law_numbers(row), may_be_corner ? &alone : nullptr, along);
  if (may_be_corner) pair.corner_at = alone;
  if (alone.is_there()) return alone;
  if (pair.replaced)
    stand_for<2>(model, work.search, pair, answer.response.separation > 0 ? 0 : law.held, work.stood_for);
  if ((memory.state & contact_touching) != 0 && (memory.state & contact_general) == 0)
    answer.let_go = change_of_shape(work, pair, remembered, law);
  finish(row, answer);
  return {};
}

/// The corner case of a row, with the destination of its answer.
CornerCase GeneralPass::corner_case(int row, CornerOnFace at, OverlapAnswer& answer) const {
  const NearPair& pair = work.pairs[row];
  const std::vector<PlacedPiece>& placed = work.placed.piece;
  return {&placed[pair.piece_a],      &placed[pair.piece_b], at,          &before.memory[row],
          &work.contacts.memory[row], &answer.response,      &answer.push};
}

/// finish() for a row that the corner case has evaluated: it touches, and its memory is written.
void GeneralPass::finish_corner(int row, CornerOnFace at, OverlapAnswer& answer) const {
  const ContactMemory& memory = before.memory[row];
  answer.changed = (memory.state & contact_touching) == 0 || memory.bonds != 0 || (memory.state & contact_kept) != 0;
  answer.touching = true;
  answer.corner_at = at;
}

/// Completes a row after its response: change flag, memory, and sleep limit.
void GeneralPass::finish(int row, OverlapAnswer& answer) const {
  const ContactMemory& memory = before.memory[row];
  const OverlapResponse& r = answer.response;
  const bool was = (memory.state & contact_touching) != 0;
  answer.changed =
      was != r.touching || memory.bonds != 0 || (memory.state & contact_kept) != (r.memory.state & contact_kept);
  if (was || r.touching) work.contacts.memory[row] = r.memory;
  answer.touching = r.touching;
  if (r.touching) return;
  NearPair& pair = work.pairs[row];
  pair.apart_by = static_cast<std::int16_t>(r.apart_by);
  pair.corner_at = {};
  if (!was || !forgets) sleep(row, r.separation);
}

/// Rows that are evaluated before their results are added.
constexpr int general_stretch = 64;

/// Rows of a run in the chunk from `first`, not beyond its end.
std::span<const int> rows_from(const Work<2>& work, const GeneralRun<2>& run, int first) {
  const int from = std::min(first, run.last), to = std::min(first + general_stretch, run.last);
  return std::span(work.awake_rows).subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from));
}

/// `answers`: buffer for a chunk; `force`: buffer for the forces of its rows.
void GeneralPass::respond_run(GeneralRun<2>& run, OverlapAnswer* answers, Vec2* force) const {
  fetch_pairs(rows_from(work, run, run.first + general_stretch));
  fetch(rows_from(work, run, run.first));
  for (int first = run.first; first < run.last; first += general_stretch) {
    const std::span<const int> rows = rows_from(work, run, first);
    fetch_pairs(rows_from(work, run, first + 2 * general_stretch));
    fetch(rows_from(work, run, first + general_stretch));
    respond_rows(rows, answers, force);
    take_up(model, work, run, first, first + static_cast<int>(rows.size()), answers);
  }
}

/// Lists the active rows of a chunk of all rows: rows of general shape, and rows whose faces are not a pair of flat
/// faces now. They are in order, from the start of the chunk in Work::awake_rows. Returns their number.
int list_stretch(const GeneralPass& pass, Work<2>& work, int first, int last) {
  std::fill(work.is_general.begin() + first, work.is_general.begin() + last, std::uint8_t{0});
  const auto begin = std::lower_bound(work.general.begin(), work.general.end(), first);
  for (auto row = begin; row != work.general.end() && *row < last; ++row) work.is_general[*row] = 1;
  for (const int row : work.general_now)
    if (row >= first && row < last) work.is_general[row] = 1;
  int* const awake = work.awake_rows.data() + first;
  int count = 0;
  for (int row = first; row < last; ++row) {
    awake[count] = row;
    if (work.is_general[row] != 0) count += pass.wakes(row) ? 1 : 0;
  }
  return count;
}

/// Lists the active rows of all chunks: threads list equal shares, and their lists are moved together.
void list_rows(const GeneralPass& pass, Work<2>& work) {
  constexpr int least_listed = 1024;
  const int count = static_cast<int>(work.pairs.size());
  const int stretch = std::max(least_listed, (count + work.threads - 1) / std::max(1, work.threads));
  const int stretches = (count + stretch - 1) / stretch;
  work.is_general.resize(work.pairs.size()), work.awake_rows.resize(work.pairs.size());
  work.awake_counts.resize(static_cast<std::size_t>(stretches));
  share(work.threads, stretches, 1, [&](int first, int last, int /*thread*/) {
    for (int s = first; s < last; ++s)
      work.awake_counts[s] = list_stretch(pass, work, s * stretch, std::min(count, (s + 1) * stretch));
  });
  auto end = work.awake_rows.begin() + work.awake_counts[0];
  for (int s = 1; s < stretches; ++s) {
    const auto from = work.awake_rows.begin() + s * stretch;
    end = std::copy(from, from + work.awake_counts[s], end);
  }
  work.awake_rows.erase(end, work.awake_rows.end());
}

}  // namespace

/// Each thread processes its runs of rows (see assembly/contact/general_contact_partition.hpp).
void polygon_contact_forces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt) {
  begin_to_stand(model, work);
  if (work.general.empty() && work.general_now.empty()) return work.general_touching.begin_anew(0);
  const GeneralPass pass{model, state, contacts_before(state, work), work, dt, forgets_all(model)};
  list_rows(pass, work);
  place_none(model, work);
  join_shared_edges(model, state, work, dt);
  const int runs = partition_general_contacts(model, work);
  constexpr std::size_t forces = std::size_t{general_stretch} * 2 * max_piece_corners;
  const auto rooms = static_cast<std::size_t>(std::clamp(work.threads, 1, most_threads));
  work.answer.resize(rooms * general_stretch), work.answer_force.resize(rooms * forces);
  share(work.threads, runs, 1, [&](int first, int last, int thread) {
    const auto t = static_cast<std::size_t>(thread);
    for (int r = first; r < last; ++r)
      pass.respond_run(work.general_runs[r], &work.answer[t * general_stretch], &work.answer_force[t * forces]);
  });
  join_general_partitions(work);
}

}  // namespace trilith
