#include "load/relative_motion.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.hpp"
#include "load/motion_read.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {
constexpr double inch = 0.0254;
}

TEST_CASE("D9: El Centro against itself with the time axis times 0.8") {
  const auto folder = record_folder();
  if (!folder) return;
  const GroundMotion right = read_motion(*folder / "elcentro_1940_cit_ns.csv").scaled_to_peak(0.8 * standard_gravity);
  const GroundMotion left = right.time_scaled(0.8);
  CHECK(near(right.amplitude_factor(), 2.2940, 1e-4));
  const double peak_right = std::abs(motion_peaks(right).velocity.value) / inch;
  const double peak_left = std::abs(motion_peaks(left).velocity.value) / inch;
  const RelativePeaks peaks = relative_peaks(right, left);
  const double relative = std::abs(peaks.velocity.value) / inch;
  MESSAGE("velocities ", peak_right, " ", peak_left, " ", relative, " in/s at ", peaks.velocity.time,
          " s, displacement ", std::abs(peaks.displacement.value) / inch, " in at ", peaks.displacement.time, " s");
  CHECK(near(peak_right, 30.20, 0.01));
  CHECK(near(peak_left, 24.16, 0.01));
  CHECK(near(relative, 43.20, 0.01));
  CHECK(near(peaks.velocity.time, 4.34, 0.01));
  CHECK(near(relative / peak_right, 1.431, 0.01));
  CHECK(near(std::abs(peaks.displacement.value) / inch, 13.13, 0.01));
  CHECK(near(peaks.displacement.time, 10.48, 0.01));
  CHECK(near(relative_passage(right, left, 10 * inch).value(), 3.92, 0.01));
  CHECK(near(relative_passage(right, left, 12 * inch).value(), 10.34, 0.01));
  CHECK(!relative_passage(right, left, 15 * inch).has_value());
}

TEST_CASE("a motion has no motion relative to itself, and all of its own relative to its opposite") {
  const GroundMotion motion = read_motion(own_record("elcentro_1940_rest_ns.csv"));
  const RelativePeaks none = relative_peaks(motion, motion);
  CHECK(none.velocity.value == 0);
  CHECK(none.displacement.value == 0);
  const RelativePeaks twice = relative_peaks(motion, motion.reversed(), 0.02);
  CHECK(near(twice.velocity.value, 2 * motion_peaks(motion).velocity.value, 1e-12));
  CHECK(near(twice.displacement.value, 2 * motion_peaks(motion).displacement.value, 1e-12));
}

TEST_CASE("a wave that arrives later makes the relative velocity of the delay") {
  // On flanks of 1 m/s2 a delay of 0.1 s is a relative velocity of 0.1 m/s.
  const GroundMotion wave(std::vector<double>{1, 1, -1, -1}, 2.0 / 3);
  const RelativePeaks peaks = relative_peaks(wave, wave.delayed(0.1));
  CHECK(near(std::abs(peaks.velocity.value), 0.1, 1e-9));
  CHECK_THROWS_AS(relative_passage(wave, wave, 0), InputError);
  CHECK_THROWS_AS(relative_peaks(wave, wave, 1e-12), InputError);
  CHECK_THROWS_AS(relative_peaks(wave, wave, -1), InputError);
}
