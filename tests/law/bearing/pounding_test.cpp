// Pounding: the requested restitution is reached, with or without tension of the dashpot.
#include "law/bearing/pounding.hpp"

#include <doctest/doctest.h>

#include <array>

#include "law/bearing/led.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

/// Two masses that meet across a gap, and the figures of their impact.
struct Impact {
  double touch = 0, lasts = 0, deepest = 0, most_force = 0, at_most_force = 0, least_force = 0;  ///< [s], [m], [N]
  std::array<double, 2> after{};                                                                 ///< [m/s]
  double unbooked = 0;                                                                           ///< [J]
};

template <class L>
Impact impact(const L& law, std::array<double, 2> mass, std::array<double, 2> v, double gap, double dt) {
  Impact seen;
  LedLaw<L> led{law, dt};
  double x = 0;
  for (double t = dt; t < 1; t += dt) {
    v[0] += dt * led.now.force() / mass[0], v[1] -= dt * led.now.force() / mass[1];
    x += dt * (v[1] - v[0]);
    led.to(x);
    const double force = -led.now.force();
    if (x < -gap && seen.touch == 0) seen.touch = t;
    if (x < -gap && force != 0) seen.lasts = t - seen.touch;
    seen.deepest = std::max(seen.deepest, -x - gap);
    seen.least_force = std::min(seen.least_force, force);
    if (force > seen.most_force) seen.most_force = force, seen.at_most_force = t - seen.touch;
    if (seen.touch > 0 && x > -gap && v[1] > v[0]) break;
  }
  seen.after = v, seen.unbooked = led.unbooked();
  return seen;
}

}  // namespace

TEST_CASE("R9: with a pulling dashpot two colliding masses have the impact of the textbook") {
  const std::array<double, 2> mass{200e3, 100e3};
  const Pounding law{2e8, 0.01, 0.65, mass[0] * mass[1] / (mass[0] + mass[1]), -1, 1};
  CHECK(near(law.damping_ratio(), 0.135851, 1e-5));
  const Impact seen = impact(law, mass, {0.6, -0.2}, 0.01, 1e-6);
  MESSAGE("R9 touch " << seen.touch << " s, contact " << seen.lasts * 1e3 << " ms, deepest " << seen.deepest * 1e3
                      << " mm, force " << seen.most_force / 1e6 << " MN at " << seen.at_most_force * 1e3
                      << " ms, after " << seen.after[0] << " and " << seen.after[1] << " m/s");
  CHECK(near(seen.touch, 0.0125, 0.005));
  CHECK(near(seen.lasts, 57.894e-3, 0.005));
  CHECK(near(seen.deepest, 11.9978e-3, 0.005));
  CHECK(near(seen.most_force, 2.4909e6, 0.005));
  CHECK(near(seen.at_most_force, 21.41e-3, 0.005));
  CHECK(near(seen.after[0], 0.16, 0.005));
  CHECK(near(seen.after[1], 0.68, 0.005));
  CHECK(seen.least_force < 0);
}

TEST_CASE("R9: damping ratios for a restitution, with and without a pulling dashpot") {
  struct Row {
    double restitution, clipped, pulling;
  };
  for (const Row& row : {Row{0.4, 0.354508, 0.279998}, Row{0.5, 0.255276, 0.215454}, Row{0.65, 0.149939, 0.135851},
                         Row{0.8, 0.074355, 0.070850}}) {
    CHECK(near(Pounding{1e8, 0, row.restitution, 1e5, -1, 0}.damping_ratio(), row.clipped, 1e-5));
    CHECK(near(Pounding{1e8, 0, row.restitution, 1e5, -1, 1}.damping_ratio(), row.pulling, 1e-5));
  }
  for (const double pull : {0.0, 1.0}) CHECK(Pounding{1e8, 0, 1, 1e5, -1, pull}.damping_ratio() == 0);
}

TEST_CASE("R9: a gap with the dashpot for 0.65 has a restitution of 0.67475 without pull and 0.65 with pull") {
  const double m = 2e5 / 3, c = 2 * 0.135851 * std::sqrt(2e8 * m);
  for (const double pull : {0.0, 1.0}) {
    const Impact seen = impact(Gap{2e8, 0.01, c, -1, pull}, {200e3, 100e3}, {0.6, -0.2}, 0.01, 1e-6);
    CHECK(near((seen.after[1] - seen.after[0]) / 0.8, pull > 0 ? 0.65 : 0.67475, 0.005));
    CHECK((seen.least_force < 0) == (pull > 0));
  }
}

TEST_CASE("pounding has the given restitution, from nearly 0 to 1") {
  for (const double pull : {0.0, 1.0})
    for (const double e : {0.14, 0.2, 0.4, 0.65, 0.9, 1.0}) {
      const Impact seen = impact(Pounding{2e8, 0.01, e, 2e5 / 3, -1, pull}, {200e3, 100e3}, {0.6, -0.2}, 0.01, 1e-6);
      CHECK(near((seen.after[1] - seen.after[0]) / 0.8, e, 1e-3));
      CHECK(std::abs(seen.unbooked) <= 1e-5 * 0.5 * 2e5 / 3 * 0.64);
    }
}

TEST_CASE("pounding closes on its own side alone") {
  for (const double side : {-1.0, 0.0, 1.0}) {
    LedLaw<Pounding> led{{1e8, 0.01, 1, 1e5, side, 0}};
    led.along(0.02);
    CHECK((led.now.force() != 0) == (side >= 0));
    led.along(-0.02);
    CHECK((led.now.force() != 0) == (side <= 0));
  }
}
