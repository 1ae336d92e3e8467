// Sums over the lanes of vectors.
#pragma once

#include "base/simd/lanes.hpp"

namespace trilith {

/// Sums over the lanes of four vectors, (0 + 1) + (2 + 3).
TRILITH_INLINE Lanes over_four(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7),
              cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

}  // namespace trilith
