#include "load/load_curve.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace trilith {

/// Linear between two points, or smooth: 10 p^3 - 15 p^4 + 6 p^5, which has zero slope and curvature at both ends and
/// so excites no vibration.
double LoadCurve::between(double t) const {
  const auto after = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  double part = (t - time[after - 1]) / (time[after] - time[after - 1]);
  if (smooth) part = part * part * part * (10 - part * (15 - 6 * part));
  return (1 - part) * share[after - 1] + part * share[after];
}

// Without a duration the share is `to` from the start on, also before it: one point is constant on both sides.
LoadCurve ramp_curve(double start, double from, double to, double duration, bool smooth) {
  return duration > 0 ? LoadCurve{{start, start + duration}, {from, to}, smooth} : LoadCurve{{start}, {to}, smooth};
}

void check_load_curve(const LoadCurve& curve, const std::string& owner) {
  if (curve.time.size() != curve.share.size())
    throw InputError(fmt::format("{}: the load curve has {} times and {} shares, must be equal in number", owner,
                                 curve.time.size(), curve.share.size()));
  for (std::size_t i = 0; i < curve.time.size(); ++i) {
    require_finite(curve.time[i], fmt::format("{}: time {} of the load curve", owner, i + 1));
    require_finite(curve.share[i], fmt::format("{}: share {} of the load curve", owner, i + 1));
    if (i > 0 && !(curve.time[i] > curve.time[i - 1]))
      throw InputError(fmt::format("{}: time {} of the load curve is {:g} s, must be above the previous one, {:g} s",
                                   owner, i + 1, curve.time[i], curve.time[i - 1]));
  }
}

}  // namespace trilith
