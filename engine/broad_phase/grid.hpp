// Finds overlapping boxes: a uniform grid sorted by counting for boxes of similar size; the few large ones are tested
// against all.
#pragma once

#include <utility>
#include <vector>

namespace trilith {

struct Box {
  double x0, y0, x1, y1;  ///< [m]
  [[nodiscard]] bool meets(const Box& o) const { return x0 <= o.x1 && o.x0 <= x1 && y0 <= o.y1 && o.y0 <= y1; }
};

/// All pairs (i, j), i < j, of overlapping boxes, sorted. Cost is linear in boxes and pairs. Each box much larger than
/// the others costs one pass over all boxes.
std::vector<std::pair<int, int>> meeting_boxes(const std::vector<Box>& boxes);

}  // namespace trilith
