#include "assembly/contact/general_contact_partition.hpp"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>

#include "assembly/contact/pair_sleeping.hpp"
#include "base/simd/lanes.hpp"
#include "base/team.hpp"

namespace trilith {
namespace {

/// Least number of rows in a run.
constexpr int least_general_run = 32;
/// Least number of rows for which several threads mark the border bodies; about 5 microseconds.
constexpr int least_marked = 2048;
/// Border of the last run: no body belongs to a following run.
constexpr int no_end = std::numeric_limits<int>::max();

template <int D>
void empty_run(int first, int last, GeneralRun<D>& run) {
  run.first = first, run.last = last;
  run.end_body = no_end;
  run.later.clear(), run.losses.clear(), run.touching.clear(), run.changed.clear();
}

/// True if one run contains all rows, so that no other run adds to any body.
template <int D>
bool one_has_all(const Work<D>& work) {
  return work.general_runs.front().end_body == no_end;
}

/// Marks the bodies of a run's rows that belong to later runs. Several threads may mark the same body.
template <int D, class PairAt>
void mark_border(const Model<D>& model, const GeneralRun<D>& run, Work<D>& work, PairAt&& pair_at) {
  for (int i = run.first; i < run.last; ++i) {
    const NearPair& pair = pair_at(i);
    for (const int piece : {pair.piece_a, pair.piece_b})
      if (const int body = model.piece_body[piece]; body >= run.end_body)
        std::atomic_ref(work.at_border[body]).store(1, std::memory_order_relaxed);
  }
}

/// Implements partition_general_contacts() for `rows` rows; row i belongs to pair_at(i).
template <int D, class PairAt>
int part_rows(const Model<D>& model, Work<D>& work, int rows, PairAt&& pair_at) {
  const int parts = work.threads <= 1 ? 1 : std::clamp(rows / least_general_run, 1, runs_a_thread * work.threads);
  // Surplus runs become empty instead of being deleted: repeated deletion would allocate memory within a step.
  if (work.general_runs.size() < static_cast<std::size_t>(parts))
    work.general_runs.resize(static_cast<std::size_t>(parts));
  work.general_touching.begin_anew(static_cast<std::size_t>(rows));
  const auto first_of = [&](int t) { return static_cast<int>(static_cast<std::int64_t>(rows) * t / parts); };
  for (int t = 0; t < static_cast<int>(work.general_runs.size()); ++t)
    empty_run(first_of(std::min(t, parts)), first_of(std::min(t + 1, parts)), work.general_runs[t]);
  if (parts == 1) return parts;
  for (int t = 0; t + 1 < parts; ++t)
    work.general_runs[t].end_body = model.piece_body[pair_at(first_of(t + 1)).piece_a];
  work.at_border.assign(model.bodies.size(), 0);
  share(rows < least_marked ? 1 : work.threads, parts, 1, [&](int first, int last, int /*thread*/) {
    for (int t = first; t < last; ++t) mark_border(model, work.general_runs[t], work, pair_at);
  });
  return parts;
}

/// Sink that adds forces on the corners of a body to its skin points directly.
struct ForcesNow {
  Vec2* on;
  TRILITH_INLINE void add(int skin, const Vec2& force) const {
    double* const at = on[skin].data();
    store_pair(at, load_pair(at) + load_pair(force.data()));
  }
};

/// Sink that adds forces directly, or stores them in a list to be added later.
struct ForcesByBorder {
  ForcesNow now;
  std::vector<LaterForce<2>>* later;  ///< nullptr: directly
  TRILITH_INLINE void add(int skin, const Vec2& force) const {
    later != nullptr ? void(later->push_back({skin, force})) : now.add(skin, force);
  }
};

/// Skin points of the corners of pieces. A copy of the addresses, because the compiler must assume that adding a force
/// changes any other.
struct PieceSkins {
  const int *skins, *first;

