// Transfer of four rows of face contacts to the columns of a kernel, and of its results back to the rows.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "assembly/contact/face_columns.hpp"
#include "broad_phase/face_line.hpp"
#include "contact/plane/face_pair.hpp"
#include "law/contact/memory.hpp"
#include "model/work.hpp"

namespace trilith {

// The kernel of a law processes four rows at a time, one per lane. The input is gathered row by row and transposed.
//
//     row 0   x0 y0                  x: x0 x1 x2 x3
//     row 1   x1 y1   load_columns   y: y0 y1 y2 y3     kernel     columns of forces   RowPairs    rows again
//     row 2   x2 y2  ------------>                    -------->    and memories        -------->   to be written
//     row 3   x3 y3
//
// Some lanes are computed and ignored when results are written: lanes without a row (`valid`), rows that are not a pair
// of faces now, and rows that do not touch. Each row writes its own memory. Forces are added to skin points row by row,
// in the order of the list, so that the bits do not depend on the lanes.

static_assert(offsetof(ContactMemory, bonds) == offsetof(ContactMemory, slip) + sizeof(double) &&
                  offsetof(ContactMemory, state) == offsetof(ContactMemory, bonds) + sizeof(std::uint32_t),
              "slip, bonds and state are moved as one pair");
// Loaded as (slip, word), with the bonds in the lower half of the word and the state in the upper half.
static_assert(std::endian::native == std::endian::little, "bonds and state are read as one number");

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

/// Buffer for delayed results of four rows. Without one they are added at once.
struct KeptFour {
  FourFaces* four = nullptr;
  FourForces* force = nullptr;
  [[nodiscard]] bool is_delayed() const { return four != nullptr; }
  void to_next() {
    if (is_delayed()) ++four, ++force;
  }
};
/// The same where the compiler knows that results are added at once: a tenth faster, for another copy of the kernel.
struct AddedAtOnce : KeptFour {
  static constexpr bool is_delayed() { return false; }
};

/// Arrays of State and Work that the rows of a batch read and write.
struct FacePass {
  const SkinMotion<2>* skin;
  const Vec2* skin_mean;  // nullptr: velocities over the step equal the present ones
  const NearPair* pairs;
  const ContactMemory* before;
  ContactMemory* after;
  const LawRow* law_row;
  const double* law_before;
  double* law_after;
  Vec2* skin_force;
  Work<2>& work;
  FaceLine line;                        // faces of meshes in line ...
  const std::uint8_t* known = nullptr;  // ... or, instead, for each row whether its faces are flat with their
                                        // neighbours in line
  KeptFour kept{};  // if threads share the rows: forces, energies and lists are stored, to be added in order
  const std::uint8_t* border = nullptr;  // forces on these sides of rows only, see RowShares; nullptr: on all
};

/// Four rows of a list. Beyond its end the list repeats its last row, which is not `valid` there.
struct FourRows {
  const int* row;
  LaneMask valid{-1, -1, -1, -1};
  TRILITH_INLINE FourRows(const int* list, std::size_t left) : row(list) {
    if (left >= lane_count) return;
    for (std::size_t i = left; i < lane_count; ++i) valid[i] = 0;
  }
};

/// Extends rows that are not pairs of faces by themselves, but are flat with their neighbours in line, or open without
/// shared length. Bonded rows are not extended. `p`, `a`, `b`: their pairs, and the ends of the faces.
TRILITH_INLINE void join_lines(const FacePass& pass, const FourRows& rows, const NearPair* const* p,
                               const FaceEnds<Lanes>& a, const FaceEnds<Lanes>& b, LeapfrogMotion<Lanes>& motion) {
  FaceOverlap<Lanes>& o = motion.overlap;
  LaneMask joins{};
  if (pass.known == nullptr)
    joins = are_flat_in_line<Lanes>(o, load_next(pass.line, pass.skin, p, a, b),
                                    Lanes{p[0]->corner, p[1]->corner, p[2]->corner, p[3]->corner});
  for (int i = 0; i < lane_count; ++i) {
    const int row = rows.row[i];
    if (pass.known != nullptr && pass.known[row] != 0) joins[i] = -1;
    if (pass.before[row].bonds != 0) joins[i] = 0;
  }
  joins &= flip(o.sane & motion.flat);
  const LaneMask opens = joins & flip(o.sane);
  constexpr double open = 1, least = 1e-12;  // [m]
  const Lanes zero{};
  motion.flat |= joins, o.sane |= opens;
  o.hi = select(opens, o.lo + least, o.hi), o.shared = select(opens, zero + least, o.shared);
  o.gap_lo = select(opens, zero + open, o.gap_lo), o.gap_hi = select(opens, zero + open, o.gap_hi);
}

/// Positions and velocities of the four face ends of each row, as columns. `Motion`: FaceMotion after an implicit step,
/// which contains the mean velocities too; in a leapfrog step both are equal and nothing more is read.
template <class Motion>
TRILITH_INLINE Motion load_motion(const FacePass& pass, const FourRows& rows) {
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
  Motion motion(a, b, Lanes{p[0]->corner, p[1]->corner, p[2]->corner, p[3]->corner});
  if constexpr (std::is_same_v<Motion, FaceMotion<Lanes>>) {
    const auto mean = [&](int NearPair::*end, Lanes& u, Lanes& v) {
      const double* row[lane_count];
      for (int i = 0; i < lane_count; ++i) row[i] = pass.skin_mean[p[i]->*end].data();
      load_columns(row, u, v);
    };
    mean(&NearPair::a0, a.u0, a.v0), mean(&NearPair::a1, a.u1, a.v1);
    mean(&NearPair::b0, b.u0, b.v0), mean(&NearPair::b1, b.u1, b.v1);
    motion.set_over_step(a, b);
  }
  if (pass.line.is_there() || pass.known != nullptr)
    if (any(flip(motion.overlap.sane & motion.flat))) join_lines(pass, rows, p, a, b, motion);
  return motion;
}

/// Memories of four contacts and of their law.
template <class M>
struct LaneMemory {
  FaceMemory<Lanes> face;
  M own;
  LaneMask touching;
};

/// True for a law's memory that names numbers which are 0 in most contacts: they are then neither transposed to columns
/// nor back.
template <class M>
inline constexpr bool has_rare_numbers = requires {
  M::damage_begin;
};
/// True for the pair of numbers from `number` on.
template <class M>
constexpr bool is_rare(int number) {
  if constexpr (has_rare_numbers<M>) return number >= M::damage_begin && number < M::damage_end;
  return false;
}

/// The numbers of the law's memory of a row from `number` on.
TRILITH_INLINE const double* law_numbers_of(const FacePass& pass, int row, int number) {
  return pass.law_before + pass.law_row[row].first + number;
}

/// True where a rare number of some row is not 0. The bits are compared, four numbers at a time.
template <class M>
TRILITH_INLINE bool some_rare_number(const FacePass& pass, const FourRows& rows) {
  static_assert((M::damage_end - M::damage_begin) % lane_count == 0);
  LaneMask bits{};
  for (int i = 0; i < lane_count; ++i)
    for (int number = M::damage_begin; number < M::damage_end; number += lane_count) {
      LaneMask four;
      __builtin_memcpy(&four, law_numbers_of(pass, rows.row[i], number), sizeof four);
      bits |= four;
    }
  return any(bits);
}

template <class M>
TRILITH_INLINE LaneMemory<M> load_memory(const FacePass& pass, const FourRows& rows) {
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
  // Slip and the word of bonds and state are adjacent and moved as one pair of numbers.
  load(&ContactMemory::slip, m.face.slip, bits);
  const LaneMask word = bits_of(bits);
  m.face.bonds[0] = has_bit(word, 1);
  m.face.bonds[1] = has_bit(word, 2);
  m.face.general = has_bit(word, general_bit);
  m.touching = has_bit(word, touching_bit);
  // The memory of a law is read in pairs of numbers; each law has an even count.
  const auto load_own = [&](bool rare) TRILITH_INLINE_LAMBDA {
    int number = 0;
    m.own.fields([&](Lanes& c0, Lanes& c1) {
      const double* row[lane_count];
      for (int i = 0; i < lane_count; ++i) row[i] = law_numbers_of(pass, rows.row[i], number);
      if (is_rare<M>(number) == rare) load_columns(row, c0, c1);
      number += 2;
    });
  };
  load_own(false);
  if constexpr (has_rare_numbers<M>) {
    m.own.set_damaged(some_rare_number<M>(pass, rows));
    if (m.own.may_be_damaged()) load_own(true);
  }
  return m;
}

/// Response as rows, for writing. `M`: the law's memory, of which the rare numbers are written by write_rare.
/// `numbers`: their number.
template <class M, std::size_t numbers>
struct RowResponse {
  RowPairs elastic, total, damping, active, slip_bits, a0, a1, b0, b1;
  std::array<RowPairs, numbers / 2> own;
  /// Bonds in bits 0 and 1, touching always set: rows that do not touch are not written here.
  TRILITH_INLINE static Lanes word_of(const FaceMemory<Lanes>& m, const LaneMask& kept) {
    const LaneMask none{};
    return as_lanes((m.bonds[0] & (none + 1)) | (m.bonds[1] & (none + 2)) | (kept & (none + kept_bit)) |
                    (none + touching_bit));
  }
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
    int number = 0;
    r.own.fields([&](const Lanes& c0, const Lanes& c1) {
      if (!is_rare<M>(number)) own[static_cast<std::size_t>(number / 2)] = {c0, c1};
      number += 2;
    });
  }
};

