#include "load/motion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "base/error.hpp"

namespace trilith {

namespace {

// Wide bounds that keep every integral and rate finite.
constexpr double least_step = 1e-9;     // [s]
constexpr double largest_step = 1e6;    // [s]
constexpr double largest_sample = 1e6;  // [m/s2]

std::string name_of(const MotionSource& source) {
  if (!source.file.empty()) return std::filesystem::path(source.file).filename().string();
  return source.title.empty() ? "ground motion" : source.title;
}

/// Computes velocity and displacement at the samples from their values at the first.
void integrate(std::vector<MotionAt>& samples, double dt) {
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const MotionAt& now = samples[i];
    MotionAt& next = samples[i + 1];
    // Acceleration linear within the interval: v' = v + dt (a + a')/2, u' = u + dt v + dt^2 (a/3 + a'/6), both exact.
    next.velocity = now.velocity + dt * (now.acceleration + next.acceleration) / 2;
    next.displacement = now.displacement + dt * (now.velocity + dt * (now.acceleration / 3 + next.acceleration / 6));
  }
}

double largest_acceleration(std::span<const MotionAt> samples) {
  double peak = 0;
  for (const MotionAt& sample : samples) peak = std::max(peak, std::abs(sample.acceleration));
  return peak;
}

}  // namespace

// Input: acceleration at equal steps [m/s2], and velocity and displacement of the ground at the first sample. Output:
// all three at each sample, consistent exactly for an acceleration that is linear between samples. A support that
// follows the displacement then has the acceleration of the record, and no baseline is corrected silently.
GroundMotion::GroundMotion(std::span<const double> acceleration, double step, MotionStart start, MotionSource source)
    : step_(step), source_(std::move(source)), description_(name_of(source_)) {
  const auto about = [this](std::string_view what) { return fmt::format("motion '{}': {}", description_, what); };
  if (!(step >= least_step && step <= largest_step))
    throw InputError(fmt::format("motion '{}': the sample step dt is {:g} s, must be between {:g} and {:g} s",
                                 description_, step, least_step, largest_step));
  if (acceleration.size() < 2)
    throw InputError(fmt::format("motion '{}': {} samples, at least 2 are needed", description_, acceleration.size()));
  samples_.reserve(acceleration.size());
  for (const double a : acceleration) {
    if (std::isnan(a)) require_finite(a, about(fmt::format("acceleration of sample {}", samples_.size() + 1)));
    if (!(std::abs(a) <= largest_sample))
      throw InputError(fmt::format("motion '{}': acceleration of sample {} is {:g} m/s2, must be within +-{:g} m/s2",
                                   description_, samples_.size() + 1, a, largest_sample));
    samples_.push_back({a, 0, 0});
  }
  samples_.front().velocity = require_finite(start.velocity, about("start velocity"));
  samples_.front().displacement = require_finite(start.displacement, about("start displacement"));
  integrate(samples_, step_);
  // An overflow persists in the sums up to the last sample as an infinity or NaN.
  require_finite(samples_.back().velocity, about("end velocity"));
  require_finite(samples_.back().displacement, about("end displacement"));
  duration_ = static_cast<double>(samples_.size() - 1) * step_;
}

/// Always integrated from the accelerations, so that velocity and displacement are consistent as in any other motion.
GroundMotion GroundMotion::transformed(double amplitude, double time, MotionStart start,
                                       const std::string& note) const {
  std::vector<double> acceleration;
  acceleration.reserve(samples_.size());
  for (const MotionAt& sample : samples_) acceleration.push_back(sample.acceleration * amplitude);
  GroundMotion result(acceleration, step_ * time, start, source_);
  result.start_time_ = require_finite(start_time_ * time, "start time of '" + description_ + "'");
  result.factor_ = factor_ * amplitude;
  result.description_ = description_ + ", " + note;
  return result;
}

GroundMotion GroundMotion::scaled(double factor) const {
  require_finite(factor, "scale factor of motion '" + description_ + "'");
  return transformed(factor, 1, {start().velocity * factor, start().displacement * factor},
                     fmt::format("x {:.6g}", factor));
}

GroundMotion GroundMotion::scaled_to_peak(double peak) const {
  if (peak == 0) return scaled(0);
  require_positive(peak, "peak to which motion '" + description_ + "' is scaled", "m/s2");
  const double present = largest_acceleration(samples_);
  if (present == 0)
    throw InputError(fmt::format("motion '{}' is zero everywhere and cannot be scaled to a peak", description_));
  const double factor = peak / present;
  return transformed(factor, 1, {start().velocity * factor, start().displacement * factor},
                     fmt::format("scaled to PGA {:.6g} g", peak / standard_gravity));
}

/// Scales by the total factor of the other motion: components of one record are scaled together.
GroundMotion GroundMotion::scaled_as(const GroundMotion& other) const {
  const double factor = std::abs(other.factor_);
  return transformed(factor, 1, {start().velocity * factor, start().displacement * factor},
                     fmt::format("x {:.6g} as {}", factor, name_of(other.source_)));
}

GroundMotion GroundMotion::reversed() const {
  return transformed(-1, 1, {-start().velocity, -start().displacement}, "reversed");
}

/// With t' = factor t and unchanged accelerations, velocities increase with the factor and displacements with its
/// square.
GroundMotion GroundMotion::time_scaled(double factor) const {
  require_positive(factor, "time factor of motion '" + description_ + "'", "");
  return transformed(1, factor, {start().velocity * factor, start().displacement * factor * factor},
                     fmt::format("time x {:.6g}", factor));
}

GroundMotion GroundMotion::delayed(double delay) const {
  require_finite(delay, "delay of motion '" + description_ + "'");
  const double begin = start_time_ + delay;
  if (!(begin >= 0) || !std::isfinite(begin))
    throw InputError(fmt::format("motion '{}' delayed by {:g} s would begin at {:g} s, must not begin before 0",
                                 description_, delay, begin));
  GroundMotion result = *this;
  result.start_time_ = begin;
  result.description_ +=
      delay < 0 ? fmt::format(", advanced {:.6g} s", -delay) : fmt::format(", delayed {:.6g} s", delay);
  return result;
}

GroundMotion GroundMotion::with_start_velocity(double velocity) const {
  return transformed(1, 1, {velocity, start().displacement}, fmt::format("from {:.6g} m/s", velocity));
}

GroundMotion GroundMotion::with_start_displacement(double displacement) const {
  return transformed(1, 1, {start().velocity, displacement}, fmt::format("from {:.6g} m", displacement));
}

}  // namespace trilith
