#include "contact/joint/friction_projection.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "contact/joint/friction_limit.hpp"

using namespace trilith;

namespace {

struct Beyond {
  Vec3 spring;
  double lean, reach;
  LimitShape<double> shape;
};

/// Limit shape of a rectangle at `angle`, from a square (`d2` 0) to a line (1).
LimitShape<double> shape_at(double d2, double angle) {
  const double length = 1 + std::sqrt(d2), width = 1 - std::sqrt(d2);  // second moments
  const Triple<double> along{std::cos(angle), std::sin(angle), 0}, across{-std::sin(angle), std::cos(angle), 0};
  return LimitSpread<double>(along * std::sqrt(length), across * std::sqrt(width)).in({1, 0, 0}, {0, 1, 0});
}

/// A force beyond the limit, by little or by much.
Beyond draw(std::mt19937_64& bits) {
  std::uniform_real_distribution<double> share(-1, 1);
  while (true) {
    const double far = std::pow(10.0, 2 * share(bits));
    const Beyond drawn{(1 + far) * Vec3(share(bits), share(bits), share(bits)), 1 + share(bits), 1.5 + share(bits),
                       shape_at(0.5 + 0.5 * share(bits), 3 * share(bits))};
    const Vec3& s = drawn.spring;
    const double turning = drawn.reach * s.z() - drawn.lean * s.y();
    if (beyond_curve<double>({s.x(), s.y(), turning}, drawn.shape) > 1) return drawn;
  }
}

bool held_alike(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

}  // namespace

TEST_CASE("four forces brought to the limit of friction at once have the bits of each alone") {
  std::mt19937_64 bits(47);
  int settled = 0;
  bool same = true;
  for (int round = 0; round < 5000; ++round) {
    Triple<Lanes> spring;
    LimitPlaces<Lanes> places;
    LaneMask asked{};
    Beyond drawn[lane_count];
    for (int i = 0; i < lane_count; ++i) {
      drawn[i] = draw(bits);
      spring.x[i] = drawn[i].spring.x(), spring.y[i] = drawn[i].spring.y(), spring.z[i] = drawn[i].spring.z();
      places.lean[i] = drawn[i].lean, places.reach[i] = drawn[i].reach;
      const LimitShape<double>& k = drawn[i].shape;
      places.shape.a.xx[i] = k.a.xx, places.shape.a.xy[i] = k.a.xy, places.shape.a.yy[i] = k.a.yy;
      places.shape.c.xx[i] = k.c.xx, places.shape.c.xy[i] = k.c.xy, places.shape.c.yy[i] = k.c.yy;
      asked[i] = (round + i) % 3 != 0 ? -1 : 0;
    }
    Triple<Lanes> z;
    const LaneMask failed = nearest_by_newton<Lanes>(places, places.from_spring(spring), asked, z);
    const Triple<Lanes> held = spring_on_limit(places, z);
    for (int i = 0; i < lane_count; ++i) {
      if (asked[i] == 0 || failed[i] != 0) continue;
      ++settled;
      const Vec3 alone = nearest_on_limit(drawn[i].spring, drawn[i].lean, drawn[i].reach, drawn[i].shape),
                 four = lane_of(held, i);
      for (const int k : {0, 1, 2}) same = same && held_alike(alone[k], four[k]);
    }
  }
  CHECK(same);
  CHECK(settled > 10000);
}

TEST_CASE("projected friction lies on the limit, and sliding follows its normal") {
  std::mt19937_64 bits(48);
  for (int round = 0; round < 2000; ++round) {
    const Beyond drawn = draw(bits);
    const LimitPlaces<double> places{drawn.lean, drawn.reach, drawn.shape};
    const Vec3 held = nearest_on_limit(drawn.spring, drawn.lean, drawn.reach, drawn.shape);
    const Triple<double> z = places.from_spring(triple_of(held));
    CHECK(std::abs(beyond_curve(z, drawn.shape) - 1) < 1e-12);
    // The gradient of the measure by the spring's force: L' v.
    const Triple<double> v = LimitNormal<double>(z, drawn.shape).vector();
    const Vec3 normal(v.x, v.y - drawn.lean * v.z, drawn.reach * v.z), slid = drawn.spring - held;
    CHECK(normal.dot(slid) >= (1 - 1e-9) * normal.norm() * slid.norm() - 1e-10);
  }
}

TEST_CASE("the limit of friction is convex for areas from a square to a line") {
  std::mt19937_64 bits(49);
  std::uniform_real_distribution<double> share(-1, 1);
  const auto on_limit = [](const Vec3& z, const LimitShape<double>& shape) {
    return Vec3(z / beyond_curve(triple_of(z), shape));
  };
  for (int round = 0; round < 5000; ++round) {
    const LimitShape<double> shape = shape_at(round % 11 * 0.1, 3 * share(bits));
    const Vec3 a = on_limit({share(bits), share(bits), share(bits)}, shape),
               b = on_limit({share(bits), share(bits), share(bits)}, shape);
    CHECK(beyond_curve(triple_of(Vec3(0.5 * (a + b))), shape) <= 1 + 1e-12);
  }
}
