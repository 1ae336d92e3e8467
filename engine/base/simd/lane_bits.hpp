// Lane masks as bits of an integer.
#pragma once

#include "base/simd/lanes.hpp"

namespace trilith {

/// Bit i: lane i of `first` is true; bit 4 + i: lane i of `rest`.
TRILITH_INLINE unsigned lane_bits(const LaneMask& first, const LaneMask& rest) {
  const LaneMask low = first & LaneMask{1, 2, 4, 8}, high = rest & LaneMask{16, 32, 64, 128};
  const LaneMask both = low | high, pairs = both | __builtin_shufflevector(both, both, 2, 3, 0, 1);
  return static_cast<unsigned>(pairs[0] | pairs[1]);
}

}  // namespace trilith
