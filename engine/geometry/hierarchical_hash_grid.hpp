// Boxes that come, change and go one by one, and which of them meet a given one.
//
// A grid of several cell sizes, kept as one table of chains: a box lies in a single cell, that of its low corner, of
// the size that its longest side asks for. Nothing depends on where the boxes are or how unlike they are in size: cells
// are made as they are needed, and a question goes once through each size in use.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace trilith {

/// A box with its sides along the axes.
template <int D>
struct FatBox {
  std::array<double, D> low, high;  ///< [m]
  [[nodiscard]] bool meets(const FatBox& o) const {
    bool apart = false;
    for (int k = 0; k < D; ++k) apart |= !(low[k] <= o.high[k] && o.low[k] <= high[k]);
    return !apart;
  }
};

/// Boxes by number. A box that is out of all measure, or of no numbers, meets nothing. Which boxes meet depends on the
/// boxes alone, the order in which they are told on how they came too.
template <int D>
class HierarchicalHashGrid {
 public:
  /// Forgets all, and makes room for boxes 0 to `count` - 1.
  void reset(int count);
  /// Box `i` is `box` from now on, whatever it was.
  void put(int i, const FatBox<D>& box);
  /// There is no box `i` any more.
  void take(int i);
  /// False too of a box that is out of all measure.
  [[nodiscard]] bool holds(int i) const { return entry_[i].level >= 0; }
  /// The box put last, where there is one.
  [[nodiscard]] const FatBox<D>& box(int i) const { return entry_[i].box; }

  /// Calls visit(i) once for each box that meets `box`.
  template <class Visit>
  void for_meeting(const FatBox<D>& box, Visit&& visit) const;

 private:
  using Cell = std::array<std::int64_t, D>;
  struct Entry {
    FatBox<D> box;
    Cell cell;
    int level = -1;    ///< -1: not there
    int next, before;  ///< in its chain, -1: none
    int place;         ///< in its level's members
  };
  /// Boxes of like size.
  struct Level {
    int exponent;        ///< sides are below 2^exponent
    double per_cell;     ///< 1 / side of a cell [1/m]
    double longest = 0;  ///< longest side that any of them has had [m]
    std::vector<int> members;
  };

  /// Of a place along an axis. Rises with x, so that clamping loses nothing.
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
  std::vector<int> head_;     ///< [chain] first box, -1: none; a power of two of them
  std::vector<Level> level_;
};

/// Odd numbers without pattern mix the bits of a cell; the high ones of the product name the chain.
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

/// Low corners of the boxes of a level that meet `box` lie within it or before it by their longest side. Where that
/// takes more cells than the level has boxes, as for the ground under pebbles, all of them are tried.
template <int D>
template <class Visit>
void HierarchicalHashGrid<D>::for_meeting(const FatBox<D>& box, Visit&& visit) const {
  for (int level = 0; level < static_cast<int>(level_.size()); ++level) {
    const Level& l = level_[level];
    if (l.members.empty()) continue;
    Cell first, last;
    double cells = 1;
    for (int k = 0; k < D; ++k) {
      // Rounded outwards: by less than the share of 1e-12 the difference may come out too high.
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
