// Baseline, filter, step, rotation and spectrum of ground motions, against closed forms.
#include "load/motion_process.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "base/error.hpp"
#include "load/response_spectrum.hpp"
#include "near.hpp"

using namespace trilith;
using testing::near;
using testing::near_zero;

namespace {

GroundMotion noise(unsigned seed, int n = 2000, double step = 0.01) {
  std::mt19937 random(seed);
  std::vector<double> a;
  for (int i = 0; i < n; ++i) a.push_back(static_cast<double>(random() % 20001) / 10000 - 1);
  return {a, step, {}, {"noise.csv", "", "", "", {}}};
}

/// A long sine with smooth start and end, so that its ends have no influence; `f` in Hz.
GroundMotion tone(double f, double step) {
  std::vector<double> a;
  const int n = static_cast<int>(600 / (f * step));
  for (int i = 0; i < n; ++i) {
    const double fade = std::sin(std::numbers::pi * i / (n - 1));
    a.push_back(fade * fade * std::sin(2 * std::numbers::pi * f * i * step));
  }
  return {a, step};
}

/// Amplitude of `motion` at `f`, and of its part a quarter period behind, by projection.
std::pair<double, double> parts_at(const GroundMotion& motion, double f) {
  double in = 0, behind = 0;
  for (std::size_t i = 0; i < motion.samples().size(); ++i) {
    const double angle = 2 * std::numbers::pi * f * static_cast<double>(i) * motion.step();
    in += motion.samples()[i].acceleration * std::sin(angle);
    behind += motion.samples()[i].acceleration * std::cos(angle);
  }
  return {in, behind};
}

}  // namespace

TEST_CASE("a baseline correction removes every polynomial up to its degree and nothing else") {
  const GroundMotion plain = baseline_corrected(noise(1), 3);
  std::vector<double> with;
  for (std::size_t i = 0; i < plain.samples().size(); ++i) {
    const double t = static_cast<double>(i) * 0.01;
    with.push_back(plain.samples()[i].acceleration + 0.7 - 0.3 * t + 0.05 * t * t - 0.002 * t * t * t);
  }
  const GroundMotion back = baseline_corrected({with, 0.01}, 3);
  double worst = 0;
  for (std::size_t i = 0; i < with.size(); ++i)
    worst = std::max(worst, std::abs(back.samples()[i].acceleration - plain.samples()[i].acceleration));
  CHECK(worst < 1e-12);
  CHECK(back.description().find("baseline of degree 3 removed") != std::string::npos);
  CHECK_THROWS_AS(baseline_corrected(noise(1), -1), InputError);
  CHECK_THROWS_AS(baseline_corrected(noise(1).scaled(2), 1), InputError);
}

TEST_CASE("a Butterworth filter has -3 dB at its corner and no phase shift, and follows its formula") {
  constexpr double step = 0.01, corner = 5;
  const auto tangent = [](double f) { return std::tan(std::numbers::pi * f * step); };
  for (const int order : {1, 2, 3, 4, 7})
    for (const double f : {2.5, 5.0, 10.0}) {
      const GroundMotion sine = tone(f, step);
      const double whole = parts_at(sine, f).first;
      const double share = std::pow(tangent(f) / tangent(corner), 2.0 * order);
      const auto [low, low_behind] = parts_at(filtered(sine, {0, corner, order, 0}), f);
      CHECK(near(low / whole, 1 / (1 + (std::sqrt(2.0) - 1) * share), 5e-3));
      CHECK(near_zero(low_behind / whole, 1e-3));
      const auto [high, high_behind] = parts_at(filtered(sine, {corner, 0, order, 0}), f);
      CHECK(near(high / whole, 1 / (1 + (std::sqrt(2.0) - 1) / share), 5e-3));
      CHECK(near_zero(high_behind / whole, 1e-3));
      if (f == corner) CHECK(near(20 * std::log10(low / whole), -3.0103, 5e-3));
    }
}

TEST_CASE("a filtered record that is played backward is the backward record filtered") {
  const GroundMotion forward = noise(4, 800);
  std::vector<double> mirrored;
  for (std::size_t i = forward.samples().size(); i-- > 0;) mirrored.push_back(forward.samples()[i].acceleration);
  const FilterBand band{0.5, 10, 4, 0};
  const GroundMotion a = filtered(forward, band), b = filtered({mirrored, 0.01}, band);
  double worst = 0;
  for (std::size_t i = 0; i < mirrored.size(); ++i)
    worst = std::max(worst, std::abs(a.samples()[i].acceleration - b.samples()[mirrored.size() - 1 - i].acceleration));
  CHECK(worst < 1e-9);
}

