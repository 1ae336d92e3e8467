// The portable elementary functions against the C library in long double, which has 11 bits more.
#include "base/portable.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/simd/portable_lanes.hpp"
#include "geometry/plane/random_convex.hpp"

using namespace trilith;

namespace {

/// Distance between a result and the true value, in units in the last place of a double.
double ulps(double found, long double expected) {
  int exponent = 0;
  std::frexp(expected, &exponent);
  return static_cast<double>(std::abs((found - expected) / std::ldexp(1.0L, std::max(exponent, -1021) - 53)));
}

struct Arguments {
  std::string name;
  std::function<double()> next;
};

/// A random finite double of any magnitude.
double any_double(std::mt19937_64& bits) {
  while (true) {
    const double x = std::bit_cast<double>(std::uint64_t{bits()});
    if (std::isfinite(x)) return x;
  }
}

std::vector<Arguments> angles(std::mt19937_64& bits) {
  return {{"within an eighth of a turn", [&] { return random_between(bits, -0.785, 0.785); }},
          {"some turns", [&] { return random_between(bits, -20, 20); }},
          {"to the end of the near reduction", [&] { return random_between(bits, -1048576, 1048576); }},
          {"far", [&] { return random_between(bits, -1e12, 1e12); }},
          {"beside a quarter turn", [&] { return random_count(bits, -100000, 100000) * (M_PI / 2); }},
          {"any double", [&] { return any_double(bits); }}};
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

TEST_CASE("sines and cosines of several angles equal single ones to the bit") {
  std::mt19937_64 bits(2);
  const std::vector<Arguments> kinds = angles(bits);
  const double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> few{0.0, -0.0, 0x1p-1074, M_PI_4, -M_PI_4, M_PI_2, -M_PI, 0x1p20, -0x1p20, infinite, none};
  for (int round = 0; round < 20000; ++round) {
    alignas(32) std::array<double, 8> angle{}, sine{}, cosine{};
    // Arguments of different kinds in one vector: one with a large argument does not change its neighbour's result.
    for (double& a : angle) {
      const auto kind = static_cast<std::size_t>(random_count(bits, 0, static_cast<int>(kinds.size())));
      a = kind < kinds.size() ? kinds[kind].next() : few[bits() % few.size()];
    }
    portable::sines_cosines(angle.data(), angle.size(), sine.data(), cosine.data());
    for (std::size_t i = 0; i < angle.size(); ++i) {
      const portable::SineCosine one = portable::sine_cosine(angle[i]);
      CAPTURE(angle[i]);
      const bool both = same(sine[i], one.sine) && same(cosine[i], one.cosine);
      CHECK((both || (std::isnan(one.sine) && std::isnan(sine[i]) && std::isnan(cosine[i]))));
    }
  }
}

TEST_CASE("sine, cosine and tangent of any angle have errors below 1 ulp and are symmetric to the bit") {
  std::mt19937_64 bits(1);
  for (const Arguments& a : angles(bits)) {
    CAPTURE(a.name);
    double sine = 0, cosine = 0, tangent = 0;
    int unlike = 0;
    for (int i = 0; i < 20000; ++i) {
      const double x = a.next();
      const auto [s, c] = portable::sine_cosine(x);
      sine = std::max(sine, ulps(s, std::sin(static_cast<long double>(x))));
      cosine = std::max(cosine, ulps(c, std::cos(static_cast<long double>(x))));
      tangent = std::max(tangent, ulps(portable::tan(x), std::tan(static_cast<long double>(x))));
      const auto [minus_s, minus_c] = portable::sine_cosine(-x);
      unlike += !same(minus_s, -s) + !same(minus_c, c) + !same(portable::tan(-x), -portable::tan(x));
      unlike += !same(s, portable::sin(x)) + !same(c, portable::cos(x));
    }
    CHECK(sine < 0.85);
    CHECK(cosine < 0.85);
    CHECK(tangent < 0.65);
    CHECK(unlike == 0);
  }
}

TEST_CASE("sine and cosine are exact at zero, and NaN for an infinite angle or NaN") {
  for (const double zero : {0.0, -0.0}) {
    CHECK(same(portable::sin(zero), zero));
    CHECK(same(portable::tan(zero), zero));
    CHECK(portable::cos(zero) == 1);
  }
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double x : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(std::isnan(portable::sin(x)));
    CHECK(std::isnan(portable::cos(x)));
    CHECK(std::isnan(portable::tan(x)));
  }
}

TEST_CASE("arc functions have errors below 1 ulp and are odd to the bit") {
  std::mt19937_64 bits(2);
  double of_point = 0, of_sine = 0, of_cosine = 0;
  int unlike = 0;
  for (int i = 0; i < 60000; ++i) {
    const bool wild = i % 3 == 0;
    const double y = wild ? any_double(bits) : random_between(bits, -1, 1);
    const double x = wild ? any_double(bits) : random_between(bits, -1, 1);
    of_point = std::max(
        of_point, ulps(portable::atan2(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x))));
    const double z = i % 2 == 0 ? random_between(bits, -1, 1) : 1 - std::ldexp(1.0, -1 - i % 53);
    of_sine = std::max(of_sine, ulps(portable::asin(z), std::asin(static_cast<long double>(z))));
    of_cosine = std::max(of_cosine, ulps(portable::acos(z), std::acos(static_cast<long double>(z))));
    of_cosine = std::max(of_cosine, ulps(portable::acos(-z), std::acos(static_cast<long double>(-z))));
    unlike += !same(portable::atan2(-y, x), -portable::atan2(y, x)) + !same(portable::asin(-z), -portable::asin(z));
  }
  CHECK(of_point < 0.55);
  CHECK(of_sine < 0.55);
  CHECK(of_cosine < 0.55);
  CHECK(unlike == 0);
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double y : {0.0, -0.0, 1.0, -1.0, infinite, -infinite})
    for (const double x : {0.0, -0.0, 1.0, -1.0, infinite, -infinite})
      CHECK(same(portable::atan2(y, x), std::atan2(y, x)));
  CHECK(portable::asin(1) == M_PI / 2);
  CHECK(std::isnan(portable::asin(1.0000001)));
  CHECK(same(portable::acos(1), 0.0));
  CHECK(portable::acos(-1) == M_PI);
  CHECK(portable::acos(0) == M_PI / 2);
  CHECK(std::isnan(portable::acos(-1.0000001)));
}

