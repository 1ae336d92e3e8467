#include "base/simd/lane_powers.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "base/portable.hpp"

using namespace trilith;

TEST_CASE("powers of positive numbers are right to the stated error, in each lane the bits of one number") {
  std::mt19937_64 bits(7);
  std::uniform_real_distribution<double> log_of_base(-60, 20), exponents(0, 3);
  for (int i = 0; i < 20000; ++i) {
    const double base = portable::exp(log_of_base(bits)), exponent = exponents(bits);
    const double power = power_of_positive(base, exponent), expected = portable::pow(base, exponent);
    const double allowed = 0x1p-52 * (3 + 2 * std::abs(exponent * portable::log(base)));
    CHECK(std::abs(power - expected) <= allowed * expected);
    const Lanes four = power_of_positive<Lanes>(Lanes{1, base, 2, base}, exponent);
    for (const int lane : {1, 3}) {
      const double one = four[lane];
      CHECK(std::bit_cast<std::uint64_t>(one) == std::bit_cast<std::uint64_t>(power));
    }
  }
}

TEST_CASE("powers at the ends of the range are finite") {
  CHECK(power_of_positive(0.0, 1.5) == 0);
  CHECK(power_of_positive(1e-300, 1.5) == 0);
  CHECK(power_of_positive(1.0, 2.7) == 1);
  CHECK(power_of_positive(1e-200, 3.0) < 1e-300);
  CHECK(power_of_positive(1e150, 3.0) > 1e300);
  CHECK(std::isfinite(power_of_positive(1e150, 3.0)));
  CHECK(std::isfinite(power_of_positive(std::numeric_limits<double>::infinity(), 2.0)));
}
