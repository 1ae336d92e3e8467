// Sine, cosine and tangent: reduction to +-pi/4, then Taylor series. Arc functions: reduction to +-1/16. Reduction up
// to 2^20: W. J. Cody and W. Waite, "Software Manual for the Elementary Functions", 1980. Beyond: M. Payne and R.
// Hanek, "Radian reduction for trigonometric functions", SIGNUM Newsletter 18, 1983. Summation in which only the last
// rounding matters: J.-M. Muller, "Elementary Functions", 3rd ed. 2016, ch. 11.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "base/portable.hpp"
#include "base/simd/lanes.hpp"
#include "base/simd/portable_lanes.hpp"
#include "base/two_doubles.hpp"

namespace trilith::portable {
namespace {

constexpr TwoDoubles kHalfPi{0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54}, kPi{2 * kHalfPi.high, 2 * kHalfPi.low};

/// Integer type of the width of T.
template <class T>
struct BitsOf {
  using type = std::uint64_t;
};
template <>
struct BitsOf<Lanes> {
  using type = LaneMask;
};
template <class T>
using Bits = typename BitsOf<T>::type;

TRILITH_INLINE std::uint64_t bits_of(double v) {
  return std::bit_cast<std::uint64_t>(v);
}
TRILITH_INLINE LaneMask bits_of(const Lanes& v) {
  return LaneMask(v);
}

/// An angle minus an integer number of quarter turns: within +-pi/4 up to rounding, `low` below half an ulp of `high`.
/// `T`: double or Lanes.
template <class T>
struct ReducedTo {
  T high, low;
  Bits<T> quarters;  ///< modulo 4
};
using Reduced = ReducedTo<double>;

/// pi/4: smaller angles need no reduction.
constexpr double kLeastReduced = 0x1.921fb54442d18p-1;
/// Largest angle of reduce_near().
constexpr double kMostNear = 0x1p20;

/// Angles up to 2^20. pi/2 is split into three parts of 33 bits, whose products are exact, and a fourth part.
template <class T>
TRILITH_INLINE ReducedTo<T> reduce_near(T angle) {
  constexpr double first = 0x1.921fb544p+0, second = 0x1.0b4611a6p-34, third = 0x1.3198a2ep-69,
                   fourth = 0x1.b839a252049c1p-104, to_whole = 0x1.8p52;
  // Adding and subtracting 1.5 2^52 rounds to the nearest integer; the last bits of the intermediate sum are its bits.
  const T sum_with = angle * 0x1.45f306dc9c883p-1 + to_whole, n = sum_with - to_whole;
  const TwoOf<T> a = exact_sum<T>(angle - n * first, -n * second), b = exact_sum<T>(a.high, -n * third);
  const TwoOf<T> sum = ordered_sum<T>(b.high, (a.low + b.low) - n * fourth);
  return {sum.high, sum.low, bits_of(sum_with) & 3};
}

__extension__ using Wide = unsigned __int128;
constexpr int kWord = 64;

/// 192 bits of 2/pi, the highest first, starting at bit `from` after the point; leading bits are zeros.
std::array<std::uint64_t, 3> bits_of_two_over_pi(int from) {
  static constexpr std::array<std::uint64_t, 20> bits{0,
                                                      0xa2f9836e4e441529,
                                                      0xfc2757d1f534ddc0,
                                                      0xdb6295993c439041,
                                                      0xfe5163abdebbc561,
                                                      0xb7246e3a424dd2e0,
                                                      0x06492eea09d1921c,
                                                      0xfe1deb1cb129a73e,
                                                      0xe88235f52ebb4484,
                                                      0xe99c7026b45f7e41,
                                                      0x3991d639835339f4,
                                                      0x9c845f8bbdf9283b,
                                                      0x1ff897ffde05980f,
                                                      0xef2f118b5a0a6d1f,
                                                      0x6d367ecf27cb09b7,
                                                      0x4f463f669e5fea2d,
                                                      0x7527bac7ebe5f17b,
                                                      0x3d0739f78a5292ea,
                                                      0x6bfb5fb11f8d5d08,
                                                      0x56033046fc7b6bab};
  const int at = from + kWord, word = at / kWord, shift = at % kWord;
  std::array<std::uint64_t, 3> out{};
  for (int i = 0; i < 3; ++i) {
    out[i] = bits[word + i] << shift;
    if (shift > 0) out[i] |= bits[word + i + 1] >> (kWord - shift);
  }
  return out;
}

/// The angle [rad] of the fraction `word` / 2^192 of a turn, at most half a turn.
TwoDoubles angle_of(std::array<std::uint64_t, 3> word) {
  int exponent = 2;  // in quarters of a turn
  while (word[0] == 0) {
    if (word[1] == 0 && word[2] == 0) return {};
    word = {word[1], word[2], 0}, exponent -= kWord;
  }
  const int zeros = std::countl_zero(word[0]);
  if (zeros > 0)
    word = {word[0] << zeros | word[1] >> (kWord - zeros), word[1] << zeros | word[2] >> (kWord - zeros), 0};
  exponent -= zeros;
  // 53 bits, then the next 53; the remaining bits are below rounding.
  const double high = static_cast<double>(word[0] >> 11);
  const double low = static_cast<double>((word[0] & 0x7ff) << 42 | word[1] >> 22);
  const TwoDoubles quarters{std::ldexp(high, exponent - 53), std::ldexp(low, exponent - 106)};
  return ordered_sum(quarters.high, quarters.low) * kHalfPi;
}

/// Angles of any size: angle (2/pi) modulo 4, computed from the significant bits of 2/pi alone.
Reduced reduce_far(double angle) {
  int exponent = 0;
  const auto whole = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(angle), &exponent), 53));
  // With |angle| = integer 2^(exponent - 53), bits of 2/pi above 4 2^(53 - exponent) give whole turns.
  const std::array<std::uint64_t, 3> bits = bits_of_two_over_pi(exponent - 53 - 2);
  std::array<std::uint64_t, 3> turn{};
  std::uint64_t carry = 0;
  for (int i = 2; i >= 0; --i) {
    const Wide product = static_cast<Wide>(whole) * bits[i] + carry;
    turn[i] = static_cast<std::uint64_t>(product), carry = static_cast<std::uint64_t>(product >> kWord);
  }
  auto quarters = static_cast<unsigned>(turn[0] >> 62);
  const bool above = (turn[0] >> 61 & 1) != 0;
  turn[0] &= ~std::uint64_t{0} >> 2;
  if (above) {  // the next quarter is nearer: measure backwards from it
    quarters += 1;
    for (std::uint64_t& word : turn) word = ~word;  // negation without the insignificant 1
    turn[0] &= ~std::uint64_t{0} >> 2;
  }
  const TwoDoubles found = angle_of(turn);
  const double sign = above != (angle < 0) ? -1 : 1;
  return {sign * found.high, sign * found.low, (angle < 0 ? 4U - quarters % 4 : quarters) & 3U};
}

