// Variation of a load in time.
#pragma once

#include <string>
#include <vector>

namespace trilith {

/// A share over time: linear between its points, constant before the first and after the last point; 1 without points.
/// If `smooth`, it follows the quintic s^3 (10 - 15 s + 6 s^2) between points, whose first and second derivatives are 0
/// at either end.
struct LoadCurve {
  std::vector<double> time;   ///< increasing [s]
  std::vector<double> share;  ///< [1]
  bool smooth = false;

  [[nodiscard]] double at(double t) const {
    if (time.empty()) return 1;
    if (t <= time.front()) return share.front();
    return t >= time.back() ? share.back() : between(t);
  }
  /// True if the load is zero from `t` [s] on.
  [[nodiscard]] bool spent(double t) const { return !time.empty() && t >= time.back() && share.back() == 0; }

 private:
  [[nodiscard]] double between(double t) const;
};

/// From one share to another within `duration` [s] after `start` [s]; a jump if `duration` is 0.
LoadCurve ramp_curve(double start, double from, double to, double duration, bool smooth);

/// Throws InputError, beginning with `owner`, for times that do not increase and for numbers that are not finite.
void check_load_curve(const LoadCurve& curve, const std::string& owner);

}  // namespace trilith
