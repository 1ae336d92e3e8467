// Exponential: reduction to +-ln 2 / 2, then Taylor series. Powers: exp(y ln x), with the logarithm in two doubles: a
// table of ln c for factors c of few bits, and the series of ln(1 + r) for the remainder r = m c - 1 (P. T. P. Tang,
// "Table-driven implementation of the logarithm function", ACM Trans. Math. Software 16, 1990). The table is
// computed from ln m = 2 artanh((m - 1) / (m + 1)) (J.-M. Muller, "Elementary Functions", 3rd ed. 2016, ch. 11).
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "base/portable.hpp"
#include "base/two_doubles.hpp"

namespace trilith::portable {
namespace {

/// ln 2 in two parts: 40 bits, whose product with an exponent is exact, and the remainder.
constexpr double kLogTwo = 0x1.62e42fefa2p-1, kLogTwoRest = 0x1.9ef35793c7673p-41;

/// 1/k! from k = 15 down to 2.
constexpr std::array kExpTerm = [] {
  std::array<double, 14> term{};
  double factorial = 1;
  for (int k = 2; k <= 15; ++k) factorial *= k, term[static_cast<std::size_t>(15 - k)] = 1 / factorial;
  return term;
}();

/// v 2^n for v from 1/2 to 2. The power of two has its bits where no result can be subnormal.
double scaled(double v, int n) {
  if (n < -1000 || n > 1000) return std::ldexp(v, n);
  return v * std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

/// exp(x.high + x.low). With x = n ln 2 + r: 2^n exp(r), where 1 + r is held in two doubles and r^2 (1/2! + r/3! + ...)
/// is added.
double exp_of(const TwoDoubles& x) {
  constexpr double far = 800;  // outside the range of doubles on both sides
  const double power = std::clamp(x.high, -far, far), n = std::floor(power * 0x1.71547652b82fep+0 + 0.5);
  const TwoDoubles near = exact_sum(power - n * kLogTwo, -n * kLogTwoRest);
  const TwoDoubles rest = exact_sum(near.high, near.low + (std::abs(x.high) < far ? x.low : 0));
  double sum = 0;  // of r^k / k! from k = 2 on, over r^2
  for (const double of : kExpTerm) sum = sum * rest.high + of;
  const TwoDoubles one = ordered_sum(1.0, rest.high);
  return scaled(one.high + (one.low + (rest.low + rest.high * rest.high * sum)), static_cast<int>(n));
}

/// ln m = 2 s (1 + s^2/3 + s^4/5 + ...) for m from 0.7 to 1.5, s = (m - 1)/(m + 1). As s^2 is below 0.04, the terms
/// from the ninth on are below 1e-12 of the sum. One double represents them to 1e-28 of the sum.
constexpr TwoDoubles log_by_series(double m) {
  constexpr int in_two_doubles = 8;
  const TwoDoubles s = TwoDoubles{m - 1, 0} / exact_sum(m, 1.0), square = s * s;
  double small = 0;
  for (int k = 22; k > in_two_doubles; --k) small = (small + 1 / (2.0 * k + 1)) * square.high;
  TwoDoubles sum{small, 0};
  for (int k = in_two_doubles; k >= 1; --k) sum = (sum + TwoDoubles{1, 0} / TwoDoubles{2.0 * k + 1, 0}) * square;
  return TwoDoubles{2 * s.high, 2 * s.low} * (TwoDoubles{1, 0} + sum);
}

/// Factors c of 12 bits that bring m near i/128 to within 0.006 of 1, and -ln c. At i = 128 the factor is 1.
struct LogFactor {
  double factor;
  TwoDoubles log;
};
constexpr int kFirstFactor = 90, kFactors = 92;
constexpr std::array kLogFactor = [] {
  std::array<LogFactor, kFactors> table{};
  for (int i = 0; i < kFactors; ++i) {
    const double factor = static_cast<int>(128.0 * 2048 / (kFirstFactor + i) + 0.5) / 2048.0;
    const TwoDoubles log = log_by_series(factor);
    table[static_cast<std::size_t>(i)] = {factor, {-log.high, -log.low}};
  }
  return table;
}();

/// m from sqrt(1/2) to sqrt(2) and the exponent of x = m 2^e.
struct Parts {
  double m;
  int exponent;
};
Parts parts_of(double x) {
  constexpr std::uint64_t fraction = (std::uint64_t{1} << 52) - 1, of_one = std::uint64_t{1023} << 52;
  Parts out{};
  if (x < std::numeric_limits<double>::min()) {
    out.m = 2 * std::frexp(x, &out.exponent), --out.exponent;
  } else {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    out = {std::bit_cast<double>((bits & fraction) | of_one), static_cast<int>(bits >> 52) - 1023};
  }
  if (out.m >= 0x1.6a09e667f3bcdp+0) out.m *= 0.5, ++out.exponent;
  return out;
}

/// ln(1 + r) for |r| below 0.006. The terms from the fourth on are below 2^-24 of the sum: one double represents them
/// to 2^-77 of it.
TwoDoubles log_of_one_and(const TwoDoubles& r) {
  constexpr TwoDoubles third = TwoDoubles{1, 0} / TwoDoubles{3, 0};
  const double h = r.high, square_high = h * h;
  const double even = -1.0 / 4 + square_high * (-1.0 / 6 + square_high * (-1.0 / 8 - square_high / 10)),
               odd = 1.0 / 5 + square_high * (1.0 / 7 + square_high * (1.0 / 9 + square_high / 11));
  const TwoDoubles square = r * r, cube = square * r;
  const TwoDoubles from_third = cube * (third + TwoDoubles{h * (even + h * odd), 0});
  return r + (TwoDoubles{-0.5 * square.high, -0.5 * square.low} + from_third);
}

/// x = m 2^e: e ln 2 - ln c + ln(m c).
TwoDoubles log_of(double x) {
  const auto [m, exponent] = parts_of(x);
  const LogFactor& of = kLogFactor[static_cast<std::size_t>(static_cast<int>(128 * m + 0.5) - kFirstFactor)];
  // The upper half of m times c is exact, and so are its difference from 1 and the other product.
  const double split = 134217729.0 * m, upper = split - (split - m);
  const TwoDoubles rest = log_of_one_and(exact_sum(upper * of.factor - 1, (m - upper) * of.factor));
  return TwoDoubles{exponent * kLogTwo, 0} + (of.log + (rest + TwoDoubles{exponent * kLogTwoRest, 0}));
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
  if (base == 0 || base == 1 || !std::isfinite(base) || !std::isfinite(exponent) ||
      (base < 0 && std::floor(exponent) != exponent))
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