Reduced reduce(double angle) {
  if (std::abs(angle) <= kLeastReduced) return {angle, 0, 0};
  if (std::abs(angle) <= kMostNear) return reduce_near(angle);
  if (std::abs(angle) <= std::numeric_limits<double>::max()) return reduce_far(angle);
  return {std::numeric_limits<double>::quiet_NaN(), 0, 0};
}

/// c[0] + c[1] z + c[2] z^2 + ... + c[7] z^7; odd and even powers are summed separately.
template <class T>
TRILITH_INLINE T series(const std::array<double, 8>& c, T z) {
  const T square = z * z;
  const T even = c[0] + square * (c[2] + square * (c[4] + square * c[6]));
  const T odd = c[1] + square * (c[3] + square * (c[5] + square * c[7]));
  return even + z * odd;
}

/// Coefficients from the fourth power on.
constexpr std::array<double, 8> kOfCosine{
    1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
    1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};

/// Sine and cosine of a reduced angle, each as an unevaluated sum.
template <class T>
struct Sums {
  TwoOf<T> sine, cosine;
};
template <class T>
TRILITH_INLINE Sums<T> sums(const ReducedTo<T>& a) {
  static constexpr std::array<double, 8> of_sine{
      -1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
      -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
  const T z = a.high * a.high, half = 0.5 * z, near_one = 1.0 - half;
  return {{a.high, a.high * z * series(of_sine, z) + a.low * near_one},
          {near_one, ((1.0 - near_one) - half) + (z * z * series(kOfCosine, z) - a.high * a.low)}};
}

/// atan(small / big) for 0 <= small <= big.
TwoDoubles arc(const TwoDoubles& small, const TwoDoubles& big) {
  if (small.high <= 0x1p-200 * big.high) return {small.high / big.high, 0};
  // atan of 0, 1/8, 2/8, ... 1.
  static constexpr std::array<TwoDoubles, 9> known{{{0, 0},
                                                    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
                                                    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
                                                    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
                                                    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
                                                    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
                                                    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
                                                    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
                                                    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55}}};
  const TwoDoubles t = small / big;
  const auto nearest = static_cast<std::size_t>(std::floor(8 * t.high + 0.5));
  const double place = 0.125 * static_cast<double>(nearest);
  // c is the nearest eighth. atan t = atan c + atan((t - c) / (1 + t c)), where the last argument is below 1/16.
  TwoDoubles rest = t;
  if (nearest > 0) rest = (TwoDoubles{t.high - place, t.low}) / (TwoDoubles{1, 0} + t * TwoDoubles{place, 0});
  static constexpr std::array<double, 8> of_arc{-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,
                                                -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
  const double z = rest.high * rest.high;
  const TwoDoubles sum = ordered_sum(known[nearest].high, rest.high);
  return ordered_sum(sum.high, sum.low + (known[nearest].low + rest.low + rest.high * z * series(of_arc, z)));
}

TwoDoubles less(const TwoDoubles& a, const TwoDoubles& b) {
  return a + TwoDoubles{-b.high, -b.low};
}

/// Angle of (x, y) with x >= 0 and y >= 0, not both 0.
TwoDoubles arc_of(const TwoDoubles& y, const TwoDoubles& x) {
  return y.high <= x.high ? arc(y, x) : less(kHalfPi, arc(x, y));
}

/// sqrt(1 - x^2), x within +-1.
TwoDoubles other_leg(double x) {
  const TwoDoubles rest = less({1, 0}, exact_product(x, x));
  TwoDoubles leg{std::sqrt(rest.high), 0};
  if (leg.high > 0) {
    const TwoDoubles taken = exact_product(leg.high, leg.high);
    leg.low = (((rest.high - taken.high) - taken.low) + rest.low) / (2 * leg.high);
  }
  return leg;
}

}  // namespace