  explicit PieceSkins(const Model<2>& model) : skins(model.corner_skin.data()), first(model.piece_first.data()) {}
  [[nodiscard]] const int* of(int piece) const { return skins + first[piece]; }
  [[nodiscard]] int count(int piece) const { return first[piece + 1] - first[piece]; }
};

template <class Sink>
void add_to_piece(const PieceSkins& skins, int piece, const Vec2* force, const Sink& sink) {
  const int *skin = skins.of(piece), count = skins.count(piece);
  for (int c = 0; c < count; ++c) sink.add(skin[c], force[c]);
}

/// Adds forces to the corners at both ends of edge e.
template <class Sink>
TRILITH_INLINE void add_to_edge(const PieceSkins& skins, int piece, int e, const std::array<Vec2, 2>& force,
                                const Sink& sink) {
  const int *skin = skins.of(piece), next = e + 1 < skins.count(piece) ? e + 1 : 0;
  sink.add(skin[e], force[0]), sink.add(skin[next], force[1]);
}

/// `sink_of(piece)`: sink for the forces on a piece.
template <class SinkOf>
TRILITH_INLINE void add_forces(const PieceSkins& skins, const NearPair& pair, const OverlapAnswer& answer,
                               SinkOf&& sink_of) {
  const CornerOnFace at = answer.corner_at;
  if (!at.is_there()) {
    add_to_piece(skins, pair.piece_a, answer.on_a, sink_of(pair.piece_a));
    add_to_piece(skins, pair.piece_b, answer.on_b, sink_of(pair.piece_b));
    return;
  }
  const int wedge = at.wedge_is_b ? pair.piece_b : pair.piece_a, owner = at.wedge_is_b ? pair.piece_a : pair.piece_b;
  const int before = (at.corner > 0 ? static_cast<int>(at.corner) : skins.count(wedge)) - 1;
  add_to_edge(skins, wedge, before, answer.push.on_wedge, sink_of(wedge));
  add_to_edge(skins, owner, at.face, answer.push.on_owner, sink_of(owner));
}

void dissipate(const RowLoss& loss, Energy& given) {
  given[EnergyTerm::contact_damping] += loss.damping;
  given[EnergyTerm::contact_friction] += loss.friction;
  given[EnergyTerm::contact_fracture] += loss.fracture;
}

RowLoss loss_of(const OverlapAnswer& answer) {
  const OverlapResponse& r = answer.response;
  return {r.lost_damping, answer.let_go.friction + r.lost_friction, answer.let_go.fracture + r.lost_fracture};
}

/// Adds the results of a row that counts to the lists, and its forces.
template <class SinkOf>
TRILITH_INLINE void take_up_row(const PieceSkins& skins, Work<2>& work, GeneralRun<2>& run, int i,
                                const OverlapAnswer& answer, SinkOf&& sink_of) {
  const int row = work.awake_rows[i];
  if (answer.changed) run.changed.push_back(row);
  if (!answer.touching) return;
  const OverlapResponse& r = answer.response;
  add_forces(skins, work.pairs[row], answer, sink_of);
  work.general_touching.at(i) = {row, r.length, r.depth, r.centre, r.force};
  run.touching.push_back(i);
}

/// Adds to the sums of a contact frame: see LaterForce.
TRILITH_INLINE void add_to_carrier(int contact_frame, const Vec3& force, const Vec3& moment, SolidWork<3>& solids) {
  const auto i = static_cast<std::size_t>(contact_frame < 0 ? -1 - contact_frame : contact_frame);
  (contact_frame < 0 ? solids.fit_force : solids.force)[i] += force;
  (contact_frame < 0 ? solids.fit_moment : solids.moment)[i] += moment;
}

/// Adds the results of a row to the lists, and its forces by add(piece, contact frame, force, moment).
template <class Add>
TRILITH_INLINE void take_up_row(Work<3>& work, GeneralRun<3>& run, const SolidAnswer& answer, Add&& add) {
  const int row = answer.row;
  if (answer.was_touching != answer.touching || answer.joint_changed) run.changed.push_back(row);
  if (!answer.touching) return let_sleep(work, static_cast<std::size_t>(row));
  const NearPair& pair = work.pairs[row];
  add(pair.piece_a, answer.carrier_a, -answer.force, answer.moment_a);
  add(pair.piece_b, answer.carrier_b, answer.force, answer.moment_b);
  work.general_touching.at(row) = {row, answer.area, answer.depth, answer.centre, answer.normal_force};
  run.touching.push_back(row);
}

void add_later(const LaterForce<2>& f, Work<2>& work) {
  work.skin_force[f.skin] += f.force;
}
void add_later(const LaterForce<3>& f, Work<3>& work) {
  add_to_carrier(f.contact_frame, f.force, f.moment, work.solids);
}

/// Joins the runs one after the other, which is the order of rows.
template <int D>
void join_runs(Work<D>& work) {
  Energy given = work.given;
  for (const GeneralRun<D>& run : work.general_runs) {
    for (const LaterForce<D>& f : run.later) add_later(f, work);
    for (const RowLoss& loss : run.losses) dissipate(loss, given);
    work.changed_rows.insert(work.changed_rows.end(), run.changed.begin(), run.changed.end());
    work.general_touching.list(run.touching);
  }
  work.given = given;
}

}  // namespace

int partition_general_contacts(const Model<2>& model, Work<2>& work) {
  return part_rows(model, work, static_cast<int>(work.awake_rows.size()),
                   [&](int i) -> const NearPair& { return work.pairs[work.awake_rows[i]]; });
}

int partition_general_contacts(const Model<3>& model, Work<3>& work) {
  return part_rows(model, work, static_cast<int>(work.pairs.size()),
                   [&](int row) -> const NearPair& { return work.pairs[row]; });
}

void take_up(const Model<2>& model, Work<2>& work, GeneralRun<2>& run, int first, int last,
             const OverlapAnswer* answers) {
  const ForcesNow now{work.skin_force.data()};
  const PieceSkins skins(model);
  if (one_has_all(work)) {
    const auto sink_of = [now](int /*piece*/) { return now; };
    for (int i = first; i < last; ++i, ++answers) {
      if (!answers->counts) continue;
      dissipate(loss_of(*answers), work.given);
      take_up_row(skins, work, run, i, *answers, sink_of);
    }
    return;
  }
  const auto sink_of = [&](int piece) {
    return ForcesByBorder{now, work.at_border[model.piece_body[piece]] != 0 ? &run.later : nullptr};
  };
  for (int i = first; i < last; ++i, ++answers) {
    if (!answers->counts) continue;
    run.losses.push_back(loss_of(*answers));
    take_up_row(skins, work, run, i, *answers, sink_of);
  }
}

void take_up(const Model<3>& model, Work<3>& work, GeneralRun<3>& run, int first, int last,
             const SolidAnswer* answers) {
  const bool is_alone = one_has_all(work);
  const auto add = [&](int piece, int contact_frame, const Vec3& force, const Vec3& moment) {
    if (is_alone || work.at_border[model.piece_body[piece]] == 0)
      add_to_carrier(contact_frame, force, moment, work.solids);
    else
      run.later.push_back({contact_frame, force, moment});
  };
  for (int i = first; i < last; ++i, ++answers) {
    if (answers->row < 0) continue;
    const RowLoss loss{answers->lost_damping, answers->lost_friction, answers->lost_fracture};
    is_alone ? dissipate(loss, work.given) : run.losses.push_back(loss);
    take_up_row(work, run, *answers, add);
  }
}

void join_general_partitions(Work<2>& work) {
  join_runs(work);
}
void join_general_partitions(Work<3>& work) {
  join_runs(work);
}

}  // namespace trilith
