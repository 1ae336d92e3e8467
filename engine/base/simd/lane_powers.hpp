// Powers of positive numbers, for one number or four at once, with the same bits in each lane.
//
//     x^n = exp(n log x),   x = m 2^e, m from sqrt(1/2) to sqrt(2)
//     log x = e log 2 + 2 (s + s^3/3 + s^5/5 + ...),  s = (m - 1)/(m + 1), |s| <= 0.1716
//     exp y = 2^k (1 + r + r^2/2 + ...),              y = k log 2 + r, |r| <= 0.3466
//
// Both series are cut where their terms fall below 2^-54. They consist of sums, products and quotients in a fixed
// order, so every processor gives the same bits. The logarithm and its product with n have four roundings. The relative
// error is therefore at most 2^-52 (3 + 2 |n log x|). For results from 1e-10 to 1e10 this is 1.1e-14. portable::pow has
// an error below 1 ulp, and takes several times as long.
#pragma once

#include <cstdint>

#include "base/simd/lanes.hpp"

namespace trilith {

/// The bits of a T, as unsigned integers.
template <class T>
struct WordsOf {
  using type = std::uint64_t;
};
template <>
struct WordsOf<Lanes> {
  using type = std::uint64_t __attribute__((vector_size(lane_count * sizeof(std::uint64_t))));
};
template <class T>
using Words = typename WordsOf<T>::type;

template <class T>
TRILITH_INLINE Words<T> words_of_number(const T& v) {
  Words<T> words;
  __builtin_memcpy(&words, &v, sizeof words);
  return words;
}
template <class T>
TRILITH_INLINE T number_of_words(const Words<T>& words) {
  T v;
  __builtin_memcpy(&v, &words, sizeof v);
  return v;
}

/// Natural logarithm of normal positive numbers.
template <class T>
TRILITH_INLINE T log_of_normal(const T& x) {
  constexpr std::uint64_t one = 0x3ff0000000000000, root_of_half = 0x3fe6a09e667f3bcd;
  constexpr double log_2 = 0x1.62e42fefa39efp-1, large = 0x1p52;
  const Words<T> words = words_of_number<T>(x), raised = (words + (one - root_of_half)) >> 52;  // e + 1023
  const T m = number_of_words<T>(words - (raised << 52) + one);
  const T e = number_of_words<T>(raised + words_of_number<double>(large)) - (large + 1023.0);
  const T s = (m - 1.0) / (m + 1.0), z = s * s;
  T sum = T{} + 1.0 / 21;
  for (int k = 19; k >= 3; k -= 2) sum = sum * z + 1.0 / k;
  return e * log_2 + 2.0 * (s + s * z * sum);
}

/// exp y for y from -700 to 700; numbers outside count as the nearer end.
template <class T>
TRILITH_INLINE T exp_in_range(const T& y) {
  constexpr double per_log_2 = 0x1.71547652b82fep+0, round = 0x1.8p52;
  constexpr double log_2_high = 0x1.62e42fee00000p-1, log_2_low = 0x1.a39ef35793c76p-33;
  constexpr std::uint64_t one = 0x3ff0000000000000;
  const T at = smaller<T>(larger<T>(y, T{} - 700.0), T{} + 700.0);
  const T shifted = at * per_log_2 + round, k = shifted - round;
  const T r = (at - k * log_2_high) - k * log_2_low;
  T sum = T{} + 1.0;
  for (int i = 13; i >= 1; --i) sum = sum * r * (1.0 / i) + 1.0;
  return sum * number_of_words<T>((words_of_number<T>(shifted) << 52) + one);
}

/// base^exponent; 0 for a base below 1e-290. The exponent is 0 to 100.
template <class T>
TRILITH_INLINE T power_of_positive(const T& base, double exponent) {
  constexpr double least = 1e-290;
  const Mask<T> counts = base >= least;
  const T result = exp_in_range<T>(exponent * log_of_normal<T>(select(counts, base, T{} + 1.0)));
  return select(counts, result, T{});
}

}  // namespace trilith
