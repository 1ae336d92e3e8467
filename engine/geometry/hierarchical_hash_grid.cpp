#include "geometry/hierarchical_hash_grid.hpp"

namespace trilith {
namespace {

/// Limit of coordinates [m]: sums and products of smaller ones stay finite.
constexpr double farthest_box = 1e100;

template <int D>
bool has_measure(const FatBox<D>& box) {
  for (int k = 0; k < D; ++k)
    if (!(box.low[k] >= -farthest_box && box.high[k] <= farthest_box && box.low[k] <= box.high[k])) return false;
  return true;
}

/// Smaller sides share the lowest level.
constexpr int least_exponent = -40;

}  // namespace

/// Cells are found by hashing; twice as many chains as boxes keep the chains short.
template <int D>
void HierarchicalHashGrid<D>::reset(int count) {
  Entry none;
  none.next = none.before = none.place = -1;
  entry_.assign(static_cast<std::size_t>(count), none);
  std::size_t chains = 16;
  while (chains < 2 * entry_.size()) chains *= 2;
  head_.assign(chains, -1);
  level_.clear();
}

/// Boxes of one power of two in size share a level. Its cells are at least twice as wide as any of its boxes, so a box
/// reaches into its own cell and its neighbours only. One large body does not coarsen the grid of the small ones.
template <int D>
int HierarchicalHashGrid<D>::level_of(double side) {
  int exponent = least_exponent;
  if (side > 0) std::frexp(side, &exponent);
  exponent = std::max(exponent, least_exponent);
  int level = 0;
  while (level < static_cast<int>(level_.size()) && level_[level].exponent != exponent) ++level;
  if (level == static_cast<int>(level_.size())) {
    level_.emplace_back();
    level_.back().exponent = exponent;
    level_.back().per_cell = std::ldexp(1.0, -(exponent + 1));  // cells are twice the longest side
  }
  level_[level].longest = std::max(level_[level].longest, side);
  return level;
}

/// Inserts the box at the head of the chain of its low corner's cell.
template <int D>
void HierarchicalHashGrid<D>::put(int i, const FatBox<D>& box) {
  take(i);
  Entry& e = entry_[i];
  e.box = box;
  if (!has_measure(box)) return;
  double side = 0;
  for (int k = 0; k < D; ++k) side = std::max(side, box.high[k] - box.low[k]);
  e.level = level_of(side);
  Level& level = level_[e.level];
  for (int k = 0; k < D; ++k) e.cell[k] = index(box.low[k], level.per_cell);
  e.place = static_cast<int>(level.members.size());
  level.members.push_back(i);
  int& head = head_[chain(e.level, e.cell)];
  e.before = -1, e.next = head;
  if (head >= 0) entry_[head].before = i;
  head = i;
}

/// Unlinks the box from its chain. In the level's list the last member takes its index.
template <int D>
void HierarchicalHashGrid<D>::take(int i) {
  Entry& e = entry_[i];
  if (e.level < 0) return;
  (e.before >= 0 ? entry_[e.before].next : head_[chain(e.level, e.cell)]) = e.next;
  if (e.next >= 0) entry_[e.next].before = e.before;
  std::vector<int>& members = level_[e.level].members;
  members[e.place] = members.back();
  entry_[members[e.place]].place = e.place;
  members.pop_back();
  e.level = -1;
}

template class HierarchicalHashGrid<2>;
template class HierarchicalHashGrid<3>;

}  // namespace trilith
