#include "load/motion_samples.hpp"

#include <fmt/format.h>

#include <cmath>

#include "load/motion_measures.hpp"
#include "load/motion_process.hpp"
#include "load/motion_read.hpp"

namespace trilith {
namespace {

/// Requires a plausible step and duration of a record.
void require_credible_times(double step, std::size_t count, const TextLines& lines) {
  if (!(step >= least_credible_step && step <= largest_credible_step))
    lines.fail_whole(fmt::format("step is {:g} s, records have {:g} to {:g} s; {}", step, least_credible_step,
                                 largest_credible_step,
                                 step > 1 ? "is it in ms? Give it in seconds" : "check the step, or its unit"));
  const double duration = step * static_cast<double>(count - 1);
  if (duration > largest_credible_duration)
    lines.fail_whole(fmt::format("lasts {:g} s, records last up to {:g} s; check the step of {:g} s", duration,
                                 largest_credible_duration, step));
}

/// Requires plausible velocity and displacement of the ground, apart from an offset that a baseline correction removes.
void require_credible_motion(const GroundMotion& motion, const TextLines& lines) {
  const GroundMotion flat = motion.samples().size() > 4 ? baseline_corrected(motion, 2) : motion;
  const MotionPeaks peaks = motion_peaks(flat);
  const double v = std::abs(peaks.velocity.value), u = std::abs(peaks.displacement.value);
  if (v > largest_credible_velocity || u > largest_credible_displacement)
    lines.fail_whole(fmt::format(
        "has a peak velocity of {:.3g} m/s and a peak displacement of {:.3g} m after a baseline "
        "correction, real ground motions stay below {:g} m/s and {:g} m; check the step of {:g} s and the unit",
        v, u, largest_credible_velocity, largest_credible_displacement, motion.step()));
}

}  // namespace

/// Requires the announced number of samples with a plausible peak: a record in cm/s2 read as g would be a thousand
/// times too strong.
GroundMotion motion_from_g(std::vector<double> acceleration, std::size_t announced, double step, MotionStart start,
                           MotionSource source, const TextLines& lines) {
  if (acceleration.size() < announced)
    lines.fail_whole(fmt::format("is cut short: {} samples, the header announces {}", acceleration.size(), announced));
  if (acceleration.size() < 2) lines.fail_whole("has fewer than 2 samples");
  double peak = 0;
  for (const double a : acceleration) peak = std::max(peak, std::abs(a));
  if (peak == 0) lines.fail_whole("is zero everywhere");
  if (peak > largest_credible_peak)
    lines.fail_whole(
        fmt::format("peak is {:g} g, above {:g} g; probably the values are not in g: divide cm/s2 by 980.665, "
                    "m/s2 by 9.80665",
                    peak, largest_credible_peak));
  require_credible_times(step, acceleration.size(), lines);
  for (double& a : acceleration) a *= standard_gravity;
  GroundMotion motion(acceleration, step, start, std::move(source));
  require_credible_motion(motion, lines);
  return motion;
}

}  // namespace trilith
