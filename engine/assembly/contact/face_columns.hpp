// Rows of four contacts as columns, one SIMD lane for each contact.
#pragma once

#include "base/simd/lanes.hpp"
#include "broad_phase/face_line.hpp"
#include "model/work.hpp"

namespace trilith {

static_assert(lane_count == 4, "columns and rows are written for four lanes");

TRILITH_INLINE Lanes join(const LanePair& low, const LanePair& high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
/// Elements 0 and 2, or 1 and 3, of both vectors in turn.
TRILITH_INLINE Lanes even(const Lanes& a, const Lanes& b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
TRILITH_INLINE Lanes odd(const Lanes& a, const Lanes& b) {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}

/// Loads two neighbouring numbers of four rows as two columns.
TRILITH_INLINE void load_columns(const double* const* row, Lanes& c0, Lanes& c1) {
  const Lanes r02 = join(load_pair(row[0]), load_pair(row[2])), r13 = join(load_pair(row[1]), load_pair(row[3]));
  c0 = even(r02, r13);
  c1 = odd(r02, r13);
}

/// Two columns as a pair for each of four rows. Lanes 0 and 2 of both columns are in `row02`, 1 and 3 in `row13`;
/// of(row) returns two neighbouring numbers.
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

/// Loads positions or velocities of one end of the faces of four pairs, by columns.
TRILITH_INLINE void load_ends(const SkinMotion<2>* skin, const NearPair* const* p, int NearPair::*end,
                              double SkinMotion<2>::*first, Lanes& c0, Lanes& c1) {
  const double* place[lane_count];
  for (int i = 0; i < lane_count; ++i) place[i] = &(skin[p[i]->*end].*first);
  load_columns(place, c0, c1);
}

/// Neighbours in line of the faces a and b of four pairs.
TRILITH_INLINE NextInLine<Lanes> load_next(const FaceLine& line, const SkinMotion<2>* skin, const NearPair* const* p,
                                           const FaceEnds<Lanes>& a, const FaceEnds<Lanes>& b) {
  NextInLine<Lanes> next;
  next.some = LaneMask{};
  const auto load = [&](int NearPair::*end, const int* to, const Lanes& x, const Lanes& y, Lanes& dx, Lanes& dy) {
    const double* place[lane_count];
    for (int i = 0; i < lane_count; ++i) {
      const int at = p[i]->*end;
      place[i] = &skin[to[at]].x;
      if (to[at] != at) next.some[i] = -1;
    }
    load_columns(place, dx, dy);
    dx -= x, dy -= y;
  };
  load(&NearPair::a0, line.before, a.x0, a.y0, next.a0x, next.a0y);
  load(&NearPair::a1, line.after, a.x1, a.y1, next.a1x, next.a1y);
  load(&NearPair::b0, line.before, b.x0, b.y0, next.b0x, next.b0y);
  load(&NearPair::b1, line.after, b.x1, b.y1, next.b1x, next.b1y);
  return next;
}

}  // namespace trilith
