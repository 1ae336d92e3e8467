// What many cases say together: middle, band and dispersion of a figure, and a probability with its interval.
#pragma once

#include <vector>

namespace trilith::results {

/// The ends of an interval that holds what is looked for with a stated confidence.
struct Confidence {
  double low = 0, high = 1;
};

/// Wilson's score interval of a probability of which `count` trials showed `hits`: E. B. Wilson, Journal of the
/// American Statistical Association 22, 1927. It never leaves 0 to 1, and with no hit it still says how much is
/// possible. `count` 0: 0 to 1. `confidence` above 0 and below 1.
Confidence wilson_interval(int hits, int count, double confidence = 0.95);

/// The value below which the share `p` of `values` lies, linear between the sorted ones (type 7 of R. J. Hyndman and
/// Y. Fan, The American Statistician 50, 1996). NaN where there are none.
double quantile(std::vector<double> values, double p);

/// A figure over many cases; values that are not finite are left out. All NaN where none is left.
struct Spread {
  int count = 0;
  double mean = 0, low = 0, high = 0;
  double median = 0, lower = 0, upper = 0;  ///< 50, 16 and 84 %: one standard deviation, were it a normal distribution
  double deviation = 0;                     ///< standard deviation, with count - 1; NaN for one value
  double dispersion = 0;  ///< standard deviation of the natural logarithm; NaN where a value is not above 0
};
Spread spread_of(const std::vector<double>& values);

}  // namespace trilith::results
