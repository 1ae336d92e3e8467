#include "load/motion_measures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace trilith {

namespace {

void keep_larger(Peak& peak, double value, double time) {
  if (std::abs(value) > std::abs(peak.value)) peak = {value, time};
}

/// Integral of a^2 over the first `s` of an interval in which a varies linearly from `from`, at rate `jerk`.
double square_integral(double from, double jerk, double s) {
  const double to = from + jerk * s;
  return s * (from * from + from * to + to * to) / 3;
}

/// Integral of |a| over an interval of length `dt` in which a varies linearly from `from` to `to`.
double absolute_integral(double from, double to, double dt) {
  // Of one sign: the trapezoid.
  if (from * to >= 0) return dt * std::abs(from + to) / 2;
  return dt * (from * from + to * to) / (2 * std::abs(to - from));  // two triangles
}

/// Integral of a^2 up to every sample [m2/s3].
std::vector<double> square_sums(const GroundMotion& motion) {
  const auto samples = motion.samples();
  std::vector<double> sums(samples.size(), 0.0);
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double jerk = (samples[i + 1].acceleration - samples[i].acceleration) / motion.step();
    sums[i + 1] = sums[i] + square_integral(samples[i].acceleration, jerk, motion.step());
  }
  return sums;
}

/// The time at which the integral of a^2 reaches `goal`.
double time_of_sum(const GroundMotion& motion, const std::vector<double>& sums, double goal) {
  const auto above = std::lower_bound(sums.begin(), sums.end(), goal);
  if (above == sums.begin()) return motion.start_time();
  if (above == sums.end()) return motion.end_time();
  // Within interval i the integral of a^2 is a cubic in time.
  const auto i = static_cast<std::size_t>(above - sums.begin()) - 1;
  const double from = motion.samples()[i].acceleration;
  const double jerk = (motion.samples()[i + 1].acceleration - from) / motion.step();
  double low = 0;
  double high = motion.step();
  for (int halving = 0; halving < 50; ++halving) {  // the sum increases monotonically, so bisection converges
    const double middle = (low + high) / 2;
    (sums[i] + square_integral(from, jerk, middle) < goal ? low : high) = middle;
  }
  return motion.sample_time(i) + high;
}

/// Position at which |a| reaches the level between `inside` (|a| below it) and `outside` (at or above): 0 at `inside`,
/// 1 at `outside`.
double crossing(double inside, double outside, double level) {
  const double bound = std::copysign(level, outside);
  return std::clamp((bound - inside) / (outside - inside), 0.0, 1.0);
}

}  // namespace

MotionPeaks motion_peaks(const GroundMotion& motion) {
  MotionPeaks peaks;
  const auto samples = motion.samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double time = motion.sample_time(i);
    keep_larger(peaks.acceleration, samples[i].acceleration, time);
    keep_larger(peaks.velocity, samples[i].velocity, time);
    keep_larger(peaks.displacement, samples[i].displacement, time);
  }
  return peaks;
}

/// pi / 2 g times the integral of a^2 (Arias 1970).
double arias_intensity(const GroundMotion& motion) {
  return std::numbers::pi / (2 * standard_gravity) * square_sums(motion).back();
}

double cumulative_absolute_velocity(const GroundMotion& motion) {
  const auto samples = motion.samples();
  double sum = 0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i)
    sum += absolute_integral(samples[i].acceleration, samples[i + 1].acceleration, motion.step());
  return sum;
}

TimeSpan significant_duration(const GroundMotion& motion, double low, double high) {
  if (!(low >= 0 && low < high && high <= 1))
    throw InputError(fmt::format("significant duration from {:g} to {:g}: must be 0 <= low < high <= 1", low, high));
  const std::vector<double> sums = square_sums(motion);
  if (sums.back() == 0) return {motion.start_time(), motion.start_time()};
  return {time_of_sum(motion, sums, low * sums.back()), time_of_sum(motion, sums, high * sums.back())};
}

/// From the first time at which |a| reaches the level to the last time at which it falls below it, both interpolated
/// between samples.
TimeSpan bracketed_duration(const GroundMotion& motion, double level) {
  require_positive(level, "level of the bracketed duration", "m/s2");
  const auto samples = motion.samples();
  const auto strong = [level](const MotionAt& sample) { return std::abs(sample.acceleration) >= level; };
  const auto first = std::find_if(samples.begin(), samples.end(), strong);
  if (first == samples.end()) return {motion.start_time(), motion.start_time()};
  const auto last = std::find_if(samples.rbegin(), samples.rend(), strong).base() - 1;
  TimeSpan span{motion.sample_time(static_cast<std::size_t>(first - samples.begin())),
                motion.sample_time(static_cast<std::size_t>(last - samples.begin()))};
  if (first != samples.begin())
    span.begin -= (1 - crossing((first - 1)->acceleration, first->acceleration, level)) * motion.step();
  if (last + 1 != samples.end())
    span.end += (1 - crossing((last + 1)->acceleration, last->acceleration, level)) * motion.step();
  return span;
}

MotionTraces motion_traces(const GroundMotion& motion) {
  MotionTraces traces;
  const auto samples = motion.samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    traces.time.push_back(motion.sample_time(i));
    traces.acceleration.push_back(samples[i].acceleration);
    traces.velocity.push_back(samples[i].velocity);
    traces.displacement.push_back(samples[i].displacement);
  }
  return traces;
}

}  // namespace trilith