TEST_CASE("a pad makes a high-pass end at rest, and impossible corner frequencies are rejected") {
  const GroundMotion motion = noise(5, 1000);
  const GroundMotion padded = filtered(motion, {0.5, 0, 4, 12});
  CHECK(padded.samples().size() == 1000 + 2400);
  double fastest = 0;
  for (const MotionAt& s : padded.samples()) fastest = std::max(fastest, std::abs(s.velocity));
  CHECK(std::abs(padded.samples().back().velocity) < 1e-6 * fastest);
  for (const FilterBand& wrong : {FilterBand{0, 0, 4, 0}, {0, 50, 4, 0}, {5, 2, 4, 0}, {1, 2, 0, 0}, {1, 2, 4, -1}})
    CHECK_THROWS_AS(filtered(motion, wrong), InputError);
}

TEST_CASE("resampling to a divided step keeps the motion, and resampling back gives the same bits") {
  const GroundMotion motion = noise(6, 300);
  const GroundMotion fine = resampled(motion, 0.0025);
  CHECK(fine.samples().size() == 4 * 299 + 1);
  for (const double t : {0.013, 0.5, 1.2345, 2.99}) CHECK(near(fine.displacement(t), motion.displacement(t), 1e-11));
  const GroundMotion coarse = resampled(tone(1, 0.005), 0.02);  // far below the new limit: kept
  const double whole = parts_at(tone(1, 0.005), 1).first, kept = parts_at(coarse, 1).first;
  CHECK(near(4 * kept / whole, 1, 2e-3));
  CHECK_THROWS_AS(resampled(motion, 0), InputError);
  CHECK_THROWS_AS(resampled(motion, 10), InputError);
}

TEST_CASE("a step or a pad with billions of samples is rejected, one just within the bound is not") {
  const GroundMotion motion = noise(9, 101);  // 1 s
  CHECK_THROWS_AS(resampled(motion, 1e-9), InputError);
  CHECK(resampled(motion, 1.25e-7).samples().size() == 8'000'001);
  const GroundMotion fast = noise(9, 101, 1e-5);
  CHECK_THROWS_AS(filtered(fast, {0, 1000, 4, 1e4}), InputError);
  CHECK(filtered(fast, {0, 1000, 4, 1}).samples().size() == 101 + 200'000);
}

TEST_CASE("a record rotated and rotated back is unchanged, and rotation keeps the sum of squares") {
  const GroundMotion a = noise(7), b = noise(8);
  const double angle = 0.7;
  const auto [x, y] = rotated(a, b, angle);
  for (std::size_t i = 0; i < 2000; i += 97) {
    const double ax = x.samples()[i].acceleration, ay = y.samples()[i].acceleration;
    const double a0 = a.samples()[i].acceleration, b0 = b.samples()[i].acceleration;
    CHECK(near(ax, a0 * std::cos(angle) + b0 * std::sin(angle), 1e-12));
    CHECK(near(ax * ax + ay * ay, a0 * a0 + b0 * b0, 1e-12));
  }
  const auto [back, across] = rotated(x, y, -angle);
  CHECK(near(back.samples()[500].displacement, a.samples()[500].displacement, 1e-11));
  const auto [quarter, rest] = rotated(a, b, std::numbers::pi / 2);
  CHECK(near(quarter.samples()[3].acceleration, b.samples()[3].acceleration, 1e-12));
  CHECK(near(rest.samples()[3].acceleration, -a.samples()[3].acceleration, 1e-12));
  CHECK_THROWS_AS(rotated(a, noise(8, 100), angle), InputError);
}

TEST_CASE("the factor to a spectrum is exact where one factor can meet it, and least in squares where not") {
  const GroundMotion motion = noise(9);
  const std::vector<double> periods{0.1, 0.3, 1.0, 2.0};
  std::vector<SpectrumPoint> target;
  for (const OscillatorPeak& p : response_spectrum(motion, periods))
    target.push_back({p.period, 2.5 * p.pseudo_acceleration});
  CHECK(near(factor_to_spectrum(motion, target), 2.5, 1e-12));
  CHECK(near(oscillator_peak(motion.scaled(factor_to_spectrum(motion, {1.0, 3.0})), 1.0, 0.05).pseudo_acceleration, 3.0,
             1e-12));
  target[0].acceleration *= 4, target[3].acceleration /= 2;  // changes the mean logarithm by ln(2) / 4
  CHECK(near(factor_to_spectrum(motion, target), 2.5 * std::pow(2.0, 0.25), 1e-12));
  CHECK_THROWS_AS(factor_to_spectrum(motion, {1.0, 0.0}), InputError);
}

TEST_CASE("a motion scaled to nothing is a control run, and may shake") {
  const GroundMotion motion = noise(3);
  for (const GroundMotion& none : {motion.scaled(0), motion.scaled_to_peak(0)}) {
    CHECK(none.at(3).acceleration == 0);
    CHECK(none.at(3).displacement == 0);
    CHECK(none.amplitude_factor() == 0);
  }
}
