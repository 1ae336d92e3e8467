#include "load/motion.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "load/motion_measures.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;

namespace {

/// Half sine a = A sin(pi t / T) over 0..T in n intervals.
GroundMotion half_sine(double amplitude, double length, int n) {
  std::vector<double> a;
  for (int i = 0; i <= n; ++i) a.push_back(amplitude * std::sin(std::numbers::pi * i / n));
  return {a, length / n};
}

GroundMotion random_motion(unsigned seed, MotionStart start = {}) {
  std::mt19937 random(seed);
  std::vector<double> a;
  for (int i = 0; i < 200; ++i) a.push_back(static_cast<double>(random() % 20001) / 1000 - 10);
  return {a, 0.02, start, {"folder/made.csv", "", "", "", {}}};
}

void check_same(const MotionAt& a, const MotionAt& b, double tolerance = 1e-12) {
  CHECK(std::abs(a.acceleration - b.acceleration) <= tolerance);
  CHECK(std::abs(a.velocity - b.velocity) <= tolerance);
  CHECK(std::abs(a.displacement - b.displacement) <= tolerance);
}

}  // namespace

TEST_CASE("constant acceleration gives linear velocity and quadratic displacement, to rounding") {
  const GroundMotion motion(std::vector<double>{2, 2, 2, 2}, 0.5, {0.3, 0.1});
  for (const double t : {0.0, 0.1, 0.5, 0.77, 1.4999}) {
    const MotionAt now = motion.at(t);
    CHECK(near(now.acceleration, 2, 1e-14));
    CHECK(near(now.velocity, 0.3 + 2 * t, 1e-14));
    CHECK(near(now.displacement, 0.1 + 0.3 * t + t * t, 1e-14));
  }
}

TEST_CASE("a linear ramp of acceleration gives t^2/2 and t^3/6, to rounding") {
  const GroundMotion motion(std::vector<double>{0, 1, 2, 3}, 1.0);
  for (const double t : {0.2, 1.0, 1.7, 2.9, 3.0}) {
    CHECK(near(motion.acceleration(t), t, 1e-14));
    CHECK(near(motion.velocity(t), t * t / 2, 1e-14));
    CHECK(near(motion.displacement(t), t * t * t / 6, 1e-14));
  }
}

TEST_CASE("a finely sampled half sine meets its analytic integrals, with an error that falls as the step squared") {
  const double amplitude = 3;
  const double length = 0.8;
  const double w = std::numbers::pi / length;
  const auto error = [&](int n) {
    const GroundMotion motion = half_sine(amplitude, length, n);
    double worst = 0;
    for (const double t : {0.11, 0.3, 0.55, 0.79}) {
      worst = std::max(worst, std::abs(motion.velocity(t) - amplitude / w * (1 - std::cos(w * t))));
      worst = std::max(worst, std::abs(motion.displacement(t) - amplitude / w * (t - std::sin(w * t) / w)));
    }
    return worst;
  };
  CHECK(error(1000) < 1e-6 * amplitude);
  CHECK(near(error(100) / error(1000), 100, 0.05));
}

TEST_CASE("velocity and displacement are continuous and integrate the acceleration between samples") {
  const GroundMotion motion = random_motion(1, {0.2, -0.1});
  const double h = 1e-3;
  for (double t = 0.0005; t < motion.end_time() - 2 * h; t += 0.0137) {
    const MotionAt now = motion.at(t);
    const MotionAt next = motion.at(t + h);
    // Simpson's rule is exact for the quadratic velocity inside an interval; skip steps across a sample.
    if (std::floor(t / 0.02) != std::floor((t + h) / 0.02)) continue;
    const MotionAt middle = motion.at(t + h / 2);
    CHECK(near(next.velocity - now.velocity, h / 6 * (now.acceleration + 4 * middle.acceleration + next.acceleration),
               1e-9));
    CHECK(
        near(next.displacement - now.displacement, h / 6 * (now.velocity + 4 * middle.velocity + next.velocity), 1e-9));
  }
  for (std::size_t i = 1; i + 1 < motion.samples().size(); ++i)
    check_same(motion.at(motion.sample_time(i) - 1e-12), motion.at(motion.sample_time(i) + 1e-12), 1e-8);
}

TEST_CASE("the ground rests before the first and after the last sample, at the start and end displacement") {
  const GroundMotion motion = random_motion(2, {0.4, 0.7}).delayed(1);
  const double end = motion.samples().back().displacement;
  for (const double t : {-1e300, -1.0, 0.0, 0.999999}) check_same(motion.at(t), {0, 0, 0.7}, 0);
  for (const double t : {motion.end_time() + 1e-9, 1e6, 1e300}) check_same(motion.at(t), {0, 0, end}, 0);
  CHECK(motion.velocity(1.0) == 0.4);
  const double infinite = std::numeric_limits<double>::infinity();
  check_same(motion.at(infinite), {0, 0, end}, 0);
  check_same(motion.at(-infinite), {0, 0, 0.7}, 0);
  check_same(motion.at(std::numeric_limits<double>::quiet_NaN()), {0, 0, 0.7}, 0);
}

