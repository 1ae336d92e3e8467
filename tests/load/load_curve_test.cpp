#include "load/load_curve.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "load/ramp.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

TEST_CASE("a load curve is straight between its points and constant outside of them") {
  const LoadCurve none{};
  CHECK(none.at(-1) == 1);
  CHECK(none.at(1e9) == 1);
  const LoadCurve c{{1, 2, 4}, {0, 1, 0.5}};
  CHECK(c.at(0) == 0);
  CHECK(c.at(1) == 0);
  CHECK(c.at(1.25) == 0.25);
  CHECK(c.at(2) == 1);
  CHECK(c.at(3) == 0.75);
  CHECK(c.at(4) == 0.5);
  CHECK(c.at(100) == 0.5);
  CHECK_FALSE(c.spent(100));
  const LoadCurve off = ramp_curve(5, 0.5, 0, 2, true);
  CHECK(off.at(5) == 0.5);
  CHECK(off.at(6) == 0.25);
  CHECK_FALSE(off.spent(6.9));
  CHECK(off.spent(7));
  CHECK(ramp_curve(5, 0, 1, 0, false).at(0) == 1);  // at once
}

TEST_CASE("a smooth load curve begins and ends without speed and acceleration and is even about its middle") {
  const LoadCurve c = ramp_curve(0, 0, 1, 1, true);
  const double h = 1e-4;
  CHECK(c.at(h) < 11 * h * h * h);
  CHECK(1 - c.at(1 - h) < 11 * h * h * h);
  CHECK(c.at(0.5) == 0.5);
  for (double t = 0; t < 1; t += 0.01) {
    CHECK(near(c.at(t) + c.at(1 - t), 1, 1e-14));
    CHECK(c.at(t + 0.01) > c.at(t));
  }
}

TEST_CASE("a load curve whose times do not rise or whose numbers are not finite is rejected with the reason") {
  const auto message_of = [](const LoadCurve& c) -> std::string {
    try {
      check_load_curve(c, "load 'p'");
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  CHECK(message_of({{0, 1, 3}, {1, 2, 3}}).empty());
  CHECK(message_of({{0, 1, 1}, {1, 2, 3}}) ==
        "load 'p': time 3 of the load curve is 1 s, must be above the previous one, 1 s");
  CHECK(message_of({{0, 1}, {1, NAN}}).find("load 'p': share 2 of the load curve") == 0);
  CHECK(message_of({{INFINITY}, {1}}).find("load 'p': time 1 of the load curve") == 0);
  CHECK(message_of({{0}, {}}).find("1 times and 0 shares") != std::string::npos);
}

TEST_CASE("a ramp ends at its distance without velocity, and its velocity and acceleration have no jump") {
  for (const auto& [by, duration] : {std::pair{0.3, 2.0}, std::pair{-1e-6, 1000.0}, std::pair{17.0, 0.013}}) {
    const GroundMotion m = ramp_motion(by, duration);
    CHECK(m.displacement(0) == 0);
    CHECK(m.velocity(0) == 0);
    CHECK(std::abs(m.velocity(duration)) <= 4e-16 * std::abs(by) / duration);
    CHECK(m.velocity(duration * (1 + 1e-12)) == 0);
    CHECK(m.acceleration(0) == 0);
    CHECK(std::abs(m.displacement(duration) - by) <= 4e-16 * std::abs(by));
    CHECK(m.displacement(2 * duration) == m.displacement(duration));
    CHECK(near(m.displacement(0.5 * duration), 0.5 * by, 1e-14));
    const double h = 1e-6 * duration, size = std::abs(by) / duration;
    double fastest = 0, before = 0;
    for (int i = 0; i <= 1000; ++i) {
      const double t = i * 1e-3 * duration, v = m.velocity(t) * (by > 0 ? 1 : -1);
      CHECK(v >= -1e-12 * size);
      CHECK(std::abs(v - before) < 0.01 * size);
      CHECK(std::abs(m.acceleration(t + h) - m.acceleration(t - h)) < 1e-4 * size / duration);
      fastest = std::max(fastest, v);
      before = v;
    }
    CHECK(near(fastest, 2 * size, 1e-9));
  }
  CHECK_THROWS_AS(ramp_motion(0, 1), InputError);
  CHECK_THROWS_AS(ramp_motion(1, 0), InputError);
  CHECK_THROWS_AS(ramp_motion(INFINITY, 1), InputError);
}

TEST_CASE("a uniform motion has its speed except at its smooth ends, and ends at its distance") {
  for (const double by : {0.05, -0.05}) {
    const double speed = 0.002, sign = by > 0 ? 1 : -1;
    const GroundMotion m = even_motion(by, speed);
    CHECK(near(m.duration(), 25 / 0.98, 1e-12));
    CHECK(m.velocity(0) == 0);
    CHECK(std::abs(m.velocity(m.duration())) < 1e-15);
    CHECK(std::abs(m.displacement(m.duration()) - by) < 1e-15);
    for (double share = 0.021; share < 0.98; share += 0.05)
      CHECK(near(m.velocity(share * m.duration()), sign * speed, 1e-12));
  }
  CHECK_THROWS_AS(even_motion(0.1, 0), InputError);
}

TEST_CASE("a stopping motion starts at the given position and velocity and ends at velocity 0") {
  const GroundMotion m = stopping_motion(0.2, -0.03, 0.4);
  CHECK(m.velocity(0) == -0.03);
  CHECK(m.displacement(0) == 0.2);
  CHECK(std::abs(m.velocity(0.4)) < 1e-17);
  CHECK(near(m.displacement(1), 0.2 - 0.03 * 0.2, 1e-12));
}
