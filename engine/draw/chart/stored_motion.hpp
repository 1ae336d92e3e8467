// Ground motions as a results file holds them, and whether the bodies followed them.
#pragma once

#include <vector>

#include "load/motion.hpp"
#include "results/reading/reader.hpp"

namespace trilith::draw {

/// The motion of a row, on its own clock.
GroundMotion stored_motion(const results::MotionRow& row);

/// The largest distance [m, rad] between where frames have a body's node and where its motion has it; frames between
/// its begin and its end, or the begin of the next motion of that node and direction. Not a number where there is none.
std::vector<double> motion_misses(const results::ResultsReader& reader, const std::vector<results::MotionRow>& rows);

}  // namespace trilith::draw
