// Fragility curves by maximum likelihood, against closed forms and against random samples.
#include "results/study/fragility.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

#include "base/error.hpp"
#include "base/normal_distribution.hpp"
#include "near.hpp"
#include "results/study/study_fragility.hpp"

using namespace trilith;
using results::CapacityBounds;
using results::fit_fragility;
using results::Fragility;
using testing::near;

namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

/// `hits` of `count` cases at intensity `x`.
void add_stripe(std::vector<CapacityBounds>& bounds, double x, int hits, int count) {
  for (int i = 0; i < count; ++i) bounds.push_back(i < hits ? CapacityBounds{0, x} : CapacityBounds{x, forever});
}

double log_likelihood(const std::vector<CapacityBounds>& bounds, double median, double dispersion) {
  double sum = 0;
  for (const CapacityBounds& b : bounds) {
    const double low = b.low > 0 ? normal_share(std::log(b.low / median) / dispersion) : 0;
    const double high = std::isfinite(b.high) ? normal_share(std::log(b.high / median) / dispersion) : 1;
    sum += std::log(high - low);
  }
  return sum;
}

/// Capacities drawn from a lognormal distribution, each known by the stripe of its trial.
std::vector<CapacityBounds> drawn_stripes(std::mt19937_64& random, double median, double dispersion, int each) {
  std::normal_distribution<double> normal;
  std::vector<CapacityBounds> bounds;
  for (const double x : {0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.3})
    for (int i = 0; i < each; ++i) {
      const double capacity = median * std::exp(dispersion * normal(random));
      bounds.push_back(capacity <= x ? CapacityBounds{0, x} : CapacityBounds{x, forever});
    }
  return bounds;
}

}  // namespace

TEST_CASE("a fragility curve passes exactly through two stripes") {
  std::vector<CapacityBounds> bounds;
  add_stripe(bounds, 0.5, 2, 10), add_stripe(bounds, 1.0, 7, 10);
  const Fragility f = fit_fragility(bounds);
  CHECK(near(f.probability(0.5), 0.2, 1e-10));
  CHECK(near(f.probability(1.0), 0.7, 1e-10));
  const double low = normal_quantile(0.2), high = normal_quantile(0.7);
  CHECK(near(f.dispersion, std::log(2.0) / (high - low), 1e-10));
  CHECK(near(f.median, std::exp(-high * f.dispersion), 1e-10));
}

TEST_CASE("the variances of two stripes follow from two independent shares") {
  // Each share is p with variance p (1 - p) / n, so its quantile eta has p (1 - p) / (n phi(eta)^2).
  std::vector<CapacityBounds> bounds;
  add_stripe(bounds, 0.5, 4, 20), add_stripe(bounds, 1.0, 14, 20);
  const Fragility f = fit_fragility(bounds);
  for (const auto& [x, p] : {std::pair{0.5, 0.2}, std::pair{1.0, 0.7}}) {
    const double eta = normal_quantile(p), error = std::sqrt(p * (1 - p) / 20) / normal_density(eta);
    const double z = normal_quantile(0.975);
    CHECK(near(f.band(x).low, normal_share(eta - z * error), 1e-8));
    CHECK(near(f.band(x).high, normal_share(eta + z * error), 1e-8));
  }
}

