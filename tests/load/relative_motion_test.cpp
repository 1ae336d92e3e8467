#include "load/relative_motion.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.hpp"
#include "load/motion_read.hpp"
#include "load/record_folder.hpp"

using namespace trilith;
using namespace trilith::testing;
using doctest::Approx;

namespace {
constexpr double inch = 0.0254;
}

TEST_CASE("D9: El Centro against itself with the time axis times 0.8") {
  const auto folder = record_folder();
  if (!folder) return;
  const GroundMotion right = read_motion(*folder / "elcentro_1940_cit_ns.csv").scaled_to_peak(0.8 * standard_gravity);
  const GroundMotion left = right.time_scaled(0.8);
  CHECK(right.amplitude_factor() == Approx(2.2940).epsilon(1e-4));
  const double peak_right = std::abs(motion_peaks(right).velocity.value) / inch;
  const double peak_left = std::abs(motion_peaks(left).velocity.value) / inch;
  const RelativePeaks peaks = relative_peaks(right, left);
  const double relative = std::abs(peaks.velocity.value) / inch;
  MESSAGE("velocities ", peak_right, " ", peak_left, " ", relative, " in/s at ", peaks.velocity.time,
          " s, displacement ", std::abs(peaks.displacement.value) / inch, " in at ", peaks.displacement.time, " s");
  CHECK(peak_right == Approx(30.20).epsilon(0.01));
  CHECK(peak_left == Approx(24.16).epsilon(0.01));
  CHECK(relative == Approx(43.20).epsilon(0.01));
  CHECK(peaks.velocity.time == Approx(4.34).epsilon(0.01));
  CHECK(relative / peak_right == Approx(1.431).epsilon(0.01));
  CHECK(std::abs(peaks.displacement.value) / inch == Approx(13.13).epsilon(0.01));
  CHECK(peaks.displacement.time == Approx(10.48).epsilon(0.01));
  CHECK(relative_passage(right, left, 10 * inch).value() == Approx(3.92).epsilon(0.01));
  CHECK(relative_passage(right, left, 12 * inch).value() == Approx(10.34).epsilon(0.01));
  CHECK(!relative_passage(right, left, 15 * inch).has_value());
}

TEST_CASE("a motion has no motion relative to itself, and all of its own relative to its opposite") {
  const GroundMotion motion = read_motion(own_record("elcentro_1940_rest_ns.csv"));
  const RelativePeaks none = relative_peaks(motion, motion);
  CHECK(none.velocity.value == 0);
  CHECK(none.displacement.value == 0);
  const RelativePeaks twice = relative_peaks(motion, motion.reversed(), 0.02);
  CHECK(twice.velocity.value == Approx(2 * motion_peaks(motion).velocity.value).epsilon(1e-12));
  CHECK(twice.displacement.value == Approx(2 * motion_peaks(motion).displacement.value).epsilon(1e-12));
}

TEST_CASE("a wave that arrives later makes the relative velocity of the delay") {
  // On flanks of 1 m/s2 a delay of 0.1 s is a relative velocity of 0.1 m/s.
  const GroundMotion wave(std::vector<double>{1, 1, -1, -1}, 2.0 / 3);
  const RelativePeaks peaks = relative_peaks(wave, wave.delayed(0.1));
  CHECK(std::abs(peaks.velocity.value) == Approx(0.1).epsilon(1e-9));
  CHECK_THROWS_AS(relative_passage(wave, wave, 0), InputError);
  CHECK_THROWS_AS(relative_peaks(wave, wave, 1e-12), InputError);
  CHECK_THROWS_AS(relative_peaks(wave, wave, -1), InputError);
}
