// Fragility: how probably something happens at an intensity, as a lognormal curve fitted to what cases showed.
#pragma once

#include <vector>

#include "results/study/study_statistics.hpp"

namespace trilith::results {

/// What one case, or one record of an incremental analysis, says of the capacity (the least intensity at which it
/// happens): it lies above `low` and up to `high`. It happened at x: 0 to x. It did not: x to infinity. It did not at
/// x and did at y: x to y.
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
  int count = 0;  ///< of bounds

  [[nodiscard]] double probability(double x) const;
  /// Pointwise band of the curve: Phi of a + b ln x -+ z times its standard error.
  [[nodiscard]] Confidence band(double x, double confidence = 0.95) const;
  /// Interval of the median by the delta method, lognormal.
  [[nodiscard]] Confidence median_interval(double confidence = 0.95) const;
};

/// The curve of the largest likelihood, prod (P(high) - P(low)): for cases in stripes it is that of J. W. Baker,
/// "Efficient analytical fragility function fitting using dynamic structural analysis", Earthquake Spectra 31, 2015,
/// eq. 11; for incremental analyses each record gives its interval, open above where it was not brought down (his eq.
/// 9 where the steps are fine). The logarithm is concave in a and b (J. W. Pratt, JASA 76, 1981), so Newton steps with
/// halving find the one maximum. Throws InputError where there is none: nothing happened, it always did, or one
/// intensity parts what happened from what did not, so that any steep curve fits as well; and where the shares do not
/// grow with the intensity. Intensities must be finite and not below 0; a bound of 0 below, and infinity above.
Fragility fit_fragility(const std::vector<CapacityBounds>& bounds);

}  // namespace trilith::results