SineCosine sine_cosine(double angle) {
  // sin and cos of r + n pi/2 are +-sin or +-cos of r, by n modulo 4.
  const Reduced reduced = reduce(angle);
  const Sums<double> found = sums(reduced);
  const double s = std::copysign(found.sine.high + found.sine.low, reduced.high),
               c = found.cosine.high + found.cosine.low;
  switch (reduced.quarters) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

namespace {

/// Sines and cosines of four angles.
struct FourTurns {
  Lanes sine, cosine;
};

/// Four angles up to kMostNear at once. Unless all are small, both reductions are computed for each angle and one is
/// selected. Sine and cosine are exchanged and negated by bit operations.
TRILITH_INLINE FourTurns turns_of(const Lanes& of) {
  const LaneMask sign = bits_of(-Lanes{}), small = magnitude(of) <= Lanes{} + kLeastReduced;
  ReducedTo<Lanes> reduced{of, Lanes{}, LaneMask{}};
  if (any(flip(small))) {
    reduced = reduce_near(of);
    reduced.high = select(small, of, reduced.high), reduced.low = select(small, Lanes{}, reduced.low);
    reduced.quarters = reduced.quarters & ~small;
  }
  const Sums<Lanes> found = sums(reduced);
  const LaneMask s = (bits_of(found.sine.high + found.sine.low) & ~sign) | (bits_of(reduced.high) & sign),
                 c = bits_of(found.cosine.high + found.cosine.low);
  const LaneMask odd = (reduced.quarters & 1) != LaneMask{}, upper = (reduced.quarters & 2) != LaneMask{};
  const LaneMask sine = ((odd & c) | (~odd & s)) ^ (upper & sign),
                 cosine = ((odd & s) | (~odd & c)) ^ ((odd ^ upper) & sign);
  return {Lanes(sine), Lanes(cosine)};
}

}  // namespace

/// Four angles at a time; larger or non-finite angles use the scalar function.
[[gnu::target_clones("avx2", "default")]] void sines_cosines(const double* angle, std::size_t count, double* sine,
                                                             double* cosine) {
  for (std::size_t i = 0; i < count; i += lane_count) {
    Lanes of;
    __builtin_memcpy(&of, angle + i, sizeof of);
    const FourTurns four = turns_of(of);
    __builtin_memcpy(sine + i, &four.sine, sizeof of);
    __builtin_memcpy(cosine + i, &four.cosine, sizeof of);
    if (!any(flip(magnitude(of) <= Lanes{} + kMostNear))) continue;
    for (std::size_t k = i; k < i + lane_count; ++k) {
      if (std::abs(angle[k]) <= kMostNear) continue;
      const SineCosine one = sine_cosine(angle[k]);
      sine[k] = one.sine, cosine[k] = one.cosine;
    }
  }
}

double tan(double angle) {
  const Reduced a = reduce(angle);
  if (std::abs(a.high) < 0x1p-200) return a.high;  // no double is as near to another multiple of pi/2
  // As in sums(), with the largest terms in two doubles.
  static constexpr std::array<double, 8> of_sine{
      1.0 / 120,        -1.0 / 5040,          1.0 / 362880,          -1.0 / 39916800,
      1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000, -1.0 / 121645100408832000};
  constexpr TwoDoubles sixth{-0x1.5555555555555p-3, -0x1.5555555555555p-57};
  const TwoDoubles square = exact_product(a.high, a.high);
  const double z = square.high;
  const TwoDoubles cube = square * TwoDoubles{a.high, 0};
  const TwoDoubles near_one = TwoDoubles{1, 0} + TwoDoubles{-0.5 * square.high, -0.5 * square.low};
  const TwoDoubles sine =
      TwoDoubles{a.high, 0} + cube * sixth + TwoDoubles{a.high * z * z * series(of_sine, z) + a.low * near_one.high, 0};
  const TwoDoubles cosine = near_one + TwoDoubles{z * z * series(kOfCosine, z) - a.high * a.low, 0};
  return a.quarters % 2 == 0 ? (sine / cosine).high : -(cosine / sine).high;
}

double atan2(double y, double x) {
  if (std::isnan(x) || std::isnan(y)) return std::numeric_limits<double>::quiet_NaN();
  double a = std::abs(x), b = std::abs(y);
  if (std::isinf(a) || std::isinf(b)) a = std::isinf(a) ? 1 : 0, b = std::isinf(b) ? 1 : 0;
  const double size = std::max(a, b);
  // Only the ratio matters: both are scaled so that products neither overflow nor lose digits.
  if (size > 0x1p500 && std::min(a, b) > 0x1p0) a *= 0x1p-600, b *= 0x1p-600;
  if (size < 0x1p-400) a *= 0x1p600, b *= 0x1p600;
  TwoDoubles angle = size > 0 ? arc_of({b, 0}, {a, 0}) : TwoDoubles{};
  if (std::signbit(x)) angle = less(kPi, angle);
  return std::copysign(angle.high, y);
}

/// The polar angle of the point (sqrt(1 - x^2), x) on the unit circle.
double asin(double x) {
  if (!(std::abs(x) <= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (std::abs(x) < 0x1p-400) return x;
  return std::copysign(arc_of({std::abs(x), 0}, other_leg(x)).high, x);
}

double acos(double x) {
  if (!(std::abs(x) <= 1)) return std::numeric_limits<double>::quiet_NaN();
  if (std::abs(x) < 0x1p-400) return kHalfPi.high;
  const TwoDoubles angle = arc_of(other_leg(x), {std::abs(x), 0});
  return x < 0 ? less(kPi, angle).high : angle.high;
}

}  // namespace trilith::portable