TEST_CASE("the interval of the median of two stripes follows from two independent shares, at every confidence") {
  // The shares' quantiles e1 and e2 at u1 and u2 = ln x are independent, and the curve passes through both:
  //     ln median = u1 - e1 (u2 - u1) / (e2 - e1)
  //
  // with the slopes -(u2 - u1) e2 / (e2 - e1)^2 and (u2 - u1) e1 / (e2 - e1)^2.
  struct Case {
    double x1, x2;
    int hits1, hits2, count;
  };
  for (const Case& c : {Case{0.5, 1.0, 4, 14, 20}, Case{0.2, 1.5, 10, 30, 40}, Case{3, 4, 30, 70, 100}}) {
    std::vector<CapacityBounds> bounds;
    add_stripe(bounds, c.x1, c.hits1, c.count), add_stripe(bounds, c.x2, c.hits2, c.count);
    const Fragility f = fit_fragility(bounds);
    const double n = c.count, p1 = c.hits1 / n, p2 = c.hits2 / n, u1 = std::log(c.x1), u2 = std::log(c.x2);
    const double e1 = normal_quantile(p1), e2 = normal_quantile(p2), w = (u2 - u1) / ((e2 - e1) * (e2 - e1));
    const double s1 = std::sqrt(p1 * (1 - p1) / n) / normal_density(e1),
                 s2 = std::sqrt(p2 * (1 - p2) / n) / normal_density(e2);
    const double error = w * std::hypot(e2 * s1, e1 * s2), median = std::exp(u1 - e1 * (u2 - u1) / (e2 - e1));
    CHECK(near(f.median, median, 1e-9));
    CHECK(near(f.median_interval().low, median * std::exp(-1.959963984540054 * error), 1e-8));
    CHECK(near(f.median_interval().high, median * std::exp(1.959963984540054 * error), 1e-8));
    for (const double confidence : {0.5, 0.68, 0.9, 0.95, 0.99}) {
      const double z = normal_quantile(0.5 + 0.5 * confidence);
      CHECK(near(f.median_interval(confidence).low, median * std::exp(-z * error), 1e-8));
      CHECK(near(f.median_interval(confidence).high, median * std::exp(z * error), 1e-8));
    }
  }
}

TEST_CASE("the interval of the median of known capacities is the interval of the mean of their logarithms") {
  // Fine steps leave a normal sample: its mean has the standard error dispersion / sqrt(n), whatever the dispersion.
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  std::vector<CapacityBounds> bounds;
  for (int i = 0; i < 40; ++i) {
    const double c = 0.6 * std::exp(0.35 * normal(random));
    bounds.push_back({c * (1 - 1e-5), c * (1 + 1e-5)});
  }
  const Fragility f = fit_fragility(bounds);
  for (const double confidence : {0.68, 0.95, 0.99}) {
    const double by = std::exp(normal_quantile(0.5 + 0.5 * confidence) * f.dispersion / std::sqrt(40.0));
    CHECK(near(f.median_interval(confidence).low, f.median / by, 1e-6));
    CHECK(near(f.median_interval(confidence).high, f.median * by, 1e-6));
  }
}

TEST_CASE("the line on a fragility curve prints its interval of 95 %") {
  std::vector<CapacityBounds> bounds;
  add_stripe(bounds, 0.5, 4, 20), add_stripe(bounds, 1.0, 14, 20);
  results::StudyFragility study{"pga", "g", false, {}, fit_fragility(bounds)};
  const auto [low, high] = study.curve.median_interval(0.95);
  CHECK(fragility_text(study) == fmt::format("median {:.4g} g (95 % {:.4g} to {:.4g}), dispersion {:.3g}, of 40 cases",
                                             study.curve.median, low, high, study.curve.dispersion));
}

TEST_CASE("no other lognormal curve is likelier than the fitted one, for stripes and for incremental analyses") {
  std::vector<CapacityBounds> stripes;
  int hits[] = {0, 1, 1, 4, 6, 7, 9, 10};
  for (int i = 0; i < 8; ++i) add_stripe(stripes, 0.1 * (i + 1), hits[i], 10);
  const std::vector<CapacityBounds> records{{0.2, 0.3}, {0.4, 0.5}, {0.4, 0.5},     {0.5, 0.6},
                                            {0.7, 0.8}, {0.3, 0.4}, {0.8, forever}, {0, 0.2}};
  for (const auto& bounds : {stripes, records}) {
    const Fragility f = fit_fragility(bounds);
    const double best = log_likelihood(bounds, f.median, f.dispersion);
    CHECK(near(best, f.log_likelihood, 1e-10));
    for (const double dm : {-1e-3, 0.0, 1e-3, 0.2, -0.2})
      for (const double ds : {-1e-3, 0.0, 1e-3, 0.2, -0.2})
        if (dm != 0 || ds != 0) CHECK(log_likelihood(bounds, f.median * (1 + dm), f.dispersion * (1 + ds)) < best);
  }
}

