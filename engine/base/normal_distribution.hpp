// The standard normal distribution: density, distribution function and quantile, with the same bits on any machine.
#pragma once

namespace trilith {

/// exp(-x^2/2) / sqrt(2 pi).
double normal_density(double x);

/// Probability that a standard normal variable is below `x`, to 15 digits of the smaller tail: G. Marsaglia,
/// "Evaluating the normal distribution", Journal of Statistical Software 11, 2004; in the tails Laplace's continued
/// fraction.
double normal_share(double x);

/// The quantile: a standard normal variable is below it with probability `p`. By bisection within -9 to 9.
double normal_quantile(double p);

}  // namespace trilith