TEST_CASE("scaling multiplies acceleration, velocity and displacement, and the start with them") {
  const GroundMotion motion = random_motion(3, {0.2, 0.05});
  const GroundMotion twice = motion.scaled(2);
  for (double t = 0; t < 3.9; t += 0.013) {
    const MotionAt now = motion.at(t);
    check_same(twice.at(t), {2 * now.acceleration, 2 * now.velocity, 2 * now.displacement});
  }
  check_same(motion.reversed().reversed().at(1.234), motion.at(1.234), 0);
  check_same(motion.reversed().at(1.234), motion.scaled(-1).at(1.234), 0);
  check_same(motion.scaled(4).scaled(0.25).at(1.234), motion.at(1.234), 0);
}

TEST_CASE("scaled to a peak, the peak is that one, and the vertical scaled as the horizontal keeps their ratio") {
  const GroundMotion horizontal = random_motion(4);
  const GroundMotion vertical = random_motion(5).scaled(0.3);
  const GroundMotion strong = horizontal.scaled_to_peak(0.8 * standard_gravity);
  CHECK(near(std::abs(motion_peaks(strong).acceleration.value), 0.8 * standard_gravity, 1e-14));
  const GroundMotion with = vertical.scaled_as(strong);
  CHECK(near(with.acceleration(1.0) / vertical.acceleration(1.0),
             strong.acceleration(1.0) / horizontal.acceleration(1.0), 1e-13));
  CHECK(vertical.scaled_as(strong.reversed()).acceleration(1.0) == with.acceleration(1.0));
}

TEST_CASE("with the time axis times f, velocities are f and displacements f^2 times as large") {
  const double f = 0.8;
  const GroundMotion motion = random_motion(6, {0.2, 0.05});
  const GroundMotion quick = motion.time_scaled(f);
  CHECK(near(quick.start().velocity, 0.16, 1e-12));
  CHECK(near(quick.start().displacement, 0.032, 1e-12));
  CHECK(near(quick.end_time(), f * motion.end_time(), 1e-12));
  for (double t = 0; t < 3.9; t += 0.013) {
    const MotionAt now = motion.at(t);
    check_same(quick.at(f * t), {now.acceleration, f * now.velocity, f * f * now.displacement}, 1e-10);
  }
  check_same(quick.time_scaled(1 / f).at(1.234), motion.at(1.234), 1e-10);
}

TEST_CASE("a delay shifts the motion and nothing else, by any time, and back") {
  const GroundMotion motion = random_motion(7, {0, 0.05});
  const GroundMotion late = motion.delayed(0.204);
  for (double t = 0; t < 3.9; t += 0.013) check_same(late.at(t + 0.204), motion.at(t), 1e-11);
  check_same(late.at(0.1), {0, 0, 0.05}, 0);
  CHECK(late.delayed(-0.204).start_time() == 0);
  CHECK(near(late.time_scaled(0.5).start_time(), 0.102, 1e-12));
  CHECK_THROWS_AS(motion.delayed(-0.01), InputError);
}

TEST_CASE("another start velocity adds a steady velocity") {
  const GroundMotion motion = random_motion(8);
  const GroundMotion moving = motion.with_start_velocity(0.25).with_start_displacement(0.5);
  for (const double t : {0.0, 0.7, 2.3}) {
    const MotionAt now = motion.at(t);
    check_same(moving.at(t), {now.acceleration, now.velocity + 0.25, now.displacement + 0.25 * t + 0.5});
  }
}

TEST_CASE("the description of a motion lists every step from the file") {
  const GroundMotion motion =
      random_motion(9).scaled_to_peak(0.8 * standard_gravity).time_scaled(0.8).delayed(0.204).reversed();
  CHECK(motion.description() == "made.csv, scaled to PGA 0.8 g, time x 0.8, delayed 0.204 s, reversed");
  CHECK(motion.source().file == "folder/made.csv");
}

TEST_CASE("samples, steps, starts and factors that are not numbers or out of range are rejected") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> good{0, 1, 0};
  CHECK_THROWS_AS(GroundMotion(std::vector<double>{1}, 0.01), InputError);
  CHECK_THROWS_AS(GroundMotion(std::vector<double>{0, nan}, 0.01), InputError);
  CHECK_THROWS_AS(GroundMotion(std::vector<double>{0, 1e9}, 0.01), InputError);
  for (const double step : {0.0, -0.01, nan, 1e-30, 1e30}) CHECK_THROWS_AS(GroundMotion(good, step), InputError);
  CHECK_THROWS_AS(GroundMotion(good, 0.01, {nan, 0}), InputError);
  CHECK_THROWS_AS(GroundMotion(good, 0.01, {0, nan}), InputError);
  const GroundMotion motion(good, 0.01);
  for (const double factor : {nan, 1e300}) {
    CHECK_THROWS_AS(motion.scaled(factor), InputError);
    CHECK_THROWS_AS(motion.time_scaled(factor), InputError);
    CHECK_THROWS_AS(motion.scaled_to_peak(factor), InputError);
  }
  CHECK_THROWS_AS(motion.time_scaled(0), InputError);
  CHECK_THROWS_AS(motion.time_scaled(-1), InputError);
  CHECK_THROWS_AS(motion.scaled_to_peak(-1), InputError);
  CHECK_THROWS_AS(motion.delayed(nan), InputError);
  CHECK_THROWS_AS(GroundMotion(std::vector<double>{0, 0}, 0.01).scaled_to_peak(1), InputError);
}
