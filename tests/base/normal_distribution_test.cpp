// The standard normal distribution: against tables, and its inverse against itself.
#include "base/normal_distribution.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "near.hpp"

using trilith::normal_density;
using trilith::normal_quantile;
using trilith::normal_share;
using trilith::testing::near;

TEST_CASE("the normal distribution matches tables, in the tails too") {
  CHECK(near(normal_share(0), 0.5, 1e-15));
  CHECK(near(normal_share(1), 0.841344746068542949, 1e-14));
  CHECK(near(normal_share(-1), 0.158655253931457051, 1e-14));
  CHECK(near(normal_share(1.959963984540054), 0.975, 1e-14));
  CHECK(near(normal_share(-5), 2.866515718791939e-07, 1e-12));
  CHECK(near(normal_share(-10), 7.619853024160526e-24, 1e-12));
  CHECK(normal_share(10) == 1);
  for (double x = -8; x <= 8; x += 0.125)
    CHECK(near(normal_share(x), 0.5 * std::erfc(-x / std::numbers::sqrt2), 1e-12));
}

TEST_CASE("the normal density is the slope of the share") {
  CHECK(near(normal_density(0), 0.398942280401432678, 1e-15));
  for (double x = -4; x <= 4; x += 0.25) {
    const double h = 1e-4;
    CHECK(near((normal_share(x + h) - normal_share(x - h)) / (2 * h), normal_density(x), 1e-6));
  }
}

TEST_CASE("quantiles of the normal distribution match tables and invert the distribution") {
  CHECK(std::abs(normal_quantile(0.5)) < 1e-14);
  CHECK(near(normal_quantile(0.84), 0.994457883209753, 1e-12));
  CHECK(near(normal_quantile(0.95), 1.644853626951473, 1e-12));
  CHECK(near(normal_quantile(0.975), 1.959963984540054, 1e-12));
  CHECK(near(normal_quantile(0.995), 2.575829303548901, 1e-12));
  CHECK(near(normal_quantile(1e-9), -5.997807015007687, 1e-10));
  for (double p = 0.01; p < 1; p += 0.03) {
    CHECK(near(normal_share(normal_quantile(p)), p, 1e-13));
    CHECK(near(normal_quantile(1 - p), -normal_quantile(p), 1e-10));
  }
}
