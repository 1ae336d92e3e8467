// Medians, bands, dispersions and Wilson's interval, against tables.
#include "results/study_statistics.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "near.hpp"

using namespace trilith::results;
using trilith::testing::near;

TEST_CASE("Wilson's interval has the values that are tabled for it") {
  // R. G. Newcombe, Statistics in Medicine 17, 1998, table I, method 3.
  CHECK(near(wilson_interval(81, 263).low, 0.2553, 2e-4));
  CHECK(near(wilson_interval(81, 263).high, 0.3662, 2e-4));
  CHECK(near(wilson_interval(15, 148).low, 0.0624, 6e-4));
  CHECK(near(wilson_interval(15, 148).high, 0.1605, 4e-4));
  CHECK(wilson_interval(0, 20).low == 0);
  CHECK(near(wilson_interval(0, 20).high, 0.1611, 4e-4));
  CHECK(near(wilson_interval(1, 29).low, 0.0061, 2e-2));
  CHECK(near(wilson_interval(1, 29).high, 0.1718, 4e-4));
  CHECK(wilson_interval(7, 7).high == 1);
  CHECK(wilson_interval(0, 0).low == 0);
  CHECK(wilson_interval(0, 0).high == 1);
}

TEST_CASE("middle, band and dispersion of a figure, of those cases that have it") {
  const Spread s = spread_of({4, 1, std::nan(""), 3, 2, 5});
  CHECK(s.count == 5);
  CHECK(s.median == 3);
  CHECK(near(s.lower, 1.64, 1e-12));
  CHECK(near(s.upper, 4.36, 1e-12));
  CHECK(s.low == 1);
  CHECK(s.high == 5);
  CHECK(near(s.deviation, std::sqrt(2.5), 1e-14));
  const Spread powers = spread_of({1, std::exp(1.0), std::exp(2.0)});
  CHECK(near(powers.dispersion, 1, 1e-14));
  CHECK(std::isnan(spread_of({-1, 1}).dispersion));
  CHECK(std::isnan(spread_of({}).median));
  CHECK(spread_of({}).count == 0);
  CHECK(std::isnan(spread_of({2}).deviation));
  CHECK(near(quantile({10, 20}, 0.25), 12.5, 1e-14));
}
