#include "load/motion_samples.hpp"

#include <fmt/format.h>

#include <cmath>

#include "load/motion_read.hpp"

namespace trilith {

/// Samples that came out as announced, of a size that ground can have: a record in cm/s2 read as g would be a thousand
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
  for (double& a : acceleration) a *= standard_gravity;
  return GroundMotion(acceleration, step, start, std::move(source));
}

}  // namespace trilith
