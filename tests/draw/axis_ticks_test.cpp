#include "draw/chart/axis_ticks.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace trilith;
using namespace trilith::draw;
TEST_CASE("ticks are multiples of 1, 2 or 5 times a power of ten within the axis") {
  CHECK(linear_ticks(0, 1, 6) == std::vector<double>{0, 0.2, 0.4, 0.6, 0.8, 1});
  CHECK(linear_ticks(-0.35, 0.35, 5) == std::vector<double>{-0.2, 0, 0.2});
  CHECK(linear_ticks(0, 53.7, 6) == std::vector<double>{0, 10, 20, 30, 40, 50});
  CHECK(linear_ticks(1000.1, 1000.2, 6) == std::vector<double>{1000.1, 1000.12, 1000.14, 1000.16, 1000.18, 1000.2});
}

TEST_CASE("a tick on the axis' end survives rounding") {
  CHECK(linear_ticks(0.1 + 0.2, 0.9, 7).front() == 0.3);
  CHECK(linear_ticks(0, 0.3 - 1e-17, 4).back() == 0.3);
}

TEST_CASE("an axis has at least two ticks, and three where that needs at most twice the requested number") {
  for (int most = 2; most <= 10; ++most)
    for (double low = -7.3; low < 8; low += 0.37)
      for (double span = 1e-6; span < 1e7; span *= 3.1) {
        const std::vector<double> ticks = linear_ticks(low * span, low * span + span, most);
        CHECK(ticks.size() >= 2);
        CHECK(ticks.size() <= static_cast<std::size_t>(std::max(6, most)));
        const double step = ticks[1] - ticks[0];
        const double lead = step / std::pow(10, std::floor(std::log10(step) + 1e-6));
        CHECK(std::min({std::abs(lead - 1), std::abs(lead - 2), std::abs(lead - 5)}) < 1e-6);
      }
}

TEST_CASE("zero among the ticks is exactly zero and has no sign") {
  for (const double tick : linear_ticks(-0.7, 0.7, 7))
    if (std::abs(tick) < 1e-12) CHECK_FALSE(std::signbit(tick));
  CHECK(tick_texts({-0.5, -0.0, 0.5}) == std::vector<std::string>{"−0.5", "0.0", "0.5"});
}

TEST_CASE("tick figures have as many decimals as the finest needs") {
  CHECK(tick_texts({0, 0.25, 0.5}) == std::vector<std::string>{"0.00", "0.25", "0.50"});
  CHECK(tick_texts({0, 20, 40}) == std::vector<std::string>{"0", "20", "40"});
}

TEST_CASE("logarithmic ticks are powers of ten, or 1, 2, 5 on a short axis, or linear on a very short one") {
  CHECK(log_ticks(0.01, 10) == std::vector<double>{0.01, 0.1, 1, 10});
  CHECK(log_ticks(0.3, 6) == std::vector<double>{0.5, 1, 2, 5});
  CHECK(log_ticks(3.1, 3.9).size() >= 2);
  CHECK(log_ticks(1e-12, 1e12).size() <= 9);
  CHECK(log_tick_texts({1e-4, 0.01, 1, 1000, 1e5}) == std::vector<std::string>{"10⁻⁴", "0.01", "1", "1000", "10⁵"});
}

TEST_CASE("minor logarithmic ticks are the 2 to 9 fold of the powers of ten") {
  CHECK(log_minor_ticks(1, 10) == std::vector<double>{2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(log_minor_ticks(1e-9, 1e9).empty());
}

TEST_CASE("the largest nice number not above a value") {
  CHECK(nice_at_most(1.2e6) == 1e6);
  CHECK(nice_at_most(0.99) == 0.5);
  CHECK(nice_at_most(0.5) == 0.5);
  CHECK(nice_at_most(49) == 20);
}
