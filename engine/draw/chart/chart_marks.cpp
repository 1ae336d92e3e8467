#include "draw/chart/chart_marks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trilith::draw {
namespace {

constexpr double line_gap = 2;

double text_end(const PlacedMark& mark, const TextStyle& style) {
  return mark.x + line_gap + text_width(mark.text, style) + line_gap;
}

/// Assigns rows from the right, because a text must be above every later line that it crosses. Returns the number of
/// rows, or a number above any limit if a text leaves the picture.
int give_rows(std::vector<PlacedMark>& marks, const TextStyle& style, double right) {
  int rows = 0;
  for (std::size_t i = marks.size(); i-- > 0;) {
    const double end = text_end(marks[i], style);
    if (end > right + line_gap) return 1000;
    marks[i].row = 0;
    for (std::size_t j = i + 1; j < marks.size() && marks[j].x < end; ++j)
      marks[i].row = std::max(marks[i].row, marks[j].row + 1);
    rows = std::max(rows, marks[i].row + 1);
  }
  return rows;
}

/// Numbers in one row; numbers of marks that are too close are merged to a range at the line of the first one.
void number_marks(std::vector<PlacedMark>& marks, const TextStyle& style) {
  for (std::size_t first = 0; first < marks.size();) {
    PlacedMark& head = marks[first];
    head.text = std::to_string(first + 1);
    std::size_t next = first + 1;
    while (next < marks.size() && marks[next].x < text_end(head, style)) {
      head.text = fmt::format("{}–{}", first + 1, next + 1);
      marks[next++].text.clear();
    }
    first = next;
  }
  for (PlacedMark& mark : marks) mark.row = 0;
}

}  // namespace

PlacedMarks place_marks(std::vector<PlacedMark> marks, const TextStyle& style, double right, int most_rows) {
  std::stable_sort(marks.begin(), marks.end(), [](const PlacedMark& a, const PlacedMark& b) { return a.x < b.x; });
  PlacedMarks out{std::move(marks), 0, {}};
  out.rows = give_rows(out.marks, style, right);
  if (out.rows <= most_rows) return out;
  for (const PlacedMark& mark : out.marks) out.key.push_back(mark.text);
  number_marks(out.marks, style);
  out.rows = 1;
  return out;
}

}  // namespace trilith::draw
