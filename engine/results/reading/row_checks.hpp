// Private to results/: checks of rows before any of their data are written.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/file/results.hpp"

namespace trilith::results {

/// Array sizes of a frame of a file.
struct FrameSizes {
  int dim;
  std::size_t nodes, elements, bearings;
  bool with_velocity;
  const std::vector<std::size_t>& field;  ///< numbers in a row of each field
};

/// Throws ResultsError if an array has another size, or contains a number that is not finite.
void check_frame(const FrameRow& frame, const FrameSizes& sizes);
void check_mode(const ModeRow& mode, int dim, std::size_t nodes);
/// Also throws for an unknown body or node, fewer than two samples, and a step that is not positive.
void check_motion(const MotionRow& motion, std::size_t bodies, std::size_t nodes);

/// Name of a row to which an event refers; "" for -1. Throws ResultsError if there is no such row.
std::string row_name(const std::vector<std::string>& names, std::int32_t index, const char* what);

}  // namespace trilith::results
