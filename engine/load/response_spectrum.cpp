#include "load/response_spectrum.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable.hpp"
#include "load/motion_measures.hpp"

namespace trilith {

namespace {

constexpr double least_period = 0.001;  // [s] bounds the number of subdivisions
constexpr double largest_period = 100;  // [s] bounds the cancellation in the recurrence, which grows as (T / dt)^3
constexpr double points_per_period = 20;

struct Oscillation {
  double displacement = 0;
  double velocity = 0;
};

/// Advances an oscillator exactly over equal time steps with linear load.
class Recurrence {
 public:
  Recurrence(double period, double damping, double step)
      : step_(step),
        omega_(2 * std::numbers::pi / period),
        damping_(damping),
        damped_omega_(omega_ * std::sqrt(1 - damping * damping)),
        decay_(portable::exp(-damping * omega_ * step)),
        cosine_(decay_ * portable::cos(damped_omega_ * step)),
        sine_(decay_ * portable::sin(damped_omega_ * step)) {}

  double step() const { return step_; }

  /// The oscillation one step later; the load per mass [m/s2] varies linearly from `from` to `to`. Solution of u'' + 2
  /// zeta w u' + w^2 u = from + (to - from) s / step: a particular solution `base` + `slope` s plus exp(-zeta w s) (c
  /// cos(w_d s) + s sin(w_d s)), with c and s from the present oscillation (Nigam and Jennings 1969).
  Oscillation advance(Oscillation now, double from, double to) const {
    const double slope = (to - from) / (step_ * omega_ * omega_);  // of the particular solution `base` + `slope` s
    const double base = from / (omega_ * omega_) - 2 * damping_ / omega_ * slope;
    const double c = now.displacement - base;
    const double s = (now.velocity - slope + damping_ * omega_ * c) / damped_omega_;
    const double free = c * cosine_ + s * sine_;
    const double free_rate = damped_omega_ * (s * cosine_ - c * sine_) - damping_ * omega_ * free;
    return {free + base + slope * step_, free_rate + slope};
  }

 private:
  double step_, omega_, damping_, damped_omega_, decay_, cosine_, sine_;
};

/// The extreme of the cubic through `from` and `to` over a time `step` in which the velocity changes its sign.
Peak extreme_between(const Oscillation& from, const Oscillation& to, double step) {
  const double rise = to.displacement - from.displacement;
  const double linear = step * from.velocity;
  const double square = 3 * rise - step * (2 * from.velocity + to.velocity);
  const double cube = step * (from.velocity + to.velocity) - 2 * rise;
  // Root of linear + 2 square r + 3 cube r^2 in 0..1: unique, because the slope has opposite signs at the two ends.
  const double root = std::sqrt(std::max(0.0, square * square - 3 * cube * linear));
  const double sum = -(square + std::copysign(root, square));
  // First the root without cancellation; the other if that lies outside.
  double r = sum == 0 ? 0.5 : linear / sum;
  if (!(r >= 0 && r <= 1)) r = cube == 0 ? 0.5 : sum / (3 * cube);
  r = std::clamp(r, 0.0, 1.0);
  return {from.displacement + r * (linear + r * (square + r * cube)), r * step};
}

/// Follows one oscillator and keeps its largest displacement.
class PeakFollower {
 public:
  explicit PeakFollower(double start_time) : peak_{0, start_time} {}

  void advance(const Recurrence& recurrence, double time, double from, double to) {
    const Oscillation next = recurrence.advance(now_, from, to);
    if (now_.velocity * next.velocity < 0) {
      const Peak inside = extreme_between(now_, next, recurrence.step());
      keep(inside.value, time + inside.time);
    }
    keep(next.displacement, time + recurrence.step());
    now_ = next;
  }
  const Peak& peak() const { return peak_; }

 private:
  void keep(double value, double time) {
    if (std::abs(value) > peak_.value) peak_ = {std::abs(value), time};
  }
  Oscillation now_;
  Peak peak_;
};

Peak largest_displacement(const GroundMotion& motion, double period, double damping) {
  // At least 20 points per period; the load remains linear within each part.
  const auto parts = std::max(1.0, std::ceil(points_per_period * motion.step() / period));
  const Recurrence recurrence(period, damping, motion.step() / parts);
  PeakFollower follower(motion.start_time());
  const auto samples = motion.samples();
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double from = -samples[i].acceleration;
    const double change = (-samples[i + 1].acceleration - from) / parts;
    for (double part = 0; part < parts; ++part)
      follower.advance(recurrence, motion.sample_time(i) + part * recurrence.step(), from + part * change,
                       from + (part + 1) * change);
  }
  // Free vibration for one more period: the largest displacement may occur after the record's end.
  const Recurrence after(period, damping, period / points_per_period);
  for (double part = 0; part < points_per_period; ++part)
    follower.advance(after, motion.end_time() + part * after.step(), 0, 0);
  return follower.peak();
}

}  // namespace

OscillatorPeak oscillator_peak(const GroundMotion& motion, double period, double damping) {
  if (!(damping >= 0 && damping < 1))
    throw InputError(fmt::format("damping ratio is {:g}, must be at least 0 and below 1 (5 % is 0.05)", damping));
  if (period == 0) {
    const Peak ground = motion_peaks(motion).acceleration;
    return {0, damping, 0, ground.time, 0, std::abs(ground.value)};
  }
  if (!(period >= least_period && period <= largest_period))
    throw InputError(
        fmt::format("period is {:g} s, must be 0 or between {:g} and {:g} s", period, least_period, largest_period));
  const Peak peak = largest_displacement(motion, period, damping);
  const double omega = 2 * std::numbers::pi / period;
  return {period, damping, peak.value, peak.time, peak.value * omega, peak.value * omega * omega};
}

// Pseudo-velocity w d and pseudo-acceleration w^2 d from the largest displacement d, as in design codes: w^2 d is the
// largest elastic force over the mass, which without damping is the largest acceleration.
std::vector<OscillatorPeak> response_spectrum(const GroundMotion& motion, std::span<const double> periods,
                                              double damping) {
  std::vector<OscillatorPeak> spectrum;
  spectrum.reserve(periods.size());
  for (const double period : periods) spectrum.push_back(oscillator_peak(motion, period, damping));
  return spectrum;
}

std::vector<double> spectrum_periods(double from, double to, int count) {
  if (!(from > 0 && from < to && std::isfinite(to) && count >= 2))
    throw InputError(fmt::format("{} periods from {:g} to {:g} s: must be at least 2, from above 0, to above from",
                                 count, from, to));
  std::vector<double> periods;
  periods.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    periods.push_back(from * portable::pow(to / from, static_cast<double>(i) / (count - 1)));
  periods.back() = to;
  return periods;
}

}  // namespace trilith
