// Hierarchical hash grid: boxes are inserted, updated and removed one by one; a query finds the boxes that meet a box.
//
// Cells of several sizes are kept as one table of chains. A box lies in a single cell: the cell of its low corner, on
// the level that fits its longest side. Positions and size ratios of the boxes do not matter: cells exist only where
// boxes are, and a query visits each level in use once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace trilith {

/// Axis-aligned box.
template <int D>
struct FatBox {
  std::array<double, D> low, high;  ///< [m]
  [[nodiscard]] bool meets(const FatBox& o) const {
    bool apart = false;
    for (int k = 0; k < D; ++k) apart |= !(low[k] <= o.high[k] && o.low[k] <= high[k]);
    return !apart;
  }
};

/// Boxes by index. A box with infinite, NaN or out-of-range coordinates meets nothing. The set of boxes found by a
/// query depends on the boxes alone; their order also depends on the history of insertions.
template <int D>
class HierarchicalHashGrid {
 public:
  /// Removes all boxes and reserves indices 0 to `count` - 1.
  void reset(int count);
  /// Inserts box `i`, or replaces it.
  void put(int i, const FatBox<D>& box);
  /// Removes box `i` if present.
  void take(int i);
  /// False also for a box whose coordinates are out of range.
  [[nodiscard]] bool holds(int i) const { return entry_[i].level >= 0; }
  /// The box of the last put(i), if i is present.
  [[nodiscard]] const FatBox<D>& box(int i) const { return entry_[i].box; }

  /// Calls visit(i) once for each box that meets `box`.
  template <class Visit>
  void for_meeting(const FatBox<D>& box, Visit&& visit) const;

 private:
  using Cell = std::array<std::int64_t, D>;
  struct Entry {
    FatBox<D> box;
    Cell cell;
    int level = -1;    ///< -1: absent
    int next, before;  ///< in its chain, -1: none
    int place;         ///< index in the level's member list
  };
  /// Boxes of similar size.
  struct Level {
    int exponent;        ///< sides are below 2^exponent [m]
    double per_cell;     ///< 1 / side length of a cell [1/m]
    double longest = 0;  ///< longest side that a box of this level has had [m]
    std::vector<int> members;
  };

  /// Cell index of a coordinate. Monotonic in x, so clamping loses no box.
  static std::int64_t index(double x, double per_cell) {
    constexpr double most = 4e18;
    return static_cast<std::int64_t>(std::clamp(std::floor(x * per_cell), -most, most));
  }
  static bool are_same(const Cell& a, const Cell& b) {
    bool same = true;
    for (int k = 0; k < D; ++k) same &= a[k] == b[k];
    return same;
  }
  [[nodiscard]] std::size_t chain(int level, const Cell& cell) const;
  int level_of(double side);
  template <class Visit>
  void visit_cells(int level, const Cell& first, const Cell& last, const FatBox<D>& box, Visit&& visit) const;

  std::vector<Entry> entry_;  ///< [box]
  std::vector<int> head_;     ///< [chain] first box, -1: none; the size is a power of two
  std::vector<Level> level_;
};

/// Multiplication by odd numbers mixes the bits of a cell; the high bits of the product select the chain.
template <int D>
std::size_t HierarchicalHashGrid<D>::chain(int level, const Cell& cell) const {
  std::uint64_t h = static_cast<std::uint64_t>(level) * 0x9e3779b97f4a7c15U;
  for (const std::int64_t c : cell) h = (h ^ static_cast<std::uint64_t>(c)) * 0xd6e8feb86659fd93U, h ^= h >> 32;
  return static_cast<std::size_t>(h) & (head_.size() - 1);
}

template <int D>
template <class Visit>
void HierarchicalHashGrid<D>::visit_cells(int level, const Cell& first, const Cell& last, const FatBox<D>& box,
                                          Visit&& visit) const {
  Cell cell = first;
  while (true) {
    for (int i = head_[chain(level, cell)]; i >= 0; i = entry_[i].next) {
      const Entry& e = entry_[i];
      // A chain may hold boxes of other cells too.
      if (e.level == level && are_same(e.cell, cell) && e.box.meets(box)) visit(i);
    }
    int k = 0;
    while (k < D && cell[k] == last[k]) cell[k] = first[k], ++k;
    if (k == D) return;
    ++cell[k];
  }
}

/// Boxes of a level that meet `box` have their low corners inside it or below it by at most their longest side. If this
/// range has more cells than the level has boxes, as for the ground under pebbles, all boxes of the level are tested.
template <int D>
template <class Visit>
void HierarchicalHashGrid<D>::for_meeting(const FatBox<D>& box, Visit&& visit) const {
  for (int level = 0; level < static_cast<int>(level_.size()); ++level) {
    const Level& l = level_[level];
    if (l.members.empty()) continue;
    Cell first, last;
    double cells = 1;
    for (int k = 0; k < D; ++k) {
      // Rounded outwards: rounding may raise the difference by less than the relative 1e-12.
      first[k] = index(box.low[k] - l.longest - 1e-12 * std::abs(box.low[k]), l.per_cell);
      last[k] = index(box.high[k], l.per_cell);
      cells *= static_cast<double>(last[k] - first[k]) + 1;
    }
    if (cells <= static_cast<double>(l.members.size())) {
      visit_cells(level, first, last, box, visit);
      continue;
    }
    for (const int i : l.members)
      if (entry_[i].box.meets(box)) visit(i);
  }
}

extern template class HierarchicalHashGrid<2>;
extern template class HierarchicalHashGrid<3>;

}  // namespace trilith
