// The inside of a chart's panel: checked values, and lines on the page.
#pragma once

#include <string>
#include <vector>

#include "draw/chart/chart.hpp"
#include "draw/chart/plot_axis.hpp"

namespace trilith::draw {

/// Colour and dash of each series name, by order of first appearance over all charts of a figure.
class SeriesLooks {
 public:
  explicit SeriesLooks(const std::vector<Chart>& charts);
  Colour colour(const ChartSeries& series) const;
  Dash dash(const ChartSeries& series) const;

 private:
  std::size_t index(const std::string& name) const;
  std::vector<std::string> names_;
};

/// `panel` with cumulative stacked series. Throws InputError as chart_canvas; `where` names the panel.
ChartPanel checked_panel(const ChartPanel& panel, AxisScale x_scale, const std::string& where);

/// The panel's drawing area with grid, frame, ticks, series and the lines of `mark_lines` (x on the page [pt]). Numbers
/// and titles of the axes are outside of `box`; numbers of x are drawn if `x_figures` is set.
struct PanelDrawing {
  PageBox box;
  const PlotAxis* x = nullptr;
  const PlotAxis* y = nullptr;
  bool x_figures = true;
  double label_room = 0;  ///< from the box's left side to the y title's far side [pt]
};
void draw_panel(Canvas& canvas, const ChartPanel& panel, const PanelDrawing& drawing,
                const std::vector<double>& mark_lines, const SeriesLooks& looks, const ChartStyle& style);

}  // namespace trilith::draw
