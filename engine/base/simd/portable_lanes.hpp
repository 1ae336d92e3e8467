// Elementary functions of several numbers at once: to the bit those of portable.hpp, from the same formulas.
#pragma once

#include <cstddef>

#include "base/simd/lanes.hpp"

namespace trilith::portable {

/// Sines and cosines of `count` angles [rad], a multiple of lane_count; all three lists begin at a multiple of 32.
void sines_cosines(const double* angle, std::size_t count, double* sine, double* cosine);

}  // namespace trilith::portable
