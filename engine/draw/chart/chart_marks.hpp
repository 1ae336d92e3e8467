// Where the names of a chart's event marks stand above the plot, so that no name crosses another or another's line.
#pragma once

#include <string>
#include <vector>

#include "draw/chart/chart.hpp"

namespace trilith::draw {

/// One mark on the page: its line at `x` [pt], its text starting just right of the line in `row` (0 next to the plot).
struct PlacedMark {
  double x = 0;
  int row = 0;
  std::string text;
};

/// Marks above the plot, and the key below it where numbers stand for the texts: key[i] belongs to number i + 1.
struct PlacedMarks {
  std::vector<PlacedMark> marks;
  int rows = 0;
  std::vector<std::string> key;
};

/// Places marks (x in pt on the page, any order) whose texts must end before `right` [pt]. Texts stand above the plot
/// where `most_rows` rows hold them, else numbers do, one for each mark or "5–9" over marks too near for single ones.
PlacedMarks place_marks(std::vector<PlacedMark> marks, const TextStyle& style, double right, int most_rows = 6);

}  // namespace trilith::draw
