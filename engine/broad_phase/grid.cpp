#include "broad_phase/grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace trilith {
namespace {

/// A grid over the small boxes, with cells of twice the median size. Each cell has a list of the boxes that overlap it:
/// member[start[c]] to member[start[c + 1] - 1] are the boxes of cell c = row * columns + column. Positions outside of
/// the grid are assigned to its outermost cells.
struct Grid {
  double x0 = 0, y0 = 0, cell = 1;
  std::int64_t columns = 1, rows = 1;
  std::vector<int> start, member;

  struct Range {
    std::int64_t i0, i1, j0, j1;
    [[nodiscard]] std::int64_t cells() const { return (i1 - i0 + 1) * (j1 - j0 + 1); }
  };
  [[nodiscard]] Range range(const Box& b) const {
    const auto column = [&](double x) {
      return std::clamp<std::int64_t>(std::int64_t((x - x0) / cell), 0, columns - 1);
    };
    const auto row = [&](double y) { return std::clamp<std::int64_t>(std::int64_t((y - y0) / cell), 0, rows - 1); };
    return {column(b.x0), column(b.x1), row(b.y0), row(b.y1)};
  }
};

/// Limit of coordinates [m]. Boxes beyond it, or with NaN, are ignored, and the watchdog ends the stage. Sums and
/// products of coordinates within it stay finite.
constexpr double farthest = 1e100;

bool is_within_measure(const Box& b) {
  return b.x0 >= -farthest && b.y0 >= -farthest && b.x1 <= farthest && b.y1 <= farthest;
}

double size_of(const Box& b) {
  return std::max(b.x1 - b.x0, b.y1 - b.y0);
}

/// The median, because a few ground slabs or one distant stone would distort a mean.
double median_size(const std::vector<Box>& boxes, const std::vector<int>& among) {
  std::vector<double> sizes(among.size());
  std::transform(among.begin(), among.end(), sizes.begin(), [&](int i) { return size_of(boxes[i]); });
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
  return sizes[sizes.size() / 2];
}

Grid lay_grid(const std::vector<Box>& boxes, const std::vector<int>& small, double cell) {
  Grid grid;
  Box all = boxes[small[0]];
  for (const int i : small) {
    all.x0 = std::min(all.x0, boxes[i].x0), all.y0 = std::min(all.y0, boxes[i].y0);
    all.x1 = std::max(all.x1, boxes[i].x1), all.y1 = std::max(all.y1, boxes[i].y1);
  }
  // The number of cells stays comparable to the number of boxes, however far some have flown.
  const double area = std::max(all.x1 - all.x0, cell) * std::max(all.y1 - all.y0, cell);
  grid.cell = std::max(cell, std::sqrt(area / (4.0 * static_cast<double>(small.size()))));
  grid.x0 = all.x0, grid.y0 = all.y0;
  const double most = 8.0 * static_cast<double>(small.size()) + 1;
  // `most` bounds columns and rows for any extent.
  grid.columns = std::int64_t(std::min((all.x1 - all.x0) / grid.cell, most)) + 1;
  grid.rows = std::int64_t(std::min((all.y1 - all.y0) / grid.cell, most)) + 1;
  // Counting sort: number of boxes in each cell, start of each list, then the boxes in their order.
  grid.start.assign(static_cast<std::size_t>(grid.columns * grid.rows + 1), 0);
  const auto for_cells = [&](int box, auto&& visit) {
    const Grid::Range r = grid.range(boxes[box]);
    for (std::int64_t j = r.j0; j <= r.j1; ++j)
      for (std::int64_t i = r.i0; i <= r.i1; ++i) visit(static_cast<std::size_t>(j * grid.columns + i));
  };
  for (const int box : small) for_cells(box, [&](std::size_t c) { ++grid.start[c + 1]; });
  for (std::size_t c = 1; c < grid.start.size(); ++c) grid.start[c] += grid.start[c - 1];
  grid.member.resize(static_cast<std::size_t>(grid.start.back()));
  std::vector<int> fill(grid.start.begin(), grid.start.end() - 1);
  for (const int box : small) for_cells(box, [&](std::size_t c) { grid.member[fill[c]++] = box; });
  return grid;
}

}  // namespace

/// A box is tested against the boxes of all cells that it overlaps. Pairs that share several cells are found several
/// times; the last line removes duplicates. Boxes over more than 8 cells, such as the ground, are tested against all
/// instead.
std::vector<std::pair<int, int>> meeting_boxes(const std::vector<Box>& boxes) {
  std::vector<std::pair<int, int>> pairs;
  std::vector<int> known, small, large;
  for (int i = 0; i < static_cast<int>(boxes.size()); ++i)
    if (is_within_measure(boxes[i])) known.push_back(i);
  if (known.size() < 2) return pairs;
  const double cell = 2 * median_size(boxes, known);
  for (const int i : known) (size_of(boxes[i]) > 8 * cell ? large : small).push_back(i);
  for (const int l : large)
    for (const int i : known) {
      const bool once = size_of(boxes[i]) <= 8 * cell || l < i;  // two large boxes are tested from the lower one
      if (i != l && once && boxes[l].meets(boxes[i])) pairs.emplace_back(std::min(l, i), std::max(l, i));
    }
  if (!small.empty()) {
    const Grid grid = lay_grid(boxes, small, cell);
    for (std::size_t c = 0; c + 1 < grid.start.size(); ++c)
      for (int p = grid.start[c]; p < grid.start[c + 1]; ++p)
        for (int q = p + 1; q < grid.start[c + 1]; ++q) {
          const int i = grid.member[p], j = grid.member[q];
          if (boxes[i].meets(boxes[j])) pairs.emplace_back(std::min(i, j), std::max(i, j));
        }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace trilith