TEST_CASE("fine steps of an incremental analysis give mean and deviation of the capacities' logarithms") {
  const double capacities[] = {0.31, 0.42, 0.45, 0.52, 0.61, 0.73, 0.9};
  std::vector<CapacityBounds> bounds;
  double sum = 0, squares = 0;
  for (const double c : capacities) {
    bounds.push_back({c * (1 - 1e-5), c * (1 + 1e-5)});
    sum += std::log(c), squares += std::log(c) * std::log(c);
  }
  const Fragility f = fit_fragility(bounds);
  const double mean = sum / 7;
  CHECK(near(f.median, std::exp(mean), 1e-7));
  CHECK(near(f.dispersion, std::sqrt(squares / 7 - mean * mean), 1e-7));  // maximum likelihood: with n
}

TEST_CASE("the band of 95 % holds the true curve in 95 of 100 studies" * doctest::test_suite("long")) {
  std::mt19937_64 random(7);
  constexpr double median = 0.55, dispersion = 0.4;
  int held[3] = {0, 0, 0}, median_held = 0, studies = 0;
  const double at[3] = {0.35, 0.55, 0.9};
  for (int i = 0; i < 1000; ++i, ++studies) {
    const Fragility f = fit_fragility(drawn_stripes(random, median, dispersion, 20));
    for (int k = 0; k < 3; ++k) {
      const double truth = normal_share(std::log(at[k] / median) / dispersion);
      held[k] += f.band(at[k]).low <= truth && truth <= f.band(at[k]).high ? 1 : 0;
    }
    const auto [low, high] = f.median_interval();
    median_held += low <= median && median <= high ? 1 : 0;
  }
  // Within three standard deviations of a count of 1000 with 0.95, and 1.5 % for errors of asymptotic formulas.
  const double allowed = 3 * std::sqrt(0.95 * 0.05 / 1000) + 0.015;
  for (const int count : held) CHECK(std::abs(count / 1000.0 - 0.95) < allowed);
  CHECK(std::abs(median_held / 1000.0 - 0.95) < allowed);
}

TEST_CASE("many samples give the curve of their distribution") {
  std::mt19937_64 random(3);
  const Fragility f = fit_fragility(drawn_stripes(random, 0.55, 0.4, 20000));
  CHECK(near(f.median, 0.55, 0.01));
  CHECK(near(f.dispersion, 0.4, 0.02));
}

TEST_CASE("cases that do not determine the curve are rejected with the missing data") {
  std::vector<CapacityBounds> none, all, parted, falling;
  add_stripe(none, 0.5, 0, 5), add_stripe(all, 0.5, 5, 5);
  add_stripe(parted, 0.5, 0, 5), add_stripe(parted, 0.7, 5, 5);
  add_stripe(falling, 0.5, 6, 10), add_stripe(falling, 1.0, 2, 10);
  CHECK_THROWS_WITH_AS(fit_fragility(none), doctest::Contains("none of 5 cases"), InputError);
  CHECK_THROWS_WITH_AS(fit_fragility(all), doctest::Contains("all 5 cases"), InputError);
  CHECK_THROWS_WITH_AS(fit_fragility(parted), doctest::Contains("jumps between 0.5 and 0.7"), InputError);
  CHECK_THROWS_WITH_AS(fit_fragility(falling), doctest::Contains("not met more often"), InputError);
  CHECK_THROWS_AS(fit_fragility({}), InputError);
  CHECK_THROWS_AS(fit_fragility({{0.5, 0.2}}), InputError);
}
