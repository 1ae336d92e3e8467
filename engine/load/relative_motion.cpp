#include "load/relative_motion.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace trilith {

namespace {

/// Uniform times over both motions, from just before the first begin to the last end.
struct Grid {
  double begin = 0;
  double step = 0;
  std::size_t count = 0;
  double time(std::size_t i) const { return begin + static_cast<double>(i) * step; }
};

Grid grid_over(const GroundMotion& right, const GroundMotion& left, double step) {
  constexpr double samples_per_step = 10;
  constexpr double most_samples = 1e8;  // bounds the work for a needlessly fine grid
  require_not_negative(step, "grid of the relative motion", "s");
  if (step == 0) step = std::min(right.step(), left.step()) / samples_per_step;
  const double begin = std::min(right.start_time(), left.start_time());
  const double end = std::max(right.end_time(), left.end_time());
  if ((end - begin) / step > most_samples)
    throw InputError("grid of the relative motion is too fine: above 1e8 samples; give a larger one");
  return {begin, step, static_cast<std::size_t>(std::ceil((end - begin) / step)) + 1};
}

/// Relative displacement before the start of both motions.
double offset_at_rest(const GroundMotion& right, const GroundMotion& left) {
  return right.start().displacement - left.start().displacement;
}

}  // namespace

// Relative motion of two supports under asynchronous ground motion, such as a passing wave: the right motion minus the
// left one.
MotionAt relative_at(const GroundMotion& right, const GroundMotion& left, double t) noexcept {
  const MotionAt r = right.at(t);
  const MotionAt l = left.at(t);
  return {r.acceleration - l.acceleration, r.velocity - l.velocity, r.displacement - l.displacement};
}

/// Sampled on a fine grid, because peaks of a difference lie between the samples of both.
RelativePeaks relative_peaks(const GroundMotion& right, const GroundMotion& left, double grid) {
  const Grid times = grid_over(right, left, grid);
  const double rest = offset_at_rest(right, left);
  RelativePeaks peaks;
  for (std::size_t i = 0; i < times.count; ++i) {
    const double t = times.time(i);
    const MotionAt now = relative_at(right, left, t);
    if (std::abs(now.velocity) > std::abs(peaks.velocity.value)) peaks.velocity = {now.velocity, t};
    const double change = now.displacement - rest;
    if (std::abs(change) > std::abs(peaks.displacement.value)) peaks.displacement = {change, t};
  }
  return peaks;
}

/// The first time at which the distance of the supports has changed by `level` from its value at rest.
std::optional<double> relative_passage(const GroundMotion& right, const GroundMotion& left, double level, double grid) {
  require_positive(level, "level of the relative displacement", "m");
  const Grid times = grid_over(right, left, grid);
  const double rest = offset_at_rest(right, left);
  for (std::size_t i = 0; i < times.count; ++i)
    if (std::abs(relative_at(right, left, times.time(i)).displacement - rest) >= level) return times.time(i);
  return std::nullopt;
}

}  // namespace trilith
