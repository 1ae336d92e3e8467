// Measures of ground motions: peaks, Arias intensity, durations, and arrays for charts.
#pragma once

#include <string>
#include <vector>

#include "load/motion.hpp"

namespace trilith {

/// A signed peak and its time [s].
struct Peak {
  double value = 0;
  double time = 0;
};

/// Largest absolute acceleration [m/s2], velocity [m/s] and displacement [m] among the samples, with their signs; the
/// first if two are equal. Velocity and displacement are the exact integrals at the samples.
struct MotionPeaks {
  Peak acceleration;
  Peak velocity;
  Peak displacement;
};
MotionPeaks motion_peaks(const GroundMotion& motion);

/// Arias intensity [m/s]: pi / (2 g) times the integral of a^2 (Arias 1970), exact for piecewise linear a.
double arias_intensity(const GroundMotion& motion);

/// Cumulative absolute velocity [m/s]: the integral of |a| (EPRI 1988), exact for piecewise linear a.
double cumulative_absolute_velocity(const GroundMotion& motion);

/// An interval of time, both ends on the motion's time axis [s]; length 0 if it is empty.
struct TimeSpan {
  double begin = 0;
  double end = 0;
  double length() const { return end - begin; }
};

/// Significant duration: while the Arias intensity grows from `low` to `high` of its end value (Trifunac and Brady
/// 1975: 0.05 to 0.95). 0 <= low < high <= 1, else InputError.
TimeSpan significant_duration(const GroundMotion& motion, double low, double high);

/// Bracketed duration: from the first to the last time |a| is at `level` [m/s2] or above (Bolt 1973: 0.05 g).
TimeSpan bracketed_duration(const GroundMotion& motion, double level = 0.05 * standard_gravity);

/// The samples as four arrays of equal length, for drawing: time [s], acceleration [m/s2], velocity [m/s],
/// displacement [m].
struct MotionTraces {
  std::vector<double> time;
  std::vector<double> acceleration;
  std::vector<double> velocity;
  std::vector<double> displacement;
};
MotionTraces motion_traces(const GroundMotion& motion);

}  // namespace trilith
