// Viscous dampers alone and on a spring: loops, relaxation, limits.
#include "law/bearing/viscous.hpp"

#include <doctest/doctest.h>

#include "law/bearing/led.hpp"
#include "law/bearing/maxwell.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double usual_line = 1e-3;

}  // namespace

TEST_CASE("R8: loops of a linear damper, one of a power of the velocity, and one on a spring") {
  LedLaw<Viscous> linear{{1e5, 1, 1, usual_line}}, power{{2e5, 1, 0.35, usual_line}};
  LedLaw<Maxwell> maxwell{{1e6, 1e5, 1, 1}};
  const double of_linear = linear.sine(0.05, 1, 2, 4000), of_power = power.sine(0.05, 1, 2, 4000),
               of_maxwell = maxwell.sine(0.05, 1, 20, 4000);
  MESSAGE("R8 linear " << of_linear << " J, " << linear.most_force << " N; power " << of_power << " J, "
                       << power.most_force << " N; Maxwell " << of_maxwell << " J, " << maxwell.most_force << " N");
  CHECK(near(of_linear, 4934.80, 0.002));
  CHECK(near(linear.most_force, 31416, 0.002));
  CHECK(near(of_power, 24188.4, 0.002));
  CHECK(near(power.most_force, 133362, 0.002));
  CHECK(near(of_maxwell, 3538.04, 0.002));
  CHECK(near(maxwell.most_force, 26600.9, 0.002));
  for (const double unbooked : {linear.unbooked(), power.unbooked(), maxwell.unbooked()})
    CHECK(near_zero(unbooked, 1e-9 * of_maxwell));
}

TEST_CASE("a damper has its force at its speed, and below its line the slope that bounds the step") {
  const Viscous law{8e4, 0.5, 0.3, 2e-3};
  const auto force = [&](double v) { return law.respond({0, v, 1e-3, 0}, {}).force(); };
  CHECK(near(force(0.5), 8e4, 1e-12));
  CHECK(near(force(-0.05), -8e4 * std::pow(0.1, 0.3), 1e-12));
  CHECK(near(force(1e-3), law.dashpot() * 1e-3, 1e-12));
  CHECK(near(force(2e-3 * (1 + 1e-9)), force(2e-3), 1e-8));
  for (double v = 1e-5; v < 1; v *= 1.1) CHECK(force(1.1 * v) - force(v) <= law.dashpot() * 0.1 * v * (1 + 1e-9));
}

TEST_CASE("a mass on a damper of a power comes to rest in a finite time, at the step that its slope allows") {
  // m v' = -C v^a: v^(1-a) = v0^(1-a) - (1-a) C t / m.
  const double mass = 5e4, c = 2e5, a = 0.35, v0 = 0.4;
  const Viscous law{c, 1, a, usual_line};
  MassOn<Viscous> m{mass, 0.9 * 2 * mass / law.dashpot(), {law}};
  m.v = v0;
  const double rest = std::pow(v0, 1 - a) * mass / ((1 - a) * c);
  double energy = 0.5 * mass * v0 * v0;
  while (m.time < 3 * rest) {
    m.step();
    CHECK(0.5 * mass * m.v * m.v <= energy * (1 + 1e-12));
    energy = 0.5 * mass * m.v * m.v;
  }
  CHECK(std::abs(m.v) < 1e-3);
  CHECK(near(m.x, std::pow(v0, 2 - a) * mass / ((2 - a) * c), 0.03));  // first order in this longest step
}

TEST_CASE("the force of a damper on a held spring relaxes exponentially or by its power law") {
  const double k = 1e6, c = 1e5, reach = 0.03, dt = 1e-4;
  LedLaw<Maxwell> linear{{k, c, 1, 1}, dt}, power{{k, c, 1, 0.5}, dt};
  linear.to(reach), power.to(reach);
  const double from = linear.now.force(), from_power = power.now.force();
  for (int i = 1; i <= 3000; ++i) {
    linear.to(reach), power.to(reach);
    if (i % 1000 != 0) continue;
    CHECK(near(linear.now.force(), from * std::exp(-i * dt * k / c), 1e-9));
    // f' = -k (f/C)^2 for the exponent 1/2.
    CHECK(near(power.now.force(), 1 / (1 / from_power + i * dt * k / (c * c)), 1e-6));
  }
  CHECK(near_zero(linear.unbooked(), 1e-12 * linear.work));
  CHECK(near_zero(power.unbooked(), 1e-12 * power.work));
}

TEST_CASE("a damper on a spring is the spring when moved fast and the dashpot when moved slowly") {
  for (const double a : {1.0, 0.4}) {
    LedLaw<Maxwell> fast{{1e6, 1e5, 1, a}, 1e-9}, slow{{1e6, 1e5, 1, a}, 1e-3};
    fast.along(1e-3, 100);
    CHECK(near(fast.now.force(), 1e3, 1e-3));
    slow.along(4, 40000);  // at 0.1 m/s
    CHECK(near(slow.now.force(), 1e5 * std::pow(0.1, a), 1e-6));
  }
}

TEST_CASE("a damper on a spring follows its equation at each power, and never gives energy") {
  for (const double a : {0.2, 0.35, 0.7, 1.0}) {
    const double k = 2e7, c = 2e5, reach = 0.05, period = 1;
    const int steps = 4000, fine = 20;
    LedLaw<Maxwell> led{{k, c, 1, a}, period / steps};
    double f = 0, off = 0, most = 0;
    const auto slope = [&](double t, double force) {
      const double v = reach * 2 * M_PI / period * std::cos(2 * M_PI * t / period);
      return k * (v - std::copysign(std::pow(std::abs(force) / c, 1 / a), force));
    };
    for (int i = 0; i < 2 * steps; ++i) {
      for (int j = 0; j < fine; ++j) {  // Runge and Kutta, fourth order
        const double h = period / steps / fine, t = (i + static_cast<double>(j) / fine) * period / steps;
        const double p = slope(t, f), q = slope(t + h / 2, f + h / 2 * p), r = slope(t + h / 2, f + h / 2 * q),
                     s = slope(t + h, f + h * r);
        f += h / 6 * (p + 2 * q + 2 * r + s);
      }
      led.to(reach * std::sin(2 * M_PI * (i + 1) / steps));
      off = std::max(off, std::abs(led.now.force() - f)), most = std::max(most, std::abs(f));
    }
    INFO("exponent ", a, ": off by ", off / most);
    CHECK(off <= 2e-3 * most);
    CHECK(led.least_loss >= -1e-9 * led.lost);
    CHECK(near_zero(led.unbooked(), 1e-9 * led.work));
  }
}
