// Reduction of long lines for a page without visible loss.
#pragma once

#include <vector>

#include "draw/canvas.hpp"

namespace trilith::draw {

/// A line of fewer points with the same appearance on the page. If x never decreases, each column of `column` pt (> 0)
/// keeps its first, lowest, highest and last point in their order, so that no peak is lost. Otherwise (a loop) points
/// nearer than a quarter of `column` to the last one kept are omitted, except the ends. All points must be finite.
std::vector<PagePoint> decimate(const std::vector<PagePoint>& line, double column);

}  // namespace trilith::draw
