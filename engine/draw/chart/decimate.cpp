#include "draw/chart/decimate.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace trilith::draw {
namespace {

std::vector<PagePoint> decimate_loop(const std::vector<PagePoint>& line, double least) {
  std::vector<PagePoint> kept = {line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if ((line[i] - kept.back()).norm() >= least) kept.push_back(line[i]);
  kept.push_back(line.back());
  return kept;
}

/// Adds first, lowest, highest and last of line[first, last) in their order, each once.
void keep_extremes(const std::vector<PagePoint>& line, std::size_t first, std::size_t last,
                   std::vector<PagePoint>& kept) {
  std::size_t low = first, high = first;
  for (std::size_t i = first; i < last; ++i) {
    if (line[i].y() < line[low].y()) low = i;
    if (line[i].y() > line[high].y()) high = i;
  }
  std::array<std::size_t, 4> at = {first, low, high, last - 1};
  std::sort(at.begin(), at.end());
  const auto end = std::unique(at.begin(), at.end());
  std::for_each(at.begin(), end, [&](std::size_t i) { kept.push_back(line[i]); });
}

}  // namespace

/// For a line with increasing x: four points of each column, which cover the same area on the page. For other lines,
/// such as a loop of force and displacement: points at least a quarter of a column apart.
std::vector<PagePoint> decimate(const std::vector<PagePoint>& line, double column) {
  assert(column > 0);
  if (line.size() < 3) return line;
  const auto falls = [](const PagePoint& a, const PagePoint& b) { return b.x() < a.x(); };
  if (std::adjacent_find(line.begin(), line.end(), falls) != line.end()) return decimate_loop(line, column / 4);
  std::vector<PagePoint> kept;
  for (std::size_t first = 0; first < line.size();) {
    const double here = std::floor(line[first].x() / column);
    std::size_t last = first + 1;
    while (last < line.size() && std::floor(line[last].x() / column) == here) ++last;
    keep_extremes(line, first, last, kept);
    first = last;
  }
  return kept;
}

}  // namespace trilith::draw
