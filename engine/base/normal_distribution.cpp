#include "base/normal_distribution.hpp"

#include <cmath>
#include <numbers>

#include "base/portable.hpp"

namespace trilith {

double normal_density(double x) {
  return portable::exp(-0.5 * x * x) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
}

/// Marsaglia's series (J. Stat. Software 11, 2004) near the middle, Laplace's continued fraction in the tails,
/// where 1 - Phi would lose its digits.
double normal_share(double x) {
  const double density = normal_density(x);
  if (std::abs(x) < 3) {
    // Phi(x) = 1/2 + density (x + x^3/3 + x^5/(3 5) + ...).
    double sum = x, term = x;
    for (int n = 3; n < 200; n += 2) term *= x * x / n, sum += term;
    return 0.5 + density * sum;
  }
  // density / (x + 1/(x + 2/(x + ...))), from the inside out.
  double beyond = std::abs(x);
  for (int n = 100; n > 0; --n) beyond = std::abs(x) + n / beyond;
  return x < 0 ? density / beyond : 1 - density / beyond;
}

/// Eighty bisections reduce the interval of 18 to rounding error.
double normal_quantile(double p) {
  double low = -9, high = 9;
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    (normal_share(middle) < p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace trilith
