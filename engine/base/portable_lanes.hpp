// Elementary functions of several numbers at once: to the bit those of portable.hpp, from the same formulas.
#pragma once

#include <array>

#include "base/lanes.hpp"

namespace trilith::portable {

/// Sines and cosines of four angles [rad], a lane each.
struct alignas(sizeof(Lanes)) FourTurns {
  std::array<double, lane_count> sine, cosine;
};
FourTurns sines_cosines(const std::array<double, lane_count>& angle);

}  // namespace trilith::portable
