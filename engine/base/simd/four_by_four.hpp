// Transpose of four rows of four numbers.
//
//     row 0   a0 b0 c0 d0              v[0] = a0 a1 a2 a3
//     row 1   a1 b1 c1 d1    ----->    v[1] = b0 b1 b2 b3
//     row 2   a2 b2 c2 d2              v[2] = c0 c1 c2 c3
//     row 3   a3 b3 c3 d3              v[3] = d0 d1 d2 d3
#pragma once

#include "base/simd/lanes.hpp"

namespace trilith {

/// Rows as columns, or columns as rows. Aligned to 32 bytes because functions for wide registers read objects that
/// narrow functions made; the compiler does not ensure this alignment itself.
struct alignas(32) FourByFour {
  Lanes v[4];

  TRILITH_INLINE FourByFour(const Lanes& r0, const Lanes& r1, const Lanes& r2, const Lanes& r3) {
    const Lanes even01 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6),
                odd01 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7),
                even23 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6),
                odd23 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
    v[0] = __builtin_shufflevector(even01, even23, 0, 1, 4, 5),
    v[1] = __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5);
    v[2] = __builtin_shufflevector(even01, even23, 2, 3, 6, 7),
    v[3] = __builtin_shufflevector(odd01, odd23, 2, 3, 6, 7);
  }
};

}  // namespace trilith
