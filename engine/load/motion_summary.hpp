// A ground motion in plain words, for a terminal.
#pragma once

#include <string>

#include "load/motion.hpp"

namespace trilith {

/// Several lines, each ended: what the motion is, its samples, peaks, intensities, durations, its end, and whether it
/// can be used (motion_check.hpp) or why not.
std::string motion_summary(const GroundMotion& motion);

}  // namespace trilith
