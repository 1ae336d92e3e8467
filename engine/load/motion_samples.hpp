// The last step of every reader: samples in g, checked as a whole, become a motion.
#pragma once

#include <vector>

#include "load/motion.hpp"
#include "load/text_lines.hpp"

namespace trilith {

/// A motion from samples [g]. Fails through `lines` for fewer than `announced` or fewer than 2 samples, for samples
/// that are all zero, and for a motion beyond the limits of motion_read.hpp.
GroundMotion motion_from_g(std::vector<double> acceleration, std::size_t announced, double step, MotionStart start,
                           MotionSource source, const TextLines& lines);

}  // namespace trilith
