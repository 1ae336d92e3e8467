// Legend of a picture: symbols with their meaning, in lines.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "draw/canvas.hpp"

namespace trilith::draw {

/// One entry: `draw` puts a symbol of `symbol_width` pt with its left end on the given point, centred in height.
struct LegendItem {
  double symbol_width = 14;
  std::function<void(Canvas&, const PagePoint&)> draw;
  std::string text;
};

/// Height of the legend in lines of at most `width` pt; 0 without items.
double legend_height(const std::vector<LegendItem>& items, const TextStyle& style, double width);

/// Draws the legend with its upper left corner at `corner`.
void draw_legend(Canvas& canvas, const std::vector<LegendItem>& items, const TextStyle& style, const PagePoint& corner,
                 double width);

}  // namespace trilith::draw
