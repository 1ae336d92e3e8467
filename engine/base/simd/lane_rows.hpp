// Conversion between row-wise numbers in memory and lanes: four rows at once, by whole registers.
#pragma once

#include <array>
#include <cstddef>

#include "base/simd/four_by_four.hpp"
#include "base/simd/lane_vectors.hpp"

namespace trilith {

static_assert(lane_count == 4 && sizeof(Vec3) == 3 * sizeof(double), "rows are written for four lanes");

/// Lanes from unaligned memory, and back.
TRILITH_INLINE Lanes load_lanes(const double* from) {
  Lanes v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
TRILITH_INLINE void store_lanes(double* to, const Lanes& v) {
  __builtin_memcpy(to, &v, sizeof v);
}

/// Four rows of many numbers; `k` is the index of the first of four in each row.
template <class Number>
struct FourRowsOf {
  Number *r0, *r1, *r2, *r3;

  TRILITH_INLINE explicit FourRowsOf(const std::array<Number*, lane_count>& row)
      : r0(row[0]), r1(row[1]), r2(row[2]), r3(row[3]) {}
  TRILITH_INLINE void load(int k, Lanes& a, Lanes& b, Lanes& c, Lanes& d) const {
    const FourByFour columns(load_lanes(r0 + k), load_lanes(r1 + k), load_lanes(r2 + k), load_lanes(r3 + k));
    a = columns.v[0], b = columns.v[1], c = columns.v[2], d = columns.v[3];
  }
  TRILITH_INLINE void load(int k, Lanes& a) const { a = Lanes{r0[k], r1[k], r2[k], r3[k]}; }
  TRILITH_INLINE void store(int k, const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) const {
    const FourByFour rows(a, b, c, d);
    store_lanes(r0 + k, rows.v[0]), store_lanes(r1 + k, rows.v[1]), store_lanes(r2 + k, rows.v[2]),
        store_lanes(r3 + k, rows.v[3]);
  }
  TRILITH_INLINE void store(int k, const Lanes& a) const { r0[k] = a[0], r1[k] = a[1], r2[k] = a[2], r3[k] = a[3]; }
};

/// Four vectors that are contiguous in memory.
TRILITH_INLINE Triple<Lanes> load_neighbours(const Vec3* first) {
  const double* const from = first->data();
  const Lanes a = load_lanes(from), b = load_lanes(from + 4), c = load_lanes(from + 8);
  const Lanes xy = __builtin_shufflevector(a, b, 0, 1, 6, 7), zx = __builtin_shufflevector(a, c, 2, 3, 4, 5),
              yz = __builtin_shufflevector(b, c, 0, 1, 6, 7);
  return {Lanes(__builtin_shufflevector(xy, zx, 0, 5, 2, 7)), Lanes(__builtin_shufflevector(xy, yz, 1, 4, 3, 6)),
          Lanes(__builtin_shufflevector(zx, yz, 0, 5, 2, 7))};
}
TRILITH_INLINE void store_neighbours(const Triple<Lanes>& v, Vec3* first) {
  double* const to = first->data();
  const Lanes xy = __builtin_shufflevector(v.x, v.y, 0, 4, 2, 6), zx = __builtin_shufflevector(v.z, v.x, 0, 5, 2, 7),
              yz = __builtin_shufflevector(v.y, v.z, 1, 5, 3, 7);
  store_lanes(to, __builtin_shufflevector(xy, zx, 0, 1, 4, 5));
  store_lanes(to + 4, __builtin_shufflevector(yz, xy, 0, 1, 6, 7));
  store_lanes(to + 8, __builtin_shufflevector(zx, yz, 2, 3, 6, 7));
}

}  // namespace trilith
