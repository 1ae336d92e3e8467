#include "near.hpp"

#include <limits>
#include <string>

using trilith::testing::near;
using trilith::testing::near_zero;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("near accepts differences up to its relative tolerance, at any scale") {
  for (const double size : {1e-300, 1e-9, 0.0666, 1.0, 1e12, 1e300})
    for (const double sign : {1.0, -1.0})
      for (const double share : {1e-12, 1e-3, 0.24}) {
        const double expected = sign * size;
        CAPTURE(expected);
        CAPTURE(share);
        CHECK(near(expected, expected, share));
        CHECK(near(expected * (1 + 0.999 * share), expected, share));
        CHECK(near(expected * (1 - 0.999 * share), expected, share));
        CHECK_FALSE(near(expected * (1 + 1.001 * share), expected, share));
        CHECK_FALSE(near(expected * (1 - 1.001 * share), expected, share));
        CHECK_FALSE(near(-expected, expected, share));
      }
  CHECK(near(3, 2, 0.5));  // the limit itself, which is exact here
  CHECK(near(1, 2, 0.5));
}

TEST_CASE("only 0 is near to 0") {
  CHECK(near(0, 0, 1e-3));
  CHECK(near(-0.0, 0, 1e-3));
  CHECK_FALSE(near(1e-300, 0, 1e-3));
}

TEST_CASE("near_zero accepts values up to its limit on both sides") {
  for (const double within : {1e-15, 0.5, 1e6})
    for (const double sign : {1.0, -1.0}) {
      CHECK(near_zero(0, within));
      CHECK(near_zero(sign * within, within));
      CHECK(near_zero(sign * 0.999 * within, within));
      CHECK_FALSE(near_zero(sign * 1.001 * within, within));
    }
}

TEST_CASE("non-finite numbers are near nothing") {
  for (const double value : {no_number, infinity, -infinity}) {
    CHECK_FALSE(near(value, 1, 1e-3));
    CHECK_FALSE(near(1, value, 1e-3));
    CHECK_FALSE(near(value, value, 1e-3));
    CHECK_FALSE(near_zero(value, 1e-3));
  }
  CHECK_FALSE(near(1, 1, no_number));
  CHECK_FALSE(near_zero(0, no_number));
}

TEST_CASE("a failed comparison prints value, expected value and difference") {
  const auto printed = [](const auto& n) { return std::string(toString(n).c_str()); };
  CHECK(printed(near(0.5, 0.4, 0.125)) == "0.5, expected 0.4: off by 0.25 of it, allowed 0.125");
  CHECK(printed(near_zero(-2e-3, 1e-3)) == "-0.002, expected 0: allowed 0.001");
}
