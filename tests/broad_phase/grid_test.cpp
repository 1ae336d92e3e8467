#include "broad_phase/grid.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace trilith;

TEST_CASE("boxes that are huge or not finite form no pairs and leave other pairs unchanged") {
  const double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  std::vector<Box> boxes;
  for (int i = 0; i < 20; ++i) boxes.push_back({0.9 * i, 0, 0.9 * i + 1, 1});
  const auto pairs = meeting_boxes(boxes);
  CHECK(pairs.size() == 19);
  for (const double away : {1e101, 1e300, infinite, none}) {
    std::vector<Box> more = boxes;
    more.push_back({away, away, away, away});
    more.push_back({-away, 0, away, 1});
    more.push_back({0, 0, away, 1});
    CHECK(meeting_boxes(more) == pairs);
  }
}

TEST_CASE("boxes far from the origin are found within the allowed range") {
  std::vector<Box> boxes{{0, 0, 1, 1}, {1e60, 0, 1.1e60, 1}, {1.05e60, 0, 1.2e60, 1}, {0.5, 0, 1.5, 1}};
  const auto pairs = meeting_boxes(boxes);
  REQUIRE(pairs.size() == 2);
  CHECK(pairs[0] == std::pair(0, 3));
  CHECK(pairs[1] == std::pair(1, 2));
}

TEST_CASE("the boxes that meet are the boxes found by a comparison of all, for any sizes and in any order") {
  std::mt19937_64 bits(5);
  std::uniform_real_distribution<double> place(0, 10), size(0.2, 2);
  for (int round = 0; round < 20; ++round) {
    std::vector<Box> boxes;
    for (int i = 0; i < 60; ++i) {
      const double x = place(bits), y = place(bits), width = size(bits), height = size(bits);
      boxes.push_back({x, y, x + width, y + height});
    }
    std::vector<std::pair<int, int>> all;
    for (int i = 0; i < 60; ++i)
      for (int j = i + 1; j < 60; ++j)
        if (boxes[i].meets(boxes[j])) all.emplace_back(i, j);
    REQUIRE(all.size() > 50);
    CHECK(meeting_boxes(boxes) == all);
  }
}
