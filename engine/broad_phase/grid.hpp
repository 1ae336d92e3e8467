// Which boxes overlap: a grid sorted by counting, for boxes of like size; the few large ones against all.
#pragma once

#include <utility>
#include <vector>

namespace trilith {

struct Box {
  double x0, y0, x1, y1;  ///< [m]
  [[nodiscard]] bool meets(const Box& o) const { return x0 <= o.x1 && o.x0 <= x1 && y0 <= o.y1 && o.y0 <= y1; }
};

/// All pairs (i, j), i < j, whose boxes meet, sorted. Cost grows with boxes and pairs, not with their square; boxes
/// that are large against the rest cost one pass over all boxes each.
std::vector<std::pair<int, int>> meeting_boxes(const std::vector<Box>& boxes);

}  // namespace trilith
