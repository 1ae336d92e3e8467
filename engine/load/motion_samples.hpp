// The last step of every reader: samples in g, checked as a whole, become a motion.
#pragma once

#include <vector>

#include "load/motion.hpp"
#include "load/text_lines.hpp"

namespace trilith {

/// A motion from samples [g]. Fails through `lines` where there are fewer than `announced`, fewer than 2, where all are
/// zero, or where the motion is beyond the limits of motion_read.hpp.
GroundMotion motion_from_g(std::vector<double> acceleration, std::size_t announced, double step, MotionStart start,
                           MotionSource source, const TextLines& lines);

}  // namespace trilith
