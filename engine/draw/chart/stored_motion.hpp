// Ground motions in a results file, and the deviation of the bodies from them.
#pragma once

#include <vector>

#include "load/motion.hpp"
#include "results/reading/reader.hpp"

namespace trilith::draw {

/// The motion of a row, in its own time.
GroundMotion stored_motion(const results::MotionRow& row);

/// The largest deviation [m], [rad] of a body's node in the frames from its prescribed motion. Frames count from the
/// start of the motion to its end, or to the start of the next motion of that node and direction. NaN if there is no
/// frame.
std::vector<double> motion_misses(const results::ResultsReader& reader, const std::vector<results::MotionRow>& rows);

}  // namespace trilith::draw
