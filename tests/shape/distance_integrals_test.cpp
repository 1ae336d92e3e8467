#include "shape/distance_integrals.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/portable.hpp"
#include "near.hpp"
#include "shape/polygon.hpp"
#include "shape/random_convex.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

Polygon sliding_square() {
  return rectangle(Vec2(-0.5, -0.5), Vec2(0.5, 0.5));
}

/// Couple of a square of side 1 that turns about its centre: share of the friction it would slide with, times 1 m.
double most_couple() {
  return (std::numbers::sqrt2 + portable::log(1 + std::numbers::sqrt2)) / 6;
}

/// Sliding and turning about a point `d` from the centre of the square: force and couple about the centre.
struct SlidingTurn {
  double force, couple;
  explicit SlidingTurn(double d) {
    const DistanceIntegrals k = distance_integrals(sliding_square(), Vec2(-d, 0));
    force = k.direction.x();
    couple = k.distance - d * force;
  }
};

}  // namespace

TEST_CASE("a square that turns on its centre resists by the closed form") {
  const DistanceIntegrals k = distance_integrals(sliding_square(), Vec2(0, 0));
  CHECK(near(k.distance, most_couple(), 1e-14));
  CHECK(near(k.distance, 0.38260, 1e-4));
  CHECK(near_zero(k.direction.norm(), 1e-16));
}

TEST_CASE("a rectangle that turns on its centre resists by the closed form") {
  const double a = 1.7, b = 0.6, d = std::sqrt(a * a + b * b);
  const double expected =
      (2 * a * b * d + a * a * a * portable::log((b + d) / a) + b * b * b * portable::log((a + d) / b)) / 12;
  CHECK(near(distance_integrals(rectangle(Vec2(3, 4), Vec2(3 + a, 4 + b)), Vec2(3 + a / 2, 4 + b / 2)).distance,
             expected, 1e-13));
}

TEST_CASE("a square that slides and turns loses of each what the other takes") {
  struct Row {
    double at, force, couple;
  };
  for (const Row& row : {Row{0.1, 0.1758, 0.9771}, Row{0.2, 0.3485, 0.9094}, Row{0.3, 0.5142, 0.8014},
                         Row{0.5, 0.7902, 0.5178}, Row{1, 0.9534, 0.2352}}) {
    const SlidingTurn turn(row.at);
    CHECK(near(turn.force, row.force, 2e-4));
    CHECK(near(turn.couple / most_couple(), row.couple, 2e-4));
  }
  // pushed at a corner, parallel to a side: the couple of the push is its arm of 1/2 times the force
  const SlidingTurn corner(0.3383);
  CHECK(near(corner.force, 0.5747, 2e-4));
  CHECK(near(corner.couple, 0.5 * corner.force, 5e-4));
}

TEST_CASE("the direction is the change of the distance as the point moves, inside and outside") {
  std::mt19937_64 bits(4);
  for (int trial = 0; trial < 500; ++trial) {
    const Polygon outline = random_convex(bits, {.slenderest = 5});
    const Vec2 c(random_between(bits, -1.5, 1.5), random_between(bits, -1.5, 1.5));
    const double h = 1e-5;
    const auto at = [&](const Vec2& by) { return distance_integrals(outline, c + by).distance; };
    const Vec2 change(at(Vec2(h, 0)) - at(Vec2(-h, 0)), at(Vec2(0, h)) - at(Vec2(0, -h)));
    CHECK(near_zero((change / (2 * h) + distance_integrals(outline, c).direction).norm(), 1e-8));
  }
}

TEST_CASE("about a point on the outline, on an edge's line or far away the integrals go on without a step") {
  const Polygon square = sliding_square();
  for (const Vec2& c : {Vec2(0.5, 0.2), Vec2(0.5, 0.5), Vec2(0.5, 3)})
    for (const double off : {1e-9, -1e-9, 1e-200}) {
      const DistanceIntegrals on = distance_integrals(square, c), next = distance_integrals(square, c + Vec2(off, off));
      CHECK(near(next.distance, on.distance, 1e-8));
      CHECK(near_zero((next.direction - on.direction).norm(), 1e-7));
    }
  const DistanceIntegrals far = distance_integrals(square, Vec2(-1000, 0));
  CHECK(near(far.distance, 1000 + 1 / 24000.0, 1e-11));
  CHECK(near(far.direction.x(), 1, 1e-6));
}
