// Laws for both horizontal directions at once: circles, not squares, for any azimuth.
#include <doctest/doctest.h>

#include <cmath>

#include "law/bearing/direction_samples.hpp"
#include "near.hpp"

namespace trilith {
namespace {

using testing::near;
using testing::near_zero;

/// A law of both directions with prescribed displacements in equal time steps. `work` is the work of the mean forces.
template <HorizontalLaw L>
struct LedBoth {
  L law;
  double dt = 1e-3, compression = 0;
  Vec2 at = Vec2::Zero();
  HorizontalResponse<typename L::Horizontal> now = {};
  double work = 0, lost = 0, least_loss = 0;

  void to(const Vec2& d) {
    const auto next = law.respond_horizontal({d, (d - at) / dt, dt, compression}, now.memory);
    work += 0.5 * (next.force + now.force).dot(d - at);
    lost += next.lost_inner, least_loss = std::min(least_loss, next.lost_inner);
    at = d, now = next;
  }
  void round(double radius, double turns, int steps) {
    for (int i = 1; i <= steps; ++i) {
      const double a = 2 * M_PI * turns * i / steps;
      to(radius * Vec2(std::cos(a), std::sin(a)));
    }
  }
};

/// Calls f(law) for every sample of a law of both directions.
template <class F>
void for_samples(F&& f) {
  DirectionLaws::for_each([&]<class L>() {
    if constexpr (HorizontalLaw<L>)
      for (L& law : testing::samples<L>(testing::usual_in_bearings)) {
        CAPTURE(describe(law));
        f(law);
      }
  });
}

/// A path that bends, crosses itself and returns [m].
Vec2 wandering(double t) {
  return {0.07 * std::sin(3 * t), 0.05 * std::sin(4.3 * t + 0.4) - 0.05 * std::sin(0.4)};
}

Vec2 turned(const Vec2& v, double angle) {
  return {std::cos(angle) * v.x() - std::sin(angle) * v.y(), std::sin(angle) * v.x() + std::cos(angle) * v.y()};
}

}  // namespace

TEST_CASE("both directions: list of laws") {
  std::string names;
  DirectionLaws::for_each([&]<class L>() {
    if constexpr (HorizontalLaw<L>) names += std::string(L::name) + " ";
  });
  CHECK(names == "linear elastic_plastic friction pendulum bouc_wen lead_rubber ");
}

TEST_CASE(
    "both directions: along any straight line the force equals the one-directional law and points along the line") {
  for_samples([]<class L>(const L& law) {
    for (const double azimuth : {0.0, 0.3, 1.1, 2.5, 4.0}) {
      const Vec2 way(std::cos(azimuth), std::sin(azimuth));
      LedBoth<L> both{law, 1e-3, 1e4};
      DirectionResponse one;
      double d = 0;
      for (int i = 1; i <= 600; ++i) {  // forward, back beyond the start, and forward again
        const double next = 0.08 * std::sin(3 * M_PI * i / 600);
        both.to(next * way);
        one = law.respond({next, (next - d) / 1e-3, 1e-3, 1e4}, one.memory);
        d = next;
        REQUIRE((both.now.force - (one.force() - one.memory.damping) * way).norm() < 1e-9 * 1e4);
        REQUIRE(near_zero(both.now.stored - one.stored, 1e-9 * 1e3));
      }
    }
  });
}

TEST_CASE("both directions: turning the path turns the force") {
  for_samples([]<class L>(const L& law) {
    LedBoth<L> straight{law, 1e-3, 1e4}, other{law, 1e-3, 1e4};
    for (int i = 1; i <= 3000; ++i) {
      const Vec2 d = wandering(2e-3 * i);
      straight.to(d), other.to(turned(d, 0.7));
      REQUIRE((turned(straight.now.force, 0.7) - other.now.force).norm() < 1e-8 * 1e4);
    }
  });
}

TEST_CASE("both directions: work is stored or dissipated, and no energy is created") {
  for_samples([]<class L>(const L& law) {
    LedBoth<L> led{law, 1e-3, 1e4};
    for (int i = 1; i <= 5000; ++i) led.to(wandering(2e-3 * i));
    const double size = std::abs(led.lost) + led.now.stored;
    // Wear makes the spring softer within a step; its booking has an error of first order in the step.
    CHECK(near_zero(led.work - led.now.stored - led.lost, 2e-4 * size));
    CHECK(led.least_loss > -1e-9 * size);
  });
}

TEST_CASE("both directions: friction round a circle is mu N, and drags behind the motion by its elastic reach") {
  const double compression = 2e5, mu = 0.08, stiffness = 1e7, radius = 0.1;
  LedBoth<Friction> led{{.mu = mu, .stiffness = stiffness}, 1e-4, compression};
  led.round(radius, 2, 400000);
  // At (radius, 0), moving along y. The slider is towed at the length mu N / k on a smaller circle.
  const double lag = std::asin(mu * compression / stiffness / radius);
  CHECK(near(led.now.force.norm(), mu * compression, 1e-12));
  CHECK(near(led.now.force.y(), mu * compression * std::cos(lag), 1e-6));
  CHECK(near(led.now.force.x(), mu * compression * std::sin(lag), 2e-3));
  // A full circle dissipates the force times the slider's path.
  LedBoth<Friction> again = led;
  again.round(radius, 1, 200000);
  CHECK(near(again.lost - led.lost, mu * compression * 2 * M_PI * std::sqrt(radius * radius - 1.6e-3 * 1.6e-3), 1e-5));
}

TEST_CASE("R4: a friction pendulum moved on a circle carries N r / R across it and mu N against its motion") {
  const double radius = 0.2, compression = 1e6;
  LedBoth<Pendulum> led{{.radius = 2, .mu = 0.05, .stiffness = 1e9}, 1e-4, compression};
  led.round(radius, 1, 100000);
  const LedBoth<Pendulum> before = led;
  led.round(radius, 1, 100000);  // at (radius, 0), moving along y
  CHECK(near(led.now.force.x(), 1e5, 0.005));
  CHECK(near(led.now.force.y(), 5e4, 0.005));
  CHECK(near(led.now.force.norm(), 111.80e3, 0.005));
  CHECK(near(std::atan2(led.now.force.y(), led.now.force.x()), 26.565 * M_PI / 180, 0.005));
  CHECK(near(led.lost - before.lost, 62.832e3, 0.005));
}

TEST_CASE("R5: a bearing that yields, moved on a circle, drags behind by its elastic reach") {
  const double radius = 0.02;
  LedBoth<ElasticPlastic> led{{1e7, 5e4, 0, 0}};
  led.at = {radius, 0}, led.now.memory.inner = along_across(led.at);  // unloaded on the circle
  led.round(radius, 2, 40000);
  for (int turn = 3; turn <= 4; ++turn) {
    const double before = led.lost;
    led.round(radius, 1, 20000);
    CHECK(near(led.now.force.x(), 12.5e3, 0.002));
    CHECK(near(led.now.force.y(), 48.412e3, 0.002));
    CHECK(near(led.lost - before, 6083.67, 0.002));
  }
}

TEST_CASE("both directions: yield is one resultant in every azimuth, where two laws of one direction make a square") {
  const ElasticPlastic steel{2e7, 1e5, 0, 0};
  for (const double azimuth : {0.0, 0.4, M_PI / 4, 1.3}) {
    const Vec2 way(std::cos(azimuth), std::sin(azimuth));
    LedBoth<ElasticPlastic> led{steel};
    for (int i = 1; i <= 100; ++i) led.to(5e-4 * i * way);
    CHECK(near(led.now.force.norm(), 1e5, 1e-12));
    LedBoth<BoucWen> smooth{{.stiffness = 2e7, .yield = 1e5, .exponent = 2, .shape = 0.5}};
    for (int i = 1; i <= 1000; ++i) smooth.to(5e-4 * i * way);
    CHECK(near(smooth.now.force.norm(), 1e5, 1e-6));
  }
  // Under a rotating resultant the yield force rotates with it and never grows.
  LedBoth<ElasticPlastic> round{steel};
  round.round(0.05, 1, 4000);
  CHECK(near(round.now.force.norm(), 1e5, 1e-12));
  LedBoth<BoucWen> smooth{{.stiffness = 2e7, .yield = 1e5, .exponent = 2, .shape = 0.5}};
  smooth.round(0.05, 1, 4000);
  CHECK(smooth.now.force.norm() < 1e5 * (1 + 1e-12));
  CHECK(smooth.now.force.norm() > 0.9e5);
}

}  // namespace trilith
