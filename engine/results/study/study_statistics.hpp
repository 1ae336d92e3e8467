// Statistics over many cases: median, band and dispersion of a figure, and a probability with its interval.
#pragma once

#include <vector>

namespace trilith::results {

/// An interval that contains the true value with a given confidence.
struct Confidence {
  double low = 0, high = 1;
};

/// Wilson's score interval of a probability for `hits` in `count` trials: E. B. Wilson, Journal of the American
/// Statistical Association 22, 1927. It stays within 0 to 1, and gives an upper bound without any hit. `count` 0: 0 to
/// 1. `confidence` above 0 and below 1.
Confidence wilson_interval(int hits, int count, double confidence = 0.95);

/// The quantile `p` of `values`, linear between the sorted ones (type 7 of R. J. Hyndman and Y. Fan, The American
/// Statistician 50, 1996). NaN without values.
double quantile(std::vector<double> values, double p);

/// A figure over many cases; values that are not finite are ignored. All NaN without values.
struct Spread {
  int count = 0;
  double mean = 0, low = 0, high = 0;
  double median = 0, lower = 0, upper = 0;  ///< 50, 16 and 84 % quantiles: one standard deviation of a normal
                                            ///< distribution
  double deviation = 0;                     ///< standard deviation, with count - 1; NaN for one value
  double dispersion = 0;  ///< standard deviation of the natural logarithm; NaN if a value is not above 0
};
Spread spread_of(const std::vector<double>& values);

}  // namespace trilith::results
