// Rows of four contacts as columns, one lane for each.
#pragma once

#include "base/lanes.hpp"
#include "world/work.hpp"

namespace trilith {

static_assert(lane_count == 4, "columns and rows are written for four lanes");

TRILITH_INLINE Lanes join(const LanePair& low, const LanePair& high) {
  return __builtin_shufflevector(low, high, 0, 1, 2, 3);
}
/// Numbers 0 and 2, or 1 and 3, of both in turn.
TRILITH_INLINE Lanes even(const Lanes& a, const Lanes& b) {
  return __builtin_shufflevector(a, b, 0, 4, 2, 6);
}
TRILITH_INLINE Lanes odd(const Lanes& a, const Lanes& b) {
  return __builtin_shufflevector(a, b, 1, 5, 3, 7);
}

/// Two neighbouring numbers of four rows, as two columns.
TRILITH_INLINE void load_columns(const double* const* row, Lanes& c0, Lanes& c1) {
  const Lanes r02 = join(load_pair(row[0]), load_pair(row[2])), r13 = join(load_pair(row[1]), load_pair(row[3]));
  c0 = even(r02, r13);
  c1 = odd(r02, r13);
}

/// Positions or velocities of one end of the faces of four pairs, by columns.
TRILITH_INLINE void load_ends(const SkinMotion<2>* skin, const NearPair* const* p, int NearPair::*end,
                              double SkinMotion<2>::*first, Lanes& c0, Lanes& c1) {
  const double* place[lane_count];
  for (int i = 0; i < lane_count; ++i) place[i] = &(skin[p[i]->*end].*first);
  load_columns(place, c0, c1);
}

}  // namespace trilith
