#include "load/response_spectrum.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "load/motion_measures.hpp"
#include "load/motion_read.hpp"
#include "load/record_folder.hpp"
#include "near.hpp"

using namespace trilith;
using namespace trilith::testing;

namespace {

constexpr double pi = std::numbers::pi;

/// Largest displacement of the same oscillator by the Runge-Kutta method of order 4 in `parts` parts of a sample
/// interval.
double peak_by_runge_kutta(const GroundMotion& motion, double period, double damping, int parts) {
  const double w = 2 * pi / period;
  const double h = motion.step() / parts;
  double x = 0;
  double v = 0;
  double peak = 0;
  for (int i = 0; i < static_cast<int>(motion.samples().size() - 1) * parts; ++i) {
    const double t = motion.start_time() + i * h;
    const auto rate = [&](double xx, double vv, double a) { return -a - 2 * damping * w * vv - w * w * xx; };
    const double a0 = motion.acceleration(t);
    const double a1 = motion.acceleration(t + h / 2);
    const double a2 = motion.acceleration(t + h);
    const double k1 = rate(x, v, a0);
    const double k2 = rate(x + h / 2 * v, v + h / 2 * k1, a1);
    const double k3 = rate(x + h / 2 * (v + h / 2 * k1), v + h / 2 * k2, a1);
    const double k4 = rate(x + h * (v + h / 2 * k2), v + h * k3, a2);
    x += h * v + h * h / 6 * (k1 + k2 + k3);
    v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    peak = std::max(peak, std::abs(x));
  }
  return peak;
}

}  // namespace

TEST_CASE("D1: peaks of elastic oscillators under the textbook El Centro") {
  constexpr double inch = 0.0254;
  const auto folder = record_folder();
  if (!folder) return;
  const GroundMotion motion = read_motion(*folder / "elcentro_1940_textbook_ns.csv");
  struct Row {
    double period, damping, peak_in;
  };
  for (const Row& row :
       {Row{0.5, 0.02, 2.687}, Row{1, 0.02, 5.967}, Row{2, 0.02, 7.466}, Row{2, 0.05, 5.373}, Row{0.5, 0.05, 2.246}}) {
    const OscillatorPeak peak = oscillator_peak(motion, row.period, row.damping);
    MESSAGE("T ", row.period, " zeta ", row.damping, ": ", peak.displacement / inch, " in at ", peak.time, " s");
    CHECK(near(peak.displacement / inch, row.peak_in, 0.01));
  }
  CHECK(near(oscillator_peak(motion, 0.5, 0.05).time, 2.35, 0.01));
}

TEST_CASE("the recurrence agrees with a fine Runge-Kutta integration, for short and long periods") {
  const GroundMotion motion = read_motion(own_record("elcentro_1940_rest_ns.csv"));
  for (const double period : {0.03, 0.1, 0.37, 1.0, 4.0})
    for (const double damping : {0.0, 0.05, 0.5})
      CHECK(near(oscillator_peak(motion, period, damping).displacement,
                 peak_by_runge_kutta(motion, period, damping, period < 0.2 ? 40 : 10), 1e-3));
}

TEST_CASE("a suddenly applied constant acceleration doubles the static displacement") {
  const GroundMotion motion(std::vector<double>(400, 1.0), 0.01);
  for (const double period : {0.02, 0.5, 1.0}) {
    const double still = std::pow(period / (2 * pi), 2);
    CHECK(near(oscillator_peak(motion, period, 0).displacement, 2 * still, 1e-4));
    const double overshoot = std::exp(-pi * 0.1 / std::sqrt(1 - 0.01));
    CHECK(near(oscillator_peak(motion, period, 0.1).displacement, still * (1 + overshoot), 1e-4));
    CHECK(near(oscillator_peak(motion, period, 0.1).time, period / 2 / std::sqrt(1 - 0.01), 1e-3));
  }
}

TEST_CASE("after a short pulse the peak of the free vibration that follows is found") {
  // Impulse V: amplitude V / w a quarter period later, long after the end of the pulse.
  const GroundMotion motion(std::vector<double>{0, 1, 0}, 0.001);
  const OscillatorPeak peak = oscillator_peak(motion, 2, 0);
  CHECK(near(peak.displacement, 0.001 / pi, 1e-4));
  CHECK(near(peak.time, 0.501, 1e-3));
}

TEST_CASE("stiff oscillators follow the ground acceleration, soft ones the ground displacement") {
  const GroundMotion motion = read_motion(own_record("elcentro_1940_rest_ns.csv"));
  const double pga = std::abs(motion_peaks(motion).acceleration.value);
  CHECK(oscillator_peak(motion, 0, 0.05).pseudo_acceleration == pga);
  CHECK(oscillator_peak(motion, 0, 0.05).displacement == 0);
  CHECK(near(oscillator_peak(motion, 0.002, 0.05).pseudo_acceleration, pga, 0.01));
  CHECK(near(oscillator_peak(motion, 100, 0.05).displacement, std::abs(motion_peaks(motion).displacement.value), 0.15));
}

TEST_CASE("the spectrum scales with the motion, and its periods with the time axis") {
  const GroundMotion motion = read_motion(own_record("elcentro_1940_rest_ns.csv"));
  const OscillatorPeak base = oscillator_peak(motion, 0.7, 0.05);
  CHECK(near(oscillator_peak(motion.scaled(-2), 0.7, 0.05).displacement, 2 * base.displacement, 1e-10));
  CHECK(near(oscillator_peak(motion.time_scaled(0.8), 0.56, 0.05).pseudo_acceleration, base.pseudo_acceleration, 1e-9));
  CHECK(near(oscillator_peak(motion.delayed(3), 0.7, 0.05).time, base.time + 3, 1e-9));
  CHECK(near(base.pseudo_velocity, base.displacement * 2 * pi / 0.7, 1e-12));
  CHECK(near(base.pseudo_acceleration, base.pseudo_velocity * 2 * pi / 0.7, 1e-12));
}

TEST_CASE("periods increase, and periods and dampings out of range are rejected") {
  const GroundMotion motion(std::vector<double>{0, 1, 0}, 0.01);
  const std::vector<double> periods = spectrum_periods(0.1, 10, 3);
  CHECK(near(periods[1], 1, 1e-12));
  CHECK(periods[2] == 10);
  const auto spectrum = response_spectrum(motion, periods);
  REQUIRE(spectrum.size() == 3);
  CHECK(spectrum[1].period == periods[1]);
  CHECK(spectrum[1].damping == 0.05);
  for (const double period : {-1.0, 1e-4, 1e3, std::nan("")})
    CHECK_THROWS_AS(oscillator_peak(motion, period, 0.05), InputError);
  for (const double damping : {-0.01, 1.0, 5.0, std::nan("")})
    CHECK_THROWS_AS(oscillator_peak(motion, 1, damping), InputError);
  CHECK_THROWS_AS(spectrum_periods(1, 0.5, 10), InputError);
  CHECK_THROWS_AS(spectrum_periods(0.1, 1, 1), InputError);
}
