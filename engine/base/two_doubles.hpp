// Double-double arithmetic: a number as the sum of two doubles, the second below half an ulp of the first; about 106
// bits. T. J. Dekker, "A floating-point technique for extending the available precision", Numerische Mathematik 18,
// 1971; D. E. Knuth, "The Art of Computer Programming" 2, sec. 4.2.2. It needs no fused multiply-add, which some
// processors lack.
#pragma once

#include <cfloat>
#include <cmath>
#include <limits>

namespace trilith {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "doubles are rounded after each operation");
#ifdef __FAST_MATH__
#error "sums must keep their order: no -ffast-math"
#endif

/// `T`: double or SIMD lanes.
template <class T>
struct TwoOf {
  T high{}, low{};
};
using TwoDoubles = TwoOf<double>;

/// a + b, exactly.
template <class T>
[[gnu::always_inline]] constexpr TwoOf<T> exact_sum(T a, T b) {
  const T sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}
/// a + b, exactly, where |a| >= |b| or a is 0.
template <class T>
[[gnu::always_inline]] constexpr TwoOf<T> ordered_sum(T a, T b) {
  const T sum = a + b;
  return {sum, b - (sum - a)};
}
/// a b, exactly, where both are below 2^996 and the product is above 2^-969.
constexpr TwoDoubles exact_product(double a, double b) {
  const auto upper = [](double v) {
    const double scaled = 134217729.0 * v;  // 2^27 + 1: leaves 26 bits
    return scaled - (scaled - v);
  };
  const double product = a * b, a1 = upper(a), b1 = upper(b), a2 = a - a1, b2 = b - b1;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

constexpr TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
  const TwoDoubles sum = exact_sum(a.high, b.high);
  return ordered_sum(sum.high, sum.low + (a.low + b.low));
}
constexpr TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
  const TwoDoubles product = exact_product(a.high, b.high);
  return ordered_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}
constexpr TwoDoubles operator/(const TwoDoubles& a, const TwoDoubles& b) {
  const double first = a.high / b.high;
  const TwoDoubles taken = exact_product(first, b.high);
  return ordered_sum(first, (((a.high - taken.high) - taken.low) + (a.low - first * b.low)) / b.high);
}

}  // namespace trilith
