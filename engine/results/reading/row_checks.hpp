// Private to results/: rows are refused before anything of them is written.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// How many numbers a frame of a file has.
struct FrameSizes {
  int dim;
  std::size_t nodes, elements, bearings;
  bool with_velocity;
  const std::vector<std::size_t>& field;  ///< numbers in a row of each field
};

/// Throws ResultsError where an array has another size, or holds a number that is not finite.
void check_frame(const FrameRow& frame, const FrameSizes& sizes);
void check_mode(const ModeRow& mode, int dim, std::size_t nodes);
/// ... or where it moves a body or node that is not there, or is no motion: less than two samples, no step.
void check_motion(const MotionRow& motion, std::size_t bodies, std::size_t nodes);

/// Of a row that an event names; "" for -1. Throws ResultsError where there is no such row.
std::string row_name(const std::vector<std::string>& names, std::int32_t index, const char* what);

}  // namespace trilith::results
