// Medians, bands, dispersions and Wilson's interval, against tables.
#include "results/study/study_statistics.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "base/normal_distribution.hpp"
#include "near.hpp"

using namespace trilith::results;
using trilith::testing::near;

TEST_CASE("Wilson's interval has the tabulated values") {
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

TEST_CASE("Wilson's interval has its stated coverage") {
  // The probability of `hits` of `count` is known, so the share of all outcomes whose interval contains p is exact. It
  // oscillates with p, and its mean over p is the confidence to 1.5 %.
  for (const int count : {50, 120, 200})
    for (const double confidence : {0.5, 0.8, 0.9, 0.95, 0.99}) {
      std::vector<Confidence> interval;  // [hits]
      for (int hits = 0; hits <= count; ++hits) interval.push_back(wilson_interval(hits, count, confidence));
      double sum = 0;
      int shares = 0;
      for (double p = 0.02; p < 0.99; p += 0.005, ++shares)
        for (int hits = 0; hits <= count; ++hits) {
          const Confidence c = interval[static_cast<std::size_t>(hits)];
          if (p < c.low || p > c.high) continue;
          sum += std::exp(std::lgamma(count + 1.0) - std::lgamma(hits + 1.0) - std::lgamma(count - hits + 1.0) +
                          hits * std::log(p) + (count - hits) * std::log(1 - p));
        }
      CAPTURE(count);
      CAPTURE(confidence);
      CHECK(std::abs(sum / shares - confidence) < 0.015);
    }
}

TEST_CASE("middle and band of many normal values are at 50, 16 and 84 %") {
  // The values at equal shares of a normal distribution, without randomness.
  std::vector<double> values;
  for (int i = 0; i < 2000; ++i) values.push_back(3 + 2 * trilith::normal_quantile((i + 0.5) / 2000));
  const Spread s = spread_of(values);
  CHECK(near(s.median, 3, 1e-9));
  CHECK(near(s.mean, 3, 1e-9));
  CHECK(near(s.deviation, 2, 2e-3));
  // Type 7 takes the value at index 1999 p, counted from 0; values are at the shares (i + 0.5) / 2000.
  CHECK(near(s.lower, 3 + 2 * trilith::normal_quantile((0.16 * 1999 + 0.5) / 2000), 1e-5));
  CHECK(near(s.upper, 3 + 2 * trilith::normal_quantile((0.84 * 1999 + 0.5) / 2000), 1e-5));
  for (double& v : values) v = std::exp(v / 10);
  CHECK(near(spread_of(values).dispersion, 0.2, 2e-3));
}