/// Writes the rare numbers of the law's memory of the rows in `which`.
template <class M>
TRILITH_INLINE void write_rare(const FacePass& pass, const FourRows& rows, M& own, const LaneMask& which) {
  const auto at = [&](int i, int number) { return pass.law_after + pass.law_row[rows.row[i]].first + number; };
  if (!own.may_be_damaged()) {
    constexpr std::size_t size = (M::damage_end - M::damage_begin) * sizeof(double);
    for (int i = 0; i < lane_count; ++i)
      if (which[i] != 0) std::memset(at(i, M::damage_begin), 0, size);
    return;
  }
  int number = 0;
  own.fields([&](const Lanes& c0, const Lanes& c1) {
    if (is_rare<M>(number)) {
      const RowPairs pairs(c0, c1);
      for (int i = 0; i < lane_count; ++i)
        if (which[i] != 0) store_pair(at(i, number), pairs.of(i));
    }
    number += 2;
  });
}

/// Sides of a row, as bits.
constexpr std::uint8_t side_a = 1, side_b = 2, both_sides = side_a | side_b;

/// Adds forces one row after the other: two of four rows may share a skin point. `sides`: the sides that receive
/// forces.
TRILITH_INLINE void add_forces(const FacePass& pass, int row, const LanePair& a0, const LanePair& a1,
                               const LanePair& b0, const LanePair& b1, unsigned sides = both_sides) {
  const NearPair& p = pass.pairs[row];
  const auto add = [&](int skin, const LanePair& force) {
    double* on = pass.skin_force[skin].data();
    store_pair(on, load_pair(on) + force);
  };
  if ((sides & side_a) != 0) {
    add(p.a0, a0);
    add(p.a1, a1);
  }
  if ((sides & side_b) != 0) {
    add(p.b0, b0);
    add(p.b1, b1);
  }
}

