// An axis prepared for drawing: its ends, ticks, numbers and title.
#pragma once

#include <string>
#include <vector>

#include "draw/chart/chart.hpp"

namespace trilith::draw {

/// Ends and ticks in the values' own unit; `texts` and `title` in the shown unit.
struct PlotAxis {
  AxisScale scale = AxisScale::linear;
  double low = 0, high = 1;
  std::vector<double> ticks, minor_ticks;
  std::vector<std::string> texts;
  std::string title;

  /// 0 at `low`, 1 at `high`; limited to -20 to 21 so that page coordinates stay small.
  double share(double value) const;
  /// Finite, and above zero on a logarithmic axis.
  bool can_show(double value) const;
};

/// The largest and smallest showable value among some, as an axis needs them.
struct ValueRange {
  double low = 0, high = 0;
  bool any = false;
  void add(double value);
};

/// Axis for data in `range` (`any` set) with at most `most_ticks` numbers. `margin` (share of the span) is left free
/// beyond free ends. Without margin a free end of a linear axis moves to the next tick if that is near. Throws
/// InputError (`where` names the axis) if fixed ends are not in order, not finite or, on a logarithmic axis, not above
/// zero. `units`: in which numbers and title are shown.
PlotAxis plot_axis(const ChartAxis& axis, const ValueRange& range, double margin, int most_ticks,
                   const std::string& where, const UnitSystem& units = {});

}  // namespace trilith::draw