TEST_CASE("exponentials and powers have an error below 1 ulp and the limits of the C functions") {
  std::mt19937_64 bits(3);
  double exponential = 0, power = 0, logarithm = 0;
  for (int i = 0; i < 30000; ++i) {
    const double x = i % 2 == 0 ? random_between(bits, -1, 1) : random_between(bits, -700, 709);
    exponential = std::max(exponential, ulps(portable::exp(x), std::exp(static_cast<long double>(x))));
    // To the accuracy of long double: it has 11 bits more, some of which represent the magnitude of a power.
    const double base = i % 2 == 0 ? std::exp(random_between(bits, -10, 10)) : 1 + random_between(bits, -1e-6, 1e-6);
    const double exponent = i % 2 == 0 ? random_between(bits, -3, 3) : random_between(bits, -1e6, 1e6);
    const long double expected = std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
    power = std::max(power, ulps(portable::pow(base, exponent), expected));
    for (const double v : {base, std::abs(any_double(bits))})
      logarithm = std::max(logarithm, ulps(portable::log(v), std::log(static_cast<long double>(v))));
  }
  CHECK(exponential < 0.85);
  CHECK(power < 0.85);
  CHECK(logarithm < 0.55);
  CHECK(portable::pow(2, 10) == 1024);
  CHECK(portable::pow(10, -3) == 0.001);
  CHECK(portable::pow(2, -1074) == std::numeric_limits<double>::denorm_min());
  CHECK(portable::pow(1, 1e300) == 1);
}

TEST_CASE("special values of exponentials, logarithms, powers and lengths match C") {
  const double infinite = std::numeric_limits<double>::infinity(), none = std::numeric_limits<double>::quiet_NaN();
  const auto alike = [](double a, double b) { return same(a, b) || (std::isnan(a) && std::isnan(b)); };
  const std::vector<double> values{0.0,      -0.0,      1,     -1,     2,        -2,        3,
                                   -3,       0.5,       -0.5,  1000.,  -1000,    5000,      -5001,
                                   0x1p1023, -0x1p1023, 1e300, -1e300, infinite, -infinite, none};
  for (const double x : values) {
    CAPTURE(x);
    if (std::abs(x) > 800 || x == 0 || std::isnan(x)) CHECK(alike(portable::exp(x), std::exp(x)));
    if (!(x > 0) || x == 1 || std::isinf(x)) CHECK(alike(portable::log(x), std::log(x)));
    for (const double y : values) {
      CAPTURE(y);
      const double expected = std::pow(x, y), length = std::hypot(x, y);
      if (expected == 0 || expected == 1 || !std::isfinite(expected)) CHECK(alike(portable::pow(x, y), expected));
      if (length == 0 || !std::isfinite(length)) CHECK(alike(portable::hypot(x, y), length));
    }
  }
  CHECK(portable::pow(-2, 3) == -8);
  CHECK(portable::pow(-2, 4) == 16);
  CHECK(portable::pow(-2, -1) == -0.5);
}

TEST_CASE("lengths are accurate to 1 part in 2^52 for any magnitude") {
  std::mt19937_64 bits(4);
  double most = 0;
  for (int i = 0; i < 30000; ++i) {
    const bool near = i % 2 == 0;
    const double x = near ? random_between(bits, -1, 1) : any_double(bits);
    const double y = near ? random_between(bits, -1, 1) : x * random_between(bits, -4, 4);
    const long double expected = std::hypot(static_cast<long double>(x), static_cast<long double>(y));
    if (expected > std::numeric_limits<double>::max() || expected < std::numeric_limits<double>::min()) continue;
    most = std::max(most, static_cast<double>(std::abs(portable::hypot(x, y) / expected - 1)));
  }
  CHECK(most < 0x1p-52);
}

TEST_CASE("sine, tangent, exponential and logarithm never decrease where the function increases") {
  std::mt19937_64 bits(5);
  const auto falls = [&](double low, double high, double (*f)(double)) {
    int found = 0;
    for (int i = 0; i < 20000; ++i) {
      const double x = random_between(bits, low, high);
      found += f(std::nextafter(x, high)) < f(x);
    }
    return found;
  };
  CHECK(falls(-1.57, 1.57, portable::sin) == 0);
  CHECK(falls(-1.57, 1.57, portable::tan) == 0);
  CHECK(falls(-1, 1, portable::asin) == 0);
  CHECK(falls(-20, 20, portable::exp) == 0);
  CHECK(falls(0.01, 100, portable::log) == 0);
}
