// Elementary functions of several numbers at once, with the same formulas and bits as portable.hpp.
#pragma once

#include <cstddef>

#include "base/simd/lanes.hpp"

namespace trilith::portable {

/// Sines and cosines of `count` angles [rad], a multiple of lane_count. All three arrays are aligned to 32 bytes.
void sines_cosines(const double* angle, std::size_t count, double* sine, double* cosine);

}  // namespace trilith::portable