/// Writes lane i of a response to its row. `Kept`: KeptFour, whose forces may be added later, or AddedAtOnce.
template <class M, std::size_t numbers, class Kept>
TRILITH_INLINE void write_row(const FacePass& pass, int row, const RowResponse<M, numbers>& r, int i,
                              const Kept& kept) {
  ContactMemory& after = pass.after[row];
  store_pair(after.shear_elastic, r.elastic.of(i));
  store_pair(after.shear_total, r.total.of(i));
  store_pair(after.damping_force, r.damping.of(i));
  store_pair(after.active, r.active.of(i));
  store_pair(&after.slip, r.slip_bits.of(i));
  after.damping_moment = 0;
  if constexpr (numbers > 0) {
    double* own = pass.law_after + pass.law_row[row].first;
    for (std::size_t k = 0; k < numbers / 2; ++k)
      if (!is_rare<M>(static_cast<int>(2 * k))) store_pair(own + 2 * k, r.own[k].of(i));
  }
  std::uint8_t later = 0;
  if (kept.is_delayed()) {
    later = pass.border == nullptr ? both_sides : pass.border[row];
    kept.four->later[static_cast<std::size_t>(i)] = later;
    if (later != 0) {
      std::array<Vec2, 4>& force = (*kept.force)[static_cast<std::size_t>(i)];
      store_pair(force[0].data(), r.a0.of(i)), store_pair(force[1].data(), r.a1.of(i));
      store_pair(force[2].data(), r.b0.of(i)), store_pair(force[3].data(), r.b1.of(i));
    }
  }
  if (later != both_sides) add_forces(pass, row, r.a0.of(i), r.a1.of(i), r.b0.of(i), r.b1.of(i), both_sides & ~later);
}

}  // namespace trilith
