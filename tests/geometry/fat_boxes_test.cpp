#include "geometry/hierarchical_hash_grid.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace trilith;

namespace {

/// Plain copy of the contents of a HierarchicalHashGrid, queried in the same way.
template <int D>
struct Both {
  HierarchicalHashGrid<D> boxes;
  std::vector<FatBox<D>> plain;
  std::vector<bool> there;

  explicit Both(int count) : plain(static_cast<std::size_t>(count)), there(static_cast<std::size_t>(count), false) {
    boxes.reset(count);
  }
  void put(int i, const FatBox<D>& box) { boxes.put(i, box), plain[i] = box, there[i] = true; }
  void take(int i) { boxes.take(i), there[i] = false; }

  [[nodiscard]] std::vector<int> meeting(const FatBox<D>& box) const {
    std::vector<int> found;
    boxes.for_meeting(box, [&](int i) { found.push_back(i); });
    std::sort(found.begin(), found.end());
    return found;
  }
  [[nodiscard]] std::vector<int> by_trying_all(const FatBox<D>& box) const {
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(plain.size()); ++i)
      if (there[i] && plain[i].meets(box)) found.push_back(i);
    return found;
  }
};

double between_two(std::mt19937_64& bits, double low, double high) {
  return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
}

/// A random box within `extent`, with sides up to `unlike` times shorter than the longest.
template <int D>
FatBox<D> random_fat_box(std::mt19937_64& bits, double extent, double unlike) {
  FatBox<D> box;
  const double size = std::pow(unlike, -between_two(bits, 0, 1));
  for (int k = 0; k < D; ++k) {
    box.low[k] = between_two(bits, -extent, extent);
    box.high[k] = box.low[k] + size * between_two(bits, 0, 1);
  }
  return box;
}

template <int D>
void move_at_random(double extent, double unlike) {
  constexpr int count = 300, moves = 6000;
  std::mt19937_64 bits(11);
  Both<D> both(count);
  int met = 0, wrong = 0;
  for (int m = 0; m < moves; ++m) {
    const int i = static_cast<int>(bits() % count);
    if (both.there[i] && bits() % 8 == 0) {
      both.take(i);
    } else if (both.there[i] && bits() % 2 == 0) {  // a small displacement, as for most boxes
      FatBox<D> box = both.plain[i];
      for (int k = 0; k < D; ++k) {
        const double by = 0.2 * between_two(bits, -1, 1) * (box.high[k] - box.low[k]);
        box.low[k] += by, box.high[k] += by;
      }
      both.put(i, box);
    } else {
      both.put(i, random_fat_box<D>(bits, extent, unlike));
    }
    const FatBox<D> asked = both.there[i] ? both.plain[i] : random_fat_box<D>(bits, extent, unlike);
    const std::vector<int> found = both.meeting(asked);
    met += static_cast<int>(found.size());
    wrong += found == both.by_trying_all(asked) ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(met > moves / 2);
}

/// With one far larger than all others, as the ground of a world of pebbles.
template <int D>
void check_ground() {
  std::mt19937_64 bits(5);
  Both<D> both(1001);
  FatBox<D> ground;
  ground.low.fill(-1e4), ground.high.fill(1e4), ground.high[D - 1] = 0.5;
  both.put(1000, ground);
  for (int i = 0; i < 1000; ++i) {
    FatBox<D> pebble = random_fat_box<D>(bits, 3, 1);
    for (int k = 0; k < D; ++k) pebble.high[k] = pebble.low[k] + 1;
    both.put(i, pebble);
  }
  CHECK(both.meeting(ground) == both.by_trying_all(ground));
  CHECK(both.meeting(ground).size() > 500);
  for (int i = 0; i < 1000; i += 10) CHECK(both.meeting(both.plain[i]) == both.by_trying_all(both.plain[i]));
}

template <int D>
FatBox<D> cube(double low, double high) {
  FatBox<D> box;
  box.low.fill(low), box.high.fill(high);
  return box;
}

/// No box, one box, boxes without extent, boxes with huge coordinates.
template <int D>
void check_few() {
  const double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  CHECK(Both<D>(0).meeting(cube<D>(0, 1)).empty());
  Both<D> both(4);
  both.take(2);
  CHECK(both.meeting(cube<D>(-1, 1)).empty());
  both.put(2, cube<D>(0, 1));
  CHECK(both.meeting(cube<D>(1, 2)) == std::vector<int>{2});  // they share a corner
  CHECK(both.meeting(cube<D>(std::nextafter(1.0, 2.0), 2)).empty());
  both.put(1, cube<D>(0, 0)), both.put(0, cube<D>(0, 0));
  CHECK(both.meeting(cube<D>(0, 0)) == std::vector<int>{0, 1, 2});
  for (const double away : {1e101, infinite, none, -infinite}) {
    both.put(3, cube<D>(away, away));
    CHECK(both.meeting(cube<D>(-2, 2)) == std::vector<int>{0, 1, 2});
    both.put(3, cube<D>(0.5, 3));
    CHECK(both.meeting(cube<D>(2, 2)) == std::vector<int>{3});
  }
  for (const double away : {-1e99, -3e18, 1e25, 1e60}) {  // so far out that cells have no own numbers
    both.put(3, cube<D>(away, away + 0.1 * std::abs(away)));
    CHECK(both.meeting(cube<D>(away, away)) == std::vector<int>{3});
    CHECK(both.meeting(cube<D>(-2, 2)) == std::vector<int>{0, 1, 2});
  }
  both.boxes.reset(4), both.there.assign(4, false);
  CHECK(both.meeting(cube<D>(-1e90, 1e90)).empty());
}

}  // namespace

TEST_CASE("among boxes that move, appear and vanish at random exactly the overlapping pairs are found") {
  for (const double unlike : {1.0, 10.0, 1e4}) {
    move_at_random<2>(2, unlike);
    move_at_random<3>(1.5, unlike);
    move_at_random<2>(0.5, unlike);
    move_at_random<3>(0.5, unlike);
  }
}

TEST_CASE("a box ten thousand times larger than the others is found in all its pairs") {
  check_ground<2>();
  check_ground<3>();
}

TEST_CASE("no box, one box, boxes without extent and huge boxes form the right pairs") {
  check_few<2>();
  check_few<3>();
}
