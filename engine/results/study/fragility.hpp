// Fragility: probability of an outcome at an intensity, as a lognormal curve fitted to the results of cases.
#pragma once

#include <vector>

#include "results/study/study_statistics.hpp"

namespace trilith::results {

/// Bounds of the capacity (the least intensity with the outcome) from one case, or from one record of an incremental
/// analysis: above `low` and up to `high`. Outcome at x: 0 to x. No outcome at x: x to infinity. No outcome at x and
/// outcome at y: x to y.
struct CapacityBounds {
  double low = 0, high = 0;
};

/// A lognormal fragility curve, P(x) = Phi(ln(x / median) / dispersion).
struct Fragility {
  double median = 0;      ///< in the intensity's unit
  double dispersion = 0;  ///< standard deviation of ln capacity
  /// Of P = Phi(a + b ln x): a = -ln(median) / dispersion, b = 1 / dispersion; their covariance from the likelihood.
  double a = 0, b = 0, var_a = 0, var_b = 0, cov_ab = 0;
  double log_likelihood = 0;
  int count = 0;  ///< number of bounds

  [[nodiscard]] double probability(double x) const;
  /// Pointwise band of the curve: Phi of a + b ln x -+ z times its standard error.
  [[nodiscard]] Confidence band(double x, double confidence = 0.95) const;
  /// Interval of the median by the delta method, lognormal.
  [[nodiscard]] Confidence median_interval(double confidence = 0.95) const;
};

/// The maximum likelihood curve, prod (P(high) - P(low)). For cases in stripes it equals the curve of J. W. Baker,
/// "Efficient analytical fragility function fitting using dynamic structural analysis", Earthquake Spectra 31, 2015,
/// eq. 11. For incremental analyses each record gives its interval, unbounded above without an outcome (his eq. 9 for
/// fine steps). The logarithm is concave in a and b (J. W. Pratt, JASA 76, 1981), so Newton steps with halving find the
/// unique maximum. Throws InputError if there is none: the outcome never or always occurs, or one intensity separates
/// both results, so that any steep curve fits equally. It also throws if the shares do not increase with the intensity.
/// Intensities must be finite and not negative, except for an upper bound of infinity.
Fragility fit_fragility(const std::vector<CapacityBounds>& bounds);

}  // namespace trilith::results
