// A ground motion in plain words, for a terminal.
#pragma once

#include <string>

#include "load/motion.hpp"

namespace trilith {

/// Several lines: description, samples, peaks, intensities, durations, end of the motion, and the result of
/// motion_check.hpp.
std::string motion_summary(const GroundMotion& motion);

}  // namespace trilith
