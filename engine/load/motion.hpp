// Ground motion: a recorded acceleration and the velocity and displacement that follow from it exactly.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace trilith {

/// Standard acceleration of gravity [m/s2] (3rd CGPM, 1901); the "g" in which records are written.
inline constexpr double standard_gravity = 9.80665;

/// The state of the ground at one instant: acceleration [m/s2], velocity [m/s], displacement [m].
struct MotionAt {
  double acceleration = 0;
  double velocity = 0;
  double displacement = 0;
};

/// The ground's velocity [m/s] and displacement [m] at the first sample.
struct MotionStart {
  double velocity = 0;
  double displacement = 0;
};

/// Origin of a motion. Every field may be empty.
struct MotionSource {
  std::string file;       ///< path as it was given
  std::string agency;     ///< agency that recorded or processed it
  std::string title;      ///< event and station
  std::string component;  ///< direction, e.g. "NS (S00E)"
  std::vector<std::string> notes;
};

/// One component of ground motion: samples of acceleration at a uniform step, linear in between.
///
/// An immutable value. Velocity (quadratic in a sample interval) and displacement (cubic) are the exact integrals of
/// the piecewise linear acceleration, from the start velocity and displacement at the first sample:
///     v(s) = v_i + a_i s + (a_{i+1} - a_i) s^2 / (2 dt)
///     u(s) = u_i + v_i s + a_i s^2 / 2 + (a_{i+1} - a_i) s^3 / (6 dt),   0 <= s <= dt.
/// Before the first sample the ground rests at the start displacement, so a start velocity other than zero is a jump of
/// the velocity at the first sample. After the last sample the ground rests at the end displacement, so an end velocity
/// other than zero is a jump there. check_usable (motion_check.hpp) rejects a motion if this jump is not small.
class GroundMotion {
 public:
  /// `acceleration`: at least 2 samples [m/s2], within +-1e6; `step`: sample step [s], 1e-9 to 1e6. Throws InputError
  /// if one is outside its range or an integral is not finite.
  GroundMotion(std::span<const double> acceleration, double step, MotionStart start = {}, MotionSource source = {});

  /// Acceleration, velocity and displacement at time `t` [s]. Constant time, no allocation; any `t`.
  MotionAt at(double t) const noexcept;
  double acceleration(double t) const noexcept { return at(t).acceleration; }
  double velocity(double t) const noexcept { return at(t).velocity; }
  double displacement(double t) const noexcept { return at(t).displacement; }

  /// The samples, with the integrals at the sample times. Sample i is at the time start_time() + i * step().
  std::span<const MotionAt> samples() const noexcept { return samples_; }
  double step() const noexcept { return step_; }                        ///< sample step [s]
  double start_time() const noexcept { return start_time_; }            ///< time of the first sample [s]
  double end_time() const noexcept { return start_time_ + duration_; }  ///< time of the last sample [s]
  double duration() const noexcept { return duration_; }                ///< first to last sample [s]
  double sample_time(std::size_t i) const noexcept { return start_time_ + static_cast<double>(i) * step_; }
  MotionStart start() const noexcept { return {samples_.front().velocity, samples_.front().displacement}; }
  /// Product of all amplitude factors applied since the record was read (sign included).
  double amplitude_factor() const noexcept { return factor_; }

  const MotionSource& source() const noexcept { return source_; }
  /// Description in one line: "elcentro_1940_rest_ns.csv, scaled to PGA 0.8 g, time x 0.8, delayed 0.204 s".
  const std::string& description() const noexcept { return description_; }

  /// All amplitudes (acceleration, velocity, displacement) times `factor`; finite and not 0.
  GroundMotion scaled(double factor) const;
  /// Scaled so that the largest |acceleration| is `peak` [m/s2], above 0. Throws InputError for an all-zero motion.
  GroundMotion scaled_to_peak(double peak) const;
  /// Times |amplitude_factor()| of another component, e.g. the vertical scaled as the horizontal was.
  GroundMotion scaled_as(const GroundMotion& other) const;
  /// Opposite direction: all amplitudes times -1.
  GroundMotion reversed() const;
  /// Time axis times `factor` (above 0), with unchanged accelerations: velocities are multiplied by `factor`,
  /// displacements by `factor`^2. A delay is multiplied too.
  GroundMotion time_scaled(double factor) const;
  /// The motion delayed by `delay` [s] (earlier if negative, but not before t = 0: InputError).
  GroundMotion delayed(double delay) const;
  /// The accelerations with another start velocity [m/s].
  GroundMotion with_start_velocity(double velocity) const;
  /// The accelerations with another start displacement [m].
  GroundMotion with_start_displacement(double displacement) const;

 private:
  GroundMotion transformed(double amplitude, double time, MotionStart start, const std::string& note) const;

  std::vector<MotionAt> samples_;  // acceleration and its exact integrals at the sample times
  double step_ = 0;
  double duration_ = 0;
  double start_time_ = 0;
  double factor_ = 1;
  MotionSource source_;
  std::string description_;
};

inline MotionAt GroundMotion::at(double t) const noexcept {
  const double since = t - start_time_;
  if (!(since >= 0)) return {0, 0, samples_.front().displacement};
  if (since > duration_) return {0, 0, samples_.back().displacement};
  const auto i = std::min(static_cast<std::size_t>(since / step_), samples_.size() - 2);
  const double s = since - static_cast<double>(i) * step_;
  const MotionAt& from = samples_[i];
  const double jerk = (samples_[i + 1].acceleration - from.acceleration) / step_;
  return {from.acceleration + jerk * s, from.velocity + s * (from.acceleration + s * jerk / 2),
          from.displacement + s * (from.velocity + s * (from.acceleration / 2 + s * jerk / 6))};
}

}  // namespace trilith
