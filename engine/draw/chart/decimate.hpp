// Long lines made short enough for a page without losing what the eye would see.
#pragma once

#include <vector>

#include "draw/canvas.hpp"

namespace trilith::draw {

/// A line of fewer points that looks the same on the page. Where x never falls: per column of `column` pt (> 0) the
/// first, lowest, highest and last point in their order, so that no peak is lost. Otherwise (a loop): points nearer
/// than a quarter of `column` to the last one kept are left out, but never the ends. All points must be finite.
std::vector<PagePoint> decimate(const std::vector<PagePoint>& line, double column);

}  // namespace trilith::draw
