// Exponential: reduction to +-ln 2 / 2, then Taylor series. Powers: exp(y ln x), with the logarithm in two doubles from
// ln m = 2 artanh((m - 1) / (m + 1)) (J.-M. Muller, "Elementary Functions", 3rd ed. 2016, ch. 11).
#include <algorithm>
#include <array>

#include "base/portable.hpp"
#include "base/two_doubles.hpp"

namespace trilith::portable {
namespace {

/// ln 2 in two parts: 40 bits, whose product with an exponent is exact, and the remainder.
constexpr double kLogTwo = 0x1.62e42fefa2p-1, kLogTwoRest = 0x1.9ef35793c7673p-41;

/// exp(x.high + x.low). With x = n ln 2 + r: 2^n exp(r), where 1 + r is held in two doubles and r^2 (1/2! + r/3! + ...)
/// is added.
double exp_of(const TwoDoubles& x) {
  constexpr double far = 800;  // outside the range of doubles on both sides
  const double power = std::clamp(x.high, -far, far), n = std::floor(power * 0x1.71547652b82fep+0 + 0.5);
  const TwoDoubles near = exact_sum(power - n * kLogTwo, -n * kLogTwoRest);
  const TwoDoubles rest = exact_sum(near.high, near.low + (std::abs(x.high) < far ? x.low : 0));
  double sum = 0;  // of r^k / k! from k = 2 on, over r^2
  for (int k = 15; k >= 2; --k) {
    double factorial = 1;
    for (int i = 2; i <= k; ++i) factorial *= i;
    sum = sum * rest.high + 1 / factorial;
  }
  const TwoDoubles one = ordered_sum(1.0, rest.high);
  return std::ldexp(one.high + (one.low + (rest.low + rest.high * rest.high * sum)), static_cast<int>(n));
}

/// 1/(2 k + 1): coefficients of the logarithm's terms that need two doubles.
constexpr int kLogTerms = 6;
constexpr std::array kLogTerm = [] {
  std::array<TwoDoubles, kLogTerms + 1> term{};
  for (int k = 1; k <= kLogTerms; ++k)
    term[static_cast<std::size_t>(k)] = TwoDoubles{1, 0} / TwoDoubles{2.0 * k + 1, 0};
  return term;
}();

/// x = m 2^e: e ln 2 + 2 s (1 + s^2/3 + s^4/5 + ...), s = (m - 1)/(m + 1). As s^2 is below 0.03, the terms from the
/// seventh on are below 2e-12 of the sum. One double represents them to 2e-28 of the sum.
TwoDoubles log_of(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0x1.6a09e667f3bcdp-1) m *= 2, --exponent;  // from sqrt(1/2) to sqrt(2)
  const TwoDoubles s = TwoDoubles{m - 1, 0} / exact_sum(m, 1.0), square = s * s;
  double small = 0;
  for (int k = 15; k > kLogTerms; --k) small = (small + 1 / (2.0 * k + 1)) * square.high;
  TwoDoubles sum{small, 0};
  for (int k = kLogTerms; k >= 1; --k) sum = (sum + kLogTerm[static_cast<std::size_t>(k)]) * square;
  const TwoDoubles of_m = TwoDoubles{2 * s.high, 2 * s.low} * (TwoDoubles{1, 0} + sum);
  return TwoDoubles{exponent * kLogTwo, 0} + (of_m + TwoDoubles{exponent * kLogTwoRest, 0});
}

}  // namespace

double exp(double x) {
  return std::isnan(x) ? x : exp_of({x, 0});
}

double log(double x) {
  if (x > 0 && std::isfinite(x)) return log_of(x).high;
  return std::log(x);  // 0, infinite, negative or NaN: exact on every machine
}

double pow(double base, double exponent) {
  // The C library is exact for bases 0 and 1, for infinite and NaN arguments, and for invalid roots of negative bases.
  const bool whole = std::floor(exponent) == exponent;
  if (base == 0 || base == 1 || !std::isfinite(base) || !std::isfinite(exponent) || (base < 0 && !whole))
    return std::pow(base, exponent);
  const TwoDoubles log = log_of(std::abs(base));
  const double sign = base < 0 && std::fmod(exponent, 2) != 0 ? -1 : 1, size = log.high * exponent;
  if (!(std::abs(size) < 800)) return sign * exp_of({size, 0});
  if (std::abs(size) < 0x1p-60) return sign;
  const TwoDoubles product = exact_product(log.high, exponent);
  return sign * exp_of({product.high, product.low + log.low * exponent});
}

double hypot_of_extremes(double x, double y) {
  const double most = std::max(std::abs(x), std::abs(y));
  if (std::isinf(x) || std::isinf(y) || std::isnan(most) || most == 0) return std::hypot(x, y);  // exact everywhere
  int exponent = 0;
  std::frexp(most, &exponent);
  const double a = std::ldexp(x, -exponent), b = std::ldexp(y, -exponent);
  return std::ldexp(std::sqrt(a * a + b * b), exponent);
}

}  // namespace trilith::portable
