#include "draw/legend.hpp"

#include <algorithm>

namespace trilith::draw {
namespace {

constexpr double symbol_gap = 4, item_gap = 14;

double line_height(const TextStyle& style) {
  return 1.75 * style.size;
}

/// Start of each item relative to the corner; y is the middle of its line.
std::vector<PagePoint> places(const std::vector<LegendItem>& items, const TextStyle& style, double width) {
  std::vector<PagePoint> out;
  double x = 0, y = line_height(style) / 2;
  for (const LegendItem& item : items) {
    const double wide = item.symbol_width + symbol_gap + text_width(item.text, style);
    if (x > 0 && x + wide > width) {
      x = 0;
      y += line_height(style);
    }
    out.emplace_back(x, y);
    x += wide + item_gap;
  }
  return out;
}

}  // namespace

double legend_height(const std::vector<LegendItem>& items, const TextStyle& style, double width) {
  if (items.empty()) return 0;
  return places(items, style, width).back().y() + line_height(style) / 2;
}

void draw_legend(Canvas& canvas, const std::vector<LegendItem>& items, const TextStyle& style, const PagePoint& corner,
                 double width) {
  const std::vector<PagePoint> at = places(items, style, width);
  for (std::size_t i = 0; i < items.size(); ++i) {
    const PagePoint start = corner + at[i];
    items[i].draw(canvas, start);
    const double room = std::max(width - at[i].x() - items[i].symbol_width - symbol_gap, style.size);
    const std::vector<std::string> lines = wrap_text(items[i].text, style, room);
    if (lines.empty()) continue;
    // An item wider than the page keeps its first line; the cut is shown.
    const std::string shown = lines.size() == 1 ? lines[0] : lines[0] + "…";
    canvas.text(start + PagePoint(items[i].symbol_width + symbol_gap, 0.36 * style.size), shown, style);
  }
}

}  // namespace trilith::draw
