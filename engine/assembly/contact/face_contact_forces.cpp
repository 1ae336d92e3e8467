// Contacts of two faces, by law, several rows at a time.
#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "assembly/contact/contact_partition.hpp"
#include "assembly/contact/contact_rows.hpp"
#include "assembly/contact/face_contact_simd.hpp"
#include "assembly/contact/face_pair_culling.hpp"
#include "assembly/contact/face_rows.hpp"
#include "assembly/evaluate.hpp"
#include "base/simd/registers.hpp"
#include "base/team.hpp"
#include "broad_phase/face_tilt_cache.hpp"
#include "broad_phase/pairs.hpp"
#include "contact/plane/face_pair.hpp"

namespace trilith {
namespace {

/// Sets the memory of a row whose faces have separated.
template <class K>
void part_row(const FacePass& pass, int row) {
  pass.after[row] = pass.before[row].parted();
  const std::uint32_t first = pass.law_row[row].first;
  keep_law_memory<K>(K::parted(law_memory<K>(pass.law_before + first)), pass.law_after + first);
}

/// Dissipated energies of rows [J], summed one after the other. A row without dissipation does not change the sum. So
/// the sum does not depend on pairs that are near but do not touch, nor on when they were found.
struct GivenOff {
  double damping = 0, friction = 0, fracture = 0;
};

/// Adds the lanes one after the other instead of by a tree: the sum has the same bits as for single rows.
TRILITH_INLINE void add_lanes(double& sum, const LaneMask& counts, const Lanes& lost) {
  const Lanes v = select(counts, lost, Lanes{});
  for (int i = 0; i < lane_count; ++i) sum += v[i];
}

/// Stores energies that are added later.
TRILITH_INLINE void keep_lanes(std::array<double, 4>& kept, const LaneMask& counts, const Lanes& lost) {
  const Lanes v = select(counts, lost, Lanes{});
  for (int i = 0; i < lane_count; ++i) kept[static_cast<std::size_t>(i)] = v[i];
}

template <class K, class R, class Kept>
TRILITH_INLINE void dissipate(const LaneMask& counts, const R& r, GivenOff& given, const Kept& kept) {
  if (kept.is_delayed()) {
    keep_lanes(kept.four->damping, counts, r.lost_damping);
    keep_lanes(kept.four->friction, counts, r.lost_friction);
    if constexpr (K::bonds) keep_lanes(kept.four->fracture, counts, r.lost_fracture);
  } else {
    add_lanes(given.damping, counts, r.lost_damping);
    add_lanes(given.friction, counts, r.lost_friction);
    if constexpr (K::bonds) add_lanes(given.fracture, counts, r.lost_fracture);
  }
}

/// Initialises four rows before it is known which of them are pairs of faces.
TRILITH_INLINE void begin_four(const FourRows& rows, const KeptFour& kept) {
  kept.four->later = {}, kept.four->turns = kept.four->is_general = {};
  for (int i = 0; i < lane_count; ++i) kept.four->row[static_cast<std::size_t>(i)] = rows.row[i];
}

/// Marks `row`, in lane i, as general: its faces are too tilted or too deep, so its overlap is computed in the same
/// evaluation.
template <class Kept>
TRILITH_INLINE void tell_general(const FacePass& pass, int row, int i, const Kept& kept) {
  if (kept.is_delayed())
    kept.four->is_general[static_cast<std::size_t>(i)] = true;
  else
    pass.work.general_now.push_back(row);
}
/// Marks a change in `row`, in lane i: a contact made or lost, or a change of bond or mortar.
template <class Kept>
TRILITH_INLINE void tell_turn(const FacePass& pass, int row, int i, const Kept& kept) {
  if (kept.is_delayed())
    kept.four->turns[static_cast<std::size_t>(i)] = true;
  else
    pass.work.changed_rows.push_back(row);
}

template <class K, class Motion, class Kept>
TRILITH_INLINE void respond_rows(const FacePass& pass, const K& law, const FourRows& rows, const Motion& motion,
                                 GivenOff& given, const Kept& kept) {
  using M = typename K::template Memory<Lanes>;
  const LaneMemory<M> memory = load_memory<M>(pass, rows);
  FaceResponse<Lanes, M> r = respond_face_motion<K>(motion, memory.face, memory.own, law);
  // A contact that has just separated dissipates its remaining energy.
  const LaneMask found = rows.valid & r.is_face_pair, counts = found & (r.touching | memory.touching);
  dissipate<K>(counts, r, given, kept);
  // Rows with possible events are processed one by one.
  const LaneMask turns = (r.touching ^ memory.touching) | K::changes(memory.face, memory.own, r.memory, r.own);
  const RowResponse<M, law_numbers<K>> out(r, K::template keeps<Lanes>(r.own));
  if (kept.is_delayed()) begin_four(rows, kept);
  const bool all = !any(flip(found & r.touching) | turns);  // as nearly always
  if constexpr (has_rare_numbers<M>) write_rare(pass, rows, r.own, all ? flip(LaneMask{}) : found & r.touching);
  if (all) {
    for (int i = 0; i < lane_count; ++i) write_row(pass, rows.row[i], out, i, kept);
    return;
  }
  for (int i = 0; i < lane_count; ++i) {
    if (rows.valid[i] == 0) continue;
    const int row = rows.row[i];
    if (r.is_face_pair[i] == 0) {
      tell_general(pass, row, i, kept);
      continue;
    }
    if (r.touching[i] != 0)
      write_row(pass, row, out, i, kept);
    else
      part_row<K>(pass, row);
    if (turns[i] != 0) tell_turn(pass, row, i, kept);
  }
}

/// Adds the results of four rows, with the same sums as without the delay.
template <class K>
TRILITH_INLINE void take_up(const FacePass& pass, const FourFaces& four, const FourForces& force, GivenOff& given) {
  for (std::size_t i = 0; i < four.row.size(); ++i) {
    given.damping += four.damping[i];
    given.friction += four.friction[i];
    if constexpr (K::bonds) given.fracture += four.fracture[i];
    const int row = four.row[i];
    const std::array<Vec2, 4>& f = force[i];
    if (four.later[i] != 0)
      add_forces(pass, row, load_pair(f[0].data()), load_pair(f[1].data()), load_pair(f[2].data()),
                 load_pair(f[3].data()), four.later[i]);
    if (four.turns[i]) pass.work.changed_rows.push_back(row);
    if (four.is_general[i]) pass.work.general_now.push_back(row);
  }
}

/// Processes blocks, motions first: two short loops allow more instruction-level parallelism than one long loop.
/// `Motion`: see load_motion.
template <class K, class Motion, class Kept>
TRILITH_INLINE void respond_as(const FacePass& pass, const K& kernel, Kept kept, std::span<const int> rows,
                               GivenOff& sums) {
  // Local copies, so that the compiler knows that the loops do not change them.
  const K law = kernel;
  GivenOff given = sums;
  constexpr std::size_t block = 16;
  std::array<Motion, block> motion;
  for (std::size_t from = 0; from < rows.size(); from += block * lane_count) {
    const std::size_t to = std::min(rows.size(), from + block * lane_count);
    const auto rows_at = [&](std::size_t i) { return FourRows(rows.data() + i, rows.size() - i); };
    for (std::size_t i = from, k = 0; i < to; i += lane_count, ++k) motion[k] = load_motion<Motion>(pass, rows_at(i));
    for (std::size_t i = from, k = 0; i < to; i += lane_count, ++k) {
      respond_rows<K>(pass, law, rows_at(i), motion[k], given, kept);
      kept.to_next();
    }
  }
  sums = given;
}

template <class K>
TRILITH_INLINE void respond_after_leapfrog(const FacePass& pass, const K& law, std::span<const int> rows,
                                           GivenOff& given) {
  using Motion = LeapfrogMotion<Lanes>;
  if (pass.kept.is_delayed()) return respond_as<K, Motion>(pass, law, pass.kept, rows, given);
  respond_as<K, Motion>(pass, law, AddedAtOnce{}, rows, given);
}

// Copies of the code of each law for wide registers and one for any machine, with the same operations and so the same
// bits. Explicit steps on present machines have copies of their own. Further copies of the other cases are not worth
// their compile time.

template <class K, class Motion>
void respond_narrow(const FacePass& pass, const K& law, std::span<const int> rows, GivenOff& given) {
  respond_as<K, Motion>(pass, law, pass.kept, rows, given);
}

#ifdef __x86_64__
template <class K>
[[gnu::target("avx2")]] void respond_wide(const FacePass& pass, const K& law, std::span<const int> rows,
                                          GivenOff& given) {
  if (pass.skin_mean == nullptr) return respond_after_leapfrog<K>(pass, law, rows, given);
  respond_as<K, FaceMotion<Lanes>>(pass, law, pass.kept, rows, given);
}
template <class K>
[[gnu::target("arch=x86-64-v4")]] void respond_widest(const FacePass& pass, const K& law, std::span<const int> rows,
                                                      GivenOff& given) {
  respond_after_leapfrog<K>(pass, law, rows, given);
}
#endif

template <class K>
void respond_as_here(const FacePass& pass, const K& law, std::span<const int> rows, GivenOff& given) {
  const bool is_leapfrog = pass.skin_mean == nullptr;
#ifdef __x86_64__
  static const Registers here = registers_here();
  if (here == Registers::widest && is_leapfrog) return respond_widest<K>(pass, law, rows, given);
  if (here != Registers::narrow) return respond_wide<K>(pass, law, rows, given);
#endif
  if (is_leapfrog) return respond_narrow<K, LeapfrogMotion<Lanes>>(pass, law, rows, given);
  respond_narrow<K, FaceMotion<Lanes>>(pass, law, rows, given);
}

void make_room(Work<2>& work, std::size_t fours) {
  work.four_faces.resize(fours), work.four_forces.resize(fours);
}
KeptFour kept_at(Work<2>& work, std::size_t four) {
  return {&work.four_faces[four], &work.four_forces[four]};
}

/// Lists the runs. The first `touched` rows come first and then the others, both in their order; each run of rows
/// contains its part of either, in the order of summation.
void list_runs(const RowShares& shares, std::span<const int> rows, std::size_t touched, std::vector<RowRun>& runs) {
  runs.clear();
  std::size_t four = 0;
  for (const auto& part : {rows.first(touched), rows.subspan(touched)})
    for (int t = 0; t < shares.runs(); ++t) {
      const auto end_of = [&](int run) {
        const auto at = std::lower_bound(part.begin(), part.end(), shares.first[static_cast<std::size_t>(run)]);
        return static_cast<std::size_t>(part.data() - rows.data() + (at - part.begin()));
      };
      runs.push_back({end_of(t), end_of(t + 1), four});
      four += (runs.back().last - runs.back().first + lane_count - 1) / lane_count;
    }
}

/// Each thread processes its runs of rows and adds the forces of bodies that no other run contains. All other results
/// are added in the order of rows.
template <class K>
void respond_shares(const FacePass& pass, const K& law, std::span<const int> rows, std::size_t touched,
                    GivenOff& given) {
  Work<2>& work = pass.work;
  const RowShares& shares = work.row_shares;
  list_runs(shares, rows, touched, work.row_runs);
  const auto parts = static_cast<std::size_t>(shares.runs());
  make_room(work, rows.size() / lane_count + 2 * parts);
  share(work.threads, shares.runs(), 1, [&](int first, int last, int /*thread*/) {
    for (auto t = static_cast<std::size_t>(first); t < static_cast<std::size_t>(last); ++t)
      for (const std::size_t r : {t, parts + t}) {
        const RowRun& run = work.row_runs[r];
        FacePass own = pass;
        own.kept = kept_at(work, run.four), own.border = shares.border.data();
        GivenOff none;
        // A run that ends within the list reads further rows beyond its end and ignores them.
        respond_as_here<K>(own, law, rows.subspan(run.first, run.last - run.first), none);
      }
  });
  GivenOff sums = given;  // kept in registers: no written force can change it
  for (const RowRun& run : work.row_runs)
    for (std::size_t i = run.first, four = run.four; i < run.last; i += lane_count, ++four)
      take_up<K>(pass, work.four_faces[four], work.four_forces[four], sums);
  given = sums;
}

/// Rows per chunk of a thread, about 5 microseconds.
constexpr int face_stretch = 128;

/// Processes chunks of rows; their results are added in the order of rows.
template <class K>
void respond_stretches(const FacePass& pass, const K& law, std::span<const int> rows, GivenOff& given) {
  Work<2>& work = pass.work;
  constexpr int fours = face_stretch / lane_count;
  make_room(work, static_cast<std::size_t>(stretches_under_way(work.threads) * fours));
  const auto part = [&](int first, int last) {
    return rows.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
  };
  share_in_order(
      work.threads, static_cast<int>(rows.size()), face_stretch,
      [&](int first, int last, int /*thread*/, int slot) {
        FacePass own = pass;
        own.kept = kept_at(work, static_cast<std::size_t>(slot * fours));
        GivenOff none;
        respond_as_here<K>(own, law, part(first, last), none);
      },
      [&](int first, int last, int slot) {
        auto four = static_cast<std::size_t>(slot * fours);
        for (int i = first; i < last; i += lane_count, ++four)
          take_up<K>(pass, work.four_faces[four], work.four_forces[four], given);
      });
}

/// Processes the rows of a law, the first `touched` of which touched before: by this thread, or by several with the
/// same bits.
template <class K>
void respond_all(const FacePass& pass, const K& law, std::span<const int> rows, std::size_t touched, bool are_shared) {
  Work<2>& work = pass.work;
  GivenOff given;
  if (work.threads <= 1 || rows.size() <= face_stretch)
    respond_as_here<K>(pass, law, rows, given);
  else
    are_shared ? respond_shares<K>(pass, law, rows, touched, given) : respond_stretches<K>(pass, law, rows, given);
  work.given[EnergyTerm::contact_damping] += given.damping;
  work.given[EnergyTerm::contact_friction] += given.friction;
  work.given[EnergyTerm::contact_fracture] += given.fracture;
}

/// Rows per chunk of a thread when faces are chosen, about 5 microseconds.
constexpr int chosen_stretch = 256;

/// Chooses the face pair of rows with several possible ones. Each row reads its own pieces and writes only itself.
void choose_faces(const Model<2>& model, const State<2>& state, const ContactHistory& before, Work<2>& work,
                  FaceBatch& batch) {
  batch.has_faces.resize(batch.choice.size());
  share(work.threads, static_cast<int>(batch.choice.size()), chosen_stretch, [&](int first, int last, int /*thread*/) {
    for (int i = first; i < last; ++i) {
      const int row = batch.choice[i];
      NearPair& pair = work.pairs[row];
      std::uint8_t& has = batch.has_faces[i];
      has = 0;
      if (before.memory[row].bonds != 0) {
        has = choose_bonded_faces(model, work, pair) ? 1 : 0;
        continue;
      }
      if (is_tilted(model, state, work, pair)) continue;
      has = choose_face_pair(model, work, false, pair) ? 1 : 0;
      if (has == 0) remember_tilt(model, state, work, pair);
    }
  });
}

/// Rows of a batch with a face pair: rows with one pair of opposed faces, and rows with several of which one is chosen
/// now. They are in the order of rows, so that sums do not depend on when the pairs were found.
const std::vector<int>& facing_now(const Model<2>& model, const State<2>& state, const ContactHistory& before,
                                   Work<2>& work, FaceBatch& batch) {
  if (batch.choice.empty()) return batch.row;
  choose_faces(model, state, before, work, batch);
  batch.chosen.clear();
  for (std::size_t i = 0; i < batch.choice.size(); ++i)
    (batch.has_faces[i] != 0 ? batch.chosen : work.general_now).push_back(batch.choice[i]);
  // Both lists are sorted, and so is the merged list.
  batch.now.resize(batch.row.size() + batch.chosen.size());
  std::merge(batch.row.begin(), batch.row.end(), batch.chosen.begin(), batch.chosen.end(), batch.now.begin());
  return batch.now;
}

}  // namespace

void respond_face_rows(const FacePass& pass, const LawInUse& law, std::span<const int> rows) {
  GivenOff none;
  with_kernel(law, [&]<class K>(const K& kernel) { respond_as_here<K>(pass, kernel, rows, none); });
}

/// For each law: selects the rows that are pairs of faces now, excludes pairs that are clearly apart, and applies the
/// kernel of the law to the others.
void face_contact_forces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt, StepTimes* times) {
  StepClock clock(times);
  const ContactHistory& before = contacts_before(state, work);
  work.general_now.clear();
  const bool are_shared = partition_face_contacts(model, work);
  for (FaceBatch& batch : work.batches) {
    const NearRows near = sort_out(face_line(model), before, work, facing_now(model, state, before, work, batch),
                                   work.face_rows, work.fresh_rows);
    if (near.count == 0) continue;
    const std::span<const int> rows(work.face_rows.data(), near.count);
    const FacePass pass{work.skin.data(),
                        work.skin_mean.empty() ? nullptr : work.skin_mean.data(),
                        work.pairs.data(),
                        before.memory.data(),
                        work.contacts.memory.data(),
                        before.law_row.data(),
                        before.law_memory.data(),
                        work.contacts.law_memory.data(),
                        work.skin_force.data(),
                        work,
                        face_line(model)};
    with_kernel(law_in_use(model, batch.law, dt),
                [&]<class K>(const K& law) { respond_all<K>(pass, law, rows, near.touched, are_shared); });
    clock.mark_law(batch.law);
  }
}

}  // namespace trilith
