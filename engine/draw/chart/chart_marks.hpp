// Positions of the names of a chart's event marks above the plot, without crossing other names or their lines.
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

/// Marks above the plot, and the key below it if numbers represent the texts: key[i] belongs to number i + 1.
struct PlacedMarks {
  std::vector<PlacedMark> marks;
  int rows = 0;
  std::vector<std::string> key;
};

/// Places marks (x in pt on the page, any order), whose texts must end before `right` [pt]. Texts are used if they fit
/// into `most_rows` rows. Otherwise numbers are used, one for each mark, or "5–9" for marks that are too close for
/// single numbers.
PlacedMarks place_marks(std::vector<PlacedMark> marks, const TextStyle& style, double right, int most_rows = 6);

}  // namespace trilith::draw
