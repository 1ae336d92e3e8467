#include "draw/chart/decimate.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace trilith;
using namespace trilith::draw;

namespace {

std::vector<PagePoint> noise(std::size_t count, double width) {
  std::mt19937 random(7);
  std::vector<PagePoint> line;
  for (std::size_t i = 0; i < count; ++i)
    line.emplace_back(width * static_cast<double>(i) / static_cast<double>(count),
                      static_cast<double>(random() % 1000));
  return line;
}

}  // namespace

TEST_CASE("a decimated series keeps the extremes of every column") {
  std::vector<PagePoint> line = noise(100000, 400);
  line[54321].y() = 5000;
  line[54322].y() = -5000;
  const std::vector<PagePoint> kept = decimate(line, 0.5);
  CHECK(kept.size() <= 4 * 801);
  const auto by_y = [](const PagePoint& a, const PagePoint& b) { return a.y() < b.y(); };
  for (int column = 0; column < 800; ++column) {
    const auto within = [&](const std::vector<PagePoint>& points) {
      std::vector<PagePoint> out;
      for (const PagePoint& p : points)
        if (std::floor(p.x() / 0.5) == column) out.push_back(p);
      return out;
    };
    const auto all = within(line), few = within(kept);
    CHECK(std::max_element(all.begin(), all.end(), by_y)->y() == std::max_element(few.begin(), few.end(), by_y)->y());
    CHECK(std::min_element(all.begin(), all.end(), by_y)->y() == std::min_element(few.begin(), few.end(), by_y)->y());
    CHECK(all.front() == few.front());
    CHECK(all.back() == few.back());
  }
}

TEST_CASE("a short series is unchanged") {
  const std::vector<PagePoint> line = noise(50, 400);
  CHECK(decimate(line, 0.5) == line);
}

TEST_CASE("a decimated loop stays within a quarter column of its points and keeps its ends") {
  std::vector<PagePoint> line;
  for (int i = 0; i < 20000; ++i) line.emplace_back(100 * std::cos(0.01 * i), 80 * std::sin(0.013 * i));
  const std::vector<PagePoint> kept = decimate(line, 2);
  CHECK(kept.size() < line.size());
  CHECK(kept.front() == line.front());
  CHECK(kept.back() == line.back());
  for (std::size_t i = 0; i < line.size(); i += 37) {
    double nearest = 1e9;
    for (const PagePoint& p : kept) nearest = std::min(nearest, (p - line[i]).norm());
    CHECK(nearest < 0.5);
  }
}
