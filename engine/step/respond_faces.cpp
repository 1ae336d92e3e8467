// Contacts of two faces, by law, several rows at once.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <span>

#include "base/team.hpp"
#include "contact/face_pair.hpp"
#include "detect/pairs.hpp"
#include "step/contact_rows.hpp"
#include "step/evaluate.hpp"
#include "step/face_columns.hpp"
#include "step/near_faces.hpp"

namespace trilith {
namespace {

// Rows of one law go through its kernel four at once, a lane each. What comes in is gathered row by row and turned:
//
//     row 0   x0 y0                  x: x0 x1 x2 x3
//     row 1   x1 y1   load_columns   y: y0 y1 y2 y3     kernel     columns of forces   RowPairs    rows again
//     row 2   x2 y2  ------------>                    -------->    and memories        -------->   to be written
//     row 3   x3 y3
//
// A lane that is no row (`valid`), or whose faces are no pair of faces now, or that does not touch, is computed with
// the others and left out as its results are written. Each row writes its own memory; forces are added to skin points
// row by row, in the order of the list, so that the bits do not depend on the lanes.

static_assert(offsetof(ContactMemory, bonds) == offsetof(ContactMemory, slip) + sizeof(double) &&
                  offsetof(ContactMemory, state) == offsetof(ContactMemory, bonds) + sizeof(std::uint32_t),
              "slip, bonds and state are moved as one pair");
// ... as (slip, word), the bonds in the lower half of the word and the state in the upper.
static_assert(std::endian::native == std::endian::little, "bonds and state are read as one number");

/// Two columns as a pair for each of four rows.
/// Lanes 0 and 2 of both columns lie in `row02`, 1 and 3 in `row13`: of(row) is then two neighbouring numbers.
struct RowPairs {
  Lanes row02, row13;
  RowPairs() = default;
  TRILITH_INLINE RowPairs(const Lanes& c0, const Lanes& c1) {
    const Lanes low = even(c0, c1), high = odd(c0, c1);
    row02 = low, row13 = high;
  }
  TRILITH_INLINE LanePair of(int row) const {
    const Lanes& v = row % 2 == 0 ? row02 : row13;
    return row < 2 ? LanePair{v[0], v[1]} : LanePair{v[2], v[3]};
  }
};

TRILITH_INLINE LaneMask bits_of(const Lanes& v) {
  LaneMask m;
  __builtin_memcpy(&m, &v, sizeof m);
  return m;
}
TRILITH_INLINE Lanes as_lanes(const LaneMask& m) {
  Lanes v;
  __builtin_memcpy(&v, &m, sizeof v);
  return v;
}
TRILITH_INLINE LaneMask has_bit(const LaneMask& word, std::int64_t bit) {
  const LaneMask none{};
  return (word & (none + bit)) != none;
}

constexpr std::int64_t touching_bit = std::int64_t{contact_touching} << 32,
                       general_bit = std::int64_t{contact_general} << 32, kept_bit = std::int64_t{contact_kept} << 32;

/// Arrays of State and Work that the rows of a batch are read from and written to.
struct Pass {
  const SkinMotion<2>* skin;
  const Vec2* skin_mean;  // nullptr: velocities over the step are those of now
  const NearPair* pairs;
  const ContactMemory* before;
  ContactMemory* after;
  const LawRow* law_row;
  const double* law_before;
  double* law_after;
  Vec2* skin_force;
  Work<2>& work;
  FourFaces* kept = nullptr;  // where threads share the rows: forces, energies and lists are kept, to be added in order
};

/// Four rows of a list at once. Beyond its end the list holds its last row again, which is not `valid` there.
struct Rows {
  const int* row;
  LaneMask valid{-1, -1, -1, -1};
  TRILITH_INLINE Rows(const int* list, std::size_t left) : row(list) {
    if (left >= lane_count) return;
    for (std::size_t i = left; i < lane_count; ++i) valid[i] = 0;
  }
};

/// Places and velocities of the four face ends of each row, as columns. After an implicit step the mean velocities over
/// it are read too; in a leapfrog step both are the same and nothing more is read.
TRILITH_INLINE FaceMotion<Lanes> load_motion(const Pass& pass, const Rows& rows) {
  const NearPair* p[lane_count];
  for (int i = 0; i < lane_count; ++i) p[i] = &pass.pairs[rows.row[i]];
  const auto ends = [&](int NearPair::*end, Lanes& x, Lanes& y, Lanes& u, Lanes& v) {
    load_ends(pass.skin, p, end, &SkinMotion<2>::x, x, y);
    load_ends(pass.skin, p, end, &SkinMotion<2>::u, u, v);
  };
  FaceEnds<Lanes> a, b;
  ends(&NearPair::a0, a.x0, a.y0, a.u0, a.v0);
  ends(&NearPair::a1, a.x1, a.y1, a.u1, a.v1);
  ends(&NearPair::b0, b.x0, b.y0, b.u0, b.v0);
  ends(&NearPair::b1, b.x1, b.y1, b.u1, b.v1);
  FaceMotion<Lanes> motion(a, b, Lanes{p[0]->corner, p[1]->corner, p[2]->corner, p[3]->corner});
  if (pass.skin_mean != nullptr) {
    const auto mean = [&](int NearPair::*end, Lanes& u, Lanes& v) {
      const double* row[lane_count];
      for (int i = 0; i < lane_count; ++i) row[i] = pass.skin_mean[p[i]->*end].data();
      load_columns(row, u, v);
    };
    mean(&NearPair::a0, a.u0, a.v0), mean(&NearPair::a1, a.u1, a.v1);
    mean(&NearPair::b0, b.u0, b.v0), mean(&NearPair::b1, b.u1, b.v1);
    motion.over_step(a, b);
  }
  return motion;
}

/// What four contacts and their law remember.
template <class M>
struct LaneMemory {
  FaceMemory<Lanes> face;
  M own;
  LaneMask touching;
};

template <class M>
TRILITH_INLINE LaneMemory<M> load_memory(const Pass& pass, const Rows& rows) {
  const auto load = [&](auto member, Lanes& c0, Lanes& c1) {
    const double* row[lane_count];
    for (int i = 0; i < lane_count; ++i) {
      if constexpr (std::is_same_v<decltype(member), double ContactMemory::*>)
        row[i] = &(pass.before[rows.row[i]].*member);
      else
        row[i] = pass.before[rows.row[i]].*member;
    }
    load_columns(row, c0, c1);
  };
  LaneMemory<M> m;
  Lanes bits;
  load(&ContactMemory::shear_elastic, m.face.shear_elastic[0], m.face.shear_elastic[1]);
  load(&ContactMemory::shear_total, m.face.shear_total[0], m.face.shear_total[1]);
  load(&ContactMemory::damping_force, m.face.damping_force[0], m.face.damping_force[1]);
  load(&ContactMemory::active, m.face.active[0], m.face.active[1]);
  // Slip and the word of bonds and state lie side by side and are moved as one pair of numbers.
  load(&ContactMemory::slip, m.face.slip, bits);
  const LaneMask word = bits_of(bits);
  m.face.bonds[0] = has_bit(word, 1);
  m.face.bonds[1] = has_bit(word, 2);
  m.face.general = has_bit(word, general_bit);
  m.touching = has_bit(word, touching_bit);
  // What a law remembers is read two by two; each law has an even count of numbers.
  int number = 0;
  m.own.fields([&](Lanes& c0, Lanes& c1) {
    const double* row[lane_count];
    for (int i = 0; i < lane_count; ++i) row[i] = pass.law_before + pass.law_row[rows.row[i]].first + number;
    load_columns(row, c0, c1);
    number += 2;
  });
  return m;
}

/// A response as rows again, to be written where they belong. `pairs`: of numbers of the law's memory.
template <std::size_t pairs>
struct RowResponse {
  RowPairs elastic, total, damping, active, slip_bits, a0, a1, b0, b1;
  std::array<RowPairs, pairs> own;
  /// Bonds in bits 0 and 1, touching always: a row that does not touch is not written from here.
  TRILITH_INLINE static Lanes word_of(const FaceMemory<Lanes>& m, const LaneMask& kept) {
    const LaneMask none{};
    return as_lanes((m.bonds[0] & (none + 1)) | (m.bonds[1] & (none + 2)) | (kept & (none + kept_bit)) |
                    (none + touching_bit));
  }
  template <class M>
  TRILITH_INLINE RowResponse(FaceResponse<Lanes, M>& r, const LaneMask& kept)
      : elastic(r.memory.shear_elastic[0], r.memory.shear_elastic[1]),
        total(r.memory.shear_total[0], r.memory.shear_total[1]),
        damping(r.memory.damping_force[0], r.memory.damping_force[1]),
        active(r.memory.active[0], r.memory.active[1]),
        slip_bits(r.memory.slip, word_of(r.memory, kept)),
        a0(r.ax0, r.ay0),
        a1(r.ax1, r.ay1),
        b0(r.bx0, r.by0),
        b1(r.bx1, r.by1) {
    std::size_t i = 0;
    r.own.fields([&](const Lanes& c0, const Lanes& c1) { own[i++] = {c0, c1}; });
  }
};

/// One row after the other: two of four may have a skin point in common.
TRILITH_INLINE void add_forces(const Pass& pass, int row, const LanePair& a0, const LanePair& a1, const LanePair& b0,
                               const LanePair& b1) {
  const NearPair& p = pass.pairs[row];
  const auto add = [&](int skin, const LanePair& force) {
    double* on = pass.skin_force[skin].data();
    store_pair(on, load_pair(on) + force);
  };
  add(p.a0, a0);
  add(p.a1, a1);
  add(p.b0, b0);
  add(p.b1, b1);
}

/// Lane i of a response to the row it belongs to. `kept`: see Pass.
template <std::size_t pairs>
TRILITH_INLINE void write_row(const Pass& pass, int row, const RowResponse<pairs>& r, int i, FourFaces* kept) {
  ContactMemory& after = pass.after[row];
  store_pair(after.shear_elastic, r.elastic.of(i));
  store_pair(after.shear_total, r.total.of(i));
  store_pair(after.damping_force, r.damping.of(i));
  store_pair(after.active, r.active.of(i));
  store_pair(&after.slip, r.slip_bits.of(i));
  after.damping_moment = 0;
  if constexpr (pairs > 0) {
    double* own = pass.law_after + pass.law_row[row].first;
    for (std::size_t k = 0; k < pairs; ++k) store_pair(own + 2 * k, r.own[k].of(i));
  }
  if (kept != nullptr) {
    std::array<Vec2, 4>& force = kept->force[static_cast<std::size_t>(i)];
    store_pair(force[0].data(), r.a0.of(i)), store_pair(force[1].data(), r.a1.of(i));
    store_pair(force[2].data(), r.b0.of(i)), store_pair(force[3].data(), r.b1.of(i));
    kept->touches[static_cast<std::size_t>(i)] = true;
  } else {
    add_forces(pass, row, r.a0.of(i), r.a1.of(i), r.b0.of(i), r.b1.of(i));
  }
}

/// What stays where the faces of a row part.
template <class K>
void part_row(const Pass& pass, int row) {
  pass.after[row] = pass.before[row].parted();
  const std::uint32_t first = pass.law_row[row].first;
  keep_law_memory<K>(K::parted(law_memory<K>(pass.law_before + first)), pass.law_after + first);
}

/// Energy given off by rows [J], added one after the other: a row that gives nothing changes no bit of a sum, so which
/// pairs are near and do not touch, and with it when they were found, does not either.
struct GivenOff {
  double damping = 0, friction = 0, fracture = 0;
};

/// One lane after the other, not by a tree: the sum has the bits that single rows would give.
TRILITH_INLINE void add_lanes(double& sum, const LaneMask& counts, const Lanes& lost) {
  const Lanes v = select(counts, lost, Lanes{});
  for (int i = 0; i < lane_count; ++i) sum += v[i];
}

/// Energies as they are added later.
TRILITH_INLINE void keep_lanes(std::array<double, 4>& kept, const LaneMask& counts, const Lanes& lost) {
  const Lanes v = select(counts, lost, Lanes{});
  for (int i = 0; i < lane_count; ++i) kept[static_cast<std::size_t>(i)] = v[i];
}

template <class K, class R>
TRILITH_INLINE void give_off(const LaneMask& counts, const R& r, GivenOff& given, FourFaces* kept) {
  if (kept != nullptr) {
    keep_lanes(kept->damping, counts, r.lost_damping);
    keep_lanes(kept->friction, counts, r.lost_friction);
    if constexpr (K::bonds) keep_lanes(kept->fracture, counts, r.lost_fracture);
    return;
  }
  add_lanes(given.damping, counts, r.lost_damping);
  add_lanes(given.friction, counts, r.lost_friction);
  if constexpr (K::bonds) add_lanes(given.fracture, counts, r.lost_fracture);
}

template <class K>
TRILITH_INLINE void respond_rows(const Pass& pass, const K& law, const Rows& rows, const FaceMotion<Lanes>& motion,
                                 GivenOff& given, FourFaces* kept) {
  using M = typename K::template Memory<Lanes>;
  const LaneMemory<M> memory = load_memory<M>(pass, rows);
  FaceResponse<Lanes, M> r = respond_face_motion<K>(motion, memory.face, memory.own, law);
  // A contact that has just parted still gives off what it held.
  const LaneMask found = rows.valid & r.is_face_pair, counts = found & (r.touching | memory.touching);
  give_off<K>(counts, r, given, kept);
  // What may be an event or needs care, row by row: a contact made or lost, a bond or the mortar that changes.
  const LaneMask turns = (r.touching ^ memory.touching) | K::changes(memory.face, memory.own, r.memory, r.own);
  const RowResponse<law_numbers<K> / 2> out(r, K::template keeps<Lanes>(r.own));
  if (kept != nullptr) {
    kept->touches = kept->turns = kept->is_general = {};
    for (int i = 0; i < lane_count; ++i) kept->row[static_cast<std::size_t>(i)] = rows.row[i];
  }
  if (!any(flip(found & r.touching) | turns)) {  // as nearly always
    for (int i = 0; i < lane_count; ++i) write_row(pass, rows.row[i], out, i, kept);
    return;
  }
  for (int i = 0; i < lane_count; ++i) {
    if (rows.valid[i] == 0) continue;
    const int row = rows.row[i];
    // Too tilted or too deep for faces: it is found by overlap in this same evaluation.
    if (r.is_face_pair[i] == 0) {
      kept != nullptr ? void(kept->is_general[static_cast<std::size_t>(i)] = true)
                      : pass.work.general_now.push_back(row);
      continue;
    }
    if (r.touching[i] != 0)
      write_row(pass, row, out, i, kept);
    else
      part_row<K>(pass, row);
    if (turns[i] == 0) continue;
    kept != nullptr ? void(kept->turns[static_cast<std::size_t>(i)] = true) : pass.work.changed_rows.push_back(row);
  }
}

/// Adds what four rows came to, as it would have been added at once.
template <class K>
void take_up(const Pass& pass, const FourFaces& four, GivenOff& given) {
  for (std::size_t i = 0; i < four.row.size(); ++i) {
    given.damping += four.damping[i];
    given.friction += four.friction[i];
    if constexpr (K::bonds) given.fracture += four.fracture[i];
    const int row = four.row[i];
    const std::array<Vec2, 4>& f = four.force[i];
    if (four.touches[i])
      add_forces(pass, row, load_pair(f[0].data()), load_pair(f[1].data()), load_pair(f[2].data()),
                 load_pair(f[3].data()));
    if (four.turns[i]) pass.work.changed_rows.push_back(row);
    if (four.is_general[i]) pass.work.general_now.push_back(row);
  }
}

/// In blocks, motions first: two short loops leave the processor more to do at once than one long one.
template <class K>
TRILITH_INLINE void respond_batch(const Pass& pass, const K& kernel, std::span<const int> rows, GivenOff& sums) {
  // Copies of its own: nothing that the loops write can change them.
  const K law = kernel;
  GivenOff given = sums;
  FourFaces* kept = pass.kept;
  constexpr std::size_t block = 16;
  std::array<FaceMotion<Lanes>, block> motion;
  for (std::size_t from = 0; from < rows.size(); from += block * lane_count) {
    const std::size_t to = std::min(rows.size(), from + block * lane_count);
    const auto rows_at = [&](std::size_t i) { return Rows(rows.data() + i, rows.size() - i); };
    for (std::size_t i = from, k = 0; i < to; i += lane_count, ++k) motion[k] = load_motion(pass, rows_at(i));
    for (std::size_t i = from, k = 0; i < to; i += lane_count, ++k)
      respond_rows<K>(pass, law, rows_at(i), motion[k], given, kept == nullptr ? nullptr : kept++);
  }
  sums = given;
}

// For each law one copy for wide registers and one for any machine: the same operations, so the same bits.

template <class K>
void respond_narrow(const Pass& pass, const K& law, std::span<const int> rows, GivenOff& given) {
  respond_batch<K>(pass, law, rows, given);
}

#ifdef __x86_64__
template <class K>
[[gnu::target("avx2")]] void respond_wide(const Pass& pass, const K& law, std::span<const int> rows, GivenOff& given) {
  respond_batch<K>(pass, law, rows, given);
}
template <class K>
[[gnu::target("arch=x86-64-v4")]] void respond_widest(const Pass& pass, const K& law, std::span<const int> rows,
                                                      GivenOff& given) {
  respond_batch<K>(pass, law, rows, given);
}

enum class Registers { narrow, wide, widest };

Registers registers_here() {
  if (!__builtin_cpu_supports("avx2")) return Registers::narrow;
  const bool v4 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                  __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512cd");
  return v4 ? Registers::widest : Registers::wide;
}
#endif

template <class K>
void respond_as_here(const Pass& pass, const K& law, std::span<const int> rows, GivenOff& given) {
#ifdef __x86_64__
  static const Registers here = registers_here();
  if (here == Registers::widest) return respond_widest<K>(pass, law, rows, given);
  if (here == Registers::wide) return respond_wide<K>(pass, law, rows, given);
#endif
  respond_narrow<K>(pass, law, rows, given);
}

/// Rows that threads take at a time: some five microseconds.
constexpr int face_stretch = 128;

/// Each stretch of rows as single rows would be answered; what they come to is added in the order of rows.
template <class K>
void respond_all(const Pass& pass, const K& law, std::span<const int> rows) {
  Work<2>& work = pass.work;
  GivenOff given;
  if (work.threads <= 1 || rows.size() <= face_stretch) {
    respond_as_here<K>(pass, law, rows, given);
  } else {
    constexpr int fours = face_stretch / lane_count;
    work.four_faces.resize(static_cast<std::size_t>(stretches_under_way(work.threads) * fours));
    const auto part = [&](int first, int last) {
      // One that ends within the list reads beyond its end what is not its own, and leaves it out.
      return rows.subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(last - first));
    };
    share_in_order(
        work.threads, static_cast<int>(rows.size()), face_stretch,
        [&](int first, int last, int /*thread*/, int slot) {
          Pass own = pass;
          own.kept = &work.four_faces[static_cast<std::size_t>(slot * fours)];
          GivenOff none;
          respond_as_here<K>(own, law, part(first, last), none);
        },
        [&](int first, int last, int slot) {
          const FourFaces* four = &work.four_faces[static_cast<std::size_t>(slot * fours)];
          for (int i = first; i < last; i += lane_count) take_up<K>(pass, *four++, given);
        });
  }
  work.given[EnergyTerm::contact_damping] += given.damping;
  work.given[EnergyTerm::contact_friction] += given.friction;
  work.given[EnergyTerm::contact_fracture] += given.fracture;
}

/// Rows of a batch: those with one pair of facing faces, and those of several of which one is chosen now. In the order
/// of rows either way, so that sums do not depend on when the pairs were found.
const std::vector<int>& facing_now(const Model<2>& model, const ContactHistory& before, Work<2>& work,
                                   FaceBatch& batch) {
  if (batch.choice.empty()) return batch.row;
  batch.chosen.clear();
  for (const int row : batch.choice) {
    const bool bonded = before.memory[row].bonds != 0;
    (choose_face_pair(model, work, bonded, work.pairs[row]) ? batch.chosen : work.general_now).push_back(row);
  }
  // Both lists rise, and so does what they are merged to.
  batch.now.resize(batch.row.size() + batch.chosen.size());
  std::merge(batch.row.begin(), batch.row.end(), batch.chosen.begin(), batch.chosen.end(), batch.now.begin());
  return batch.now;
}

}  // namespace

void respond_faces(const Model<2>& model, const State<2>& state, Work<2>& work, double dt, StepTimes* times) {
  StepClock clock(times);
  const ContactHistory& before = contacts_before(state, work);
  work.general_now.clear();
  for (FaceBatch& batch : work.batches) {
    const std::size_t count =
        sort_out(before, work, facing_now(model, before, work, batch), work.face_rows, work.fresh_rows);
    if (count == 0) continue;
    const std::span<const int> rows(work.face_rows.data(), count);
    const Pass pass{work.skin.data(),
                    work.skin_mean.empty() ? nullptr : work.skin_mean.data(),
                    work.pairs.data(),
                    before.memory.data(),
                    work.contacts.memory.data(),
                    before.law_row.data(),
                    before.law_memory.data(),
                    work.contacts.law_memory.data(),
                    work.skin_force.data(),
                    work};
    with_kernel(law_in_use(model, batch.law, dt), [&]<class K>(const K& law) { respond_all<K>(pass, law, rows); });
    clock.mark_law(batch.law);
  }
}

}  // namespace trilith
